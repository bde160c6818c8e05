// Moving horizon of an MpcController. It sets the stage and the targets of each knot, and the
// initial guess of a solve.
#pragma once

#include "base/to_size.hpp"
#include "burnish/mpc/knot_times.hpp"
#include "burnish/mpc/task.hpp"
#include "burnish/ocp/problem.hpp"
#include "burnish/solver/ddp.hpp"

namespace burnish {

class Horizon {
 public:
  /// `problem` must outlive the horizon. The horizon has the knots of `problem`. Throws Error for a
  /// phase whose stage does not exist.
  Horizon(Problem& problem, const Schedule& schedule);

  /// Sets the schedule for later calls of place() and place_knot().
  void follow(const Schedule& schedule) noexcept { schedule_ = schedule; }
  int stage_of(int phase) const { return stage_of_phase_[to_size(phase)]; }

  /// Returns the times of the knots, as set by the last place().
  const KnotTimes& times() const { return times_; }
  int stage_at(double schedule_time) const noexcept;

  /// Sets stage, time and targets of one knot (place_knot) or of all knots (place). If knots have
  /// different lengths, place() moves knots to nearby phase changes. If knots were fixed, a contact
  /// could begin late by the length of a knot. Exceptions from functions in targets are passed on.
  void place_knot(int knot, double schedule_time);
  void place(double schedule_time);

  /// These functions set the initial guess of a solve.
  /// - guess_rest(): the robot stays at rest in the state x, with the controls u.
  /// - guess_shifted(): the last solution, interpolated from the time `schedule_time` of the
  ///   schedule on. After the end of the solution, its last knot is repeated. If knots have equal
  ///   lengths, each control is the solution's control at the start of the knot. Otherwise, each
  ///   control is the mean of the solution's controls over the knot.
  void guess_rest(const Eigen::VectorXd& x, const Eigen::VectorXd& u) noexcept;
  void guess_shifted(const Eigen::VectorXd& x, const DdpSolver& solver,
                     double schedule_time) noexcept;
  /// Shifts the multipliers of constraints: each knot receives the multipliers of the nearest knot
  /// of the last solution.
  void shift_limits(DdpSolver& solver, double schedule_time) noexcept;
  const RowMatrix& guess_x() const { return guess_x_; }
  const RowMatrix& guess_u() const { return guess_u_; }
  /// Records the time of the schedule at which the solver's current solution begins.
  void solved_from(double schedule_time) noexcept {
    guess_time_ = schedule_time;
    solved_.copy_first(times_);
  }

 private:
  void begin_at_phases(double schedule_time) noexcept;
  double place_in_solution(int knot, double elapsed) const noexcept;
  void guess_mean_control(int knot, double elapsed, const DdpSolver& solver) noexcept;

  Problem& problem_;
  Schedule schedule_;
  /// Times of the knots: in the specification, as last placed, and of the last solution.
  KnotTimes given_, times_, solved_;
  /// Start times of knots with different lengths, on the schedule's clock [s].
  std::vector<double> begins_;
  std::vector<int> nearest_;  ///< Nearest knot of the solution, per knot; used by shift_limits().
  std::vector<int> stage_of_phase_;
  Eigen::VectorXd dx_;
  RowMatrix guess_x_, guess_u_;
  double guess_time_ = 0.0;  ///< Time of the schedule at the last solution's first knot [s].
};

}  // namespace burnish
