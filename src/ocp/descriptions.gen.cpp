// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "ocp/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Description& description_of(const ProblemCheckOptions* /*of*/) {
  using S = ProblemCheckOptions;
  static const Description all =
      Describe<S>("ocp", "ProblemCheckOptions",
                  "Options of check_problem(): the random states, and the largest accepted error "
                  "of a derivative.")
          .field("states", &S::states,
                 "Number of random states per stage, at least 1")
          .field("seed", &S::seed,
                 "Seed of the random states; equal seeds give equal states on every machine")
          .field("tolerance", &S::tolerance,
                 "Largest accepted error of a derivative, relative to the largest entry of its "
                 "block")
          .more("The error is |derivative - finite difference|. An example of a block is dnext_dq")
          .field("x", &S::x,
                 "States around which random states are drawn; empty: the initial state at every "
                 "knot")
          .more("One state per knot: N + 1 vectors of nx entries")
          .field("u", &S::u,
                 "Controls around which random controls are drawn; empty: controls that hold the "
                 "robot at rest")
          .more("N vectors of nu entries. Vectors for impacts are ignored")
          .field("position", &S::position,
                 "Largest random change of a position, uniformly distributed [rad, m]")
          .more("For lengths, the value is multiplied by the robot's size in m, rounded to a "
                "power of ten")
          .field("velocity", &S::velocity,
                 "Largest random change of a velocity [{rad/s}], or in m/s")
          .field("torque", &S::torque,
                 "Largest random change of a control or of a torque in the state [{Nm}], or in N")
          .more("The value is for a robot of 20 kg and 1 m. For other robots, it is scaled with "
                "the robot's weight. In Nm, it is also scaled with the robot's size")
          .field("progress", &S::progress,
                 "Function called after each stage, with the number of finished stages and the "
                 "number of all stages.");
  return all;
}

const Description& description_of(const ProblemCheckRow* /*of*/) {
  using S = ProblemCheckRow;
  static const Description all =
      Describe<S>("ocp", "ProblemCheckRow",
                  "Result of check_problem() for one function of one stage, over all random "
                  "states of the stage. The function is the next state, one term, or the sum of "
                  "the costs.")
          .result()
          .field("stage", &S::stage)
          .field("term", &S::term,
                 "\"next state\", \"all costs\", or the name of a cost term or a constraint")
          .field("states", &S::states,
                 "Number of states at which the derivatives were compared")
          .field("worst_error", &S::worst_error,
                 "Largest error, relative to the largest entry of the derivative block; infinite "
                 "if a NaN occurred")
          .field("worst", &S::worst,
                 "Entry with the largest error, in a derivative block such as \"dnext_dq\", "
                 "\"dr_du\" or \"dcost_dv\"")
          .field("pass_", &S::pass,
                 "True if worst_error <= tolerance");
  return all;
}

const Description& description_of(const ProblemReport* /*of*/) {
  using S = ProblemReport;
  static const Description all =
      Describe<S>("ocp", "ProblemReport",
                  "Result of check_problem().")
          .result()
          .field("robot", &S::robot)
          .field("rows", &S::rows)
          .field("tolerance", &S::tolerance)
          .field("pass_", &S::pass,
                 "True if there is at least one row and every row passes");
  return all;
}

const Words& words_of(InputKind /*of*/) {
  static const Words all{
      "ocp",
      "InputKind",
      "Kind of value that an input of a problem can have.",
      {{"scalar", "A number"},
       {"vector", "Several numbers"},
       {"rotation", "A unit quaternion x, y, z, w"},
       {"surface", "A curved surface, and the depth by which it yields along its normal"},
       {"inertia", "The inertia of a payload that the robot carries at `frame`"}}};
  return all;
}

const Description& description_of(const InputSpec* /*of*/) {
  using S = InputSpec;
  static const Description all =
      Describe<S>("ocp", "InputSpec",
                  "Input of a problem: a named value to which costs, constraints and contacts "
                  "refer. Estimators and tasks set the value between solves. An input changes "
                  "values only: terms, rows and contacts stay the same.")
          .field("name", &S::name,
                 "Unique name")
          .required()
          .field("kind", &S::kind)
          .field("value", &S::value,
                 "Value until Problem::set_input() sets one: constant, or a function of time; "
                 "empty: none")
          .more("While an input has no value, its uses keep the values of the specification. A "
                "vector needs this value, because the value defines the number of entries. A "
                "surface or an inertia cannot have this value")
          .field("frame", &S::frame,
                 "Frame of the robot that carries the payload; required for an inertia, empty for"
                 " other kinds");
  return all;
}

