#include "specs_polishing.hpp"

#include "polishing/figures.hpp"

namespace burnish::python {

using namespace polishing;

template <>
const EnumTable& AsEnum<ReachProblem>::table() {
  static const EnumTable words("burnish.polishing", "ReachProblem",
                               {"none", "position", "joint", "torque", "collision"});
  return words;
}
template <>
const EnumTable& AsEnum<ControllerKind>::table() {
  static const EnumTable words("burnish.polishing", "ControllerKind", {"mpc", "baseline"});
  return words;
}
template <>
const EnumTable& AsEnum<PlantKind>::table() {
  static const EnumTable words("burnish.polishing", "PlantKind", {"mujoco", "ideal"});
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
const SpecTable& AsDataclass<ReachOptions>::table() {
  static const SpecTable fields = SpecTable("burnish.polishing", "ReachOptions")
                                      .field("spacing", &ReachOptions::spacing)
                                      .field("tolerance", &ReachOptions::tolerance)
                                      .field("joint_margin", &ReachOptions::joint_margin)
                                      .field("torque_share", &ReachOptions::torque_share)
                                      .field("link_radius", &ReachOptions::link_radius);
  return fields;
}
template <>
const SpecTable& AsDataclass<ReachReport>::table() {
  static const SpecTable fields =
      SpecTable("burnish.polishing", "ReachReport")
          .field("problem", &ReachReport::problem)
          .field("text", &ReachReport::text)
          .field("s", &ReachReport::s)
          .field("p_world", &ReachReport::p_world)
          .field("joint", &ReachReport::joint)
          .field("value", &ReachReport::value)
          .field("limit", &ReachReport::limit)
          .field("points", &ReachReport::points)
          .field("path_length", &ReachReport::path_length)
          .field("joint_margin", &ReachReport::joint_margin)
          .field("tightest_joint", &ReachReport::tightest_joint)
          .field("torque_share", &ReachReport::torque_share)
          .field("tightest_torque", &ReachReport::tightest_torque)
          .field("clearance", &ReachReport::clearance)
          .field("tightest_clearance", &ReachReport::tightest_clearance);
  return fields;
}
template <>
const SpecTable& AsDataclass<PostureOptions>::table() {
  static const SpecTable fields = SpecTable("burnish.polishing", "PostureOptions")
                                      .field("random_starts", &PostureOptions::random_starts)
                                      .field("seed", &PostureOptions::seed)
                                      .field("tilt_limit", &PostureOptions::tilt_limit)
                                      .field("joint_margin", &PostureOptions::joint_margin)
                                      .field("body_distance", &PostureOptions::body_distance)
                                      .field("bend", &PostureOptions::bend)
                                      .field("checked", &PostureOptions::checked)
                                      .field("reach", &PostureOptions::reach);
  return fields;
}
template <>
const SpecTable& AsDataclass<FoundPosture>::table() {
  static const SpecTable fields = SpecTable("burnish.polishing", "FoundPosture")
                                      .field("q", &FoundPosture::q)
                                      .field("score", &FoundPosture::score)
                                      .field("tilt", &FoundPosture::tilt)
                                      .field("reach", &FoundPosture::reach)
                                      .field("candidates", &FoundPosture::candidates);
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
const SpecTable& AsDataclass<TickTimes>::table() {
  static const SpecTable fields = [] {
    SpecTable table("burnish.polishing", "TickTimes");
    each_tick_figure(
        [&](const FigureEntry& entry, auto member) { table.field(entry.name, member); });
    return table;
  }();
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
const SpecTable& AsDataclass<PlanArrays>::table() {
  static const SpecTable fields = SpecTable("burnish.polishing", "PlanRecord")
                                      .field("time", &PlanArrays::time)
                                      .field("terms", &PlanArrays::terms)
                                      .field("costs", &PlanArrays::costs)
                                      .field("step", &PlanArrays::step)
                                      .field("q", &PlanArrays::q);
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
