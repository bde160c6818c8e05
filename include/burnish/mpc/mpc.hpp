// Model predictive control of a task: a horizon that moves with time, solved again and again from
// the measured state, and its policy in between. What the task is, it gives: mpc/task.hpp.
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

/// When a run is given up, whatever the task; the task's own limits are its. Infinite: never.
/// @described mpc
struct SafetyLimits {
  double joint_speed_ratio = 1.2;  ///< of the robot's velocity limits, > 0 or infinite
  /// [rad] that a joint may be beyond its limit, >= 0 @more m of prismatic joints
  double joint_margin = 0.05;
  double stale = 0.02;  ///< [s] without a new measurement, > 0 or infinite @more longer than a tick
  /// [s] of measurements that are no state, > 0 or infinite @more which the last good one bridges
  double bad = 0.01;
  int failed_solves = 5;  ///< in a row, >= 1 @more the first solve may not fail
  /// [s] of computing time per plan, >= 0 or infinite @more of wall clock; the first one, made at
  /// rest, may take longer
  double deadline = std::numeric_limits<double>::infinity();
  int late_solves = 5;  ///< in a row, >= 1
  /// [s] without anything that tells where a floating base is, > 0 or infinite
  double base_lost = 0.05;
  /// [m] along the ground that a foot may have slid within the last second, about, > 0 or infinite
  double support_way = 0.2;
  /// of a joint's effort limit, that the measured torque may be off the commanded one, mean over 30
  /// ms: a motor that fails, > 0 or infinite @code of a joint's effort limit, that the measured
  /// torque may be off the commanded one, mean over 30 ms: a motor that fails; 0.6 of that where it
  /// gives less than a fifth of what it is told. For measurements that have torques.
  double torque_gap = std::numeric_limits<double>::infinity();
};

/// What plans make of a support that holds always and slips all the same: they keep its forces
/// within what it was felt to bear while it did, or, where that is not measured, within the least.
/// It slips while it bears `load`, has slid by `way` along the ground within the last second and
/// goes on faster than `speed`.
/// @described mpc
/// What they reckon with is the friction of its FrictionCone and CenterOfPressure, among the
/// constraints; supports without a cone are left alone.
struct SlipOptions {
  bool enabled = true;  ///< plans are told of feet that slip
  double way = 2.5e-3;  ///< [m], >= 0
  double speed = 0.02;  ///< [m/s], mean over 5 ms, >= 0
  double load = 30.0;   ///< [N], >= 0
  double share = 0.7;   ///< of what was felt, that plans keep within, 0 to 1
  double least = 0.02;  ///< coefficient of friction that plans are always left, > 0
  /// [s] in which they are told, twice that where it is not measured: what changes at once has no
  /// good plan, >= 0
  double easing = 0.05;
  double recovery = 0.1;  ///< [1/s], coefficient by which they trust it again while it rests, >= 0
  double radius = 0.0;    ///< [m], of supports that are balls: that they roll is no slip, >= 0
};

/// How the robot is brought to rest after a fault, and held there: tau = b(q, 0) - M (stiffness e +
/// damping v) on the actuated joints, e = q (-) q_hold, within the torque limits. q_hold is where
/// the robot was at the fault, and slips where the spring would use more than `give` of a joint's
/// effort limit.
/// @described mpc
/// The law holds for the rows and columns a of the actuated joints: tau_a = b_a(q, 0) - M_aa
/// (stiffness e_a + damping v_a). No contact force is asked for. A motor that was found to fail
/// (FaultKind::MotorLost) is left out: the others hold the robot as one whose joint is free there.
/// A robot on supports (MpcSpec::supports) is held as one that they carry, and, where their sensors
/// say that they do not, as one that hangs. q_hold slips: where the spring's torque M_aa stiffness
/// e would exceed `give` times a joint's effort limit, q_hold follows q so that it does not. A fast
/// robot is thereby braked and held where it comes to rest, a hand can push it aside, and a wrong
/// model (torques off by d) lets it sink by (stiffness M_aa)^-1 d and no further. Joints without an
/// effort limit do not slip. A floating base is not held. Without a good measurement for more than
/// 10 ms (or SafetyLimits::bad, if that is shorter) there is no spring, and v dies away from its
/// last value as the damping would have it: that bears a gap, but blind for good the robot is not
/// held, and its brakes are to be used. When measurements come back, q_hold is where the robot is
/// then.
struct Fallback {
  /// [1/s^2], times the mass matrix; 0: nothing holds, the arm is braked only, >= 0
  double stiffness = 900.0;
  double damping = 40.0;  ///< [1/s], times the mass matrix, >= 0
  double give = 0.15;     ///< of the torque limits, where the spring slips; 0 to 1, 0 to 1
};

