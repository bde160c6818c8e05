#include "record/figures_json.hpp"

namespace burnish {

Json metrics_json(const Metrics& metrics) {
  Json json;
  each_metric([&](const FigureEntry& entry, auto member) {
    json[entry.key()] = figure_json(metrics.*member);
  });
  if (metrics.solver)
    each_solver_figure([&](const FigureEntry& entry, auto member) {
      json["solver"][entry.key()] = figure_json(*metrics.solver.*member);
    });
  return json;
}

}  // namespace burnish
