// Model predictive control of a task: an optimal control problem over a moving horizon is solved
// repeatedly from the measured state. Tasks are defined by mpc/task.hpp.
#pragma once

#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "burnish/mpc/controller.hpp"
#include "burnish/mpc/fault.hpp"
#include "burnish/mpc/feedback.hpp"
#include "burnish/mpc/friction_estimate.hpp"
#include "burnish/mpc/model_error.hpp"
#include "burnish/mpc/task.hpp"
#include "burnish/ocp/problem.hpp"
#include "burnish/solver/options.hpp"

namespace burnish {

class DdpSolver;

/// Limits beyond which a controller raises a fault, in every task. A task may have further limits.
/// An infinite limit is never exceeded.
/// @described mpc
struct SafetyLimits {
  /// Largest joint speed, as a multiple of the robot's velocity limit, > 0 or infinite
  double joint_speed_ratio = 1.2;
  /// Largest distance of a joint beyond its position limit [rad], >= 0
  /// @more For prismatic joints the unit is m
  double joint_margin = 0.05;
  /// Longest time without a new measurement [s], > 0 or infinite
  /// @more The time must be longer than the tick period
  double stale = 0.02;
  /// Longest time with invalid measurements [s], > 0 or infinite
  /// @more During this time, the feedback policy continues from the last valid measurement
  double bad = 0.01;
  /// Number of failed solves in a row that raises a fault, >= 1
  /// @more A failed first solve raises a fault at once
  int failed_solves = 5;
  /// Longest computing time of a plan, as wall-clock time [s], >= 0 or infinite
  /// @more The first plan, which is computed at rest, may take longer
  double deadline = std::numeric_limits<double>::infinity();
  /// Number of late plans in a row that raises a fault, >= 1
  /// @more A plan is late if its computing time exceeds `deadline`
  int late_solves = 5;
  /// Longest time without a position estimate of a floating base [s], > 0 or infinite
  double base_lost = 0.05;
  /// Largest sliding distance of a foot along the ground within about a second [m], > 0 or infinite
  double support_slip = 0.2;
  /// Largest torque error of a motor, as a fraction of its effort limit, > 0 or infinite
  /// @more The torque error is the difference between measured and commanded torque, as a mean over
  /// 30 ms. Beyond the limit, the motor counts as failed. While a motor delivers less than a fifth
  /// of its command, the limit is multiplied by 0.6. A finite limit requires measured torques
  double torque_gap = std::numeric_limits<double>::infinity();
};

/// Reaction of plans to a slipping support, such as a foot: plans reduce the coefficient of
/// friction of that support. The reduced coefficient is `friction_fraction` times the measured
/// ratio of tangential to normal force. Without measured forces, the reduced coefficient is
/// `min_friction`. A support counts as slipping if its load (if measured), its sliding speed and
/// its sliding distance within about a second all exceed their thresholds.
/// @described mpc
/// The reduced coefficient applies to the residuals FrictionCone and CenterOfPressure of supports
/// that are in contact in every stage. Supports without a FrictionCone are not affected.
struct SlipOptions {
  /// Reduce the friction coefficient of supports that slip
  bool enabled = true;
  /// Sliding distance above which a support can count as slipping [m], >= 0
  double distance = 2.5e-3;
  /// Sliding speed (mean over 5 ms) above which a support can count as slipping [m/s], >= 0
  double speed = 0.02;
  /// Load above which a support can count as slipping [N], >= 0
  double load = 30.0;
  /// Reduced friction coefficient, as a fraction of the measured ratio of tangential to normal
  /// force of the slipping support, 0 to 1
  double friction_fraction = 0.7;
  /// Lower limit of the reduced friction coefficient, > 0
  double min_friction = 0.02;
  /// Time constant of the reduction of the friction coefficient [s], >= 0
  /// @more Without measured forces, the time constant is doubled. The reduction is gradual, because
  /// the solver would not find a good plan after an abrupt change
  double easing = 0.05;
  /// Rate at which the friction coefficient recovers while the support does not slip [1/s], >= 0
  double recovery = 0.1;
  /// Radius of spherical feet (0: feet are not spherical) [m], >= 0
  /// @more Rolling of a spherical foot does not count as slipping
  double radius = 0.0;
};

/// Spring and damper in the joints that stop the robot after a fault and hold it there. The torque
/// of the actuated joints is tau = b(q, 0) - M (stiffness e + damping v), clipped to the effort
/// limits. M is the mass matrix, b(q, 0) the gravity torque, v the joint velocity and e = q (-)
/// q_hold the spring deflection. q_hold is the configuration at the fault. If the spring torque of
/// a joint would exceed `saturation_fraction` times its effort limit, q_hold follows the robot.
/// @described mpc
/// With the index a for rows and columns of the actuated joints, the control law is tau_a = b_a(q,
/// 0) - M_aa (stiffness e_a + damping v_a). The control law requests no contact force. A motor that
/// has failed (FaultKind::MotorLost) gets no torque. On a robot with kinematic loops or supports,
/// the other motors then hold the robot as if the joint of the failed motor were free.
///
/// For a robot on supports (MpcSpec::supports), M and b are computed with the supports in contact.
/// If the sensor of a support measures no load, the support is left out, and the support's leg is
/// held like a hanging leg.
///
/// If the spring torque M_aa stiffness e_a exceeds `saturation_fraction` times the effort limit of
/// a joint, q_hold moves towards q until no joint exceeds that torque. A fast robot is therefore
/// braked and held where it stops, and a person can push it aside. A constant torque error d of the
/// model moves the robot by only (stiffness M_aa)^-1 d. Joints without an effort limit do not move
/// q_hold. A floating base is not held.
///
/// Without a valid measurement, v in the damping term decays from the last measured value at the
/// rate `damping`. The spring is switched off after 10 ms, or after SafetyLimits::bad if this time
/// is shorter. The fallback bridges only short gaps between measurements: a robot that stays
/// without measurements is not held and needs its brakes. When measurements return after the spring
/// was switched off, q_hold is set to the measured configuration.
struct Fallback {
  /// Spring stiffness per inertia (0: a damper brakes the robot, no spring) [1/s^2], >= 0
  double stiffness = 900.0;
  /// Damping, multiplied by the mass matrix [1/s], >= 0
  double damping = 40.0;
  /// Largest spring torque, as a fraction of a joint's effort limit, 0 to 1
  double saturation_fraction = 0.15;
};

/// Time at which a newly computed plan replaces the previous one.
/// @described mpc
enum class PlanTiming {
  /// A plan is used a fixed time, solver_delay, after the measurement from which it was computed
  Fixed,
  /// A plan is used when its measured computing time has passed in simulated time
  /// @note Until then the previous plan stays in use, and the next solve does not begin.
  Measured,
  /// A plan is used as soon as a background thread has computed it
  /// @note Ticks do not wait for the thread. The thread calls functions of the specification.
  Thread,
};

/// Specification of a model predictive controller. The controller repeatedly solves an optimal
/// control problem over a moving horizon from the measured state. Between solves, the controller
/// applies the feedback policy of the last solution.
/// @described mpc
struct MpcSpec {
  /// Optimal control problem: model, stages, costs and horizon
  /// @more The schedule selects the stage of each knot. The segments of the horizon define only the
  /// number of knots and their steps
  /// @required
  /// @note Unless the horizon's segments state steps, all stages must have the same step. A knot
  /// belongs to the phase that contains the knot's time. If steps differ, the knot nearest to a
  /// change of phase is moved to the time of the change.
  ProblemSpec problem;
  std::vector<SchedulePhase> schedule = {};
  /// Function that creates the task, which defines events and monitored quantities; none: no task
  MakeTask task = {};
  /// Frame at which Measurement::tool_force_world acts
  std::string tool = "tool";
  /// Robot frame that carries the surface, such as a plate in the other hand; empty: the world
  /// @more The reaction to the force on the tool acts on this frame
  std::string base = {};
  /// Normal of the surface that the tool presses on, in the axes of `base` (world axes if `base` is
  /// empty)
  /// @more The normal points towards the robot. Friction acts perpendicular to the normal
  Eigen::Vector3d normal_base = Eigen::Vector3d::UnitZ();
  /// Normal force above which the tool counts as in contact [N]
  /// @after force_sensor
  double contact_threshold = 2.0;
  /// Names of the contacts that the robot stands on or leans against
  /// @more The fallback and the estimators use the supports that are in contact in every stage. A
  /// robot with a floating base needs at least one such support. Supports that are in contact only
  /// in some stages, such as hands on a wall, require support_sensors
  std::vector<std::string> supports = {};
  /// Whether Measurement.support_wrenches is measured, with one column per entry of `supports`
  /// @more Torque errors are then estimated in all joints, including the joints of supporting legs
  bool support_sensors = false;
  /// Whether Measurement.tool_force_world is measured; if false, the force at the tool is estimated
  /// @more The estimated force explains the change of the torque error at contact. The estimate
  /// uses torques, positions and velocities, and requires model_error.kind torque
  bool force_sensor = true;
  /// Time between ticks [s]
  double tick_period = 5e-4;
  /// Time between solves, a multiple of the tick period [s]
  double update_period = 0.01;
  /// Time before the first plan during which the fallback holds the robot in place [s], >= 0
  /// @more The estimators settle during this time. The schedule begins afterwards
  double settle = 0.0;
  /// When a new plan comes into use: fixed, measured or thread
  PlanTiming timing = PlanTiming::Fixed;
  /// Time from a measurement to the use of the plan computed from that measurement [s]
  /// @more With timing fixed, the delay is at most the update period. The new plan starts from the
  /// state that is predicted for the end of the delay under the current policy
  double solver_delay = 0.0;
  /// Assumed delay from a torque command to the torque in the joint, rounded to ticks [s]
  /// @more The state at the end of the delay is predicted from the torques already sent. Plans and
  /// feedback start from the predicted state. The model error is estimated from the torque that
  /// acted at the time of the measurement
  double command_delay = 0.0;
  /// Assumed delay from a measurement to the tick that receives it [s]
  /// @more The controller predicts the state over the sum of both delays, command_delay and
  /// measurement_delay. Measurement.time must be the time of the receiving tick
  double measurement_delay = 0.0;
  /// Factor on measured computing times, to simulate a slower computer
  /// @more The factor is used only if `timing` is `measured`
  double slowdown = 1.0;
  DdpOptions solver = {
      .update = StepUpdate::MultipleShooting, .max_iterations = 1, .limits = {.tolerance = 1e-6}};
  /// Maximum number of iterations of the first solve
  int first_iterations = 100;
  /// Maximum number of iterations of a solve right after the schedule's clock jumped or waited
  int jump_iterations = 3;
  /// Maximum number of Riccati recursions per iteration if the problem has constraints
  /// @more The number of sweeps that reuse a factorization has the same maximum. The entries
  /// max_factorizations, max_sweeps and max_l1_weight of solver.limits are ignored
  int max_factorizations = 8;
  /// Maximum number of Riccati recursions per iteration in the first solve
  /// @more This maximum is also used in a solve right after the schedule's clock jumped or waited
  int first_max_factorizations = 50;
  /// Additional limits on the commanded torques, nv entries [Nm (N)]; empty: no additional limits
  /// @more The robot's effort limits always apply. The fallback uses only the effort limits
  Eigen::VectorXd torque_limit = {};
  ModelErrorOptions model_error = {};
  /// Estimation of the friction coefficient at the tool, for contacts with ContactSpec.friction
  FrictionEstimateOptions friction_estimate = {};
  SlipOptions slip = {};  ///< Reaction of plans to slipping supports
  SafetyLimits limits = {};
  Fallback fallback = {};
  /// Apply the Riccati feedback policy between solves; if false, the planned torque is held
  bool feedback = true;
};

/// Model predictive controller after section IV of Kleff et al. (see docs/frames.md), with
/// extensions.
///
/// Call tick() once per `tick_period` with the current measurement. reset() restores the state of a
/// new controller, except for payloads. With PlanTiming::Fixed, the same measurements after a
/// reset() give bitwise the same torques. The first measurement may have any time. The schedule's
/// clock starts at that time.
///
/// The first solve may take long: it runs until it converges or reaches `first_iterations`. With
/// PlanTiming::Thread, the fallback holds the robot during the first solve, and the schedule's
/// clock stands still. With PlanTiming::Measured and PlanTiming::Thread, an update that is due
/// waits until the previous plan is finished.
///
/// Steps of a tick:
///  1. The measurement is checked.
///  2. The model error is estimated, with the torque commanded at the previous tick. The force at
///     the tool is estimated from torques, positions and velocities by forward dynamics.
///  3. The schedule's clock advances, with the events that the task detected.
///  4. The limits of the controller are checked, then the limits of the task.
///  5. When an update is due, the stages and targets of the horizon are set, and the problem is
///     solved from the measured state, with the last solution as warm start. With a `solver_delay`,
///     the problem is solved from the state predicted for the end of the delay.
///  6. The policy computes the torque, which is clipped to the torque limits.
/// If commands or measurements have a delay, steps 5 and 6 use the state that is predicted for the
/// time when the torque acts.
///
/// Plans satisfy the constraints of the problem as far as `max_factorizations` recursions suffice.
/// Command::constraint_residual is the remaining residual, and Command::constraint_violation is the
/// violation along the plan. Torques are clipped to `torque_limit` before they are sent. If the
/// hard constraints cannot all be satisfied from the measured state on, their violation is
/// penalized with the L1 penalty weight `solver.limits.l1_weight`. The controller follows the
/// resulting plan and sets Command::constraints_infeasible.
///
/// After an invalid measurement (NaN, wrong size, or a time that does not increase), the policy
/// continues from the last valid measurement until SafetyLimits::bad or SafetyLimits::stale has
/// passed. If an update fails, the previous plan stays in use. The first fault activates the
/// fallback until reset(). fault() then returns the fault with a record of the last second. The
/// fallback also computes the torque before the first plan. The torque is always finite.
///
/// Ticks do not throw. They allocate only if functions in the specification (targets, residuals,
/// the solver's callback) allocate. Exceptions of targets and residuals are caught, in any thread
/// of the solver. The update then counts as failed, and take_exception() returns the exception. If
/// the problem has a torque model, the command is the input of that model's filter, and the
/// actuators must have the same lag.
class MpcController final : public Controller {
 public:
  /// Creates the controller. Throws Error with one sentence if the specification is inconsistent.
  explicit MpcController(MpcSpec spec);
  ~MpcController() override;

