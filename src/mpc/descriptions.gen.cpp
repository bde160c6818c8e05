// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "mpc/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Description& description_of(const Measurement* /*of*/) {
  using S = Measurement;
  static const Description all =
      Describe<S>("mpc", "Measurement",
                  "What the sensors say at a tick.")
          .field("time", &S::time,
                 "{s}")
          .field("q", &S::q,
                 "nq")
          .field("v", &S::v,
                 "nv")
          .field("tau", &S::tau,
                 "nv, of the torque sensors between motor and link, Nm or N")
          .field("tool_force_world", &S::tool_force_world,
                 "Of the force sensor: the surface's force on the tool, N, world axes.")
          .field("imu", &S::imu,
                 "of the robot's inertial measurement unit, if it has one")
          .field("support_wrenches", &S::support_wrenches,
                 "of the sensors in what the robot stands on: force and moment of the ground on "
                 "each support, N and Nm, at the origin of its frame, in the frame's axes; 6 x "
                 "supports, or empty: not measured")
          .field("base_lost_for", &S::base_lost_for,
                 "{s} since nothing tells where a floating base is, whose entries of q and v are "
                 "old; 0: it is told");
  return all;
}

const Description& description_of(const Command* /*of*/) {
  using S = Command;
  static const Description all =
      Describe<S>("mpc", "Command",
                  "What a controller sends. Only `tau` reaches the plant; the rest says what the "
                  "controller aims at and how it fares, for the record.")
          .field("tau", &S::tau,
                 "nv, Nm or N; zero for a floating base")
          .field("phase", &S::phase,
                 "where the task stands: of an MpcController, its place in the schedule")
          .field("target_force", &S::target_force,
                 "{N}, how hard the surface shall push back along its normal")
          .field("p_target_world", &S::p_target_world,
                 "{m}, of the tip frame's origin; where a task presses, on the surface as it is "
                 "known")
          .field("normal_world", &S::normal_world,
                 "What the controller believes the surface's normal at the tool to be, world "
                 "axes.")
          .field("force_estimate_world", &S::force_estimate_world,
                 "What the controller believes the surface's force on the tool to be, N, world "
                 "axes.")
          .field("friction", &S::friction,
                 "What it believes the coefficient of friction between tool and surface to be.")
          .field("status", &S::status)
          .field("solve_time", &S::solve_time,
                 "{s} of wall clock, where an optimal control problem was solved")
          .field("iterations", &S::iterations,
                 "of its solver")
          .field("missed_deadline", &S::missed_deadline,
                 "its solution came later than it was due")
          .field("limits_outside", &S::limits_outside,
                 "Of the last plan of a controller that keeps limits: the largest violation of a "
                 "hard one along it, and what was left open when its budget was spent, as shares "
                 "of a limit's scale.")
          .field("limits_open", &S::limits_open)
          .field("limits_pushing", &S::limits_pushing,
                 "limits that push, over all knots")
          .field("limits_infeasible", &S::limits_infeasible,
                 "they cannot all be kept from here on")
          .field("clipped_torques", &S::clipped_torques,
                 "joints whose torque was cut to what may be sent, at this tick");
  return all;
}

const Words& words_of(FaultKind /*of*/) {
  static const Words all{
      "mpc",
      "FaultKind",
      "What can go wrong in a control loop.",
      {{"none"},
       {"stale_measurement", "time does not go on"},
       {"bad_measurement", "NaN, infinite or of the wrong size, for too long"},
       {"out_of_range", "a joint is beyond its position limit"},
       {"solver_failed", "no usable plan for too many updates in a row, or at the first"},
       {"solver_late", "too many updates in a row took longer than their deadline"},
       {"contact_lost", "no force for too long while it is wanted"},
       {"no_contact", "the tool went on too far where the surface was expected"},
       {"contact_late", "the tool took too long to get to the surface"},
       {"unexpected_contact", "a force while the tool moves through free space"},
       {"force_limit", "the tool is pushed harder than allowed"},
       {"speed_limit", "a joint or the tool is faster than allowed"},
       {"support_slipped", "what the robot stands on came away too far"},
       {"motor_lost", "a joint's torque is not what was sent"},
       {"watched", "a quantity of the task, FaultReport.quantity, is beyond its limit"},
       {"base_lost", "nothing tells where a floating base is, for too long"}}};
  return all;
}