const Description& description_of(const StateLayout* /*of*/) {
  using S = StateLayout;
  static const Description all =
      Describe<S>("ocp", "StateLayout",
                  "Sizes of the parts of the state and the control, and the first column of each "
                  "part in z = (du, dq, dv, dtau, dforce).")
          .field("nq", &S::nq)
          .field("nv", &S::nv)
          .field("filtered", &S::filtered,
                 "Number of torques in the state: nu with a torque model, else 0")
          .field("holds_torque", &S::holds_torque,
                 "True if the torques in the state are the control of the previous step; the "
                 "current control then acts on the robot")
          .field("force_states", &S::force_states,
                 "Number of contact forces in the state; they are forces of the previous step (N,"
                 " Nm)")
          .field("nu", &S::nu)
          .field("actuated", &S::actuated,
                 "For each control, the index in v of the entry that the control drives");
  return all;
}

const Description& description_of(const Problem::QuasiStatic* /*of*/) {
  using S = Problem::QuasiStatic;
  static const Description all =
      Describe<S>("ocp", "QuasiStatic",
                  "Control and contact forces that hold a posture at rest.")
          .result()
          .field("control", &S::control,
                 "Control, nu entries, Nm")
          .field("force", &S::force,
                 "Forces, one entry per row of the stage's contacts, N and Nm")
          .field("residual", &S::residual,
                 "Largest joint torque that remains unbalanced, Nm");
  return all;
}

const Description& description_of(const Penalty* /*of*/) {
  using S = Penalty;
  static const Description all =
      Describe<S>("ocp", "Penalty",
                  "Penalty function phi that turns each entry r of a residual into a cost.")
          .field("kind", &S::kind)
          .field("lower", &S::lower,
                 "Lower limits of a barrier, in the residual's unit; empty: no lower limit")
          .more("One number for all rows, or one number per row. Infinite for a row without a "
                "lower limit")
          .number_too()
          .field("upper", &S::upper,
                 "Upper limits of a barrier, in the residual's unit; empty: no upper limit")
          .more("One number for all rows, or one number per row. Infinite for a row without an "
                "upper limit")
          .number_too()
          .field("width", &S::width,
                 "Width of the penalties smooth_absolute and log_barrier, in the residual's unit,"
                 " positive");
  return all;
}

const Words& words_of(Penalty::Kind /*of*/) {
  static const Words all{
      "ocp",
      "PenaltyKind",
      "Form of phi(r) for one residual entry r. All forms are convex, so that Gauss-Newton "
      "Hessians are positive semidefinite.",
      {{"quadratic", "r^2 / 2"},
       {"barrier", "Half the squared distance of r from the interval [lower, upper]; zero inside"},
       {"smooth_absolute", "sqrt(r^2 + width^2) - width. Approximately |r| for large |r|, and r^2 / (2 width) for "
        "small |r|"},
       {"log_barrier", "Sum of the costs of the lower and the upper limit. Let s be the distance of r from a "
        "limit, negative beyond the limit. For s > width, a limit costs -log(s / width). "
        "Otherwise, it costs ((s / width - 2)^2 - 1) / 2, a parabola that continues the logarithm"
        " smoothly"}}};
  return all;
}

