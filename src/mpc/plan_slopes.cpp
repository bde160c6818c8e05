#include "mpc/plan_slopes.hpp"

#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "mpc/horizon.hpp"

namespace burnish {
namespace {

// Steps of the finite differences. Plans are almost linear over such steps, and errors of the
// solver are much smaller than the differences.
constexpr double state_step = 1e-5;   // [rad (m), rad/s (m/s), Nm (N)]
constexpr double torque_step = 1e-2;  // [Nm (N)]

constexpr int first_iterations = 60;  // from a guess at rest; the remaining error is negligible
// Iterations from a nearby solution; one iteration is already almost exact.
constexpr int next_iterations = 3;

DdpOptions slope_options(DdpOptions options) {
  options.max_iterations = first_iterations;
  options.stop_tolerance = 1e-14;
  return options;
}

/// Solver of one problem with many initial states and torque errors. Each solve starts from the
/// same solution.
class Differences {
 public:
  Differences(const ProblemSpec& problem, const std::vector<SchedulePhase>& phases, int phase,
              const DdpOptions& solver, double decay_time)
      : problem_(problem),
        schedule_(phases),
        horizon_(problem_, schedule_),
        solver_(problem_, slope_options(solver)),
        decay_time_(decay_time),
        x_(problem.initial_state),
        no_torque_(Eigen::VectorXd::Zero(problem_.layout().nv)) {
    horizon_.place(schedule_.start_of(phase));
    const int stage = horizon_.stage_of(phase);
    horizon_.guess_rest(x_, problem_.quasi_static(stage, x_).control);
    solver_.set_guess({horizon_.guess_x().data(), horizon_.guess_u().data()});
    solver_.solve();
    if (!solver_.us().allFinite() || !solver_.xs().allFinite())
      throw Error("margins: the problem has no solution at the start of phase " +
                  in_quotes(phases[to_size(phase)].name) + ": " + solver_.text());
    xs_ = solver_.xs();
    us_ = solver_.us();
    solver_.set_max_iterations(next_iterations);
  }

  PlanSlopes slopes() {
    const StateLayout& layout = problem_.layout();
    const int ndx = layout.ndx(), nv = layout.nv;
    PlanSlopes result{.layout = layout, .step = problem_.step_of(0)};
    result.u.resize(layout.nu, ndx + nv);
    result.change.resize(ndx, ndx + nv);
    const Eigen::VectorXd u = us_.row(0).head(layout.nu).transpose(), change = first_change(xs_);
    Eigen::VectorXd dx = Eigen::VectorXd::Zero(ndx), x = x_, d = no_torque_;
    for (int k = 0; k < ndx + nv; ++k) {
      const bool is_state = k < ndx;
      const double step = is_state ? state_step : torque_step;
      if (is_state) {
        dx.setZero();
        dx[k] = step;
        problem_.integrate(x_.data(), dx.data(), x.data());
        solve_from(x, no_torque_);
      } else {
        d.setZero();
        d[k - ndx] = step;
        solve_from(x_, d);
      }
      result.u.col(k) = (solver_.us().row(0).head(layout.nu).transpose() - u) / step;
      result.change.col(k) = (first_change(solver_.xs()) - change) / step;
    }
    return result;
  }

 private:
  /// Returns the change of state during the first knot.
  Eigen::VectorXd first_change(const Eigen::Ref<const RowMatrix>& xs) const {
    Eigen::VectorXd change(problem_.layout().ndx());
    const Eigen::VectorXd from = xs.row(0).transpose(), to = xs.row(1).transpose();
    problem_.difference(from.data(), to.data(), change.data());
    return change;
  }
  void solve_from(const Eigen::VectorXd& x, const Eigen::VectorXd& torque) {
    if (std::isinf(decay_time_))
      (void)problem_.set_torque_bias(torque);
    else
      (void)problem_.set_torque_bias(no_torque_, torque, decay_time_);
    (void)problem_.set_initial_state(x);
    RowMatrix xs = xs_;
    xs.row(0) = x.transpose();
    solver_.set_guess(xs, us_);
    solver_.solve();
  }

  Problem problem_;
  Schedule schedule_;
  Horizon horizon_;
  DdpSolver solver_;
  double decay_time_;  ///< Time constant with which a torque error decays [s]
  Eigen::VectorXd x_, no_torque_;
  RowMatrix xs_, us_;
};

}  // namespace

PlanSlopes plan_slopes(const ProblemSpec& problem, const std::vector<SchedulePhase>& schedule,
                       int phase, const DdpOptions& solver, double decay_time) {
  return Differences(problem, schedule, phase, solver, decay_time).slopes();
}

}  // namespace burnish