const Description& description_of(const FaultReport* /*of*/) {
  using S = FaultReport;
  static const Description all =
      Describe<S>("mpc", "FaultReport",
                  "The first fault of a run, and the ticks that led to it.")
          .field("kind", &S::kind)
          .field("time", &S::time,
                 "{s}, of the measurement, or when it was due if there was none")
          .field("joint", &S::joint,
                 "entry of v that it is about, or -1")
          .field("value", &S::value,
                 "What was measured: s, updates, N, m, m/s, or of a joint rad (m), rad/s and Nm "
                 "(N).")
          .field("limit", &S::limit,
                 "what was allowed, in the same unit")
          .field("quantity", &S::quantity,
                 "of FaultKind::Watched: its name and unit; of SupportSlipped: the support; else "
                 "the part that it is about, such as \"hand 'left'\"; or empty")
          .field("joint_name", &S::joint_name,
                 "of that entry of v; empty: none")
          .field("unit", &S::unit,
                 "of value and limit of a joint; empty: the kind has one")
          .field("cause", &S::cause,
                 "What led to it, as far as measurements tell: clauses, such as \"the force came "
                 "to 1.4 N at most; 2 N count as contact\"; or empty.")
          .field("last_second", &S::last_second,
                 "oldest row first, the fault's tick last; empty while there is no fault");
  return all;
}

const Description& description_of(const LinearFeedback* /*of*/) {
  using S = LinearFeedback;
  static const Description all =
      Describe<S>("mpc", "LinearFeedback",
                  "u = feedforward + gain (x (-) state): the triple that linear feedback "
                  "controllers take.")
          .result()
          .field("feedforward", &S::feedforward,
                 "nu, Nm (N)")
          .field("gain", &S::gain,
                 "nu x ndx: by position, velocity and, with a torque model, torque")
          .field("state", &S::state,
                 "nx, (q, v) or (q, v, tau)");
  return all;
}

const Description& description_of(const FrictionEstimateOptions* /*of*/) {
  using S = FrictionEstimateOptions;
  static const Description all =
      Describe<S>("mpc", "FrictionEstimateOptions",
                  "How the coefficient of friction between a tool and the surface that it slides "
                  "on is estimated: deviations of what is believed at first, and of what is "
                  "measured.")
          .field("enabled", &S::enabled,
                 "estimate it; else what is believed is what is known")
          .field("coefficient", &S::coefficient,
                 "believed at first; plans know friction if that is above 0, or estimated",
                 {.least = 0})
          .field("deviation", &S::deviation,
                 "of that",
                 {.least = 0, .open = true})
          .field("wander", &S::wander,
                 "per square root of a metre of way, by which it changes",
                 {.least = 0})
          .field("force_noise", &S::force_noise,
                 "{N}, of the force along the surface, independent every `noise_time`",
                 {.least = 0, .open = true})
          .field("noise_time", &S::noise_time,
                 "{s}",
                 {.least = 0})
          .field("speed", &S::speed,
                 "{m/s}, below which what is felt may be stiction and tells little",
                 {.least = 0, .open = true});
  return all;
}

const Description& description_of(const GainRange* /*of*/) {
  using S = GainRange;
  static const Description all =
      Describe<S>("mpc", "GainRange",
                  "Factors by which the torque of one joint may be wrong while the others are "
                  "right: 0.1 to 10 were tried.")
          .result()
          .field("joint", &S::joint)
          .field("below", &S::below,
                 "smallest factor")
          .field("above", &S::above,
                 "largest factor");
  return all;
}