const Description& description_of(const CostTerm* /*of*/) {
  using S = CostTerm;
  static const Description all =
      Describe<S>("ocp", "CostTerm",
                  "A cost term: weight * sum over rows i of weights_i phi(r_i), with the penalty "
                  "phi of residual r. If the knot has a duration, the term is multiplied by the "
                  "duration. The sum over all knots then approximates an integral over time.")
          .field("residual", &S::residual)
          .required()
          .field("weight", &S::weight,
                 "Weight of the term, not negative")
          .more("The unit is 1 / (unit of phi). If the knot has a duration, the unit is 1 / (unit"
                " of phi) per second")
          .field("name", &S::name,
                 "Name of the term, unique in its stage; empty: the name of the residual")
          .field("weights", &S::weights,
                 "Weights of the rows, not negative; empty: 1 for every row")
          .field("penalty", &S::penalty,
                 "Penalty of each row; empty: the default penalty of the residual, usually "
                 "quadratic")
          .field("offset_input", &S::offset_input,
                 "Name of the input whose value is added to the target; empty: none")
          .more("A scalar or vector input needs as many entries as the target. Exception: a "
                "vector of 3 entries moves the position of a target pose. A rotation input turns "
                "a target rotation or pose about the target's own axes")
          .field("friction_ratio_input", &S::friction_ratio_input,
                 "Name of the scalar input that multiplies the friction coefficient; empty: none")
          .more("The value is at least 0; values above 1 count as 1. The residual must be a "
                "friction cone, or a centre of pressure with friction")
          .field("surface_input", &S::surface_input,
                 "Name of the input whose surface replaces the surface of the residual's "
                 "reference; empty: none")
          .more("If the reference follows no surface, the residual needs a target position. This "
                "position then moves into the surface along the normal, by the depth of the input");
  return all;
}

const Description& description_of(const Constraint* /*of*/) {
  using S = Constraint;
  static const Description all =
      Describe<S>("ocp", "Constraint",
                  "A constraint lower <= r_i <= upper on every row i of a residual. Equal limits "
                  "make an equality constraint. A constraint is hard, or soft with a penalty for "
                  "violations.")
          .field("residual", &S::residual)
          .required()
          .field("name", &S::name,
                 "Name of the constraint, unique among the stage's terms; empty: the name of the "
                 "residual")
          .field("lower", &S::lower,
                 "Lower limits in the residual's unit: one number, or one per row; empty: no "
                 "lower limit")
          .more("A constraint needs a lower or an upper limit. Exceptions are margins (friction "
                "cone, center of pressure, support), which need no limits. Their rows must then "
                "be at least zero")
          .number_too()
          .field("upper", &S::upper,
                 "Upper limits in the residual's unit: one number, or one per row; empty: no "
                 "upper limit")
          .number_too()
          .field("scale", &S::scale,
                 "Characteristic size of each row, in its unit: one number, or one per row; "
                 "empty: automatic")
          .more("If both limits exist and differ, the automatic size is half their difference. "
                "Otherwise it depends on the residual. For forces, it is the robot's weight. For "
                "torque rates, it is torque limit times cut-off. For distances, it is the limit "
                "itself, if above zero. For support margins, it is half the width of the polygon."
                " For other residuals, it is the robot's own limit of the quantity. If none of "
                "these exists, the size must be stated")
          .number_too()
          .field("l1_weight", &S::l1_weight,
                 "L1 penalty weight of violations (infinite: hard) in cost per unit of the row",
                 {.least = 0, .infinite = true})
          .more("A violation v at a knot costs l1_weight |v| + 1/2 quadratic_weight v^2. This "
                "cost is not multiplied by the duration of the knot. Violations therefore cost "
                "less if the same horizon is divided into fewer, longer knots")
          .field("quadratic_weight", &S::quadratic_weight,
                 "Quadratic penalty weight of violations, in cost per squared row unit",
                 {.least = 0})
          .field("offset_input", &S::offset_input,
                 "Name of the input whose value is added to the target; empty: none")
          .more("A scalar or vector input needs as many entries as the target. Exception: a "
                "vector of 3 entries moves the position of a target pose. A rotation input turns "
                "a target rotation or pose about the target's own axes")
          .field("friction_ratio_input", &S::friction_ratio_input,
                 "Name of the scalar input that multiplies the friction coefficient; empty: none")
          .more("The value is at least 0; values above 1 count as 1. The residual must be a "
                "friction cone, or a centre of pressure with friction")
          .field("surface_input", &S::surface_input,
                 "Name of the input whose surface replaces the surface of the residual's "
                 "reference; empty: none")
          .more("If the reference follows no surface, the residual needs a target position. This "
                "position then moves into the surface along the normal, by the depth of the input");
  return all;
}

const Words& words_of(Integrator /*of*/) {
  static const Words all{
      "ocp",
      "Integrator",
      "Integration scheme from one knot to the next.",
      {{"semi_implicit_euler", "v' = v + step a(q, v, tau), q' = q (+) step v'"},
       {"runge_kutta4", "Classical Runge-Kutta with constant control; costs are evaluated at the start of the "
        "step"}}};
  return all;
}

