// Specification of an optimal control problem: a robot, contacts, stages with costs and
// constraints, and a horizon.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "burnish/contact/contact.hpp"
#include "burnish/contact/contact_set.hpp"
#include "burnish/model/model.hpp"
#include "burnish/ocp/input.hpp"
#include "burnish/ocp/residual.hpp"

namespace burnish {

/// Penalty function phi that turns each entry r of a residual into a cost.
/// @described ocp
/// All penalties are convex, so that Gauss-Newton Hessians are positive semidefinite.
struct Penalty {
  /// Form of phi(r) for one residual entry r. All forms are convex, so that Gauss-Newton Hessians
  /// are positive semidefinite.
  /// @described ocp.PenaltyKind
  enum class Kind {
    Quadratic,  ///< r^2 / 2
    Barrier,    ///< Half the squared distance of r from the interval [lower, upper]; zero inside

    /// sqrt(r^2 + width^2) - width. Approximately |r| for large |r|, and r^2 / (2 width) for small
    /// |r|
    SmoothAbsolute,
    /// Sum of the costs of the lower and the upper limit. Let s be the distance of r from a limit,
    /// negative beyond the limit. For s > width, a limit costs -log(s / width). Otherwise, it costs
    /// ((s / width - 2)^2 - 1) / 2, a parabola that continues the logarithm smoothly
    LogBarrier,
  };

  Kind kind = Kind::Quadratic;
  /// Lower limits of a barrier, in the residual's unit; empty: no lower limit
  /// @more One number for all rows, or one number per row. Infinite for a row without a lower limit
  /// @number_too
  Eigen::VectorXd lower;
  /// Upper limits of a barrier, in the residual's unit; empty: no upper limit
  /// @more One number for all rows, or one number per row. Infinite for a row without an upper
  /// limit @number_too
  Eigen::VectorXd upper;
  /// Width of the penalties smooth_absolute and log_barrier, in the residual's unit, positive
  double width = 1.0;

  static Penalty quadratic() { return {}; }
  static Penalty barrier(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);
  static Penalty at_least(double lower);
  static Penalty smooth_absolute(double width);
  static Penalty log_barrier(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                             double width);

  bool has_limits() const { return kind == Kind::Barrier || kind == Kind::LogBarrier; }
};

std::string name_of(Penalty::Kind kind);
/// Returns the penalty kind with the name "quadratic", "barrier", "smooth_absolute" or
/// "log_barrier". For any other name, throws Error with the nearest known name.
Penalty::Kind parse_penalty(const std::string& name);

/// A cost term: weight * sum over rows i of weights_i phi(r_i), with the penalty phi of residual r.
/// If the knot has a duration, the term is multiplied by the duration. The sum over all knots then
/// approximates an integral over time.
/// @described ocp
struct CostTerm {
  /// Name of the term, unique in its stage; empty: the name of the residual @after weight
  std::string name = {};
  Residual residual;  ///< @required

  /// Weight of the term, not negative
  /// @more The unit is 1 / (unit of phi). If the knot has a duration, the unit is 1 / (unit of phi)
  /// per second
  double weight = 1.0;
  Eigen::VectorXd weights = {};  ///< Weights of the rows, not negative; empty: 1 for every row

  /// Penalty of each row; empty: the default penalty of the residual, usually quadratic
  std::optional<Penalty> penalty = {};
  /// Name of the input whose value is added to the target; empty: none
  /// @more A scalar or vector input needs as many entries as the target. Exception: a vector of 3
  /// entries moves the position of a target pose. A rotation input turns a target rotation or pose
  /// about the target's own axes
  std::string offset_input = {};
  /// Name of the scalar input that multiplies the friction coefficient; empty: none
  /// @more The value is at least 0; values above 1 count as 1. The residual must be a friction
  /// cone, or a centre of pressure with friction
  std::string friction_ratio_input = {};
  /// Name of the input whose surface replaces the surface of the residual's reference; empty: none
  /// @more If the reference follows no surface, the residual needs a target position. This position
  /// then moves into the surface along the normal, by the depth of the input
  std::string surface_input = {};
};

/// A constraint lower <= r_i <= upper on every row i of a residual. Equal limits make an equality
/// constraint. A constraint is hard, or soft with a penalty for violations.
/// @described ocp
struct Constraint {
  /// Name of the constraint, unique among the stage's terms; empty: the name of the residual
  std::string name = {};
  Residual residual;  ///< @after - @required

