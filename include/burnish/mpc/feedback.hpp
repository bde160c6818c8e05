// Feedback policy over the horizon, copied from a solution. A controller applies the policy between
// two solves.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "burnish/base/views.hpp"
#include "burnish/mpc/knot_times.hpp"
#include "burnish/solver/shooting_problem.hpp"

namespace burnish {

class DdpSolver;

/// Linear feedback law for the control u at the state x: u = feedforward + gain (x (-) state). The
/// sign (-) stands for the difference of two states on their manifold.
/// @described mpc @result
/// Linear feedback controllers of ros2_control use laws of this form, too.
struct LinearFeedback {
  /// Feedforward torques, nu entries [Nm (N)]
  Eigen::VectorXd feedforward;
  /// Feedback gains, nu x ndx. Columns: position, velocity and, with a torque model, torque
  Eigen::MatrixXd gain;
  /// State at which the law is linearized, nx entries: (q, v), or (q, v, tau) with a torque model
  Eigen::VectorXd state;
};

/// Feedback policy over time, copied from the first knots of a solution. Only the constructors
/// allocate. Two threads must not call at() or control() of one FeedbackPlan at the same time,
/// because both functions write to its scratch memory.
class FeedbackPlan {
 public:
  /// Allocates space for the first `knots` knots of the problem's horizon, or for the whole horizon
  /// if the horizon has fewer knots. `step`: time between knots [s]. The problem must outlive the
  /// plan. Throws Error if `knots` is less than 1 or `step` is not positive.
  FeedbackPlan(const ShootingProblem& problem, int knots, double step);
  /// Allocates space for one knot per entry of `steps`. Each entry is the time from that knot to
  /// the next one [s]. Entries beyond the end of the problem's horizon are ignored. The problem
  /// must outlive the plan. Throws Error if `steps` is empty or an entry is not positive.
  FeedbackPlan(const ShootingProblem& problem, std::span<const double> steps);

  /// Copies the trajectory and gains of `solver`. The plan then starts at `time` [s]. `solver` must
  /// solve the problem that was passed to the constructor. If a knot has fewer controls than other
  /// knots, zeros replace its missing controls and gain rows.
  void load(const DdpSolver& solver, double time) noexcept;
  /// Copies the trajectory and gains of `solver`, and the knot times in `times`. The plan then
  /// starts at `time` [s]. `times` must have at least knots() knots; further knots are ignored.
  void load(const DdpSolver& solver, double time, const KnotTimes& times) noexcept;
  /// Shifts the loaded plan in time so that it starts at `time` [s].
  void begin_at(double time) noexcept { start_ = time; }
  /// Copies the content of `other`, which must have the same problem and number of knots. Another
  /// thread may evaluate `other` at the same time.
  void follow(const FeedbackPlan& other) noexcept;
  void clear() noexcept { loaded_ = false; }
  bool empty() const { return !loaded_; }
  int knots() const { return knots_; }
  /// Returns the time of `knot` [s]. `knot` is between 0 and knots(). The value knots() means the
  /// end of the plan.
  double time_of(int knot) const { return start_ + times_.after(knot); }
  double start() const { return start_; }  ///< Time at which the plan starts [s]

  /// Writes the policy at `time` [s] into `out`. Controls and gains come from the knot whose step
  /// contains `time`. The state is interpolated between this knot and the next one. A time outside
  /// the plan is replaced by the start or the end of the plan. `out` must have the sizes of the
  /// result of make_feedback(). If the plan is empty, `out` stays unchanged.
  void at(double time, LinearFeedback& out) noexcept;
  LinearFeedback make_feedback() const;
  /// Writes the control that `feedback` gives at the state `x` (nx entries) into `u` (nu entries).
  void control(const LinearFeedback& feedback, const Eigen::VectorXd& x,
               Eigen::VectorXd& u) noexcept;

 private:
  const ShootingProblem* problem_;
  int knots_;
  KnotTimes times_;
  double start_ = 0.0;
  bool loaded_ = false;
  RowMatrix x_, u_;
  std::vector<Eigen::MatrixXd> gain_;
  Eigen::VectorXd dx_;  ///< Scratch: difference of two states
};

}  // namespace burnish
