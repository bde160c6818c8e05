// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "mpc/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Description& description_of(const ToolCommand* /*of*/) {
  using S = ToolCommand;
  static const Description all =
      Describe<S>("mpc", "ToolCommand",
                  "Targets and estimates of a controller at one tool.")
          .field("target_force", &S::target_force,
                 "Target of the normal force of the surface on the tool [{N}]")
          .field("p_target_world", &S::p_target_world,
                 "Target position of the tool frame's origin, in world axes [{m}]")
          .more("While the tool presses, the target lies on the estimated surface")
          .field("normal_world", &S::normal_world,
                 "Estimated surface normal at the tool, a unit vector in world axes")
          .field("force_estimate_world", &S::force_estimate_world,
                 "Estimated force of the surface on the tool, in world axes [{N}]")
          .field("friction", &S::friction,
                 "Estimated coefficient of friction between tool and surface");
  return all;
}

const Description& description_of(const Command* /*of*/) {
  using S = Command;
  static const Description all =
      Describe<S>("mpc", "Command",
                  "Output of a controller. Only `tau` reaches the plant. The other entries record"
                  " targets, estimates and solver results.")
          .field("tau", &S::tau,
                 "Joint torques to apply, nv entries, zero for a floating base [{Nm (N)}]")
          .field("phase", &S::phase,
                 "Current phase of the task")
          .more("For an MpcController, this is the index of the phase in the schedule")
          .field("tools", &S::tools,
                 "Targets and estimates at each tool")
          .more("For an MpcController, in the order of MpcSpec.tools. A controller without a tool"
                " has one entry, which records the targets of its task")
          .field("status", &S::status)
          .field("solve_time", &S::solve_time,
                 "Wall-clock time of the solve that finished at this tick [{s}]; 0: no solve "
                 "finished")
          .field("iterations", &S::iterations,
                 "Number of iterations of the solve that finished at this tick; 0: no solve "
                 "finished")
          .field("missed_deadline", &S::missed_deadline,
                 "True if the solve that finished at this tick took longer than its deadline")
          .field("constraint_violation", &S::constraint_violation,
                 "Largest violation of a hard constraint in the last plan, as a fraction of the "
                 "constraint's scale")
          .field("constraint_residual", &S::constraint_residual,
                 "Constraint residual after the last iteration of the last solve, as a fraction "
                 "of the constraint's scale")
          .field("active_constraints", &S::active_constraints,
                 "Number of active constraints in the last plan, summed over all knots")
          .field("constraints_infeasible", &S::constraints_infeasible,
                 "True if the last solve found that the hard constraints cannot all be satisfied")
          .field("clipped_torques", &S::clipped_torques,
                 "Number of joints whose torque was clipped to its limit at this tick");
  return all;
}

const Words& words_of(FaultKind /*of*/) {
  static const Words all{
      "mpc",
      "FaultKind",
      "Kinds of faults that can occur in a control loop.",
      {{"none"},
       {"stale_measurement", "No new measurement arrived for too long"},
       {"bad_measurement", "Measurements had NaN, infinity or a wrong size for too long"},
       {"out_of_range", "A joint exceeds its position limit by more than the margin"},
       {"solver_failed", "Too many solves in a row, or the first solve, gave no usable plan"},
       {"solver_late", "Too many solves in a row took longer than the deadline"},
       {"contact_lost", "The contact force was missing for too long in a phase that requires contact"},
       {"no_contact", "The tool moved too far without contact after contact was due"},
       {"contact_late", "Contact did not occur within the allowed time after it was due"},
       {"unexpected_contact", "A contact force acts while the tool should move in free space"},
       {"force_limit", "The contact force at the tool is larger than allowed"},
       {"speed_limit", "A joint or the tool moves faster than allowed"},
       {"support_slipped", "A support of the robot, such as a foot, moved too far"},
       {"motor_lost", "The measured torque of a joint deviates too much from the command"},
       {"watched", "A quantity that the task monitors (FaultReport.quantity) exceeds its limit"},
       {"base_lost", "A floating base had no position estimate for too long"}}};
  return all;
}

