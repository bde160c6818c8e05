// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "ocp/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Description& description_of(const ProblemCheckOptions* /*of*/) {
  using S = ProblemCheckOptions;
  static const Description all =
      Describe<S>("ocp", "ProblemCheckOptions",
                  "How check_problem() looks.")
          .field("states", &S::states,
                 "random states per stage, at least 1")
          .field("seed", &S::seed,
                 "the same seed gives the same states on every machine")
          .field("tolerance", &S::tolerance,
                 "on |derivative - difference| over the block's largest entry")
          .field("x", &S::x,
                 "Trajectory to draw around: N + 1 states (nx) and N controls (nu; those of "
                 "impacts are not read). Empty: the initial state, and the control that holds it "
                 "at rest.")
          .field("u", &S::u)
          .field("position", &S::position,
                 "How far states are drawn from it, uniformly, for a robot of 1 m and 20 kg: "
                 "lengths grow with its size, torques and forces with its weight. rad, m")
          .field("velocity", &S::velocity,
                 "{rad/s}, m/s")
          .field("torque", &S::torque,
                 "{Nm}, N: controls, and torques in the state")
          .field("progress", &S::progress,
                 "Called after each stage with the number of stages done and the number of all "
                 "stages.");
  return all;
}

const Description& description_of(const ProblemCheckRow* /*of*/) {
  using S = ProblemCheckRow;
  static const Description all =
      Describe<S>("ocp", "ProblemCheckRow",
                  "The next state, one cost term or the costs together, of one stage at all its "
                  "states.")
          .result()
          .field("stage", &S::stage)
          .field("term", &S::term,
                 "name of a cost term or a constraint, \"next state\" or \"all costs\"")
          .field("states", &S::states)
          .field("worst_error", &S::worst_error,
                 "relative to the block's largest entry; infinite after a NaN")
          .field("worst", &S::worst,
                 "blocks: such as \"dnext_dq\", \"dr_du\", \"dcost_dv\"")
          .field("pass_", &S::pass,
                 "worst_error <= tolerance");
  return all;
}

const Description& description_of(const ProblemReport* /*of*/) {
  using S = ProblemReport;
  static const Description all =
      Describe<S>("ocp", "ProblemReport",
                  "What check_problem() found.")
          .result()
          .field("robot", &S::robot)
          .field("rows", &S::rows)
          .field("tolerance", &S::tolerance)
          .field("pass_", &S::pass,
                 "there are rows, and all of them pass");
  return all;
}

const Description& description_of(const StateLayout* /*of*/) {
  using S = StateLayout;
  static const Description all =
      Describe<S>("ocp", "StateLayout",
                  "Where the parts of z = (du, dq, dv, dtau, dforce) start, and how many entries "
                  "they have.")
          .field("nq", &S::nq)
          .field("nv", &S::nv)
          .field("filtered", &S::filtered,
                 "torques in the state (torque model), or 0")
          .field("holds_torque", &S::holds_torque,
                 "those are the controls of the step before, and what acts is the control itself")
          .field("remembered", &S::remembered,
                 "forces of the step before in the state, N and Nm (remembered_forces)")
          .field("nu", &S::nu)
          .field("actuated", &S::actuated,
                 "entry of v that control i drives; nu entries");
  return all;
}

const Description& description_of(const Problem::QuasiStatic* /*of*/) {
  using S = Problem::QuasiStatic;
  static const Description all =
      Describe<S>("ocp", "QuasiStatic",
                  "The control of least norm that with the contacts of a stage holds a state at "
                  "rest.")
          .result()
          .field("control", &S::control,
                 "nu, Nm")
          .field("force", &S::force,
                 "rows of the stage's contacts, N and Nm")
          .field("residual", &S::residual,
                 "largest torque that nothing balances, Nm");
  return all;
}

const Description& description_of(const Penalty* /*of*/) {
  using S = Penalty;
  static const Description all =
      Describe<S>("ocp", "Penalty",
                  "What a residual costs: a function of each of its entries.")
          .field("kind", &S::kind)
          .field("lower", &S::lower,
                 "barriers: limit in the residual's unit, a number for all rows or one per row, "
                 "infinite where there is none; empty: none")
          .number_too()
          .field("upper", &S::upper,
                 "Barriers: limits in the residual's unit; one entry for all rows, or one per "
                 "row; infinite where there is none. Empty: none.")
          .number_too()
          .field("width", &S::width,
                 "residual's unit, positive");
  return all;
}

