#include "specs_polishing.hpp"

#include "polishing/figures.hpp"

namespace burnish::python {

using namespace polishing;

template <>
const EnumTable& AsEnum<ControllerKind>::table() {
  static const EnumTable words("burnish.polishing", "ControllerKind", {"mpc", "baseline"});
  return words;
}
template <>
const SpecTable& AsDataclass<VerdictFigures>::table() {
  static const SpecTable fields = [] {
    SpecTable table("burnish.polishing", "VerdictFigures");
    each_verdict_figure([&](const FigureEntry& entry, auto member, auto, bool) {
      table.field(entry.name, member);
    });
    return table;
  }();
  return fields;
}
template <>
const SpecTable& AsDataclass<NamedSurface>::table() {
  static const SpecTable fields = SpecTable("burnish.polishing", "NamedSurface")
                                      .field("name", &NamedSurface::name)
                                      .field("posture", &NamedSurface::posture)
                                      .field("normal_world", &NamedSurface::normal_world);
  return fields;
}
template <>
const SpecTable& AsDataclass<Setting>::table() {
  static const SpecTable fields = SpecTable("burnish.polishing", "Setting")
                                      .field("robot", &Setting::robot)
                                      .field("q_start", &Setting::q_start)
                                      .field("scene", &Setting::scene)
                                      .field("surface_axes", &Setting::surface_axes)
                                      .field("p_start", &Setting::p_start)
                                      .field("p_center", &Setting::p_center)
                                      .field("reach_end", &Setting::reach_end)
                                      .field("touch", &Setting::touch)
                                      .field("ramp_end", &Setting::ramp_end)
                                      .field("track_end", &Setting::track_end);
  return fields;
}
template <>
const SpecTable& AsDataclass<RunSpec>::table() {
  static const SpecTable fields = SpecTable("burnish.polishing", "RunSpec")
                                      .field("task", &RunSpec::task)
                                      .field("robot", &RunSpec::robot)
                                      .field("controller", &RunSpec::controller)
                                      .field("plant", &RunSpec::plant)
                                      .field("check_reach", &RunSpec::check_reach)
                                      .field("reach", &RunSpec::reach)
                                      .field("plan_rate", &RunSpec::plan_rate)
                                      .field("progress", &RunSpec::progress);
  return fields;
}
template <>
const SpecTable& AsDataclass<ExperimentSpec>::table() {
  static const SpecTable fields = SpecTable("burnish.polishing", "ExperimentSpec")
                                      .field("plant", &ExperimentSpec::plant)
                                      .field("seeds", &ExperimentSpec::seeds)
                                      .field("first_seed", &ExperimentSpec::first_seed)
                                      .field("threads", &ExperimentSpec::threads)
                                      .field("quick", &ExperimentSpec::quick)
                                      .field("surfaces", &ExperimentSpec::surfaces)
                                      .field("robots", &ExperimentSpec::robots)
                                      .field("tools", &ExperimentSpec::tools)
                                      .field("overrides", &ExperimentSpec::overrides)
                                      .field("progress", &ExperimentSpec::progress);
  return fields;
}
template <>
const SpecTable& AsDataclass<ResultColumn>::table() {
  static const SpecTable fields = SpecTable("burnish.polishing", "ResultColumn")
                                      .field("name", &ResultColumn::name)
                                      .field("unit", &ResultColumn::unit)
                                      .field("digits", &ResultColumn::digits);
  return fields;
}
template <>
const SpecTable& AsDataclass<ResultTable>::table() {
  static const SpecTable fields = SpecTable("burnish.polishing", "ResultTable")
                                      .field("name", &ResultTable::name)
                                      .field("title", &ResultTable::title)
                                      .field("columns", &ResultTable::columns)
                                      .field("rows", &ResultTable::rows)
                                      .field("for_people", &ResultTable::for_people);
  return fields;
}
template <>
const SpecTable& AsDataclass<Figure>::table() {
  static const SpecTable fields = SpecTable("burnish.polishing", "Figure")
                                      .field("name", &Figure::name)
                                      .field("plot", &Figure::plot);
  return fields;
}
template <>
const SpecTable& AsDataclass<NamedTask>::table() {
  static const SpecTable fields = SpecTable("burnish.polishing", "NamedTask")
                                      .field("name", &NamedTask::name)
                                      .field("task", &NamedTask::task);
  return fields;
}
template <>
const SpecTable& AsDataclass<ExperimentReport>::table() {
  static const SpecTable fields = SpecTable("burnish.polishing", "ExperimentReport")
                                      .field("title", &ExperimentReport::title)
                                      .field("tables", &ExperimentReport::tables)
                                      .field("figures", &ExperimentReport::figures)
                                      .field("tasks", &ExperimentReport::tasks)
                                      .field("findings", &ExperimentReport::findings)
                                      .field("failures", &ExperimentReport::failures)
                                      .field("interrupted", &ExperimentReport::interrupted);
  return fields;
}
template <>
const SpecTable& AsDataclass<NamedExperiment>::table() {
  static const SpecTable fields = SpecTable("burnish.polishing", "Experiment")
                                      .field("name", &NamedExperiment::name)
                                      .field("summary", &NamedExperiment::summary);
  return fields;
}

}  // namespace burnish::python