  /// Lower limits in the residual's unit: one number, or one per row; empty: no lower limit
  /// @more A constraint needs a lower or an upper limit. Exceptions are margins (friction cone,
  /// center of pressure, support), which need no limits. Their rows must then be at least zero
  /// @number_too
  Eigen::VectorXd lower = {};
  /// Upper limits in the residual's unit: one number, or one per row; empty: no upper limit
  /// @number_too
  Eigen::VectorXd upper = {};
  /// Characteristic size of each row, in its unit: one number, or one per row; empty: automatic
  /// @more If both limits exist and differ, the automatic size is half their difference. Otherwise
  /// it depends on the residual. For forces, it is the robot's weight. For torque rates, it is
  /// torque limit times cut-off. For distances, it is the limit itself, if above zero. For support
  /// margins, it is half the width of the polygon. For other residuals, it is the robot's own limit
  /// of the quantity. If none of these exists, the size must be stated @number_too
  Eigen::VectorXd scale = {};
  /// L1 penalty weight of violations (infinite: hard) in cost per unit of the row, >= 0 or infinite
  /// @more A violation v at a knot costs l1_weight |v| + 1/2 quadratic_weight v^2. This cost is not
  /// multiplied by the duration of the knot. Violations therefore cost less if the same
  /// horizon is divided into fewer, longer knots
  double l1_weight = std::numeric_limits<double>::infinity();
  /// Quadratic penalty weight of violations, in cost per squared row unit, >= 0
  double quadratic_weight = 0.0;
  /// Name of the input whose value is added to the target; empty: none
  /// @more A scalar or vector input needs as many entries as the target. Exception: a vector of 3
  /// entries moves the position of a target pose. A rotation input turns a target rotation or pose
  /// about the target's own axes
  std::string offset_input = {};
  /// Name of the scalar input that multiplies the friction coefficient; empty: none
  /// @more The value is at least 0; values above 1 count as 1. The residual must be a friction
  /// cone, or a centre of pressure with friction
  std::string friction_ratio_input = {};
  /// Name of the input whose surface replaces the surface of the residual's reference; empty: none
  /// @more If the reference follows no surface, the residual needs a target position. This position
  /// then moves into the surface along the normal, by the depth of the input
  std::string surface_input = {};
};

/// Integration scheme from one knot to the next.
/// @described ocp
enum class Integrator {
  SemiImplicitEuler,  ///< v' = v + step a(q, v, tau), q' = q (+) step v'

  /// Classical Runge-Kutta with constant control; costs are evaluated at the start of the step
  /// @note The order is four, also for free-flyers and planar joints.
  RungeKutta4,
};

/// Actuator model: each torque follows its control through a first-order low-pass filter,
/// dtau/dt = cutoff (u - tau). The torques become part of the state.
/// @described ocp
/// Source: eq. (49) of the paper in docs/frames.md. The variant Held has no filter. Each step
/// applies its control as the torque, and the state contains the control of the previous step, tau.
/// The torque rate (u - tau) / step is then a function of state and control.
struct TorqueModel {
  /// Discretization of the low-pass filter over one step.
  /// @described ocp
  enum class Discretization {
    Exact,  ///< A step multiplies the torque error u - tau by exp(-cutoff step)
    Euler,  ///< A step multiplies the torque error u - tau by 1 - cutoff step
    Held,   ///< No filter: tau in the state is the control of the previous step, and the current
            ///< control acts on the robot
  };
  double cutoff = 0.0;  ///< Cut-off frequency of the low-pass filter [rad/s]
  Discretization discretization = Discretization::Exact;

  /// Returns the torque model with Discretization::Held: no low-pass filter, and the control of the
  /// previous step is part of the problem's state.
  static TorqueModel held() { return {0.0, Discretization::Held}; }
  bool is_held() const { return discretization == Discretization::Held; }
};

/// Driven joints of the robot, and whether passive joint torques act.
/// @described ocp
struct ActuationSpec {
  /// Names of the driven joints; empty: automatic
  /// @more Automatic: every joint except a free-flying base. For robots with loops: every joint
  /// with a motor, which is a joint with an effort limit above zero
  std::vector<std::string> joints = {};
  /// Whether damping, smoothed friction, springs and tendons of the model act on the joints
  /// @note Friction is smoothed as in dynamics/passive.hpp.
  bool passive_torques = false;
  /// Speed at which smoothed joint friction reaches 76 % of its full size [rad/s], or in m/s
  double slip_velocity = 0.01;
};

/// Settings that several knots can share: active contacts, costs, constraints and the duration of a
/// step.
/// @described ocp
struct Stage {
  std::string name = {};
  std::vector<std::string> contacts = {};  ///< Names of the active contacts
  std::vector<CostTerm> costs = {};
  std::vector<Constraint> constraints = {};
  double step = 0.01;  ///< Duration of a knot, unless the knot has its own step [s]
  Integrator integrator = Integrator::SemiImplicitEuler;
  /// Whether the knot is an inelastic impact, in which the contacts close and velocities jump
  /// @more An impact takes no time and has no control. Its costs are not multiplied by a duration
  bool impact = false;
};

/// Consecutive knots of one stage, with the stage's step or with steps of their own. The segment's
/// own steps are equal, or change from knot to knot by a constant factor. With growing steps, few
/// knots cover a long time. Contact gains and friction speeds are set for the stage's step. A knot
/// that is n times as long as this step uses smaller gains for stability: kd / n and kp / n^2. The
/// speeds below which friction fades are multiplied by n.
/// @described ocp
struct HorizonSegment {
  std::string stage = {};
  int knots = 1;
  double step = 0.0;  ///< Duration of the segment's first knot (0: the stage's step) [s]

