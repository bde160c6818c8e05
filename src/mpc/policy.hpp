// Feedback policy of an MpcController between two solves. It holds the plan in use and the next
// plan.
#pragma once

#include <limits>
#include <vector>

#include "burnish/mpc/feedback.hpp"
#include "burnish/ocp/problem.hpp"
#include "burnish/solver/ddp.hpp"

namespace burnish {

/// Settings of a Policy.
struct PolicySpec {
  std::vector<double>
      steps;           ///< Steps of the knots that the policy keeps, from the first knot on [s].
  bool feedback;       ///< Whether gains are applied; if false, the planned control of the knot is
                       ///< applied alone.
  double tick_period;  ///< Time between ticks [s].
};

class Policy {
 public:
  /// Reserves memory for plans of `problem`.
  Policy(const PolicySpec& spec, const Problem& problem);

  void reset() noexcept;
  /// Loads the solver's solution as the next plan. The plan begins at `time` [s]; `times` are the
  /// times of its knots relative to `time`. The plan comes into use at `time` or at `done` [s],
  /// whichever is later. `measured`: time of the measurement from which the plan was computed [s].
  void load(const DdpSolver& solver, double time, const KnotTimes& times,
            double done = -std::numeric_limits<double>::infinity(),
            double measured = -std::numeric_limits<double>::infinity()) noexcept;
  /// First part of load(), with most of the work. A planning thread may call it while ticks run,
  /// provided that waits() is false.
  void fill(const DdpSolver& solver, const KnotTimes& times) noexcept;
  /// Second part of load(), with little work. The parameters are those of load().
  void offer(double time, double done, double measured) noexcept;
  /// Copies the plan that `other` uses, so that a prediction can use it while ticks run.
  void follow(const Policy& other) noexcept { plan_.follow(other.plan_); }
  bool waits() const { return next_ready_; }  ///< True if a loaded plan is not yet in use.
  /// Returns the time of the measurement from which the plan in use was computed [s].
  double measured() const { return measured_; }
  /// Replaces the plan in use by the loaded plan once the time of that plan has come.
  void take_over(double now) noexcept;
  /// Computes the control u (nu) by the plan in use at the time `time` [s] and the state x (nx).
  /// The control is clipped to the effort limits.
  void control(double time, const Eigen::VectorXd& x, Eigen::VectorXd& u) noexcept;
  /// Adds `torque` [Nm or N] to entry i of the feedforward in feedback().
  void add_feedforward(int i, double torque) noexcept { feedback_.feedforward[i] += torque; }
  /// Returns the affine policy at the last control().
  const LinearFeedback& feedback() const { return feedback_; }

 private:
  FeedbackPlan plan_, next_;
  LinearFeedback feedback_;
  Eigen::VectorXd effort_;  ///< Effort limits, nu [Nm or N].
  bool feeds_back_;
  double rounding_;  ///< Tolerance of the time at which a plan comes into use [s].
  /// Time of the measurement from which plan_ was computed [s].
  double measured_ = -std::numeric_limits<double>::infinity();
  double next_measured_ = 0.0;  ///< Time of the measurement from which next_ was computed [s].
  double next_time_ = 0.0;      ///< Time at which next_ comes into use [s].
  bool next_ready_ = false;     ///< True if next_ is loaded and not yet in use.
};

}  // namespace burnish