/// When a plan is used, that takes time to be made.
/// @described mpc
enum class PlanTiming {
  Fixed,  ///< solver_delay after the measurement that it starts from
  /// when it would be done: the time that it took passes, as measured, while the plan before goes
  /// on; for simulations @note The next plan begins no earlier.
  Measured,
  /// when it is done: plans are made in a thread of their own @note A tick takes no longer for
  /// them. The functions of the specification are called in that thread.
  Thread,
};

/// Model predictive control of a task: a horizon that moves with time, solved again and again from
/// the measured state, and its policy in between.
/// @described mpc
struct MpcSpec {
  /// Horizon, stages, costs. The schedule replaces the horizon's stages, so its segments matter for
  /// the number of knots and their steps alone. @required @note All stages have the same step
  /// unless the segments state theirs. Where steps differ, the knot nearest to a change of phase
  /// begins there; else a knot is of the phase that it begins in.
  ProblemSpec problem;
  std::vector<SchedulePhase> schedule = {};
  MakeTask task = {};         ///< events of the schedule, what is watched; none: neither
  std::string tool = "tool";  ///< frame that Measurement::tool_force_world acts at
  /// frame that the surface moves with, which the force on the tool pushes back at: of the robot,
  /// as a plate in its other hand; empty: the world
  std::string base = {};
  /// That the tool presses along: of the surface, towards the robot. Friction is across it. In the
  /// axes of `base`, with which it turns.
  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();
  /// [N] along the normal that count as contact @after force_sensor
  double contact_threshold = 2.0;
  /// Contacts of the problem that the robot stands on or leans against, by their names. Those of
  /// every stage are what the fallback and the estimates take to hold always: a base that floats
  /// free wants some. Those of some stages, such as hands on a wall, want support_sensors.
  std::vector<std::string> supports = {};
  /// Measurement.support_wrenches are measured, in the order of `supports`: then the torque error
  /// is known of all joints, of those on supports too
  bool support_sensors = false;
  /// Measurement.tool_force_world is measured; else the force at the tool is what torques,
  /// positions and velocities say beyond what they said in the air just before, which wants
  /// model_error.kind torque
  bool force_sensor = true;
  double tick_period = 5e-4;    ///< [s]
  double update_period = 0.01;  ///< [s] between solves, a multiple of the tick
  /// [s] before the first plan in which the fallback holds the robot where it is, so that what
  /// estimates comes to rest; the schedule begins after it, >= 0
  double settle = 0.0;
  PlanTiming timing = PlanTiming::Fixed;  ///< fixed, measured or thread
  /// [s] from a measurement to the use of the plan that starts from it, at most the update period.
  /// The plan is made for the state that the policy in use leads to by then.
  double solver_delay = 0.0;
  /// [s] from a command to the torque that it makes, as far as it is known; rounded to ticks. Plans
  /// begin in the state that the torques already sent lead to, feedback acts on that state at every
  /// tick, and the model error is told from the torque that acted when it was measured.
  double command_delay = 0.0;
  /// [s] from what is measured to the tick that has it, all but its time, as far as it is known;
  /// see command_delay
  double measurement_delay = 0.0;
  double slowdown = 1.0;  ///< of measured timing: a machine by this factor slower
  DdpOptions solver = {
      .update = StepUpdate::MultipleShooting, .max_iterations = 1, .limits = {.tolerance = 1e-6}};
  int first_iterations = 100;  ///< of the first solve
  int jump_iterations = 3;     ///< of one after the schedule's clock jumped or stood still
  /// recursions per iteration where the problem has limits, and at most as many sweeps with kept
  /// factors; those of solver.limits, and its largest_price, mean nothing here
  int max_factors = 8;
  int first_factors = 50;  ///< likewise of the first solve, and of one after a jump
  /// [Nm] (N), nv: what is sent stays within, and within the robot's effort limits; empty: those
  Eigen::VectorXd torque_limit = {};
  ModelErrorOptions model_error = {};
  /// Of the tool's contacts with friction (ContactSpec.friction): their coefficient.
  FrictionEstimateOptions friction_estimate = {};
  SlipOptions slip = {};  ///< of what the robot stands on
  SafetyLimits limits = {};
  Fallback fallback = {};
  bool feedback = true;  ///< the Riccati policy between solves; without, the planned torque is held
};