  int nv() const override;
  void reset() noexcept override;
  const Command& tick(const Measurement& measurement) noexcept override;

  /// Sets the payload that the robot carries from the next tick on. `payload`: inertia in the axes
  /// of `frame`. A previous payload of the same body is replaced. Plans, estimators and the
  /// fallback use the payload, and reset() does not remove it. Call set_payload() between ticks.
  /// The call does not allocate. If a thread is computing a plan, the call waits for the plan.
  ///
  /// If check_inertia() reports NotFinite or NotPhysical, returns that status and changes nothing;
  /// otherwise returns Ok. Throws Error for an unknown frame, with the nearest name, and for a
  /// frame that is fixed to the world.
  ///
  /// Also throws Error if measurements come from an EstimatedBase, which does not account for
  /// payloads. Put the payload into the model with with_payload() instead. If measurements of an
  /// EstimatedBase begin after the payload was set, Command::status is NotPhysical and the fallback
  /// holds the robot.
  Status set_payload(std::string_view frame, const InertiaSpec& payload);
  bool carries_payload() const noexcept override;
  void expect_estimated_base() noexcept override;

  /// Returns the first fault since reset(). FaultReport::kind is None if there was no fault.
  const FaultReport& fault() const;
  /// Returns and clears the first exception that a function of the specification threw since
  /// reset() or since the previous call of take_exception(); null if there was none.
  std::exception_ptr take_exception() noexcept;
  /// Returns the feedback policy of the last tick: feedforward torque, gains, and the state at
  /// which the policy is linearized.
  const LinearFeedback& feedback() const;
  /// Returns the estimated torque error, nv entries [Nm, or N]. The torque error is the sum of the
  /// observer's estimate and the joint torques due to friction along the surface. The friction is
  /// the estimated ratio of friction to normal force, times the target force.
  const Eigen::VectorXd& torque_error() const;
  /// Returns the estimated error of the normal force [N]. It is estimated only with
  /// ModelErrorKind::Force.
  double force_error() const;
  /// Returns the coefficients of friction that plans use for supports (see SlipOptions). Only
  /// supports in contact in every stage have an entry, in the order of ProblemSpec::contacts. If a
  /// support has no friction cone, its entry is infinite.
  const Eigen::VectorXd& support_friction() const;
  const Schedule& schedule() const;
  /// Returns the time since the measurement from which the plan in use was computed [s]; infinite
  /// if there is no plan.
  double plan_age() const;
  const Problem& problem() const;
  /// Returns the states of the most recent plan, (N + 1) x nx for N knots. With a solver delay, the
  /// most recent plan may not be in use yet. Do not call this function while a thread computes a
  /// plan (PlanTiming::Thread).
  MatrixView plan() const;
  /// Returns the solver, which contains the trajectory, gains and value function of the most recent
  /// plan. Do not call this function while a thread computes a plan (PlanTiming::Thread).
  const DdpSolver& solver() const;
  /// Returns the cost of each term at `knot` of the most recent plan, in the order of
  /// problem().term_names(knot). Costs are multiplied by the knot's step. Throws Error for a knot
  /// out of range. Allocates, so do not call this function in ticks or while a thread computes a
  /// plan.
  std::vector<double> plan_costs(int knot);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