const Description& description_of(const LoopMargins* /*of*/) {
  using S = LoopMargins;
  static const Description all =
      Describe<S>("mpc", "LoopMargins",
                  "Stability margins of a controller's loop around an arm.")
          .result()
          .field("delay", &S::delay,
                 "{s}, largest extra command delay at which the loop is stable, up to 0.01; 0: it"
                 " is unstable without any")
          .field("bandwidth", &S::bandwidth,
                 "{rad/s} of the model-error observer for which that delay is smallest")
          .field("gains", &S::gains,
                 "one range per entry of v");
  return all;
}

const Words& words_of(ModelErrorKind /*of*/) {
  static const Words all{
      "mpc",
      "ModelErrorKind",
      "What an MpcController estimates of what its model gets wrong. Both are relative to the "
      "torque that was commanded, so that what actuators get wrong is part of them.",
      {{"none", "nothing: the paper's controller"},
       {"torque", "d in M a + b = tau + J^T f + d, a torque per joint"},
       {"force", "what the measured normal force is above the one that the model predicts"}}};
  return all;
}

const Description& description_of(const ModelErrorOptions* /*of*/) {
  using S = ModelErrorOptions;
  static const Description all =
      Describe<S>("mpc", "ModelErrorOptions",
                  "The constant part of what the model gets wrong, estimated from measurements "
                  "and given back to the model (offset-free model predictive control).")
          .field("kind", &S::kind,
                 "none, torque (per joint) or force (along the normal)")
          .field("bandwidth", &S::bandwidth,
                 "{rad/s} of the observer; a higher one follows friction sooner and tolerates "
                 "less delay; auto: fitted to the arm where a task does that, else 30",
                 {.least = 0, .open = true})
          .in_code("rad/s of the observer; a higher one follows friction sooner and tolerates "
                   "less delay; none: fitted to the arm where a task does that, else 30")
          .more("With kind force the observer closes a loop through the controller, whose delays "
                "bound its bandwidth: behind a force sensor filtered at 50 Hz, 50 rad/s work and "
                "100 rad/s oscillate.")
          .word("auto")
          .field("boost", &S::boost,
                 "factor on the bandwidth while a torque error changes faster than its noise: "
                 "after a push or an impact, or where a joint reverses; 1: no boost; auto: fitted"
                 " to the arm where a task does that, else 3",
                 {.least = 0, .open = true})
          .in_code("factor on the bandwidth while a torque error changes faster than its noise: "
                   "after a push or an impact, or where a joint reverses; 1: no boost; none: "
                   "fitted to the arm where a task does that, else 3")
          .word("auto")
          .field("calm", &S::calm,
                 "factor on the bandwidth while noise alone, such as encoder steps, changes the "
                 "torque error: a slower observer passes less of it on; 1: never",
                 {.least = 0.01, .most = 1})
          .field("lag", &S::lag,
                 "{s} by which measured velocities follow torques later than known delays say, "
                 "behind filters and motors; auto: fitted to the arm where a task does that, else"
                 " 0",
                 {.least = 0})
          .in_code("s by which measured velocities follow torques later than known delays say, "
                   "behind filters and motors; none: fitted to the arm where a task does that, "
                   "else 0")
          .word("auto")
          .field("force_gain", &S::force_gain,
                 "{N} pushed back at once for each N that the measured normal force is off in "
                 "contact, of kind torque with a force sensor; auto: fitted to the arm where a "
                 "task does that, else 0",
                 {.least = 0})
          .in_code("N pushed back at once for each N that the measured normal force is off in "
                   "contact, of kind torque with a force sensor; none: fitted to the arm where a "
                   "task does that, else 0")
          .word("auto")
          .field("sliding_bandwidth", &S::sliding_bandwidth,
                 "{rad/s} of the estimate of friction along the surface, with kind torque; 0: the"
                 " bandwidth",
                 {.least = 0})
          .field("fading", &S::fading,
                 "{s}, decay time that plans assume for a torque error that has just appeared, as"
                 " after a push",
                 {.least = 0, .open = true, .infinite = true})
          .more("Errors that have lasted for some seconds do not decay; infinite: none does.")
          .field("limit", &S::limit,
                 "{Nm (N)}, largest magnitude of an estimate; for a floating base at least 6 % of"
                 " its weight",
                 {.least = 0, .open = true})
          .field("joint_friction", &S::joint_friction,
                 "with kind torque: joint friction is estimated separately and fed forward, so "
                 "that it changes sign as soon as a joint reverses")
          .field("friction_speed", &S::friction_speed,
                 "{rad/s} (m/s) over which that friction changes its sign",
                 {.least = 0, .open = true});
  return all;
}