const Words& words_of(Penalty::Kind /*of*/) {
  static const Words all{
      "ocp",
      "PenaltyKind",
      "phi of one residual entry r. All are convex, so that Gauss-Newton Hessians are positive.",
      {{"square", "r^2 / 2"},
       {"barrier", "half the square of how far r is outside [lower, upper], zero inside"},
       {"smooth_absolute", "sqrt(r^2 + width^2) - width: |r| far from zero, r^2 / (2 width) close to it"},
       {"log_barrier", "-log(s / width), s the distance to each limit, where s > width; below, and beyond the "
        "limit, the parabola ((s / width - 2)^2 - 1) / 2 that continues it smoothly"}}};
  return all;
}

const Description& description_of(const CostTerm* /*of*/) {
  using S = CostTerm;
  static const Description all =
      Describe<S>("ocp", "CostTerm",
                  "weight * sum over rows i of weights_i phi(r_i), times the knot's step while "
                  "time passes: a cost is an integral over time, whatever the knots.")
          .field("residual", &S::residual)
          .required()
          .field("weight", &S::weight,
                 "1 / (unit of phi) / s while time passes; not negative")
          .field("name", &S::name,
                 "unique in its stage; the residual's name if left empty")
          .field("weights", &S::weights,
                 "per row, or empty for ones; not negative")
          .field("penalty", &S::penalty,
                 "Empty: a square, or what the residual says.");
  return all;
}

const Description& description_of(const Constraint* /*of*/) {
  using S = Constraint;
  static const Description all =
      Describe<S>("ocp", "Constraint",
                  "lower <= r_i <= upper for every row i of a residual; an equality where the two"
                  " meet. Hard, or soft with a price.")
          .field("residual", &S::residual)
          .required()
          .field("name", &S::name,
                 "unique among the terms of its stage; the residual's name if left empty")
          .field("lower", &S::lower,
                 "In the residual's unit: per row, one for all, or empty: none. At least one of "
                 "the two, but for the margins (friction cone, center of pressure, support), "
                 "whose rows are at least zero unless said.")
          .number_too()
          .field("upper", &S::upper,
                 "likewise")
          .number_too()
          .field("scale", &S::scale,
                 "What counts as much of a row, in its unit: per row, one for all, or empty: half"
                 " the distance of its limits, without one the robot's own limit, of forces its "
                 "weight, of torque rates its torque times the cut-off, of distances the limit "
                 "itself where it is above zero, of support margins half the polygon's width. "
                 "Without any of these it must be stated.")
          .number_too()
          .field("price", &S::price,
                 "A violation v costs price |v| + 1/2 square v^2, in units of cost (not "
                 "multiplied by the step: of longer knots there are fewer that pay); infinite: "
                 "hard.",
                 {.least = 0, .infinite = true})
          .field("square", &S::square,
                 "likewise",
                 {.least = 0});
  return all;
}

const Words& words_of(Integrator /*of*/) {
  static const Words all{
      "ocp",
      "Integrator",
      "How the state goes from one knot to the next.",
      {{"semi_implicit_euler", "v' = v + step a(q, v, tau), q' = q (+) step v'"},
       {"runge_kutta4", "classical, the control held; costs are taken at the start of the step"}}};
  return all;
}

const Description& description_of(const TorqueModel* /*of*/) {
  using S = TorqueModel;
  static const Description all =
      Describe<S>("ocp", "TorqueModel",
                  "Actuators as a first-order low-pass of the control: dtau/dt = cutoff (u - "
                  "tau). The torques join the state.")
          .field("cutoff", &S::cutoff,
                 "{rad/s}")
          .field("discretization", &S::discretization);
  return all;
}

const Words& words_of(TorqueModel::Discretization /*of*/) {
  static const Words all{
      "ocp",
      "Discretization",
      "Of the torque model.",
      {{"exact", "decay over a step: exp(-cutoff step)"},
       {"euler", "1 - cutoff step"},
       {"held", "tau is the control of the step before and does not act; without a cutoff"}}};
  return all;
}