const Description& description_of(const FaultReport* /*of*/) {
  using S = FaultReport;
  static const Description all =
      Describe<S>("mpc", "FaultReport",
                  "Report of the first fault of a run, with the ticks before the fault.")
          .field("kind", &S::kind)
          .field("time", &S::time,
                 "Time of the measurement that shows the fault [{s}]")
          .more("For a missing measurement, this is the time at which the measurement was due")
          .field("joint", &S::joint,
                 "Index in v of the joint with the fault; -1: the fault concerns no joint")
          .field("value", &S::value,
                 "Measured value that violates the limit")
          .more("The unit depends on the kind of fault: s, number of updates, N, m or m/s. If the"
                " fault concerns a joint, the unit is rad, rad/s or Nm (prismatic joint: m, m/s "
                "or N)")
          .field("limit", &S::limit,
                 "Limit that `value` violates, in the unit of `value`")
          .field("quantity", &S::quantity,
                 "Subject of the fault: a monitored quantity, a support, or a part of the robot; "
                 "empty if there is none")
          .more("With FaultKind::Watched, this is name and unit of the quantity. With "
                "FaultKind::SupportSlipped, this is the name of the support. A part of the robot "
                "is named as in \"hand 'left'\"")
          .field("joint_name", &S::joint_name,
                 "Name of the joint with the fault; empty: the fault concerns no joint")
          .field("unit", &S::unit,
                 "Unit of `value` and `limit` if the fault concerns a joint; empty: the kind of "
                 "fault determines the unit")
          .field("cause", &S::cause,
                 "Probable cause of the fault, such as \"the largest force was 1.4 N; 2 N count "
                 "as contact\"; empty if unknown")
          .field("last_second", &S::last_second,
                 "Record of all ticks in the last second before the fault, oldest first; empty "
                 "without a fault");
  return all;
}

const Description& description_of(const LinearFeedback* /*of*/) {
  using S = LinearFeedback;
  static const Description all =
      Describe<S>("mpc", "LinearFeedback",
                  "Linear feedback law for the control u at the state x: u = feedforward + gain "
                  "(x (-) state). The sign (-) stands for the difference of two states on their "
                  "manifold.")
          .result()
          .field("feedforward", &S::feedforward,
                 "Feedforward torques, nu entries [{Nm (N)}]")
          .field("gain", &S::gain,
                 "Feedback gains, nu x ndx. Columns: position, velocity and, with a torque model,"
                 " torque")
          .field("state", &S::state,
                 "State at which the law is linearized, nx entries: (q, v), or (q, v, tau) with a"
                 " torque model");
  return all;
}

const Description& description_of(const GainRange* /*of*/) {
  using S = GainRange;
  static const Description all =
      Describe<S>("mpc", "GainRange",
                  "Stable range of a factor on the torque of one joint. The control loop is "
                  "stable for factors in this range if the torques of all other joints are exact."
                  " Only factors from 0.1 to 10 are tried.")
          .result()
          .field("joint", &S::joint)
          .field("below", &S::below,
                 "Smallest torque factor at which the control loop is stable")
          .field("above", &S::above,
                 "Largest torque factor at which the control loop is stable");
  return all;
}

const Description& description_of(const LoopMargins* /*of*/) {
  using S = LoopMargins;
  static const Description all =
      Describe<S>("mpc", "LoopMargins",
                  "Stability margins of the closed loop of a controller and an arm.")
          .result()
          .field("delay", &S::delay,
                 "Largest extra delay of commands at which the control loop is stable [{s}]")
          .more("Delays up to 0.01 s are tried. The value 0 means that the control loop is "
                "unstable even without extra delay")
          .field("bandwidth", &S::bandwidth,
                 "Bandwidth of the model-error observer for which the delay margin is smallest "
                 "[{rad/s}]")
          .more("The delay margin is computed for up to three bandwidths")
          .field("gains", &S::gains,
                 "Stable ranges of torque factors, one per entry of v");
  return all;
}

