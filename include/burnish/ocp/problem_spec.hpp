// An optimal control problem as a user states it: a robot, contacts, stages of costs, a horizon.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "burnish/contact/contact.hpp"
#include "burnish/contact/contact_set.hpp"
#include "burnish/model/model.hpp"
#include "burnish/ocp/residual.hpp"

namespace burnish {

/// What a residual costs: a function of each of its entries.
/// @described ocp
/// It is phi of one residual entry r. All are convex, so that Gauss-Newton Hessians are positive.
struct Penalty {
  /// phi of one residual entry r. All are convex, so that Gauss-Newton Hessians are positive.
  /// @described ocp.PenaltyKind
  enum class Kind {
    Square,   ///< r^2 / 2
    Barrier,  ///< half the square of how far r is outside [lower, upper], zero inside
    /// sqrt(r^2 + width^2) - width: |r| far from zero, r^2 / (2 width) close to it
    SmoothAbsolute,
    /// -log(s / width), s the distance to each limit, where s > width; below, and beyond the limit,
    /// the parabola ((s / width - 2)^2 - 1) / 2 that continues it smoothly
    LogBarrier,
  };

  Kind kind = Kind::Square;
  /// barriers: limit in the residual's unit, a number for all rows or one per row, infinite where
  /// there is none; empty: none @number_too @note One entry for all
  /// rows, or one per row, in the residual's unit.
  Eigen::VectorXd lower;
  /// Barriers: limits in the residual's unit; one entry for all rows, or one per row; infinite
  /// where there is none. Empty: none. @number_too
  Eigen::VectorXd upper;
  double width = 1.0;  ///< residual's unit, positive

  static Penalty square() { return {}; }
  static Penalty barrier(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);
  static Penalty at_least(double lower);
  static Penalty smooth_absolute(double width);
  static Penalty log_barrier(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                             double width);

  bool has_limits() const { return kind == Kind::Barrier || kind == Kind::LogBarrier; }
};

std::string name_of(Penalty::Kind kind);
/// Reads "square", "barrier", "smooth_absolute" or "log_barrier". Throws Error with the nearest
/// known name.
Penalty::Kind parse_penalty(const std::string& name);

/// weight * sum over rows i of weights_i phi(r_i), times the knot's step while time passes: a cost
/// is an integral over time, whatever the knots.
/// @described ocp
struct CostTerm {
  std::string name = {};  ///< unique in its stage; the residual's name if left empty @after weight
  Residual residual;      ///< @required
  double weight = 1.0;    ///< 1 / (unit of phi) / s while time passes; not negative
  Eigen::VectorXd weights = {};         ///< per row, or empty for ones; not negative
  std::optional<Penalty> penalty = {};  ///< Empty: a square, or what the residual says.
};

/// lower <= r_i <= upper for every row i of a residual; an equality where the two meet. Hard, or
/// soft with a price.
/// @described ocp
struct Constraint {
  /// unique among the terms of its stage; the residual's name if left empty
  std::string name = {};
  Residual residual;  ///< @after - @required
  /// In the residual's unit: per row, one for all, or empty: none. At least one of the two, but for
  /// the margins (friction cone, center of pressure, support), whose rows are at least zero unless
  /// said. @number_too
  Eigen::VectorXd lower = {};
  Eigen::VectorXd upper = {};  ///< likewise @number_too
  /// What counts as much of a row, in its unit: per row, one for all, or empty: half the distance
  /// of its limits, without one the robot's own limit, of forces its weight, of torque rates its
  /// torque times the cut-off, of distances the limit itself where it is above zero, of support
  /// margins half the polygon's width. Without any of these it must be stated. @number_too
  Eigen::VectorXd scale = {};
  /// A violation v costs price |v| + 1/2 square v^2, in units of cost (not multiplied by the step:
  /// of longer knots there are fewer that pay); infinite: hard. >= 0 or infinite
  double price = std::numeric_limits<double>::infinity();
  double square = 0.0;  ///< likewise, >= 0
};

/// How the state goes from one knot to the next.
/// @described ocp
enum class Integrator {
  SemiImplicitEuler,  ///< v' = v + step a(q, v, tau), q' = q (+) step v'
  /// classical, the control held; costs are taken at the start of the step @note Of fourth order,
  /// on free-flyers and planar joints too.
  RungeKutta4,
};

/// Actuators as a first-order low-pass of the control: dtau/dt = cutoff (u - tau). The torques join
/// the state.
/// @described ocp
/// Source: eq. (49) of the paper. Or held: each step's torque is its control, and the control of
/// the step before joins the state, so that rates (u - tau) / step are known.
struct TorqueModel {
  /// Of the torque model.
  /// @described ocp
  enum class Discretization {
    Exact,  ///< decay over a step: exp(-cutoff step)
    Euler,  ///< 1 - cutoff step
    Held,   ///< tau is the control of the step before and does not act; without a cutoff
  };
  double cutoff = 0.0;  ///< [rad/s]
  Discretization discretization = Discretization::Exact;