const Description& description_of(const ActuationSpec* /*of*/) {
  using S = ActuationSpec;
  static const Description all =
      Describe<S>("ocp", "ActuationSpec",
                  "Which joints are driven.")
          .field("joints", &S::joints,
                 "Empty: every joint but a free-flying base, and of robots with loops every joint"
                 " with a motor, that is an effort limit above zero.")
          .field("passive_torques", &S::passive_torques,
                 "Joint damping and friction of the model act too, smoothed as "
                 "dynamics/passive.hpp has it, and its springs and tendons.")
          .field("slip_velocity", &S::slip_velocity,
                 "{rad/s} or m/s");
  return all;
}

const Description& description_of(const Stage* /*of*/) {
  using S = Stage;
  static const Description all =
      Describe<S>("ocp", "Stage",
                  "A kind of knot: which contacts hold, what is aimed at, how long a step is.")
          .field("name", &S::name)
          .field("contacts", &S::contacts,
                 "names of those that hold")
          .field("costs", &S::costs)
          .field("constraints", &S::constraints)
          .field("step", &S::step,
                 "{s}, of knots that have none of their own")
          .field("integrator", &S::integrator)
          .field("impact", &S::impact,
                 "The contacts are made here: velocities jump so that they hold (inelastic), no "
                 "time passes, there is no control, and costs are not multiplied by a step.");
  return all;
}

const Description& description_of(const HorizonSegment* /*of*/) {
  using S = HorizonSegment;
  static const Description all =
      Describe<S>("ocp", "HorizonSegment",
                  "Consecutive knots of one stage. Their steps may be their own: all alike, or "
                  "each longer (or shorter) than the one before by the same factor, so that few "
                  "knots look far ahead. What is numerical is made for the stage's step, and a "
                  "knot n times as long has it n times slower, as explicit steps ask for: gains "
                  "of contacts are kd / n and kp / n^2, the speeds below which friction fades are"
                  " n times as high.")
          .field("stage", &S::stage)
          .field("knots", &S::knots)
          .field("step", &S::step,
                 "{s}, of the first of them; 0: the stage's")
          .field("duration", &S::duration,
                 "{s}, of all of them together: steps grow from the first one by the factor r >= "
                 "1/2, at most 2, for which step (1 + r + ... + r^(knots - 1)) is this; 0: knots "
                 "times the step.");
  return all;
}

const Description& description_of(const ProblemSpec* /*of*/) {
  using S = ProblemSpec;
  static const Description all =
      Describe<S>("ocp", "ProblemSpec",
                  "An optimal control problem as a user states it: a robot, contacts, stages of "
                  "costs, a horizon.")
          .field("model", &S::model)
          .required()
          .field("contacts", &S::contacts,
                 "all contacts of the problem; stages choose; those of the robot's loops need not"
                 " be among them")
          .field("contact_solver", &S::contact_solver)
          .field("actuation", &S::actuation)
          .field("torque_model", &S::torque_model)
          .field("remembered_forces", &S::remembered_forces,
                 "Contacts whose forces of the step before join the state (rows held, in their "
                 "own reference; zero where the contact did not hold), for ContactForceRate. They"
                 " act on nothing.")
          .field("control_lower", &S::control_lower,
                 "nu entries or one for all, Nm (N); empty: none.")
          .number_too()
          .field("control_upper", &S::control_upper,
                 "likewise")
          .number_too()
          .field("stages", &S::stages)
          .field("horizon", &S::horizon)
          .field("terminal", &S::terminal,
                 "costs of the last state")
          .field("terminal_constraints", &S::terminal_constraints)
          .field("initial_state", &S::initial_state,
                 "(q, v), then tau with a torque model, then the remembered forces.")
          .field("start_time", &S::start_time,
                 "{s}, of the first knot");
  return all;
}

const Description& description_of(const StepError* /*of*/) {
  using S = StepError;
  static const Description all =
      Describe<S>("ocp", "StepError",
                  "How far the end of one step of a plan is from the motion that small steps lead"
                  " to.")
          .result()
          .field("knot", &S::knot,
                 "at which the step begins; -1: no time passes in the problem")
          .field("place", &S::place,
                 "the knot's name, such as \"press, knot 3\"")
          .field("time", &S::time,
                 "{s}, of that knot")
          .field("step", &S::step,
                 "{s}")
          .field("entry", &S::entry,
                 "the entry of v, as the model names it")
          .field("unit", &S::unit,
                 "\"rad\" or \"m\"; of velocities \"rad/s\" or \"m/s\"")
          .field("error", &S::error,
                 "size, in that unit")
          .field("limit", &S::limit,
                 "largest error that is no warning, in that unit");
  return all;
}