/// The controller of the paper's section IV and more.
///
/// A new controller is ready; reset() makes it so again, and the same measurements then give the
/// same torques to the last bit. tick() is to be called once per `tick_period` with what was
/// measured then; the first call that plans solves the problem to its end and may take its time,
/// unless a thread does (PlanTiming::Thread): then the fallback holds the robot where it is, and
/// the schedule's clock stands still, until that plan is there. Times of measurements may start
/// anywhere: the schedule's clock starts at the first one.
///
/// Updates that are due before the plan before is done wait for it, where timing is not fixed.
///
/// Each tick: (1) the measurement is checked; (2) the model error is estimated, from the torque
/// commanded at the tick before, and the force at the tool from torques, positions and velocities
/// by forward dynamics; (3) the schedule's clock goes on, with the events that the task found; (4)
/// limits are checked, the controller's and then the task's; (5) when an update is due,
/// the horizon is given its stages and targets, warm-started from the last solution, and solved
/// from the measured state, or from the one that the policy is predicted to lead to after
/// `solver_delay`; (6) the policy gives the torque, within the effort limits. With known delays the
/// measured state of (5) and (6) is the predicted one in which the torque will act.
///
/// Constraints of the problem are kept by every plan, with as many recursions as `max_factors` says
/// and no more: what that leaves open, and what the plan breaks, is in Command::limits_open and
/// limits_outside, and the torque that is sent is cut to `torque_limit`. Where hard ones cannot all
/// be kept from the measured state on, each gives way at the price of `solver.limits.price`: the
/// plan is the one that breaks them least by that measure, it is followed, and
/// Command::limits_infeasible says so.
///
/// Measurements that are no state (NaN, wrong sizes, time that stands still) are bridged: the
/// policy goes on from the last good one until the limits' `bad` or `stale` is over. An update that
/// fails is bridged by the plan before it. The first fault latches the fallback and fault(), with
/// the last second of ticks, until reset(); before the first good measurement the torque is the
/// fallback's too. Whatever comes in, the torque is finite.
///
/// Ticks allocate nothing and throw nothing, as long as the functions that the specification holds
/// (targets, residuals, the solver's callback) allocate nothing. What targets and residuals throw,
/// in whatever thread of the solver, is caught: the update then counts as failed, and
/// take_exception() has it. With a torque model in the problem the command is its filter's input,
/// and the actuators must have that lag.
class MpcController final : public Controller {
 public:
  /// Throws Error with one sentence for a specification that does not fit together.
  explicit MpcController(MpcSpec spec);
  ~MpcController() override;

  int nv() const override;
  void reset() noexcept override;
  const Command& tick(const Measurement& measurement) noexcept override;

  /// What the robot carries at a frame from the next tick on, in the frame's axes, in the place of
  /// what that frame's body carried before: plans, estimates and the fallback all have it, and
  /// reset() keeps it. Between ticks; allocates nothing; waits for a plan that a thread makes.
  /// Returns Ok, or NotFinite or NotPhysical as check_inertia() does, which changes nothing. Throws
  /// Error with the nearest known name for a frame that there is not, for one that is fixed to the
  /// world, and where the base is estimated (EstimatedBase), which a payload does not reach: put it
  /// into the model with with_payload() instead. Where such a measurement comes first after a
  /// payload, the command's status is NotPhysical and the fallback holds the robot.
  Status set_payload(std::string_view frame, const InertiaSpec& payload);
  bool carries_payload() const noexcept override;
  void expect_estimated_base() noexcept override;

  /// Its kind is None until there is one. reset() clears it.
  const FaultReport& fault() const;
  /// The first exception that a function of the specification threw since reset() or since this was
  /// asked last; null if there was none.
  std::exception_ptr take_exception() noexcept;
  /// The policy of the last tick: feedforward torque, gains, linearisation state.
  const LinearFeedback& feedback() const;
  /// nv, estimated, Nm (N): the observer's, and that of friction along the surface in proportion to
  /// the force that is asked for.
  const Eigen::VectorXd& torque_error() const;
  double force_error() const;  ///< N, estimated (ModelErrorKind::Force)
  /// Of supports that hold always, in their order: the coefficient of friction that plans reckon
  /// with, SlipOptions; infinite where they have no cone.
  const Eigen::VectorXd& support_friction() const;
  const Schedule& schedule() const;
  /// s from the measurement that the plan in use was made from to the last good one; infinite while
  /// there is none.
  double plan_age() const;
  const Problem& problem() const;
  /// States of the plan, (N + 1) x nx, as solved last; with a solver delay not in use yet. This and
  /// what follows is not to be asked while a thread makes the next plan (PlanTiming::Thread).
  MatrixView plan() const;
  /// What solved that plan last: its trajectory, gains and value function.
  const DdpSolver& solver() const;
  /// Cost of each term at a knot of that plan, as problem().term_names(knot) names them; the knots'
  /// steps are in it. For the record: allocates, and is not for ticks.
  std::vector<double> plan_costs(int knot);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