const Description& description_of(const TorqueModel* /*of*/) {
  using S = TorqueModel;
  static const Description all =
      Describe<S>("ocp", "TorqueModel",
                  "Actuator model: each torque follows its control through a first-order low-pass"
                  " filter, dtau/dt = cutoff (u - tau). The torques become part of the state.")
          .field("cutoff", &S::cutoff,
                 "Cut-off frequency of the low-pass filter [{rad/s}]")
          .field("discretization", &S::discretization);
  return all;
}

const Words& words_of(TorqueModel::Discretization /*of*/) {
  static const Words all{
      "ocp",
      "Discretization",
      "Discretization of the low-pass filter over one step.",
      {{"exact", "A step multiplies the torque error u - tau by exp(-cutoff step)"},
       {"euler", "A step multiplies the torque error u - tau by 1 - cutoff step"},
       {"held", "No filter: tau in the state is the control of the previous step, and the current control"
        " acts on the robot"}}};
  return all;
}

const Description& description_of(const ActuationSpec* /*of*/) {
  using S = ActuationSpec;
  static const Description all =
      Describe<S>("ocp", "ActuationSpec",
                  "Driven joints of the robot, and whether passive joint torques act.")
          .field("joints", &S::joints,
                 "Names of the driven joints; empty: automatic")
          .more("Automatic: every joint except a free-flying base. For robots with loops: every "
                "joint with a motor, which is a joint with an effort limit above zero")
          .field("passive_torques", &S::passive_torques,
                 "Whether damping, smoothed friction, springs and tendons of the model act on the"
                 " joints")
          .field("slip_velocity", &S::slip_velocity,
                 "Speed at which smoothed joint friction reaches 76 % of its full size [{rad/s}],"
                 " or in m/s");
  return all;
}

const Description& description_of(const Stage* /*of*/) {
  using S = Stage;
  static const Description all =
      Describe<S>("ocp", "Stage",
                  "Settings that several knots can share: active contacts, costs, constraints and"
                  " the duration of a step.")
          .field("name", &S::name)
          .field("contacts", &S::contacts,
                 "Names of the active contacts")
          .field("costs", &S::costs)
          .field("constraints", &S::constraints)
          .field("step", &S::step,
                 "Duration of a knot, unless the knot has its own step [{s}]")
          .field("integrator", &S::integrator)
          .field("impact", &S::impact,
                 "Whether the knot is an inelastic impact, in which the contacts close and "
                 "velocities jump")
          .more("An impact takes no time and has no control. Its costs are not multiplied by a "
                "duration");
  return all;
}

const Description& description_of(const HorizonSegment* /*of*/) {
  using S = HorizonSegment;
  static const Description all =
      Describe<S>("ocp", "HorizonSegment",
                  "Consecutive knots of one stage, with the stage's step or with steps of their "
                  "own. The segment's own steps are equal, or change from knot to knot by a "
                  "constant factor. With growing steps, few knots cover a long time. Contact "
                  "gains and friction speeds are set for the stage's step. A knot that is n times"
                  " as long as this step uses smaller gains for stability: kd / n and kp / n^2. "
                  "The speeds below which friction fades are multiplied by n.")
          .field("stage", &S::stage)
          .field("knots", &S::knots)
          .field("step", &S::step,
                 "Duration of the segment's first knot (0: the stage's step) [{s}]")
          .field("duration", &S::duration,
                 "Duration of the whole segment (0: knots times the step) [{s}]")
          .more("Steps change from knot to knot by a factor r from 1/2 to 2. The factor solves "
                "step (1 + r + ... + r^(knots - 1)) = duration");
  return all;
}