const Description& description_of(const SafetyLimits* /*of*/) {
  using S = SafetyLimits;
  static const Description all =
      Describe<S>("mpc", "SafetyLimits",
                  "Limits beyond which a controller raises a fault, in every task. A task may "
                  "have further limits. An infinite limit is never exceeded.")
          .field("joint_speed_ratio", &S::joint_speed_ratio,
                 "Largest joint speed, as a multiple of the robot's velocity limit",
                 {.least = 0, .open = true, .infinite = true})
          .field("joint_margin", &S::joint_margin,
                 "Largest distance of a joint beyond its position limit [{rad}]",
                 {.least = 0})
          .more("For prismatic joints the unit is m")
          .field("stale", &S::stale,
                 "Longest time without a new measurement [{s}]",
                 {.least = 0, .open = true, .infinite = true})
          .more("The time must be longer than the tick period")
          .field("bad", &S::bad,
                 "Longest time with invalid measurements [{s}]",
                 {.least = 0, .open = true, .infinite = true})
          .more("During this time, the feedback policy continues from the last valid measurement")
          .field("failed_solves", &S::failed_solves,
                 "Number of failed solves in a row that raises a fault",
                 {.least = 1})
          .more("A failed first solve raises a fault at once")
          .field("deadline", &S::deadline,
                 "Longest computing time of a plan, as wall-clock time [{s}]",
                 {.least = 0, .infinite = true})
          .more("The first plan, which is computed at rest, may take longer")
          .field("late_solves", &S::late_solves,
                 "Number of late plans in a row that raises a fault",
                 {.least = 1})
          .more("A plan is late if its computing time exceeds `deadline`")
          .field("base_lost", &S::base_lost,
                 "Longest time without a position estimate of a floating base [{s}]",
                 {.least = 0, .open = true, .infinite = true})
          .field("support_slip", &S::support_slip,
                 "Largest sliding distance of a foot along the ground within about a second [{m}]",
                 {.least = 0, .open = true, .infinite = true})
          .field("torque_gap", &S::torque_gap,
                 "Largest torque error of a motor, as a fraction of its effort limit",
                 {.least = 0, .open = true, .infinite = true})
          .more("The torque error is the difference between measured and commanded torque, as a "
                "mean over 30 ms. Beyond the limit, the motor counts as failed. While a motor "
                "delivers less than a fifth of its command, the limit is multiplied by 0.6. A "
                "difference of more than 0.4 times the limit counts then after 0.1 s. A finite "
                "limit requires measured torques");
  return all;
}

const Description& description_of(const Fallback* /*of*/) {
  using S = Fallback;
  static const Description all =
      Describe<S>("mpc", "Fallback",
                  "Virtual spring and damper in each joint, to stop and hold the robot after a "
                  "fault. The torque of the actuated joints is tau = b(q, 0) - M (stiffness e + "
                  "damping v), clipped to the effort limits. M is the mass matrix, b(q, 0) the "
                  "gravity torque, v the joint velocity and e = q (-) q_hold the spring "
                  "deflection. q_hold is the configuration at the fault. If the spring torque of "
                  "a joint would exceed `saturation_fraction` times its effort limit, q_hold "
                  "follows the robot.")
          .field("stiffness", &S::stiffness,
                 "Ratio of spring stiffness to mass matrix (0: no spring, only the damper) "
                 "[{1/s^2}]",
                 {.least = 0})
          .field("damping", &S::damping,
                 "Ratio of damping to mass matrix [{1/s}]",
                 {.least = 0})
          .field("saturation_fraction", &S::saturation_fraction,
                 "Largest spring torque, as a fraction of a joint's effort limit",
                 {.least = 0, .most = 1});
  return all;
}

