// Conversion of the types of the report layer between Python and C++.
#pragma once

#include "burnish/report/metrics.hpp"
#include "burnish/report/standing_figures.hpp"
#include "burnish/report/svg_plot.hpp"
#include "report/descriptions.hpp"
#include "specs_sim.hpp"
