// Specification of a model predictive controller.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/estimate/friction_estimate.hpp"
#include "burnish/estimate/measurement.hpp"
#include "burnish/estimate/model_error.hpp"
#include "burnish/estimate/slip.hpp"
#include "burnish/mpc/task.hpp"
#include "burnish/ocp/problem_spec.hpp"
#include "burnish/solver/options.hpp"

namespace burnish {

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
  /// of its command, the limit is multiplied by 0.6. A difference of more than 0.4 times the limit
  /// counts then after 0.1 s. A finite limit requires measured torques
  double torque_gap = std::numeric_limits<double>::infinity();
};

/// Virtual spring and damper in each joint, to stop and hold the robot after a fault. The torque
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
  /// Ratio of spring stiffness to mass matrix (0: no spring, only the damper) [1/s^2], >= 0
  double stiffness = 900.0;
  /// Ratio of damping to mass matrix [1/s], >= 0
  double damping = 40.0;
  /// Largest spring torque, as a fraction of a joint's effort limit, 0 to 1
  double saturation_fraction = 0.15;
};

/// Time at which a newly computed plan replaces the previous one.
/// @described mpc
enum class PlanTiming {
  /// A plan comes into use solver_delay seconds after the measurement from which it is computed
  Fixed,
  /// A plan comes into use when its measured computing time has passed in simulated time
  /// @note Until then the previous plan stays in use, and the next solve does not begin.
  Measured,
  /// A plan comes into use as soon as a background thread has computed the plan
  /// @note Ticks do not wait for the thread. The thread calls functions of the specification.
  Thread,
};

/// Tool of a controller, which presses on a surface.
/// @described mpc
struct ToolSpec {
  /// Frame of the tool
  std::string frame = "tool";
  /// Robot frame that carries the surface, such as a hand that holds a plate; empty: the world
  /// @more The reaction to the force on the tool acts on this frame
  std::string base = {};
  /// Normal of the surface that the tool presses on, in the axes of `base` (world axes if `base` is
  /// empty)
  /// @more The normal points towards the robot; its length has no effect. Estimates use
  /// this normal until MpcTask::surface() returns a surface. Contacts do not use it: state their
  /// normal in ContactSpec.reference
  Eigen::Vector3d normal_base = Eigen::Vector3d::UnitZ();
  /// Normal force above which the tool counts as in contact [N], >= 0
  double contact_threshold = 2.0;
  /// Estimation of the friction coefficient
  /// @more Contacts between `frame` and `base` that have ContactSpec.friction use the estimate
  FrictionEstimateOptions friction = {};
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
  /// Tools that press on surfaces; none: the robot has no tool
  std::vector<ToolSpec> tools = {};
  /// Names of the contacts that the robot stands on or leans against
  /// @more The fallback and the estimators use the supports that are in contact in every stage. A
  /// robot with a floating base needs at least one such support. Supports that are in contact only
  /// in some stages, such as hands on a wall, require a sensor (`touches`)
  std::vector<std::string> supports = {};
  /// Entries of `supports` that press with a planned force, such as a hand on a table
  /// @more The fallback does not use these supports, even if they are in contact in every stage,
  /// because the fallback would load a hand like a foot. These supports require a sensor
  /// (`touches`)
  std::vector<std::string> resting_supports = {};
  /// Sensors of tools, feet and hands that the controller reads
  /// @more Measurement.wrenches has one column per entry, in this order. A tool without
  /// an entry is assumed to have a force sensor; its column comes before those of the entries. A
  /// NaN in a component that the controller reads makes the measurement invalid. If the entry of
  /// the only tool states the sensor `none`, the force on the tool is estimated from the change of
  /// the torque error at contact. This estimate requires that model_error.kind is `torque`. With a
  /// sensor at each support, torque errors are estimated in all joints, including the joints of
  /// supporting legs. If only some supports have sensors, the others count as rigid contacts. A
  /// support whose rotation is free, such as a point foot, needs no sensor of moments
  std::vector<TouchSensor> touches = {};
  /// Time between ticks [s]
  double tick_period = 5e-4;
  /// Time between solves, a multiple of the tick period [s]
  double update_period = 0.01;
  /// Time before the first plan during which the fallback holds the robot in place [s], >= 0
  /// @more The estimators settle during this time. The schedule begins afterwards
  double settle = 0.0;
  /// Rule for when a new plan comes into use: `fixed`, `measured` or `thread`
  PlanTiming timing = PlanTiming::Fixed;
  /// Time from a measurement to the use of the plan computed from that measurement [s]
  /// @more If `timing` is `fixed`, the delay is at most the update period. The new plan starts from
  /// the state that is predicted for the end of the delay under the current policy
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
  SlipOptions slip = {};  ///< Reaction of plans to slipping supports
  SafetyLimits limits = {};
  Fallback fallback = {};
  /// Apply the Riccati feedback policy between solves; if false, the planned torque is held
  bool feedback = true;
};

/// Returns the sensors of the columns of Measurement::wrenches. The force sensors of tools without
/// an entry come first, then the entries of MpcSpec::touches follow. WrenchSensor::Automatic is
/// replaced with the components that it stands for.
std::vector<TouchSensor> touch_sensors(const MpcSpec& spec);
/// Returns the frames of touch_sensors(). In a simulation, the scene must have a touch (TouchSpec)
/// at each frame.
std::vector<std::string> touches_of(const MpcSpec& spec);
/// Returns the column of Measurement::wrenches with the force at `frame`; -1 if it is not measured.
int wrench_column(const MpcSpec& spec, std::string_view frame);

}  // namespace burnish