  /// Duration of the whole segment (0: knots times the step) [s]
  /// @more Steps change from knot to knot by a factor r from 1/2 to 2. The factor solves step (1 +
  /// r + ... + r^(knots - 1)) = duration
  double duration = 0.0;

  bool has_own_steps() const { return step != 0.0 || duration != 0.0; }
};

/// Largest number of knots of one problem, without the terminal knot.
inline constexpr std::size_t max_knots = 100'000;

/// Specification of an optimal control problem: a robot, contacts, stages with costs and
/// constraints, and a horizon.
/// @described ocp
struct ProblemSpec {
  Model model;  ///< @required

  /// Contacts of the problem; each stage selects its active contacts from them
  /// @more Contacts of the robot's loops may be omitted
  std::vector<ContactSpec> contacts = {};
  ContactSolver contact_solver = {};
  ActuationSpec actuation = {};
  std::optional<TorqueModel> torque_model = {};
  /// Names of contacts whose forces in the previous step become part of the state
  /// @more These forces are inputs of ContactForceRate, and do not act on the robot. There is one
  /// entry per constrained direction, in the contact's own reference frame. Entries of a contact
  /// that was not active are zero
  std::vector<std::string> force_states = {};
  /// Lower bounds of the control in Nm (N): nu entries, or one for all; empty: none @number_too
  Eigen::VectorXd control_lower = {};
  /// Upper bounds of the control in Nm (N): nu entries, or one for all; empty: none @number_too
  Eigen::VectorXd control_upper = {};
  /// Named values that change between solves, such as an estimated surface
  std::vector<InputSpec> inputs = {};
  /// Name of a vector input of nv entries with a constant InputSpec.value; empty: none
  /// @more The value is a torque on the joints, in addition to all torques of the model
  std::string torque_bias_input = {};
  std::vector<Stage> stages = {};
  std::vector<HorizonSegment> horizon = {};
  std::vector<CostTerm> terminal = {};  ///< Costs of the last state
  std::vector<Constraint> terminal_constraints = {};
  /// Initial state: q and v, then tau with a torque model, then the force states
  Eigen::VectorXd initial_state = {};
  double start_time = 0.0;  ///< Time of the first knot [s]
};

/// Returns the specification with contacts for all kinematic loops of the robot, active in every
/// stage. The constructor of Problem calls with_loops(). Contacts for loops that `spec` already
/// contains are not changed. The gains of added contacts come from LoopGains::for_step(), with the
/// longest step of all stages. Throws Error if another contact has the name of a loop.
ProblemSpec with_loops(ProblemSpec spec);

/// Returns the specification with SlidingFriction::speed, the fade speed of tool friction, filled
/// in for every contact with friction. A stated fade speed is not changed. Otherwise the fade speed
/// is
///   max(0.01 m/s, 4 c N step / m),
/// the largest value over all stages in which the contact is active. In one step, friction changes
/// the speed of the tool by c N step / m. Here c is the friction coefficient (0.3 if it is zero). N
/// is the largest normal force in costs and constraints of the stage, or else the weight of m. The
/// mass m is the smallest effective mass of the tool along the surface, at the initial state.
ProblemSpec with_fade_speeds(ProblemSpec spec);

/// Returns the duration of each knot of the horizon [s]; 0 at impacts. Throws Error if the horizon
/// is invalid.
std::vector<double> knot_steps(const ProblemSpec& spec);

/// Returns the joints that an actuation drives. Throws Error for an unknown joint name.
std::vector<const Joint*> driven_joints(const Model& model, const ActuationSpec& actuation);

}  // namespace burnish