const Description& description_of(const SafetyLimits* /*of*/) {
  using S = SafetyLimits;
  static const Description all =
      Describe<S>("mpc", "SafetyLimits",
                  "When a run is given up, whatever the task; the task's own limits are its. "
                  "Infinite: never.")
          .field("joint_speed_ratio", &S::joint_speed_ratio,
                 "of the robot's velocity limits",
                 {.least = 0, .open = true, .infinite = true})
          .field("joint_margin", &S::joint_margin,
                 "{rad} that a joint may be beyond its limit",
                 {.least = 0})
          .more("m of prismatic joints")
          .field("stale", &S::stale,
                 "{s} without a new measurement",
                 {.least = 0, .open = true, .infinite = true})
          .more("longer than a tick")
          .field("bad", &S::bad,
                 "{s} of measurements that are no state",
                 {.least = 0, .open = true, .infinite = true})
          .more("which the last good one bridges")
          .field("failed_solves", &S::failed_solves,
                 "in a row",
                 {.least = 1})
          .more("the first solve may not fail")
          .field("deadline", &S::deadline,
                 "{s} of computing time per plan",
                 {.least = 0, .infinite = true})
          .more("of wall clock; the first one, made at rest, may take longer")
          .field("late_solves", &S::late_solves,
                 "in a row",
                 {.least = 1})
          .field("base_lost", &S::base_lost,
                 "{s} without anything that tells where a floating base is",
                 {.least = 0, .open = true, .infinite = true})
          .field("support_way", &S::support_way,
                 "{m} along the ground that a foot may have slid within the last second, about",
                 {.least = 0, .open = true, .infinite = true})
          .field("torque_gap", &S::torque_gap,
                 "of a joint's effort limit, that the measured torque may be off the commanded "
                 "one, mean over 30 ms: a motor that fails",
                 {.least = 0, .open = true, .infinite = true})
          .in_code("of a joint's effort limit, that the measured torque may be off the commanded "
                   "one, mean over 30 ms: a motor that fails; 0.6 of that where it gives less "
                   "than a fifth of what it is told. For measurements that have torques.");
  return all;
}

const Description& description_of(const SlipOptions* /*of*/) {
  using S = SlipOptions;
  static const Description all =
      Describe<S>("mpc", "SlipOptions",
                  "What plans make of a support that holds always and slips all the same: they "
                  "keep its forces within what it was felt to bear while it did, or, where that "
                  "is not measured, within the least. It slips while it bears `load`, has slid by"
                  " `way` along the ground within the last second and goes on faster than "
                  "`speed`.")
          .field("enabled", &S::enabled,
                 "plans are told of feet that slip")
          .field("way", &S::way,
                 "{m}",
                 {.least = 0})
          .field("speed", &S::speed,
                 "{m/s}, mean over 5 ms",
                 {.least = 0})
          .field("load", &S::load,
                 "{N}",
                 {.least = 0})
          .field("share", &S::share,
                 "of what was felt, that plans keep within",
                 {.least = 0, .most = 1})
          .field("least", &S::least,
                 "coefficient of friction that plans are always left",
                 {.least = 0, .open = true})
          .field("easing", &S::easing,
                 "{s} in which they are told, twice that where it is not measured: what changes "
                 "at once has no good plan",
                 {.least = 0})
          .field("recovery", &S::recovery,
                 "{1/s}, coefficient by which they trust it again while it rests",
                 {.least = 0})
          .field("radius", &S::radius,
                 "{m}, of supports that are balls: that they roll is no slip",
                 {.least = 0});
  return all;
}