const Description& description_of(const StepReport* /*of*/) {
  using S = StepReport;
  static const Description all =
      Describe<S>("ocp", "StepReport",
                  "What check_steps() found: the largest error of a position and of a velocity, "
                  "of those above their limits where there are any.")
          .result()
          .field("status", &S::status,
                 "ok, or why the errors of `knot` cannot be computed: the smallest steps do not "
                 "agree, a number is not finite, or what the contacts say")
          .field("knot", &S::knot,
                 "the first one with that status; -1: none")
          .field("position", &S::position,
                 "by the model's difference")
          .field("velocity", &S::velocity)
          .field("coarse", &S::coarse,
                 "an error is above its limit, or cannot be computed")
          .field("step_enough", &S::step_enough,
                 "{s}, a step that would do at the worst knot; 0: not coarse, or none was found");
  return all;
}

}  // namespace burnish

namespace burnish::residual {

const Description& description_of(const State* /*of*/) {
  using S = State;
  static const Description all =
      Describe<S>("residual", "State",
                  "x (-) target, ndx rows: dq (rad, m), dv (rad/s, m/s), dtau (Nm, N).")
          .field("target", &S::target,
                 "a state of nx entries; None: the initial state of the problem");
  return all;
}

const Description& description_of(const Control* /*of*/) {
  using S = Control;
  static const Description all =
      Describe<S>("residual", "Control",
                  "u - target, nu rows, Nm (N).")
          .field("target", &S::target,
                 "None: zero");
  return all;
}

const Description& description_of(const JointPosition* /*of*/) {
  using S = JointPosition;
  static const Description all =
      Describe<S>("residual", "JointPosition",
                  "q_j - target for revolute and prismatic joints, one row each, rad or m. No "
                  "joints: all of them that have a limit.")
          .field("joints", &S::joints)
          .name_of("joint")
          .field("target", &S::target,
                 "None: zero, as limits want it");
  return all;
}

const Description& description_of(const JointVelocity* /*of*/) {
  using S = JointVelocity;
  static const Description all =
      Describe<S>("residual", "JointVelocity",
                  "v - target for the entries of the named joints, rad/s or m/s; no joints: all "
                  "but the free-flying base.")
          .field("joints", &S::joints)
          .name_of("joint")
          .field("target", &S::target,
                 "None: zero");
  return all;
}

const Description& description_of(const JointTorque* /*of*/) {
  using S = JointTorque;
  static const Description all =
      Describe<S>("residual", "JointTorque",
                  "What the actuators apply to the named joints minus the target, Nm or N: the "
                  "control, or with a cut-off of the torque model the torque state. No joints: "
                  "all actuated ones.")
          .field("joints", &S::joints)
          .name_of("joint")
          .field("target", &S::target,
                 "None: zero");
  return all;
}

const Description& description_of(const JointTorqueRate* /*of*/) {
  using S = JointTorqueRate;
  static const Description all =
      Describe<S>("residual", "JointTorqueRate",
                  "How fast the torques of the named joints follow the control, minus the target:"
                  " cutoff (u - tau), Nm/s or N/s, at the begin of the step, over which it "
                  "decays; (u - tau) / step where torques are held and tau is the control of the "
                  "step before. With a torque model alone, where there is a control. No joints: "
                  "all actuated ones.")
          .field("joints", &S::joints)
          .name_of("joint")
          .field("target", &S::target,
                 "None: zero");
  return all;
}

const Description& description_of(const FramePosition* /*of*/) {
  using S = FramePosition;
  static const Description all =
      Describe<S>("residual", "FramePosition",
                  "Origin of a frame minus the target, 3 rows, m, written in the axes of the "
                  "reference, whose base is the world. Its origin must not be the frame itself; "
                  "where its axes follow a surface at the frame (Reference.on) it is that of what"
                  " the surface is fixed in, and the first two rows are how far the target is "
                  "along the tangents at the frame.")
          .field("frame", &S::frame)
          .name_of("frame")
          .stated()
          .field("target", &S::target,
                 "3, {m}: from the reference's origin, in the axes that its rotation is fixed in;"
                 " of Reference::world(...) a point of the world")
          .field("reference", &S::reference);
  return all;
}

const Description& description_of(const FrameDistance* /*of*/) {
  using S = FrameDistance;
  static const Description all =
      Describe<S>("residual", "FrameDistance",
                  "Distance of a frame's origin from the target, 1 row, m, measured along "
                  "`directions` of the reference, whose base is the world and whose origin must "
                  "not be the frame itself: along all three from a point, along two from a line, "
                  "along one from a plane. It is sqrt(d^2 + (1e-6 m)^2), so that it has a "
                  "derivative everywhere; at d = 0 that is zero, as no direction leads away.")
          .field("frame", &S::frame)
          .name_of("frame")
          .stated()
          .field("target", &S::target,
                 "3, {m}, as of FramePosition. None: the reference's origin, unless that is the "
                 "world's")
          .field("directions", &S::directions,
                 "one or more of x, y and z")
          .field("reference", &S::reference);
  return all;
}

const Description& description_of(const FrameRotation* /*of*/) {
  using S = FrameRotation;
  static const Description all =
      Describe<S>("residual", "FrameRotation",
                  "log(R_target^T A^T R), 3 rows, rad, target axes: how far the frame is from the"
                  " target, which is a rotation from the axes A of the reference, whose base is "
                  "the world; its origin does not matter.")
          .field("frame", &S::frame)
          .name_of("frame")
          .stated()
          .field("target", &S::target,
                 "quaternion x, y, z, w, of unit length")
          .field("reference", &S::reference);
  return all;
}

const Description& description_of(const FrameInclination* /*of*/) {
  using S = FrameInclination;
  static const Description all =
      Describe<S>("residual", "FrameInclination",
                  "Lead and tilt of an axis of a frame minus the target, 2 rows, rad: the angles "
                  "by which it leans from the third axis of the reference, whose base is the "
                  "world, towards the first and towards the second: atan2(e_x, e_z) and "
                  "atan2(e_y, e_z), with e the axis in the reference. How it is turned about "
                  "itself does not matter. With Reference.on the third axis is a surface's "
                  "normal.")
          .field("frame", &S::frame)
          .name_of("frame")
          .stated()
          .field("reference", &S::reference)
          .field("axis", &S::axis,
                 "3, of any length, in the frame")
          .field("target", &S::target,
                 "lead and tilt, {rad}; None: zero");
  return all;
}

const Description& description_of(const FrameHeight* /*of*/) {
  using S = FrameHeight;
  static const Description all =
      Describe<S>("residual", "FrameHeight",
                  "Height of a frame's origin above the surface that the reference follows "
                  "(Reference.on), minus the target, 1 row, m: how far away the surface is along "
                  "its normal at the frame, below zero in the material. Exact for planes, spheres"
                  " and cylinders, to first order for others; far outside of a surface that the "
                  "normal there misses it only grows.")
          .field("frame", &S::frame)
          .name_of("frame")
          .stated()
          .field("reference", &S::reference)
          .stated()
          .field("target", &S::target,
                 "{m}; None: zero");
  return all;
}

const Description& description_of(const FramePlacement* /*of*/) {
  using S = FramePlacement;
  static const Description all =
      Describe<S>("residual", "FramePlacement",
                  "SE(3) logarithm of the frame in the target: 3 rows m, 3 rows rad, target axes.")
          .field("frame", &S::frame)
          .name_of("frame")
          .stated()
          .field("target", &S::target,
                 "position (m), quaternion x, y, z, w");
  return all;
}

const Description& description_of(const FrameVelocity* /*of*/) {
  using S = FrameVelocity;
  static const Description all =
      Describe<S>("residual", "FrameVelocity",
                  "Velocity of a frame in the world minus the target, 6 rows: m/s, rad/s, written"
                  " in the reference, whose tool is the frame and whose base is the world.")
          .field("frame", &S::frame)
          .name_of("frame")
          .stated()
          .field("reference", &S::reference)
          .field("target", &S::target,
                 "None: zero");
  return all;
}

const Description& description_of(const ContactForce* /*of*/) {
  using S = ContactForce;
  static const Description all =
      Describe<S>("residual", "ContactForce",
                  "Force of an active contact minus the target, N and Nm: the held rows in the "
                  "contact's own reference, or six rows in another one.")
          .field("contact", &S::contact)
          .name_of("contact")
          .stated()
          .field("reference", &S::reference)
          .field("target", &S::target,
                 "None: zero");
  return all;
}

const Description& description_of(const ContactForceRate* /*of*/) {
  using S = ContactForceRate;
  static const Description all =
      Describe<S>("residual", "ContactForceRate",
                  "How fast the force of an active contact changes from the step before to this "
                  "one, minus the target: (f - f_before) / step, N/s and Nm/s, the held rows in "
                  "the contact's own reference. For contacts that the problem remembers the force"
                  " of.")
          .field("contact", &S::contact)
          .name_of("contact")
          .stated()
          .field("target", &S::target,
                 "None: zero");
  return all;
}

const Description& description_of(const FrictionCone* /*of*/) {
  using S = FrictionCone;
  static const Description all =
      Describe<S>("residual", "FrictionCone",
                  "Two rows, N: friction * f_n - |f_t| (smoothed over 1e-3 N) and f_n, both to be"
                  " kept above a limit: the default penalty is a barrier at 0. f_n is the force "
                  "along the axis `normal` of the reference (0, 1, 2: x, y, z), f_t what stands "
                  "at a right angle to it. With `sides` n a pyramid inside the cone: n rows, N, "
                  "friction * cos(pi / n) * f_n - d_i . f_t, where d_0 is the next axis of the "
                  "reference after the normal and the others follow every 360 / n degrees.")
          .field("contact", &S::contact)
          .name_of("contact")
          .stated()
          .field("friction", &S::friction,
                 "",
                 {.least = 0, .open = true})
          .field("normal", &S::normal)
          .words("x y z")
          .field("reference", &S::reference,
                 "default: the contact's own")
          .field("sides", &S::sides,
                 "3 to 32, of a pyramid inside the cone; 0: the cone itself",
                 {.least = 0});
  return all;
}

const Description& description_of(const CenterOfPressure* /*of*/) {
  using S = CenterOfPressure;
  static const Description all =
      Describe<S>("residual", "CenterOfPressure",
                  "Four rows, Nm: how far the centre of pressure is inside a rectangle of the "
                  "tool's axes, times the normal force f_z: half_x f_z +- m_y, half_y f_z +- m_x,"
                  " both halves in m; zero where the centre, which is (-m_y, m_x) / f_z, is at "
                  "the edge above in x, below in x, below in y, above in y. With friction eight "
                  "rows more, Nm, four to the right and four to the left: how far the moment "
                  "about the normal is within what the corners bear with that coefficient each. "
                  "Default penalty: a barrier at 0.")
          .field("contact", &S::contact)
          .name_of("contact")
          .stated()
          .field("half_x", &S::half_x,
                 "{m}",
                 {.least = 0, .open = true})
          .stated()
          .field("half_y", &S::half_y,
                 "{m}",
                 {.least = 0, .open = true})
          .stated()
          .field("friction", &S::friction,
                 "0: the moment about the normal is free",
                 {.least = 0});
  return all;
}

const Description& description_of(const CenterOfMass* /*of*/) {
  using S = CenterOfMass;
  static const Description all =
      Describe<S>("residual", "CenterOfMass",
                  "Centre of mass minus the target, 3 rows, m, world.")
          .field("target", &S::target);
  return all;
}

const Description& description_of(const SupportMargin* /*of*/) {
  using S = SupportMargin;
  static const Description all =
      Describe<S>("residual", "SupportMargin",
                  "How far the centre of mass, seen from above, is inside of each edge of a "
                  "support polygon: a row per edge, m, all to be kept above a limit: the default "
                  "penalty is a barrier at 0. Row i is of the edge from point i to the next one, "
                  "the last back to the first.")
          .field("points", &S::points,
                 "3 or more, x and y in the world, {m}: the corners of a convex polygon, "
                 "counter-clockwise as seen from above. Others are refused.")
          .stated();
  return all;
}

const Description& description_of(const CentroidalMomentum* /*of*/) {
  using S = CentroidalMomentum;
  static const Description all =
      Describe<S>("residual", "CentroidalMomentum",
                  "Momentum about the centre of mass minus the target, 6 rows: kg m/s, kg m^2/s, "
                  "world axes.")
          .field("target", &S::target,
                 "None: zero");
  return all;
}

}  // namespace burnish::residual
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