const Description& description_of(const ProblemSpec* /*of*/) {
  using S = ProblemSpec;
  static const Description all =
      Describe<S>("ocp", "ProblemSpec",
                  "Specification of an optimal control problem: a robot, contacts, stages with "
                  "costs and constraints, and a horizon.")
          .field("model", &S::model)
          .required()
          .field("contacts", &S::contacts,
                 "Contacts of the problem; each stage selects its active contacts from them")
          .more("Contacts of the robot's loops may be omitted")
          .field("contact_solver", &S::contact_solver)
          .field("actuation", &S::actuation)
          .field("torque_model", &S::torque_model)
          .field("force_states", &S::force_states,
                 "Names of contacts whose forces in the previous step become part of the state")
          .more("These forces are inputs of ContactForceRate, and do not act on the robot. There "
                "is one entry per constrained direction, in the contact's own reference frame. "
                "Entries of a contact that was not active are zero")
          .field("control_lower", &S::control_lower,
                 "Lower bounds of the control in Nm (N): nu entries, or one for all; empty: none")
          .number_too()
          .field("control_upper", &S::control_upper,
                 "Upper bounds of the control in Nm (N): nu entries, or one for all; empty: none")
          .number_too()
          .field("inputs", &S::inputs,
                 "Named values that change between solves, such as an estimated surface")
          .field("torque_bias_input", &S::torque_bias_input,
                 "Name of a vector input of nv entries with a constant InputSpec.value; empty: "
                 "none")
          .more("The value is a torque on the joints, in addition to all torques of the model")
          .field("stages", &S::stages)
          .field("horizon", &S::horizon)
          .field("terminal", &S::terminal,
                 "Costs of the last state")
          .field("terminal_constraints", &S::terminal_constraints)
          .field("initial_state", &S::initial_state,
                 "Initial state: q and v, then tau with a torque model, then the force states")
          .field("start_time", &S::start_time,
                 "Time of the first knot [{s}]");
  return all;
}

const Description& description_of(const StepError* /*of*/) {
  using S = StepError;
  static const Description all =
      Describe<S>("ocp", "StepError",
                  "Discretization error of one step of a plan: the difference between the end of "
                  "this step and the end of an integration with small steps.")
          .result()
          .field("knot", &S::knot,
                 "Knot at which the step begins; -1: no step was examined")
          .field("place", &S::place,
                 "Name of the knot, such as \"press, knot 3\"")
          .field("time", &S::time,
                 "Time at which the step begins [{s}]")
          .field("step", &S::step,
                 "Duration of the step [{s}]")
          .field("entry", &S::entry,
                 "Name of the entry of v that has the error")
          .field("unit", &S::unit,
                 "Unit of the error: \"rad\" or \"m\"; for velocities \"rad/s\" or \"m/s\"")
          .field("error", &S::error,
                 "Largest absolute error, in the unit of the entry")
          .field("limit", &S::limit,
                 "Limit of the error, in the unit of the error; a larger error causes a warning");
  return all;
}

const Description& description_of(const StepReport* /*of*/) {
  using S = StepReport;
  static const Description all =
      Describe<S>("ocp", "StepReport",
                  "Result of check_steps(): the worst position error and the worst velocity "
                  "error. Any error above its limit is worse than any error within its limit; "
                  "other errors are compared by size.")
          .result()
          .field("status", &S::status,
                 "Status ok, or the reason why the errors of `knot` cannot be computed")
          .more("Not converged: the results of the smallest steps still differ. Other reasons: a "
                "number is not finite, or the contacts cannot be solved")
          .field("knot", &S::knot,
                 "First knot whose errors cannot be computed; -1: none")
          .field("position", &S::position,
                 "Worst position error, as a difference of configurations")
          .field("velocity", &S::velocity)
          .field("coarse", &S::coarse,
                 "True if an error exceeds its limit or cannot be computed")
          .field("sufficient_step", &S::sufficient_step,
                 "Sufficient step at the worst knot (0: all steps are short enough, or none was "
                 "found) [{s}]");
  return all;
}

}  // namespace burnish