const Description& description_of(const Fallback* /*of*/) {
  using S = Fallback;
  static const Description all =
      Describe<S>("mpc", "Fallback",
                  "How the robot is brought to rest after a fault, and held there: tau = b(q, 0) "
                  "- M (stiffness e + damping v) on the actuated joints, e = q (-) q_hold, within"
                  " the torque limits. q_hold is where the robot was at the fault, and slips "
                  "where the spring would use more than `give` of a joint's effort limit.")
          .field("stiffness", &S::stiffness,
                 "{1/s^2}, times the mass matrix; 0: nothing holds, the arm is braked only",
                 {.least = 0})
          .field("damping", &S::damping,
                 "{1/s}, times the mass matrix",
                 {.least = 0})
          .field("give", &S::give,
                 "of the torque limits, where the spring slips; 0 to 1",
                 {.least = 0, .most = 1});
  return all;
}

const Words& words_of(PlanTiming /*of*/) {
  static const Words all{
      "mpc",
      "PlanTiming",
      "When a plan is used, that takes time to be made.",
      {{"fixed", "solver_delay after the measurement that it starts from"},
       {"measured", "when it would be done: the time that it took passes, as measured, while the plan before "
        "goes on; for simulations"},
       {"thread", "when it is done: plans are made in a thread of their own"}}};
  return all;
}

const Description& description_of(const MpcSpec* /*of*/) {
  using S = MpcSpec;
  static const Description all =
      Describe<S>("mpc", "MpcSpec",
                  "Model predictive control of a task: a horizon that moves with time, solved "
                  "again and again from the measured state, and its policy in between.")
          .field("problem", &S::problem,
                 "Horizon, stages, costs. The schedule replaces the horizon's stages, so its "
                 "segments matter for the number of knots and their steps alone.")
          .required()
          .field("schedule", &S::schedule)
          .field("task", &S::task,
                 "events of the schedule, what is watched; none: neither")
          .field("tool", &S::tool,
                 "frame that Measurement::tool_force_world acts at")
          .field("base", &S::base,
                 "frame that the surface moves with, which the force on the tool pushes back at: "
                 "of the robot, as a plate in its other hand; empty: the world")
          .field("normal_world", &S::normal_world,
                 "That the tool presses along: of the surface, towards the robot. Friction is "
                 "across it. In the axes of `base`, with which it turns.")
          .field("supports", &S::supports,
                 "Contacts of the problem that the robot stands on or leans against, by their "
                 "names. Those of every stage are what the fallback and the estimates take to "
                 "hold always: a base that floats free wants some. Those of some stages, such as "
                 "hands on a wall, want support_sensors.")
          .field("support_sensors", &S::support_sensors,
                 "Measurement.support_wrenches are measured, in the order of `supports`: then the"
                 " torque error is known of all joints, of those on supports too")
          .field("force_sensor", &S::force_sensor,
                 "Measurement.tool_force_world is measured; else the force at the tool is what "
                 "torques, positions and velocities say beyond what they said in the air just "
                 "before, which wants model_error.kind torque")
          .field("contact_threshold", &S::contact_threshold,
                 "{N} along the normal that count as contact")
          .field("tick_period", &S::tick_period,
                 "{s}")
          .field("update_period", &S::update_period,
                 "{s} between solves, a multiple of the tick")
          .field("settle", &S::settle,
                 "{s} before the first plan in which the fallback holds the robot where it is, so"
                 " that what estimates comes to rest; the schedule begins after it",
                 {.least = 0})
          .field("timing", &S::timing,
                 "fixed, measured or thread")
          .field("solver_delay", &S::solver_delay,
                 "{s} from a measurement to the use of the plan that starts from it, at most the "
                 "update period. The plan is made for the state that the policy in use leads to "
                 "by then.")
          .field("command_delay", &S::command_delay,
                 "{s} from a command to the torque that it makes, as far as it is known; rounded "
                 "to ticks. Plans begin in the state that the torques already sent lead to, "
                 "feedback acts on that state at every tick, and the model error is told from the"
                 " torque that acted when it was measured.")
          .field("measurement_delay", &S::measurement_delay,
                 "{s} from what is measured to the tick that has it, all but its time, as far as "
                 "it is known; see command_delay")
          .field("slowdown", &S::slowdown,
                 "of measured timing: a machine by this factor slower")
          .field("solver", &S::solver)
          .field("first_iterations", &S::first_iterations,
                 "of the first solve")
          .field("jump_iterations", &S::jump_iterations,
                 "of one after the schedule's clock jumped or stood still")
          .field("max_factors", &S::max_factors,
                 "recursions per iteration where the problem has limits, and at most as many "
                 "sweeps with kept factors; those of solver.limits, and its largest_price, mean "
                 "nothing here")
          .field("first_factors", &S::first_factors,
                 "likewise of the first solve, and of one after a jump")
          .field("torque_limit", &S::torque_limit,
                 "{Nm} (N), nv: what is sent stays within, and within the robot's effort limits; "
                 "empty: those")
          .field("model_error", &S::model_error)
          .field("friction_estimate", &S::friction_estimate,
                 "Of the tool's contacts with friction (ContactSpec.friction): their coefficient.")
          .field("slip", &S::slip,
                 "of what the robot stands on")
          .field("limits", &S::limits)
          .field("fallback", &S::fallback)
          .field("feedback", &S::feedback,
                 "the Riccati policy between solves; without, the planned torque is held");
  return all;
}

