// Model predictive control of a contact task: a horizon that moves with time, solved again and
// again from the measured state, and its policy in between.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "burnish/mpc/controller.hpp"
#include "burnish/mpc/fault.hpp"
#include "burnish/mpc/feedback.hpp"
#include "burnish/mpc/model_error.hpp"
#include "burnish/mpc/schedule.hpp"
#include "burnish/ocp/problem.hpp"
#include "burnish/solver/options.hpp"

namespace burnish {

/// What the task asks of the tool at a time of the schedule, for the record and the faults.
struct TaskTarget {
  Eigen::Vector3d p_world = Eigen::Vector3d::Zero();  ///< m
  double force = 0.0;                                 ///< N, along the normal; 0: no contact wanted
};

/// When a run is given up. Infinite: never.
struct SafetyLimits {
  double force = 100.0;            ///< N, measured at the tool
  double tool_speed = 1.0;         ///< m/s
  double joint_speed_ratio = 1.2;  ///< of the model's velocity limits
  double joint_margin = 0.05;      ///< rad (m) that a joint may be beyond its limit
  double stale = 0.02;             ///< s without a new measurement
  double bad = 0.01;               ///< s of bad measurements that the last good one bridges
  double contact_lost = 0.15;      ///< s without force where it is wanted
  double contact_threshold = 2.0;  ///< N of normal force that count as contact
  double unexpected_force = 15.0;  ///< N while no contact is wanted
  int failed_solves = 5;           ///< in a row
  double deadline = std::numeric_limits<double>::infinity();  ///< s of wall clock per update
  int late_solves = 5;                                        ///< in a row
};

/// How the robot is brought to rest after a fault: gravity compensation and damping, tau = b(q, 0)
/// - damping * diag(M) v, within the torque limits. No contact force is asked for.
struct Fallback {
  double damping = 8.0;  ///< 1/s
};

struct MpcSpec {
  /// Horizon, stages, costs. The horizon's stages are replaced by what the schedule says, so its
  /// segments matter for the number of knots alone; all stages have the same step.
  ProblemSpec problem;
  std::vector<SchedulePhase> schedule = {};
  std::string tool = "tool";
  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();  ///< of the surface, towards the robot
  std::function<TaskTarget(double time)> target = {};       ///< by time of the schedule
  double tick_period = 5e-4;                                ///< s
  double update_period = 0.01;  ///< s between solves, a multiple of the tick
  double solver_delay = 0.0;    ///< s from a measurement to the use of its plan; predicted over
  DdpOptions solver = {.update = StepUpdate::MultipleShooting, .max_iterations = 1};
  int first_iterations = 100;  ///< of the first solve, and
  int jump_iterations = 3;     ///< of one after the schedule's clock jumped
  ModelErrorOptions model_error = {};
  SafetyLimits limits = {};
  Fallback fallback = {};
  bool feedback = true;  ///< the Riccati policy between solves; without, the planned torque is held
};

/// The controller of the paper's section IV and more. Ticks allocate nothing and throw nothing; a
/// run that starts with a state outside what can be solved is a fault like any other.
///
/// Each tick: (1) the measurement is checked; (2) the model error is estimated; (3) the force at
/// the tool is estimated from torques, positions and velocities by forward dynamics; (4) the
/// schedule's clock goes on, contact being a measured normal force above the threshold; (5) when an
/// update is due, the horizon is given its stages and targets and solved from the measured state,
/// or the one that the policy is predicted to lead to after `solver_delay`; (6) the policy gives
/// the torque, within the effort limits; (7) limits are checked. The first fault latches the
/// fallback until reset().
class MpcController final : public Controller {
 public:
  /// Throws Error with one sentence for a specification that does not fit together.
  explicit MpcController(MpcSpec spec);
  ~MpcController() override;

  int nv() const override;
  void reset() noexcept override;
  const Command& tick(const Measurement& measurement) noexcept override;

  const FaultReport& fault() const;
  /// The policy in use: feedforward torque, gains, linearisation state.
  const LinearFeedback& feedback() const;
  const Eigen::VectorXd& torque_error() const;  ///< nv, estimated, Nm (N)
  double force_error() const;                   ///< N, estimated (ModelErrorKind::Force)
  const Schedule& schedule() const;
  const Problem& problem() const;
  /// States of the plan, (N + 1) x nx, as solved last.
  MatrixView plan() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
