#include "ocp/descriptions.hpp"

namespace burnish {

const Words& words_of(Penalty::Kind /*of*/) {
  static const Words all{
      "ocp",
      "PenaltyKind",
      "phi of one residual entry r. All are convex, so that Gauss-Newton Hessians are positive.",
      {{"square", "r^2 / 2"},
       {"barrier", "half the square of how far r is outside [lower, upper], zero inside"},
       {"smooth_absolute",
        "sqrt(r^2 + width^2) - width: |r| far from zero, r^2 / (2 width) close to it"},
       {"log_barrier",
        "-log(s / width), s the distance to each limit, where s > width; below, and beyond the "
        "limit, the parabola ((s / width - 2)^2 - 1) / 2 that continues it smoothly"}}};
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

const Description& description_of(const Penalty* /*of*/) {
  using P = Penalty;
  static const Description all =
      Describe<P>("ocp", "Penalty", "What a residual costs: a function of each of its entries.")
          .field("kind", &P::kind)
          .field("lower", &P::lower,
                 "barriers: limit in the residual's unit, a number for all rows or one per row, "
                 "infinite where there is none; empty: none")
          .number_too()
          .field("upper", &P::upper,
                 "Barriers: limits in the residual's unit; one entry for all rows, or one per row; "
                 "infinite where there is none. Empty: none.")
          .number_too()
          .field("width", &P::width, "residual's unit, positive");
  return all;
}

const Description& description_of(const Constraint* /*of*/) {
  using C = Constraint;
  static const Description all =
      Describe<C>("ocp", "Constraint",
                  "lower <= r_i <= upper for every row i of a residual; an equality where the two "
                  "meet. Hard, or soft with a price.")
          .field("residual", &C::residual)
          .required()
          .field("name", &C::name,
                 "unique among the terms of its stage; the residual's name if left empty")
          .field("lower", &C::lower,
                 "In the residual's unit: per row, one for all, or empty: none. At least one of "
                 "the two, but for the margins (friction cone, center of pressure, support), whose "
                 "rows are at least zero unless said.")
          .number_too()
          .field("upper", &C::upper, "likewise")
          .number_too()
          .field("scale", &C::scale,
                 "What counts as much of a row, in its unit: per row, one for all, or empty: half "
                 "the distance of its limits, without one the robot's own limit, of forces its "
                 "weight, of torque rates its torque times the cut-off, of distances the limit "
                 "itself where it is above zero, of support margins half the polygon's width. "
                 "Where there is none of these it has to be said.")
          .number_too()
          .field("price", &C::price,
                 "A violation v costs price |v| + 1/2 square v^2, in units of cost (not multiplied "
                 "by the step: of longer knots there are fewer that pay); infinite: hard.",
                 range::not_negative_or_infinite)
          .field("square", &C::square, "likewise", range::not_negative);
  return all;
}

const Description& description_of(const CostTerm* /*of*/) {
  using C = CostTerm;
  static const Description all =
      Describe<C>("ocp", "CostTerm",
                  "weight * sum over rows i of weights_i phi(r_i), times the knot's step while "
                  "time passes: a cost is an integral over time, whatever the knots.")
          .field("residual", &C::residual)
          .required()
          .field("weight", &C::weight, "1 / (unit of phi) / s while time passes; not negative")
          .field("name", &C::name, "unique in its stage; the residual's name if left empty")
          .field("weights", &C::weights, "per row, or empty for ones; not negative")
          .field("penalty", &C::penalty, "Empty: a square, or what the residual says.");
  return all;
}

const Description& description_of(const TorqueModel* /*of*/) {
  using T = TorqueModel;
  static const Description all =
      Describe<T>("ocp", "TorqueModel",
                  "Actuators as a first-order low-pass of the control: dtau/dt = cutoff (u - tau). "
                  "The torques join the state.")
          .field("cutoff", &T::cutoff, "{rad/s}")
          .field("discretization", &T::discretization);
  return all;
}

const Description& description_of(const ActuationSpec* /*of*/) {
  using A = ActuationSpec;
  static const Description all =
      Describe<A>("ocp", "ActuationSpec", "Which joints are driven.")
          .field("joints", &A::joints,
                 "Empty: every joint but a free-flying base, and of robots with loops every joint "
                 "with a "
                 "motor, that is an effort limit above zero.")
          .field("passive_torques", &A::passive_torques,
                 "Joint damping and friction of the model act too, smoothed as "
                 "dynamics/passive.hpp has it, and its springs and tendons.")
          .field("slip_velocity", &A::slip_velocity, "{rad/s} or m/s");
  return all;
}

const Description& description_of(const Stage* /*of*/) {
  using S = Stage;
  static const Description all =
      Describe<S>("ocp", "Stage",
                  "A kind of knot: which contacts hold, what is aimed at, how long a step is.")
          .field("name", &S::name)
          .field("contacts", &S::contacts, "names of those that hold")
          .field("costs", &S::costs)
          .field("constraints", &S::constraints)
          .field("step", &S::step, "{s}, of knots that have none of their own")
          .field("integrator", &S::integrator)
          .field("impact", &S::impact,
                 "The contacts are made here: velocities jump so that they hold (inelastic), no "
                 "time passes, there is no control, and costs are not multiplied by a step.");
  return all;
}

const Description& description_of(const HorizonSegment* /*of*/) {
  using H = HorizonSegment;
  static const Description all =
      Describe<H>(
          "ocp", "HorizonSegment",
          "Consecutive knots of one stage. Their steps may be their own: all alike, or each "
          "longer (or shorter) than the one before by the same factor, so that few knots "
          "look far ahead. What is numerical is made for the stage's step, and a knot n "
          "times as long has it n times slower, as explicit steps ask for: gains of contacts "
          "are kd / n and kp / n^2, the speeds below which friction fades are n times as "
          "high.")
          .field("stage", &H::stage)
          .field("knots", &H::knots)
          .field("step", &H::step, "{s}, of the first of them; 0: the stage's")
          .field("duration", &H::duration,
                 "{s}, of all of them together: steps grow from the first one by the factor r >= "
                 "1/2, at most 2, for which step (1 + r + ... + r^(knots - 1)) is this; 0: knots "
                 "times the step.");
  return all;
}

const Description& description_of(const ProblemSpec* /*of*/) {
  using P = ProblemSpec;
  static const Description all =
      Describe<P>("ocp", "ProblemSpec",
                  "An optimal control problem as a user states it: a robot, contacts, stages of "
                  "costs, a horizon.")
          .field("model", &P::model)
          .required()
          .field("contacts", &P::contacts,
                 "all contacts of the problem; stages choose; those of the robot's loops need not "
                 "be among them")
          .field("contact_solver", &P::contact_solver)
          .field("actuation", &P::actuation)
          .field("torque_model", &P::torque_model)
          .field("remembered_forces", &P::remembered_forces,
                 "Contacts whose forces of the step before join the state (rows held, in their own "
                 "reference; zero where the contact did not hold), for ContactForceRate. They act "
                 "on nothing.")
          .field("control_lower", &P::control_lower,
                 "nu entries or one for all, Nm (N); empty: none.")
          .number_too()
          .field("control_upper", &P::control_upper, "likewise")
          .number_too()
          .field("stages", &P::stages)
          .field("horizon", &P::horizon)
          .field("terminal", &P::terminal, "costs of the last state")
          .field("terminal_constraints", &P::terminal_constraints)
          .field("initial_state", &P::initial_state,
                 "(q, v), then tau with a torque model, then the remembered forces.")
          .field("start_time", &P::start_time, "{s}, of the first knot");
  return all;
}

const Description& description_of(const StateLayout* /*of*/) {
  using S = StateLayout;
  static const Description all =
      Describe<S>(
          "ocp", "StateLayout",
          "Where the parts of z = (du, dq, dv, dtau, dforce) start, and how many entries they "
          "have.")
          .field("nq", &S::nq)
          .field("nv", &S::nv)
          .field("filtered", &S::filtered, "torques in the state (torque model), or 0")
          .field("holds_torque", &S::holds_torque,
                 "those are the controls of the step before, and what acts is the control itself")
          .field("remembered", &S::remembered,
                 "forces of the step before in the state, N and Nm (remembered_forces)")
          .field("nu", &S::nu)
          .field("actuated", &S::actuated, "entry of v that control i drives; nu entries");
  return all;
}

const Description& description_of(const Problem::QuasiStatic* /*of*/) {
  using Q = Problem::QuasiStatic;
  static const Description all =
      Describe<Q>(
          "ocp", "QuasiStatic",
          "The control of least norm that with the contacts of a stage holds a state at rest.")
          .result()
          .field("control", &Q::control, "nu, Nm")
          .field("force", &Q::force, "rows of the stage's contacts, N and Nm")
          .field("residual", &Q::residual, "largest torque that nothing balances, Nm");
  return all;
}

const Description& description_of(const ProblemCheckOptions* /*of*/) {
  using P = ProblemCheckOptions;
  static const Description all =
      Describe<P>("ocp", "ProblemCheckOptions", "How check_problem() looks.")
          .field("states", &P::states, "random states per stage, at least 1")
          .field("seed", &P::seed, "the same seed gives the same states on every machine")
          .field("tolerance", &P::tolerance,
                 "on |derivative - difference| over the block's largest entry")
          .field(
              "x", &P::x,
              "Trajectory to draw around: N + 1 states (nx) and N controls (nu; those of impacts "
              "are not read). Empty: the initial state, and the control that holds it at rest.")
          .field("u", &P::u)
          .field("position", &P::position,
                 "How far states are drawn from it, uniformly, for a robot of 1 m and 20 kg: "
                 "lengths grow "
                 "with its size, torques and forces with its weight. rad, m")
          .field("velocity", &P::velocity, "{rad/s}, m/s")
          .field("torque", &P::torque, "{Nm}, N: controls, and torques in the state")
          .field("progress", &P::progress,
                 "Called after each stage with the number of stages done and the number of all "
                 "stages.");
  return all;
}

const Description& description_of(const ProblemCheckRow* /*of*/) {
  using P = ProblemCheckRow;
  static const Description all =
      Describe<P>(
          "ocp", "ProblemCheckRow",
          "The next state, one cost term or the costs together, of one stage at all its states.")
          .result()
          .field("stage", &P::stage)
          .field("term", &P::term,
                 R"(name of a cost term or a constraint, "next state" or "all costs")")
          .field("states", &P::states)
          .field("worst_error", &P::worst_error,
                 "relative to the block's largest entry; infinite after a NaN")
          .field("worst", &P::worst, R"(blocks: such as "dnext_dq", "dr_du", "dcost_dv")")
          .field("pass_", &P::pass, "worst_error <= tolerance");
  return all;
}

const Description& description_of(const ProblemReport* /*of*/) {
  using P = ProblemReport;
  static const Description all =
      Describe<P>("ocp", "ProblemReport", "What check_problem() found.")
          .result()
          .field("robot", &P::robot)
          .field("rows", &P::rows)
          .field("tolerance", &P::tolerance)
          .field("pass_", &P::pass, "there are rows, and all of them pass");
  return all;
}

const Description& description_of(const StepError* /*of*/) {
  using E = StepError;
  static const Description all =
      Describe<E>("ocp", "StepError",
                  "How far the end of one step of a plan is from the motion that small steps lead "
                  "to.")
          .result()
          .field("knot", &E::knot, "at which the step begins; -1: no time passes in the problem")
          .field("place", &E::place, "the knot's name, such as \"press, knot 3\"")
          .field("time", &E::time, "{s}, of that knot")
          .field("step", &E::step, "{s}")
          .field("entry", &E::entry, "the entry of v, as the model names it")
          .field("unit", &E::unit, R"("rad" or "m"; of velocities "rad/s" or "m/s")")
          .field("error", &E::error, "size, in that unit")
          .field("limit", &E::limit, "largest error that is no warning, in that unit");
  return all;
}

const Description& description_of(const StepReport* /*of*/) {
  using R = StepReport;
  static const Description all =
      Describe<R>("ocp", "StepReport",
                  "What check_steps() found: the largest error of a position and of a velocity, of "
                  "those above their limits where there are any.")
          .result()
          .field("status", &R::status,
                 "ok, or why the errors of `knot` cannot be computed: the smallest steps do not "
                 "agree, a number is not finite, or what the contacts say")
          .field("knot", &R::knot, "the first one with that status; -1: none")
          .field("position", &R::position, "by the model's difference")
          .field("velocity", &R::velocity)
          .field("coarse", &R::coarse, "an error is above its limit, or cannot be computed")
          .field("step_enough", &R::step_enough,
                 "{s}, a step that would do at the worst knot; 0: not coarse, or none was found");
  return all;
}

}  // namespace burnish