const Description& description_of(const SurfaceEstimateOptions* /*of*/) {
  using S = SurfaceEstimateOptions;
  static const Description all =
      Describe<S>("pressing", "SurfaceEstimateOptions",
                  "How the surface under a sliding tool is estimated from the tool's own path: "
                  "deviations of what is believed at first, and of what is measured.")
          .field("enabled", &S::enabled,
                 "estimate it; else what is believed is what is known")
          .field("height", &S::height,
                 "{m}, of the surface",
                 {.least = 0, .open = true})
          .field("tilt", &S::tilt,
                 "{rad}, of the normal about each tangent",
                 {.least = 0, .open = true})
          .field("curvature", &S::curvature,
                 "{1/m}, and a quarter of what the surface is believed to bend by",
                 {.least = 0, .open = true})
          .field("bend_change", &S::bend_change,
                 "{1/m} per square root of a metre of way, by which curvatures wander",
                 {.least = 0, .open = true})
          .field("position_noise", &S::position_noise,
                 "{m}, of the tip's position along the normal, beside what differs from tick to "
                 "tick, which is found out",
                 {.least = 0, .open = true})
          .field("noise_length", &S::noise_length,
                 "{m} of way after which that noise is another: an encoder's step seen from the "
                 "tip",
                 {.least = 0, .open = true})
          .field("force_noise", &S::force_noise,
                 "{N}, of the force along the normal",
                 {.least = 0, .open = true})
          .field("compliance", &S::compliance,
                 "{m/N}, of the surface under the tip",
                 {.least = 0, .open = true})
          .field("rate", &S::rate,
                 "{m/s}, of the surface along its normal; 0: it stands. What may move is told "
                 "from a slope only once the tip has turned",
                 {.least = 0});
  return all;
}

const Description& description_of(const SchedulePhase* /*of*/) {
  using S = SchedulePhase;
  static const Description all =
      Describe<S>("mpc", "SchedulePhase",
                  "One of the phases that follow each other in a schedule.")
          .field("name", &S::name,
                 "such as \"approach\"")
          .field("stage", &S::stage,
                 "of the optimal control problem")
          .field("duration", &S::duration,
                 "{s}; infinite for the last one only")
          .field("until", &S::until,
                 "Event, such as \"contact\", that ends it, and not before; empty: its duration "
                 "does. When the event is early, the clock jumps to the end; when it is late, the"
                 " clock stands still `hold` s before it, so that the horizon goes on with the "
                 "phase and plans the next one soon. Of the last phase it means nothing.")
          .field("hold", &S::hold,
                 "{s}; longer than the phase: the clock stands still at its start");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
