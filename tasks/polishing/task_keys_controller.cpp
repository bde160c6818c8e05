// Keys of a task file: the controller.
#include "polishing/task_keys.hpp"

namespace burnish::polishing {
namespace {

TaskSection horizon_section() {
  constexpr auto positive = Range::Positive;
  return {
      "controller",
      "The optimal control problem that is solved again and again, and the loop around it.",
      {number_key("horizon", "s that are planned ahead", positive, at(&Task::horizon)),
       number_key("step", "s between two knots of the plan", positive, at(&Task::step)),
       number_key("update_rate", "Hz, of new plans; divides the tick rate", positive,
                  at(&Task::update_rate)),
       number_key("tick_rate", "Hz, of torque commands", positive, at(&Task::tick_rate)),
       number_key("solver_delay", "s from a measurement to the use of the plan made from it",
                  Range::NotNegative, at(&Task::solver_delay)),
       count_key("iterations", "of the solver, per plan", 1, at(&Task::iterations)),
       word_key("solver", "multiple_shooting or rollout", {"rollout", "multiple_shooting"},
                at(&Task::solver)),
       flag_key("feedback", "between plans follow their Riccati gains, not just their torques",
                at(&Task::feedback)),
       number_key("contact_kd", "1/s, damping of the contact constraint (Baumgarte)",
                  Range::NotNegative, at(&Task::contact_kd)),
       number_key("torque_cutoff",
                  "rad/s, torque lag that plans know of; 0: none; the plant's is in disturbances",
                  Range::NotNegative, at(&Task::torque_cutoff)),
       word_key("axes", "of contact and force: surface, or local (the tool's)",
                {"surface", "local"}, at(&Task::axes))}};
}

TaskSection weights_section() {
  const auto weight = [](const char* name, const char* meaning, double Weights::*member) {
    return number_key(name, meaning, Range::NotNegative, at(&Task::weights, member));
  };
  return {
      "weights",
      "Cost per second of squared error. What counts is how they compare: raise one, and its "
      "error\n"
      "shrinks at the expense of the others.",
      {weight("force", "1/N^2: force along the normal to its target", &Weights::force),
       weight("position", "1/m^2: tool to the path, in the reach to the point above the surface",
              &Weights::position),
       weight("approach", "s^2/m^2: speed along the normal to that of approach and retreat",
              &Weights::approach),
       weight("rotation",
              "1/rad^2: tool to its orientation at the start; less lets the wrist follow",
              &Weights::rotation),
       weight("posture", "1/rad^2: joints to the start; more holds the elbow, costs path accuracy",
              &Weights::posture),
       weight("velocity", "s^2/rad^2: joint speeds; more damps, and lags on fast paths",
              &Weights::velocity),
       weight("torque", "1/Nm^2: torques to those that hold the start", &Weights::torque),
       weight("position_limits", "1/rad^2 beyond 0.05 rad inside a joint's limits",
              &Weights::position_limits),
       weight("velocity_limits", "s^2/rad^2 beyond a joint's velocity limit",
              &Weights::velocity_limits),
       weight("torque_limits", "1/Nm^2 beyond a joint's effort limit", &Weights::torque_limits),
       weight("terminal", "s: what the end of the horizon costs, as a time at its running cost",
              &Weights::terminal)}};
}

TaskSection model_error_section() {
  return {
      "model_error",
      "What measurements say that the model gets wrong, given back to it before each plan.",
      {word_key("kind", "none, torque (per joint) or force (along the normal)",
                {"none", "torque", "force"}, at(&Task::model_error, &ModelErrorOptions::kind)),
       number_key("bandwidth", "rad/s of the observer; more follows friction, and bears less delay",
                  Range::Positive, at(&Task::model_error, &ModelErrorOptions::bandwidth)),
       number_key("limit", "Nm (N): estimates stay within +- this", Range::Positive,
                  at(&Task::model_error, &ModelErrorOptions::limit))}};
}

TaskSection limits_section() {
  const auto key = [](const char* name, const char* meaning, const auto& entry) {
    return number_key(name, meaning, Range::PositiveOrNever, entry);
  };
  const auto limit = [key](const char* name, const char* meaning, double SafetyLimits::*member) {
    return key(name, meaning, at(&Task::limits, member));
  };
  const auto tool = [key](const char* name, const char* meaning, double ToolLimits::*member) {
    return key(name, meaning, at(&Task::tool_limits, member));
  };
  const auto count = [](const char* name, const char* meaning, int SafetyLimits::*member) {
    return count_key(name, meaning, 1, at(&Task::limits, member));
  };
  return {
      "limits",
      "Beyond these a run is given up: the arm is braked and held (fallback), and there is a "
      "report.\n"
      "Each may be never.",
      {tool("force", "N at the tool, mean over force_window", &ToolLimits::force),
       tool("force_window", "s", &ToolLimits::force_window),
       tool("tool_speed", "m/s", &ToolLimits::tool_speed),
       limit("joint_speed_ratio", "of the robot's velocity limits",
             &SafetyLimits::joint_speed_ratio),
       number_key("joint_margin", "rad that a joint may be beyond its limit", Range::NotNegative,
                  at(&Task::limits, &SafetyLimits::joint_margin)),
       limit("stale", "s without a new measurement", &SafetyLimits::stale),
       limit("bad", "s of measurements that are no state", &SafetyLimits::bad),
       tool("contact_lost", "s without force while it is wanted", &ToolLimits::contact_lost),
       key("contact_threshold", "N that count as contact", at(&Task::contact_threshold)),
       tool("late_contact_travel", "m that the tool may go on after contact was due",
            &ToolLimits::late_contact_travel),
       tool("late_contact_time", "s that contact may come late", &ToolLimits::late_contact_time),
       tool("unexpected_force", "N while moving through free space", &ToolLimits::unexpected_force),
       tool("release", "s into the retreat after which it is free space at the latest",
            &ToolLimits::release),
       count("failed_solves", "in a row", &SafetyLimits::failed_solves),
       limit("deadline", "s of computing time per plan", &SafetyLimits::deadline),
       count("late_solves", "in a row", &SafetyLimits::late_solves)}};
}

TaskSection fallback_section() {
  const auto key = [](const char* name, const char* meaning, double Fallback::*member) {
    return number_key(name, meaning, Range::NotNegative, at(&Task::fallback, member));
  };
  return {
      "fallback",
      "What holds the arm after a fault: gravity compensation, a damper, and a spring that "
      "slips.",
      {key("stiffness", "1/s^2, times the mass matrix; 0: nothing holds, the arm is braked only",
           &Fallback::stiffness),
       key("damping", "1/s, times the mass matrix", &Fallback::damping),
       key("give", "of the torque limits, where the spring slips; 0 to 1", &Fallback::give)}};
}

}  // namespace

std::vector<TaskSection> controller_sections() {
  return {horizon_section(), weights_section(), model_error_section(), limits_section(),
          fallback_section()};
}

}  // namespace burnish::polishing
