// What the layer's specifications hold; figures, by their table: report/figures.hpp.
#pragma once

#include "base/description.hpp"
#include "burnish/report/metrics.hpp"
#include "burnish/report/standing_figures.hpp"
#include "burnish/report/svg_plot.hpp"

namespace burnish {

const Description& description_of(const SolverFigures*);
const Description& description_of(const Metrics*);
const Description& description_of(const StandingFigures*);
const Description& description_of(const MetricsSpec*);
const Description& description_of(const NamedMetrics*);
const Description& description_of(const Curve*);
const Description& description_of(const Panel*);
const Description& description_of(const PlotSpec*);

}  // namespace burnish