const Words& words_of(PlanTiming /*of*/) {
  static const Words all{
      "mpc",
      "PlanTiming",
      "Time at which a newly computed plan replaces the previous one.",
      {{"fixed", "A plan comes into use solver_delay seconds after the measurement from which it is "
        "computed"},
       {"measured", "A plan comes into use when its measured computing time has passed in simulated time"},
       {"thread", "A plan comes into use as soon as a background thread has computed the plan"}}};
  return all;
}

const Description& description_of(const ToolSpec* /*of*/) {
  using S = ToolSpec;
  static const Description all =
      Describe<S>("mpc", "ToolSpec",
                  "Tool of a controller, which presses on a surface.")
          .field("frame", &S::frame,
                 "Frame of the tool")
          .field("base", &S::base,
                 "Robot frame that carries the surface, such as a hand that holds a plate; empty:"
                 " the world")
          .more("The reaction to the force on the tool acts on this frame")
          .field("normal_base", &S::normal_base,
                 "Normal of the surface that the tool presses on, in the axes of `base` (world "
                 "axes if `base` is empty)")
          .more("The normal points towards the robot; its length has no effect. Estimates use "
                "this normal until MpcTask::surface() returns a surface. Contacts do not use it: "
                "state their normal in ContactSpec.reference")
          .field("contact_threshold", &S::contact_threshold,
                 "Normal force above which the tool counts as in contact [{N}]",
                 {.least = 0})
          .field("friction", &S::friction,
                 "Estimation of the friction coefficient")
          .more("Contacts between `frame` and `base` that have ContactSpec.friction use the "
                "estimate");
  return all;
}

