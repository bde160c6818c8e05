// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#pragma once

#include "base/descriptions.gen.hpp"
#include "burnish/report/metrics.hpp"
#include "burnish/report/svg_plot.hpp"
#include "model/descriptions.gen.hpp"

namespace burnish {

const Description& description_of(const MetricsSpec*);
const Description& description_of(const NamedMetrics*);
const Description& description_of(const Curve*);
const Description& description_of(const Panel*);
const Description& description_of(const PlotSpec*);

}  // namespace burnish