namespace burnish::residual {

const Description& description_of(const State* /*of*/) {
  using S = State;
  static const Description all =
      Describe<S>("residual", "State",
                  "Difference of the state from the target, x (-) target, ndx rows: dq (rad, m), "
                  "dv (rad/s, m/s), dtau (Nm, N).")
          .field("target", &S::target,
                 "Target state, nx entries; None: the initial state of the problem");
  return all;
}

const Description& description_of(const Control* /*of*/) {
  using S = Control;
  static const Description all =
      Describe<S>("residual", "Control",
                  "Control minus the target, nu rows, Nm (N).")
          .field("target", &S::target,
                 "Target control; None: zero");
  return all;
}

const Description& description_of(const JointPosition* /*of*/) {
  using S = JointPosition;
  static const Description all =
      Describe<S>("residual", "JointPosition",
                  "Position of revolute and prismatic joints minus the target, one row per joint,"
                  " rad or m. If no joints are named, there is a row for every joint with a "
                  "position limit.")
          .field("joints", &S::joints)
          .name_of("joint")
          .field("target", &S::target,
                 "Target positions; None: zero, so the residual equals the positions");
  return all;
}

const Description& description_of(const JointVelocity* /*of*/) {
  using S = JointVelocity;
  static const Description all =
      Describe<S>("residual", "JointVelocity",
                  "Velocity of joints minus the target, one row per entry of v, rad/s or m/s. If "
                  "no joints are named, there are rows for all joints except the free-flying "
                  "base.")
          .field("joints", &S::joints)
          .name_of("joint")
          .field("target", &S::target,
                 "Target velocities; None: zero");
  return all;
}

const Description& description_of(const JointTorque* /*of*/) {
  using S = JointTorque;
  static const Description all =
      Describe<S>("residual", "JointTorque",
                  "Actuator torque of joints minus the target, Nm or N. Usually, the torque is "
                  "the control. With a torque model that has a cut-off, it is the torque in the "
                  "state. If no joints are named, there are rows for all actuated joints.")
          .field("joints", &S::joints)
          .name_of("joint")
          .field("target", &S::target,
                 "Target torques; None: zero");
  return all;
}

const Description& description_of(const JointTorqueRate* /*of*/) {
  using S = JointTorqueRate;
  static const Description all =
      Describe<S>("residual", "JointTorqueRate",
                  "Rate of actuator torques of joints minus the target, Nm/s or N/s. The rate "
                  "needs a torque model and a control u. With a cut-off, the rate is cutoff (u - "
                  "tau) at the start of the step, where tau is the torque in the state. The rate "
                  "decays over the step. With held torques, the rate is (u - tau) / step, where "
                  "tau is the control of the previous step. If no joints are named, there are "
                  "rows for all actuated joints.")
          .field("joints", &S::joints)
          .name_of("joint")
          .field("target", &S::target,
                 "Target rates; None: zero");
  return all;
}

const Description& description_of(const FramePosition* /*of*/) {
  using S = FramePosition;
  static const Description all =
      Describe<S>("residual", "FramePosition",
                  "Position of a frame's origin minus the target, 3 rows, m, in the axes of the "
                  "reference frame. The base of the reference must be the world, and the origin "
                  "must not be the frame itself. With Reference.on, the axes of the reference "
                  "follow a surface at the frame. The position is then measured from the origin "
                  "of the frame in which the surface is fixed. The first two rows are along the "
                  "surface's tangents.")
          .field("frame", &S::frame)
          .name_of("frame")
          .stated()
          .field("target", &S::target,
                 "Target position from the reference's origin, 3 entries [{m}]")
          .more("Written in the axes of the frame Reference.axes, without Reference.rotation. "
                "With Reference::world(...), the target is a point of the world")
          .field("reference", &S::reference);
  return all;
}

const Description& description_of(const FrameDistance* /*of*/) {
  using S = FrameDistance;
  static const Description all =
      Describe<S>("residual", "FrameDistance",
                  "Distance of a frame's origin from the target, along one or more axes of the "
                  "reference; 1 row [m]. With three axes it is the distance from a point, with "
                  "two axes from a line, with one axis from a plane. The base of the reference "
                  "must be the world, and the reference's origin must not be the frame itself. "
                  "For a distance d the row is sqrt(d^2 + (1e-6 m)^2), which is differentiable "
                  "everywhere. At d = 0 the derivative of the row is zero.")
          .field("frame", &S::frame)
          .name_of("frame")
          .stated()
          .field("target", &S::target,
                 "Target position from the reference's origin (None: the origin itself), 3 "
                 "entries [{m}]")
          .more("Written in the axes of the frame Reference.axes, without Reference.rotation. If "
                "the reference's origin is the world's origin, a target is required")
          .field("directions", &S::directions,
                 "Axes that count: one or more of x, y and z")
          .field("reference", &S::reference);
  return all;
}

const Description& description_of(const FrameRotation* /*of*/) {
  using S = FrameRotation;
  static const Description all =
      Describe<S>("residual", "FrameRotation",
                  "Rotation of a frame relative to its target rotation, log(R_target^T A^T R), 3 "
                  "rows, rad, in the axes of the target. R is the rotation of the frame in the "
                  "world, and A that of the reference. The target R_target is relative to A. The "
                  "base of the reference must be the world, and the origin of the reference has "
                  "no effect.")
          .field("frame", &S::frame)
          .name_of("frame")
          .stated()
          .field("target", &S::target,
                 "Target rotation: quaternion x, y, z, w, of unit length")
          .field("reference", &S::reference);
  return all;
}

const Description& description_of(const FrameInclination* /*of*/) {
  using S = FrameInclination;
  static const Description all =
      Describe<S>("residual", "FrameInclination",
                  "Lead and tilt of an axis e of a frame minus the target, 2 rows, rad. Here e is"
                  " written in the reference frame. Lead is the inclination from the reference's "
                  "z axis towards its x axis, atan2(e_x, e_z). Tilt is the inclination from the z"
                  " axis towards the y axis, atan2(e_y, e_z). The base of the reference must be "
                  "the world. Rotation about the axis e has no effect. With Reference.on, z is "
                  "the normal of a surface.")
          .field("frame", &S::frame)
          .name_of("frame")
          .stated()
          .field("reference", &S::reference)
          .field("axis", &S::axis,
                 "Axis in the frame, 3 entries, of any length")
          .field("target", &S::target,
                 "Target lead and tilt [{rad}]; None: zero");
  return all;
}

const Description& description_of(const FrameHeight* /*of*/) {
  using S = FrameHeight;
  static const Description all =
      Describe<S>("residual", "FrameHeight",
                  "Height of a frame's origin above a surface minus the target, 1 row, m. The "
                  "reference follows the surface (Reference.on). The height is the distance to "
                  "the surface along the normal at the frame, negative inside the material. It is"
                  " exact for planes, spheres and cylinders, and correct to first order for other"
                  " surfaces. If the normal at the frame does not meet the surface, the height is"
                  " no distance, but still increases with the distance.")
          .field("frame", &S::frame)
          .name_of("frame")
          .stated()
          .field("reference", &S::reference)
          .stated()
          .field("target", &S::target,
                 "Target height [{m}]; None: zero");
  return all;
}

const Description& description_of(const FramePlacement* /*of*/) {
  using S = FramePlacement;
  static const Description all =
      Describe<S>("residual", "FramePlacement",
                  "Pose of a frame relative to the target, as an SE(3) logarithm in the target's "
                  "axes: 3 rows in m, 3 rows in rad.")
          .field("frame", &S::frame)
          .name_of("frame")
          .stated()
          .field("target", &S::target,
                 "Target pose: position (m), quaternion x, y, z, w");
  return all;
}

const Description& description_of(const FrameVelocity* /*of*/) {
  using S = FrameVelocity;
  static const Description all =
      Describe<S>("residual", "FrameVelocity",
                  "Velocity of a frame in the world minus the target, 6 rows: 3 in m/s, 3 in "
                  "rad/s. The velocity is written in a reference frame, whose tool is the frame "
                  "and whose base is the world.")
          .field("frame", &S::frame)
          .name_of("frame")
          .stated()
          .field("reference", &S::reference)
          .field("target", &S::target,
                 "Target velocity; None: zero");
  return all;
}

const Description& description_of(const ContactForce* /*of*/) {
  using S = ContactForce;
  static const Description all =
      Describe<S>("residual", "ContactForce",
                  "Force of an active contact minus the target, N and Nm. In the contact's own "
                  "reference frame, there is one row per constrained direction. In another "
                  "reference frame, there are six rows.")
          .field("contact", &S::contact)
          .name_of("contact")
          .stated()
          .field("reference", &S::reference)
          .field("target", &S::target,
                 "Target force; None: zero");
  return all;
}

const Description& description_of(const ContactForceRate* /*of*/) {
  using S = ContactForceRate;
  static const Description all =
      Describe<S>("residual", "ContactForceRate",
                  "Rate of change of an active contact's force f, (f - f_before) / step, minus "
                  "the target, N/s and Nm/s. f_before is the force of the previous step. There is"
                  " one row per constrained direction, in the contact's own reference frame. The "
                  "contact must be in the problem's list force_states.")
          .field("contact", &S::contact)
          .name_of("contact")
          .stated()
          .field("target", &S::target,
                 "Target rates; None: zero");
  return all;
}

const Description& description_of(const FrictionCone* /*of*/) {
  using S = FrictionCone;
  static const Description all =
      Describe<S>("residual", "FrictionCone",
                  "Margins of a contact force within its friction cone, 2 rows, N: friction * f_n"
                  " - |f_t| and f_n. Here f_n is the force along the axis `normal` of the "
                  "reference (0, 1, 2: x, y, z). f_t is the tangential force, and |f_t| is "
                  "smoothed over 1e-3 N. With `sides` = n > 0, a pyramid inside the cone replaces"
                  " the cone. There are then n rows, N: friction * cos(pi / n) * f_n - d_i . f_t."
                  " The tangents d_i are 360 / n degrees apart. The first tangent is the "
                  "reference's axis that follows the normal (x follows z). Default penalty: a "
                  "barrier at 0.")
          .field("contact", &S::contact)
          .name_of("contact")
          .stated()
          .field("friction", &S::friction,
                 "Friction coefficient",
                 {.least = 0, .open = true})
          .field("normal", &S::normal,
                 "Axis of the reference along the normal")
          .words("x y z")
          .field("reference", &S::reference,
                 "Reference; by default the contact's own")
          .field("sides", &S::sides,
                 "Number of sides of a pyramid inside the cone, 3 to 32 (0: the cone itself)",
                 {.least = 0});
  return all;
}

const Description& description_of(const CenterOfPressure* /*of*/) {
  using S = CenterOfPressure;
  static const Description all =
      Describe<S>("residual", "CenterOfPressure",
                  "Margins of the centre of pressure within a rectangle in the tool's axes, times"
                  " the normal force f_z. There are 4 rows, Nm: half_x f_z + m_y, half_x f_z - "
                  "m_y, half_y f_z + m_x and half_y f_z - m_x. The centre of pressure is c = "
                  "(-m_y, m_x) / f_z. These rows are zero if c is at the edge with the largest x,"
                  " smallest x, smallest y and largest y, respectively. With friction, there are "
                  "8 more rows, Nm: the distances of the moment about the normal from the moments"
                  " at which the corners slip. The first 4 of the 8 rows limit negative moments, "
                  "the last 4 positive moments. Each corner has the coefficient `friction`. "
                  "Default penalty: a barrier at 0.")
          .field("contact", &S::contact)
          .name_of("contact")
          .stated()
          .field("half_x", &S::half_x,
                 "Half length of the rectangle along the tool's x [{m}]",
                 {.least = 0, .open = true})
          .stated()
          .field("half_y", &S::half_y,
                 "Half length of the rectangle along the tool's y [{m}]",
                 {.least = 0, .open = true})
          .stated()
          .field("friction", &S::friction,
                 "Friction coefficient at each corner, which limits the moment about the normal "
                 "(0: no limit)",
                 {.least = 0});
  return all;
}

const Description& description_of(const CenterOfMass* /*of*/) {
  using S = CenterOfMass;
  static const Description all =
      Describe<S>("residual", "CenterOfMass",
                  "Position of the centre of mass minus the target, 3 rows, m, world axes.")
          .field("target", &S::target);
  return all;
}

const Description& description_of(const SupportMargin* /*of*/) {
  using S = SupportMargin;
  static const Description all =
      Describe<S>("residual", "SupportMargin",
                  "Distance of the centre of mass from each edge of a support polygon, seen from "
                  "above, one row per edge, m. The distance is positive inside. Row i belongs to "
                  "the edge from point i to the next point; the last edge returns to the first "
                  "point. Default penalty: a barrier at 0.")
          .field("points", &S::points,
                 "Corners of a convex polygon, 3 or more, x and y in the world [{m}], "
                 "counter-clockwise from above. Other polygons are rejected.")
          .stated();
  return all;
}

const Description& description_of(const CentroidalMomentum* /*of*/) {
  using S = CentroidalMomentum;
  static const Description all =
      Describe<S>("residual", "CentroidalMomentum",
                  "Linear momentum (3 rows, kg m/s) and angular momentum about the centre of mass"
                  " (3 rows, kg m^2/s) minus the target, world axes.")
          .field("target", &S::target,
                 "Target momentum; None: zero");
  return all;
}

}  // namespace burnish::residual
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
