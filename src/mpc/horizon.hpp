// The horizon of an MpcController: which stage each knot is of as time goes on, and where a solve
// begins.
#pragma once

#include "burnish/mpc/knot_times.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/solver/ddp.hpp"
#include "mpc/ground_terms.hpp"

namespace burnish {

/// Those that are given MpcTask::surface.
std::vector<int> contacts_on_surface(const MpcSpec& spec);
/// Those of the tool with the world that have friction.
std::vector<int> contacts_that_rub(const MpcSpec& spec);

class Horizon {
 public:
  /// The problem must outlive it; its knots are the horizon's. Throws Error for a phase whose stage
  /// there is not.
  Horizon(const MpcSpec& spec, Problem& problem, const Schedule& schedule);

  /// Where the schedule is, for all knots that are placed from then on.
  void follow(const Schedule& schedule) noexcept { schedule_ = schedule; }
  int stage_of(int phase) const { return stage_of_phase_[static_cast<std::size_t>(phase)]; }

  /// Of the knots as they were placed last.
  const KnotTimes& times() const { return times_; }
  int stage_at(double schedule_time) const noexcept;
  /// N that contact forces of one row are to be lower than their targets: ModelErrorKind::Force.
  void set_force_error(double error) noexcept { force_error_ = error; }

  /// MpcTask::surface and surface_depth, for all knots that are placed from then on.
  void set_surface(const Quadric& surface, double depth) noexcept {
    surface_ = surface;
    depth_ = depth;
  }
  void forget_surface() noexcept { surface_.reset(); }
  /// The coefficient of the tool's contacts with friction, likewise.
  void set_friction(double coefficient) noexcept { friction_ = coefficient; }

  /// The coefficient of friction under each support that holds always, likewise; what the problem
  /// states beside its cone's goes with that. Where it is infinite the specification's is kept.
  void set_support_friction(const Eigen::VectorXd& friction) noexcept {
    support_friction_ = friction;
  }

  /// Stage and time of a knot, of all of them. Where knots are of different lengths, the one that
  /// begins nearest to a change of phase begins there: in a long knot a contact would else be made
  /// late by up to its length. May throw what targets throw.
  void place_knot(int knot, double schedule_time);
  void place(double schedule_time);

  /// Where a solve begins, of x: resting there with the controls u, or the solver's solution as a
  /// function of the schedule's time, from this time on: between its knots, the last one repeated.
  /// Controls are those at a knot's start, or, where knots are of different lengths, the mean over
  /// it.
  void guess_rest(const Eigen::VectorXd& x, const Eigen::VectorXd& u) noexcept;
  void guess_shifted(const Eigen::VectorXd& x, const DdpSolver& solver,
                     double schedule_time) noexcept;
  /// Multipliers of limits go along: to each knot those of the one of the solution that is nearest.
  void shift_limits(DdpSolver& solver, double schedule_time) noexcept;
  const RowMatrix& guess_x() const { return guess_x_; }
  const RowMatrix& guess_u() const { return guess_u_; }
  /// The solver's solution begins at this time of the schedule.
  void solved_from(double schedule_time) noexcept {
    guess_time_ = schedule_time;
    solved_.copy_first(times_);
  }

 private:
  /// Of a cost or constraint of a stage, by its place among these, what its signal is set from.
  struct Target {
    int term;
    Signal signal;
  };
  void begin_at_phases(double schedule_time) noexcept;
  double where(int knot, double elapsed) const noexcept;
  void guess_mean_control(int knot, double elapsed, const DdpSolver& solver) noexcept;
  void press_places(int knot, double schedule_time);
  void ground(int knot, int stage);
  void lower_forces(int knot, double schedule_time);

  Problem& problem_;
  Schedule schedule_;
  /// As the specification has them, as they were placed last, and those of the last solution.
  KnotTimes given_, times_, solved_;
  std::vector<double> begins_;  ///< s of the schedule, of uneven knots
  std::vector<int> nearest_;    ///< of the solution's knots, for shift_limits()
  std::vector<int> stage_of_phase_;
  std::vector<int> following_;  ///< contacts_on_surface()
  std::optional<Quadric> surface_;
  double depth_ = 0.0;        ///< m
  std::vector<int> rubbing_;  ///< contacts_that_rub()
  double friction_;
  std::vector<std::vector<GroundTerm>> grounds_;  ///< per stage
  Eigen::VectorXd cones_;                         ///< per support, as the specification has them
  Eigen::VectorXd support_friction_;              ///< per support
  bool corrects_force_;
  double force_error_ = 0.0;
  /// Per stage: contact forces of one row, points of the world that the tool is to come to.
  std::vector<std::vector<Target>> forces_, places_;
  std::vector<Target> places_at_end_;
  Eigen::VectorXd dx_, one_, three_;
  RowMatrix guess_x_, guess_u_;
  double guess_time_ = 0.0;  ///< s of the schedule, of the last solution's first knot
};

}  // namespace burnish