const Description& description_of(const MpcSpec* /*of*/) {
  using S = MpcSpec;
  static const Description all =
      Describe<S>("mpc", "MpcSpec",
                  "Specification of a model predictive controller. The controller repeatedly "
                  "solves an optimal control problem over a moving horizon from the measured "
                  "state. Between solves, the controller applies the feedback policy of the last "
                  "solution.")
          .field("problem", &S::problem,
                 "Optimal control problem: model, stages, costs and horizon")
          .more("The schedule selects the stage of each knot. The segments of the horizon define "
                "only the number of knots and their steps")
          .required()
          .field("schedule", &S::schedule)
          .field("task", &S::task,
                 "Function that creates the task, which defines events and monitored quantities; "
                 "none: no task")
          .field("tools", &S::tools,
                 "Tools that press on surfaces; none: the robot has no tool")
          .field("supports", &S::supports,
                 "Names of the contacts that the robot stands on or leans against")
          .more("The fallback and the estimators use the supports that are in contact in every "
                "stage. A robot with a floating base needs at least one such support. Supports "
                "that are in contact only in some stages, such as hands on a wall, require a "
                "sensor (`touches`)")
          .field("resting_supports", &S::resting_supports,
                 "Entries of `supports` that press with a planned force, such as a hand on a "
                 "table")
          .more("The fallback does not use these supports, even if they are in contact in every "
                "stage, because the fallback would load a hand like a foot. These supports "
                "require a sensor (`touches`)")
          .field("touches", &S::touches,
                 "Sensors of tools, feet and hands that the controller reads")
          .more("Measurement.wrenches has one column per entry, in this order. A tool without an "
                "entry is assumed to have a force sensor; its column comes before those of the "
                "entries. A NaN in a component that the controller reads makes the measurement "
                "invalid. If the entry of the only tool states the sensor `none`, the force on "
                "the tool is estimated from the change of the torque error at contact. This "
                "estimate requires that model_error.kind is `torque`. With a sensor at each "
                "support, torque errors are estimated in all joints, including the joints of "
                "supporting legs. If only some supports have sensors, the others count as rigid "
                "contacts. A support whose rotation is free, such as a point foot, needs no "
                "sensor of moments")
          .field("tick_period", &S::tick_period,
                 "Time between ticks [{s}]")
          .field("update_period", &S::update_period,
                 "Time between solves, a multiple of the tick period [{s}]")
          .field("settle", &S::settle,
                 "Time before the first plan during which the fallback holds the robot in place "
                 "[{s}]",
                 {.least = 0})
          .more("The estimators settle during this time. The schedule begins afterwards")
          .field("timing", &S::timing,
                 "Rule for when a new plan comes into use: `fixed`, `measured` or `thread`")
          .field("solver_delay", &S::solver_delay,
                 "Time from a measurement to the use of the plan computed from that measurement "
                 "[{s}]")
          .more("If `timing` is `fixed`, the delay is at most the update period. The new plan "
                "starts from the state that is predicted for the end of the delay under the "
                "current policy")
          .field("command_delay", &S::command_delay,
                 "Assumed delay from a torque command to the torque in the joint, rounded to "
                 "ticks [{s}]")
          .more("The state at the end of the delay is predicted from the torques already sent. "
                "Plans and feedback start from the predicted state. The model error is estimated "
                "from the torque that acted at the time of the measurement")
          .field("measurement_delay", &S::measurement_delay,
                 "Assumed delay from a measurement to the tick that receives it [{s}]")
          .more("The controller predicts the state over the sum of both delays, command_delay and"
                " measurement_delay. Measurement.time must be the time of the receiving tick")
          .field("slowdown", &S::slowdown,
                 "Factor on measured computing times, to simulate a slower computer")
          .more("The factor is used only if `timing` is `measured`")
          .field("solver", &S::solver)
          .field("first_iterations", &S::first_iterations,
                 "Maximum number of iterations of the first solve")
          .field("jump_iterations", &S::jump_iterations,
                 "Maximum number of iterations of a solve right after the schedule's clock jumped"
                 " or waited")
          .field("max_factorizations", &S::max_factorizations,
                 "Maximum number of Riccati recursions per iteration if the problem has "
                 "constraints")
          .more("The number of sweeps that reuse a factorization has the same maximum. The "
                "entries max_factorizations, max_sweeps and max_l1_weight of solver.limits are "
                "ignored")
          .field("first_max_factorizations", &S::first_max_factorizations,
                 "Maximum number of Riccati recursions per iteration in the first solve")
          .more("This maximum is also used in a solve right after the schedule's clock jumped or "
                "waited")
          .field("torque_limit", &S::torque_limit,
                 "Additional limits on the commanded torques, nv entries [{Nm (N)}]; empty: no "
                 "additional limits")
          .more("The robot's effort limits always apply. The fallback uses only the effort limits")
          .field("model_error", &S::model_error)
          .field("slip", &S::slip,
                 "Reaction of plans to slipping supports")
          .field("limits", &S::limits)
          .field("fallback", &S::fallback)
          .field("feedback", &S::feedback,
                 "Apply the Riccati feedback policy between solves; if false, the planned torque "
                 "is held");
  return all;
}

const Description& description_of(const SchedulePhase* /*of*/) {
  using S = SchedulePhase;
  static const Description all =
      Describe<S>("mpc", "SchedulePhase",
                  "Phase of a task. A schedule is a sequence of phases.")
          .field("name", &S::name,
                 "Name of the phase, such as \"approach\"")
          .field("stage", &S::stage,
                 "Name of the stage of the optimal control problem that is used in the phase")
          .field("duration", &S::duration,
                 "Duration of the phase [{s}]")
          .more("Only the last phase may have an infinite duration")
          .field("until", &S::until,
                 "Event that ends the phase, such as \"contact\"; empty: the phase ends after its"
                 " duration")
          .more("If the event is early, the schedule's clock jumps to the end of the phase. If "
                "the event is late, the clock stops at the time `hold` before the end of the "
                "phase and waits. Plans made while the clock waits contain the rest of this phase"
                " and then the next phase. The last phase ignores its event")
          .field("hold", &S::hold,
                 "Time before the end of the phase at which the schedule's clock waits for a late"
                 " event [{s}]")
          .more("If `hold` is longer than the phase, the clock waits at the start of the phase");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
