#include "specs_polishing.hpp"

#include "polishing/figures.hpp"

namespace burnish::python {

using namespace polishing;

template <>
const EnumTable& AsEnum<PathKind>::table() {
  static const EnumTable words("burnish.polishing", "PathKind",
                               {"circle", "spiral", "zigzag", "points"});
  return words;
}
template <>
const EnumTable& AsEnum<ForceAxes>::table() {
  static const EnumTable words("burnish.polishing", "ForceAxes", {"surface", "local"});
  return words;
}
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
const SpecTable& AsDataclass<PathSpec>::table() {
  static const SpecTable fields = SpecTable("burnish.polishing", "PathSpec")
                                      .field("kind", &PathSpec::kind)
                                      .field("radius", &PathSpec::radius)
                                      .field("rate", &PathSpec::rate)
                                      .field("start_up", &PathSpec::start_up)
                                      .field("pitch", &PathSpec::pitch)
                                      .field("width", &PathSpec::width)
                                      .field("height", &PathSpec::height)
                                      .field("rows", &PathSpec::rows)
                                      .field("speed", &PathSpec::speed)
                                      .field("points", &PathSpec::points);
  return fields;
}
template <>
const SpecTable& AsDataclass<PlanarPoint>::table() {
  static const SpecTable fields = SpecTable("burnish.polishing", "PlanarPoint")
                                      .field("p", &PlanarPoint::p)
                                      .field("v", &PlanarPoint::v)
                                      .field("a", &PlanarPoint::a);
  return fields;
}
template <>
const SpecTable& AsDataclass<Weights>::table() {
  static const SpecTable fields = SpecTable("burnish.polishing", "Weights")
                                      .field("posture", &Weights::posture)
                                      .field("velocity", &Weights::velocity)
                                      .field("torque", &Weights::torque)
                                      .field("position", &Weights::position)
                                      .field("approach", &Weights::approach)
                                      .field("rotation", &Weights::rotation)
                                      .field("force", &Weights::force)
                                      .field("position_limits", &Weights::position_limits)
                                      .field("velocity_limits", &Weights::velocity_limits)
                                      .field("torque_limits", &Weights::torque_limits)
                                      .field("terminal", &Weights::terminal);
  return fields;
}
template <>
const SpecTable& AsDataclass<Verdict>::table() {
  static const SpecTable fields = SpecTable("burnish.polishing", "Verdict")
                                      .field("contact_share", &Verdict::contact_share)
                                      .field("force_rmse", &Verdict::force_rmse)
                                      .field("path_share", &Verdict::path_share);
  return fields;
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
const SpecTable& AsDataclass<PostureLimits>::table() {
  static const SpecTable fields = SpecTable("burnish.polishing", "PostureLimits")
                                      .field("tilt", &PostureLimits::tilt)
                                      .field("joint_margin", &PostureLimits::joint_margin)
                                      .field("body_distance", &PostureLimits::body_distance);
  return fields;
}
template <>
const SpecTable& AsDataclass<Task>::table() {
  static const SpecTable fields = SpecTable("burnish.polishing", "Task")
                                      .field("robot", &Task::robot)
                                      .field("posture", &Task::posture)
                                      .field("search", &Task::search)
                                      .field("tool", &Task::tool)
                                      .field("tool_axis", &Task::tool_axis)
                                      .field("tip_radius", &Task::tip_radius)
                                      .field("normal_world", &Task::normal_world)
                                      .field("point_world", &Task::point_world)
                                      .field("extent", &Task::extent)
                                      .field("friction", &Task::friction)
                                      .field("stiffness", &Task::stiffness)
                                      .field("damping", &Task::damping)
                                      .field("force", &Task::force)
                                      .field("touch_force", &Task::touch_force)
                                      .field("path", &Task::path)
                                      .field("clearance", &Task::clearance)
                                      .field("reach_duration", &Task::reach_duration)
                                      .field("approach_speed", &Task::approach_speed)
                                      .field("ramp_duration", &Task::ramp_duration)
                                      .field("polish_duration", &Task::polish_duration)
                                      .field("retreat_duration", &Task::retreat_duration)
                                      .field("verdict", &Task::verdict)
                                      .field("horizon", &Task::horizon)
                                      .field("step", &Task::step)
                                      .field("update_rate", &Task::update_rate)
                                      .field("tick_rate", &Task::tick_rate)
                                      .field("solver_delay", &Task::solver_delay)
                                      .field("iterations", &Task::iterations)
                                      .field("solver", &Task::solver)
                                      .field("contact_kd", &Task::contact_kd)
                                      .field("torque_cutoff", &Task::torque_cutoff)
                                      .field("axes", &Task::axes)
                                      .field("feedback", &Task::feedback)
                                      .field("model_error", &Task::model_error)
                                      .field("limits", &Task::limits)
                                      .field("tool_limits", &Task::tool_limits)
                                      .field("contact_threshold", &Task::contact_threshold)
                                      .field("fallback", &Task::fallback)
                                      .field("weights", &Task::weights)
                                      .field("disturbances", &Task::disturbances);
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
