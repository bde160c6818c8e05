// Values of the report layer.
#pragma once

#include "burnish/report/metrics.hpp"
#include "burnish/report/standing_figures.hpp"
#include "burnish/report/svg_plot.hpp"
#include "report/descriptions.hpp"
#include "specs_sim.hpp"
