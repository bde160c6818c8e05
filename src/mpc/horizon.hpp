// Moving horizon of an MpcController. It sets the stage and the targets of each knot, and the
// initial guess of a solve.
#pragma once

#include "base/to_size.hpp"
#include "burnish/mpc/knot_times.hpp"
#include "burnish/mpc/mpc_spec.hpp"
#include "burnish/ocp/problem.hpp"
#include "burnish/solver/ddp.hpp"
#include "mpc/ground_terms.hpp"

namespace burnish {

/// Returns the indices of the contacts whose surface MpcTask::surface() replaces.
std::vector<int> contacts_on_surface(const MpcSpec& spec);
/// Returns the indices of contacts with friction between the tool and MpcSpec::base.
std::vector<int> contacts_with_friction(const MpcSpec& spec);

class Horizon {
 public:
  /// `problem` must outlive the horizon. The horizon has the knots of `problem`. Throws Error for a
  /// phase whose stage does not exist.
  Horizon(const MpcSpec& spec, Problem& problem, const Schedule& schedule);

  /// Sets the schedule for later calls of place() and place_knot().
  void follow(const Schedule& schedule) noexcept { schedule_ = schedule; }
  int stage_of(int phase) const { return stage_of_phase_[to_size(phase)]; }

  /// Returns the times of the knots, as set by the last place().
  const KnotTimes& times() const { return times_; }
  int stage_at(double schedule_time) const noexcept;
  /// Sets the amount by which the targets of one-dimensional contact forces are lowered, see
  /// ModelErrorKind::Force [N].
  void set_force_error(double error) noexcept { force_error_ = error; }

  /// Sets MpcTask::surface() and surface_depth() for later calls of place() and place_knot().
  void set_surface(const Quadric& surface, double depth) noexcept {
    surface_ = surface;
    depth_ = depth;
  }
  void forget_surface() noexcept { surface_.reset(); }
  /// Sets the friction of the tool's contacts for later calls of place() and place_knot().
  void set_friction(double coefficient) noexcept { friction_ = coefficient; }

  /// Sets the coefficient of friction under each support for later calls of place() and
  /// place_knot(). Other friction terms of a support are scaled by the ratio of the new to the
  /// specified coefficient of its friction cone. An infinite entry leaves the specification
  /// unchanged.
  void set_support_friction(const Eigen::VectorXd& friction) noexcept {
    support_friction_ = friction;
  }

  /// Sets stage, time and targets of one knot (place_knot) or of all knots (place). If knots have
  /// different lengths, place() moves knots to nearby changes of phase. Without this, a contact
  /// could begin late by the length of a knot. Exceptions of targets are passed on.
  void place_knot(int knot, double schedule_time);
  void place(double schedule_time);

  /// Set the initial guess of a solve.
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
  /// Target of a cost or constraint: index of the term in its stage, and signal of its target.
  struct Target {
    int term;
    Signal signal;
  };
  void begin_at_phases(double schedule_time) noexcept;
  double place_in_solution(int knot, double elapsed) const noexcept;
  void guess_mean_control(int knot, double elapsed, const DdpSolver& solver) noexcept;
  void shift_places(int knot, double schedule_time);
  void set_ground_friction(int knot, int stage);
  void lower_forces(int knot, double schedule_time);

  Problem& problem_;
  Schedule schedule_;
  /// Times of the knots: in the specification, as last placed, and of the last solution.
  KnotTimes given_, times_, solved_;
  /// Start times of knots with different lengths, on the schedule's clock [s].
  std::vector<double> begins_;
  std::vector<int> nearest_;  ///< Nearest knot of the solution, per knot; used by shift_limits().
  std::vector<int> stage_of_phase_;
  std::vector<int> following_;  ///< Indices by contacts_on_surface().
  std::optional<Quadric> surface_;
  double depth_ = 0.0;              ///< Depth by which the surface yields under the tool [m].
  std::vector<int> with_friction_;  ///< Indices by contacts_with_friction().
  double friction_;
  /// Ground terms of each stage, by ground_terms().
  std::vector<std::vector<GroundTerm>> grounds_;
  Eigen::VectorXd cones_;             ///< Friction in each support's cone in the specification.
  Eigen::VectorXd support_friction_;  ///< Friction of each support that plans use.
  bool corrects_force_;
  double force_error_ = 0.0;
  /// Per stage: targets of one-dimensional contact forces, and of positions of the tool.
  std::vector<std::vector<Target>> forces_, places_;
  std::vector<Target> places_at_end_;
  Eigen::VectorXd dx_, one_, three_;
  RowMatrix guess_x_, guess_u_;
  double guess_time_ = 0.0;  ///< Time of the schedule at the last solution's first knot [s].
};

}  // namespace burnish
