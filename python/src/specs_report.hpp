// Values of the report layer.
#pragma once

#include "burnish/report/metrics.hpp"
#include "burnish/report/svg_plot.hpp"
#include "specs_sim.hpp"

namespace burnish::python {

template <>
struct SpecOf<MetricsSpec> : AsDataclass<MetricsSpec> {};
template <>
struct SpecOf<SolverFigures> : AsDataclass<SolverFigures> {};
template <>
struct SpecOf<Metrics> : AsDataclass<Metrics> {};
template <>
struct SpecOf<NamedMetrics> : AsDataclass<NamedMetrics> {};
template <>
struct SpecOf<Curve> : AsDataclass<Curve> {};
template <>
struct SpecOf<Panel> : AsDataclass<Panel> {};
template <>
struct SpecOf<PlotSpec> : AsDataclass<PlotSpec> {};

}  // namespace burnish::python