  /// Torques that are the control, of which the last one is remembered.
  static TorqueModel held() { return {0.0, Discretization::Held}; }
  bool is_held() const { return discretization == Discretization::Held; }
};

/// Which joints are driven.
/// @described ocp
struct ActuationSpec {
  /// Empty: every joint but a free-flying base, and of robots with loops every joint with a motor,
  /// that is an effort limit above zero.
  std::vector<std::string> joints = {};
  /// Joint damping and friction of the model act too, smoothed as dynamics/passive.hpp has it, and
  /// its springs and tendons.
  bool passive_torques = false;
  double slip_velocity = 0.01;  ///< [rad/s] or m/s
};

/// A kind of knot: which contacts hold, what is aimed at, how long a step is.
/// @described ocp
struct Stage {
  std::string name = {};
  std::vector<std::string> contacts = {};  ///< names of those that hold
  std::vector<CostTerm> costs = {};
  std::vector<Constraint> constraints = {};
  double step = 0.01;  ///< [s], of knots that have none of their own
  Integrator integrator = Integrator::SemiImplicitEuler;
  /// The contacts are made here: velocities jump so that they hold (inelastic), no time passes,
  /// there is no control, and costs are not multiplied by a step.
  bool impact = false;
};

/// Consecutive knots of one stage. Their steps may be their own: all alike, or each longer (or
/// shorter) than the one before by the same factor, so that few knots look far ahead. What is
/// numerical is made for the stage's step, and a knot n times as long has it n times slower, as
/// explicit steps ask for: gains of contacts are kd / n and kp / n^2, the speeds below which
/// friction fades are n times as high.
/// @described ocp
struct HorizonSegment {
  std::string stage = {};
  int knots = 1;
  double step = 0.0;  ///< [s], of the first of them; 0: the stage's
  /// [s], of all of them together: steps grow from the first one by the factor r >= 1/2, at most 2,
  /// for which step (1 + r + ... + r^(knots - 1)) is this; 0: knots times the step.
  double duration = 0.0;

  bool has_own_steps() const { return step != 0.0 || duration != 0.0; }
};

/// Of one problem, the terminal one not counted.
inline constexpr std::size_t max_knots = 100'000;

/// An optimal control problem as a user states it: a robot, contacts, stages of costs, a horizon.
/// @described ocp
struct ProblemSpec {
  Model model;  ///< @required
  /// all contacts of the problem; stages choose; those of the robot's loops need not be among them
  std::vector<ContactSpec> contacts = {};
  ContactSolver contact_solver = {};
  ActuationSpec actuation = {};
  std::optional<TorqueModel> torque_model = {};
  /// Contacts whose forces of the step before join the state (rows held, in their own reference;
  /// zero where the contact did not hold), for ContactForceRate. They act on nothing.
  std::vector<std::string> remembered_forces = {};
  /// nu entries or one for all, Nm (N); empty: none. @number_too
  Eigen::VectorXd control_lower = {};
  Eigen::VectorXd control_upper = {};  ///< likewise @number_too
  std::vector<Stage> stages = {};
  std::vector<HorizonSegment> horizon = {};
  std::vector<CostTerm> terminal = {};  ///< costs of the last state
  std::vector<Constraint> terminal_constraints = {};
  /// (q, v), then tau with a torque model, then the remembered forces.
  Eigen::VectorXd initial_state = {};
  double start_time = 0.0;  ///< [s], of the first knot
};

/// The problem with the loops of its robot among the contacts, held in every stage: what a Problem
/// compiles. Those that are stated already are left as they are; others have the gains of
/// LoopGains::for_step at the longest step. Throws Error where a contact that is none has a loop's
/// name.
ProblemSpec with_loops(ProblemSpec spec);

/// Returns the problem with a fade speed for each friction of a tool that states none,
///   max(0.01 m/s, 4 coefficient N step / m),
/// the largest over the stages that hold the contact. In one step friction changes the speed of the
/// tool by coefficient N step / m. N is the largest normal force in costs and constraints of the
/// stage, or the weight of m if there is none; m is the smallest effective mass of the tool across
/// the normal at the initial state. A coefficient of zero counts as 0.3.
ProblemSpec with_fade_speeds(ProblemSpec spec);

/// s, of each knot of the horizon; 0 at impacts. Throws Error for segments that cannot be.
std::vector<double> knot_steps(const ProblemSpec& spec);

/// Joints that the problem drives.
std::vector<const Joint*> driven_joints(const Model& model, const ActuationSpec& actuation);

}  // namespace burnish
