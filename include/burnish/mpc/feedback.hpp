// The plan of a solve as a controller between two solves: a policy along the horizon.
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

/// u = feedforward + gain (x (-) state): the triple that linear feedback controllers take.
/// @described mpc @result
/// As in ros2_control.
struct LinearFeedback {
  Eigen::VectorXd feedforward;  ///< nu, Nm (N)
  Eigen::MatrixXd gain;   ///< nu x ndx: by position, velocity and, with a torque model, torque
  Eigen::VectorXd state;  ///< nx, (q, v) or (q, v, tau)
};

/// A copy of the first knots of a solution. Allocates when made, never afterwards. Not for several
/// threads at once, not even its const functions.
class FeedbackPlan {
 public:
  /// Room for `knots` knots of the problem's horizon, all of them if there are no more; step: s
  /// between them. The problem must outlive the plan. Throws Error for fewer than one knot and for
  /// a step that is not positive.
  FeedbackPlan(const ShootingProblem& problem, int knots, double step);
  /// Room for a knot per step, s, whose lengths may differ; all of the horizon's if there are no
  /// more. Throws Error for no steps and for one that is not positive.
  FeedbackPlan(const ShootingProblem& problem, std::span<const double> steps);

  /// Copies the solver's trajectory and gains, to hold from `time` on. The solver must be one of
  /// the plan's problem. Rows of controls that a knot does not have are zero.
  void load(const DdpSolver& solver, double time) noexcept;
  /// The same, with knots at other times than before; `times` has at least the plan's knots.
  void load(const DdpSolver& solver, double time, const KnotTimes& times) noexcept;
  /// Of what was loaded, from another time on.
  void begin_at(double time) noexcept { start_ = time; }
  /// What another plan of the same problem and knots holds, which a second thread may ask
  /// meanwhile.
  void follow(const FeedbackPlan& other) noexcept;
  void clear() noexcept { loaded_ = false; }
  bool empty() const { return !loaded_; }
  int knots() const { return knots_; }
  /// s, of a knot, 0 to knots(); the last is the end.
  double time_of(int knot) const { return start_ + times_.after(knot); }
  double start() const { return start_; }  ///< s

  /// The policy at a time: the controls and gains of the knot that it falls into, about a state
  /// between that knot's and the next one's. Before the start it is the policy there; after the
  /// last knot, the last controls and gains about the last state. `out` has its sizes from
  /// make_feedback(), and stays as it is while the plan is empty.
  void at(double time, LinearFeedback& out) const noexcept;
  LinearFeedback make_feedback() const;
  /// u = feedforward + gain (x (-) state); u: nu, x: nx.
  void control(const LinearFeedback& feedback, const Eigen::VectorXd& x,
               Eigen::VectorXd& u) const noexcept;

 private:
  const ShootingProblem* problem_;
  int knots_;
  KnotTimes times_;
  double start_ = 0.0;
  bool loaded_ = false;
  RowMatrix x_, u_;
  std::vector<Eigen::MatrixXd> gain_;
  mutable Eigen::VectorXd dx_;
};

}  // namespace burnish
