// The plan in use and the one that is to follow it, as a controller between two solves.
#pragma once

#include <limits>

#include "burnish/mpc/mpc.hpp"

namespace burnish {

class Policy {
 public:
  /// Room for as many knots as are needed until a run is given up for want of plans.
  Policy(const MpcSpec& spec, const Problem& problem);

  void reset() noexcept;
  /// The solver's plan from `time` (s) on, with its knots at these times after; it is there to be
  /// used from `done` on, and was made from the measurement of `measured`.
  void load(const DdpSolver& solver, double time, const KnotTimes& times,
            double done = -std::numeric_limits<double>::infinity(),
            double measured = -std::numeric_limits<double>::infinity()) noexcept;
  /// The two halves of that: what is long, for whoever made the plan to do while none waits to be
  /// taken over, beside ticks; and what is short.
  void fill(const DdpSolver& solver, const KnotTimes& times) noexcept;
  void offer(double time, double done, double measured) noexcept;
  /// The plan in use as the other's, for what is foreseen beside it; while that is asked by ticks.
  void follow(const Policy& other) noexcept { plan_.follow(other.plan_); }
  bool waits() const { return next_ready_; }     ///< a plan, for its time
  double measured() const { return measured_; }  ///< s, that the plan in use was made from
  /// Goes over to the plan that waits, if its time has come.
  void take_over(double now) noexcept;
  /// Of the plan in use at a time (s) and a state x (nx): u (nu), within the effort limits.
  void control(double time, const Eigen::VectorXd& x, Eigen::VectorXd& u) noexcept;
  /// What entry i of the last control() is given besides, Nm (N).
  void add_feedforward(int i, double torque) noexcept { feedback_.feedforward[i] += torque; }
  const LinearFeedback& feedback() const { return feedback_; }  ///< at the last control()

 private:
  FeedbackPlan plan_, next_;
  LinearFeedback feedback_;
  Eigen::VectorXd effort_;  ///< nu, Nm (N)
  bool feeds_back_;
  double rounding_;                                             ///< s
  double measured_ = -std::numeric_limits<double>::infinity();  ///< s, of plan_
  double next_measured_ = 0.0;                                  ///< s
  double next_time_ = 0.0;                                      ///< s, when next_ takes over
  bool next_ready_ = false;                                     ///< next_ waits for its time
};

}  // namespace burnish
