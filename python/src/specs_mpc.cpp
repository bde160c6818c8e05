#include "specs_mpc.hpp"

namespace burnish::python {

template <>
const EnumTable& AsEnum<Touch>::table() {
  static const EnumTable words("burnish.pressing", "Touch", {"free", "due", "wanted", "leaving"});
  return words;
}
template <>
const EnumTable& AsEnum<FaultKind>::table() {
  static const EnumTable words(
      "burnish.mpc", "FaultKind",
      {"none", "stale_measurement", "bad_measurement", "out_of_range", "solver_failed",
       "solver_late", "contact_lost", "no_contact", "contact_late", "unexpected_contact",
       "force_limit", "speed_limit", "watched"});
  return words;
}
template <>
const SpecTable& AsDataclass<Measurement>::table() {
  static const SpecTable fields = SpecTable("burnish.mpc", "Measurement")
                                      .field("time", &Measurement::time)
                                      .field("q", &Measurement::q)
                                      .field("v", &Measurement::v)
                                      .field("tau", &Measurement::tau)
                                      .field("tool_force_world", &Measurement::tool_force_world);
  return fields;
}
template <>
const SpecTable& AsDataclass<Command>::table() {
  static const SpecTable fields = SpecTable("burnish.mpc", "Command")
                                      .field("tau", &Command::tau)
                                      .field("phase", &Command::phase)
                                      .field("target_force", &Command::target_force)
                                      .field("p_target_world", &Command::p_target_world)
                                      .field("force_estimate_world", &Command::force_estimate_world)
                                      .field("status", &Command::status)
                                      .field("solve_time", &Command::solve_time)
                                      .field("iterations", &Command::iterations)
                                      .field("missed_deadline", &Command::missed_deadline);
  return fields;
}
template <>
const SpecTable& AsDataclass<SchedulePhase>::table() {
  static const SpecTable fields = SpecTable("burnish.mpc", "SchedulePhase")
                                      .field("name", &SchedulePhase::name)
                                      .field("stage", &SchedulePhase::stage)
                                      .field("duration", &SchedulePhase::duration)
                                      .field("until", &SchedulePhase::until)
                                      .field("hold", &SchedulePhase::hold);
  return fields;
}
template <>
const SpecTable& AsDataclass<TaskTarget>::table() {
  static const SpecTable fields = SpecTable("burnish.pressing", "TaskTarget")
                                      .field("p_world", &TaskTarget::p_world)
                                      .field("force", &TaskTarget::force);
  return fields;
}
template <>
const SpecTable& AsDataclass<PressingTask>::table() {
  static const SpecTable fields = SpecTable("burnish.pressing", "PressingTask")
                                      .field("touch", &PressingTask::touch)
                                      .field("target", &PressingTask::target)
                                      .field("limits", &PressingTask::limits);
  return fields;
}
template <>
const SpecTable& AsDataclass<FaultReport>::table() {
  static const SpecTable fields = SpecTable("burnish.mpc", "FaultReport")
                                      .field("kind", &FaultReport::kind)
                                      .field("time", &FaultReport::time)
                                      .field("joint", &FaultReport::joint)
                                      .field("value", &FaultReport::value)
                                      .field("limit", &FaultReport::limit)
                                      .field("quantity", &FaultReport::quantity)
                                      .field("last_second", &FaultReport::last_second);
  return fields;
}
template <>
const SpecTable& AsDataclass<LinearFeedback>::table() {
  static const SpecTable fields = SpecTable("burnish.mpc", "LinearFeedback")
                                      .field("feedforward", &LinearFeedback::feedforward)
                                      .field("gain", &LinearFeedback::gain)
                                      .field("state", &LinearFeedback::state);
  return fields;
}
template <>
const SpecTable& AsDataclass<MpcSpec>::table() {
  static const SpecTable fields = SpecTable("burnish.mpc", "MpcSpec")
                                      .field("problem", &MpcSpec::problem)
                                      .field("schedule", &MpcSpec::schedule)
                                      .field("task", &MpcSpec::task)
                                      .field("tool", &MpcSpec::tool)
                                      .field("normal_world", &MpcSpec::normal_world)
                                      .field("contact_threshold", &MpcSpec::contact_threshold)
                                      .field("tick_period", &MpcSpec::tick_period)
                                      .field("update_period", &MpcSpec::update_period)
                                      .field("solver_delay", &MpcSpec::solver_delay)
                                      .field("solver", &MpcSpec::solver)
                                      .field("first_iterations", &MpcSpec::first_iterations)
                                      .field("jump_iterations", &MpcSpec::jump_iterations)
                                      .field("model_error", &MpcSpec::model_error)
                                      .field("limits", &MpcSpec::limits)
                                      .field("fallback", &MpcSpec::fallback)
                                      .field("feedback", &MpcSpec::feedback);
  return fields;
}

}  // namespace burnish::python
