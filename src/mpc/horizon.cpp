#include "mpc/horizon.hpp"

#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"

namespace burnish {

Horizon::Horizon(Problem& problem, const Schedule& schedule)
    : problem_(problem),
      schedule_(schedule),
      given_(knot_steps(problem.spec())),
      times_(given_),
      solved_(given_),
      begins_(to_size(problem.knots()) + 1),
      nearest_(to_size(problem.knots())),
      dx_(Eigen::VectorXd::Zero(problem.layout().ndx())),
      guess_x_(RowMatrix::Zero(problem.knots() + 1, problem.layout().nx())),
      guess_u_(RowMatrix::Zero(problem.knots(), problem.layout().nu)) {
  for (const SchedulePhase& phase : schedule.phases())
    stage_of_phase_.push_back(problem.stage_index(phase.stage));
}

int Horizon::stage_at(double schedule_time) const noexcept {
  return stage_of_phase_[to_size(schedule_.phase_at(schedule_time))];
}

void Horizon::place_knot(int knot, double schedule_time) {
  problem_.set_knot(knot, stage_at(schedule_time), schedule_time);
}

void Horizon::place(double schedule_time) {
  const int N = problem_.knots();
  if (given_.is_even()) {
    for (int k = 0; k <= N; ++k) place_knot(k, schedule_time + given_.after(k));
    return;
  }
  begin_at_phases(schedule_time);
  for (int k = 0; k < N; ++k) problem_.set_step(k, times_.step(k));
  for (int k = 0; k <= N; ++k) place_knot(k, begins_[to_size(k)]);
}

/// Moves the knot nearest to each change of phase to that change. Skips a change if this knot has
/// already moved or is an end of the horizon, or if a step would become shorter than min_step.
void Horizon::begin_at_phases(double schedule_time) noexcept {
  const int N = problem_.knots();
  times_.copy_first(given_);
  for (int k = 0; k <= N; ++k) begins_[to_size(k)] = schedule_time + given_.after(k);
  constexpr double min_step = 0.2;  // shortest allowed step, as a fraction of the nominal step
  int last = 0;
  for (int phase = 1; phase < static_cast<int>(schedule_.phases().size()); ++phase) {
    const double begin = schedule_.start_of(phase), ahead = begin - schedule_time;
    const double place = given_.place(ahead);
    const int k = static_cast<int>(std::lround(place));
    if (k <= last || k >= N) continue;
    if (ahead - times_.after(k - 1) < min_step * given_.step(k - 1)) continue;
    times_.move(k, ahead);
    begins_[to_size(k)] = begin;
    last = k;
  }
}

void Horizon::guess_rest(const Eigen::VectorXd& x, const Eigen::VectorXd& u) noexcept {
  guess_x_.rowwise() = x.transpose();
  guess_u_.rowwise() = u.transpose();
}

void Horizon::guess_shifted(const Eigen::VectorXd& x, const DdpSolver& solver,
                            double schedule_time) noexcept {
  const int N = problem_.knots();
  const auto xs = solver.xs();
  const auto us = solver.us();
  const double elapsed = std::max(0.0, schedule_time - guess_time_);
  for (int k = 0; k <= N; ++k) {
    const double at = place_in_solution(k, elapsed);
    const int i = std::min(static_cast<int>(at), N - 1);
    const double* const here = xs.data() + i * xs.cols();
    problem_.difference(here, here + xs.cols(), dx_.data());
    dx_ *= at - i;
    problem_.integrate(here, dx_.data(), guess_x_.row(k).data());
    if (k == N) break;
    guess_u_.row(k) = us.row(i);
    if (!given_.is_even()) guess_mean_control(k, elapsed, solver);
  }
  guess_x_.row(0) = x.transpose();
}

/// Returns the position of a knot in the last solution, as a fractional knot number. `elapsed`:
/// time from the start of the last solution to the start of the horizon [s].
double Horizon::place_in_solution(int knot, double elapsed) const noexcept {
  if (given_.is_even())
    return std::min(knot + elapsed / given_.step(0), static_cast<double>(given_.knots()));
  return solved_.place(times_.after(knot) + elapsed);
}

void Horizon::guess_mean_control(int knot, double elapsed, const DdpSolver& solver) noexcept {
  const auto us = solver.us();
  const int N = problem_.knots();
  const double begin = times_.after(knot) + elapsed, end = times_.after(knot + 1) + elapsed;
  const int first = std::min(static_cast<int>(solved_.place(begin)), N - 1);
  // Within this knot, only one control of the solution applies.
  if (first == N - 1 || end <= solved_.after(first + 1)) return;
  guess_u_.row(knot).setZero();
  double from = begin;
  for (int i = first; i < N && from < end; ++i) {
    const double until = i == N - 1 ? end : std::min(end, solved_.after(i + 1));
    guess_u_.row(knot) += (until - from) / (end - begin) * us.row(i);
    from = until;
  }
}

void Horizon::shift_limits(DdpSolver& solver, double schedule_time) noexcept {
  const int N = problem_.knots();
  const double elapsed = std::max(0.0, schedule_time - guess_time_);
  if (given_.is_even()) {
    const double knots = elapsed / given_.step(0) + 0.5;
    solver.shift_limits(static_cast<int>(std::min(knots, static_cast<double>(N))));
    return;
  }
  for (int k = 0; k < N; ++k)
    nearest_[to_size(k)] = static_cast<int>(std::lround(place_in_solution(k, elapsed)));
  solver.shift_limits(nearest_);
}

}  // namespace burnish
