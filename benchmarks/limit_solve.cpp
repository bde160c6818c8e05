#include "limit_solve.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

namespace burnish::bench {
namespace {

/// Temporary file for the lifetime of this object.
class ScratchFile {
 public:
  explicit ScratchFile(const std::string& text)
      : path_(std::filesystem::temp_directory_path() /
              ("limit_problem_" + std::to_string(getpid()) + ".yaml")) {
    std::ofstream(path_) << text;
  }
  ~ScratchFile() { std::filesystem::remove(path_); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Largest number of iterations of solves without limits: half of the number for solves with
/// limits. Problems that need more are not used, because their difficulty is not due to limits.
constexpr int max_iterations_without_limits = 25;

/// Limits are judged infeasible if the violation at the first knot exceeds this fraction of the
/// scale; chosen by hand.
constexpr double max_start_violation = 1e-6;

TrajectoryGuess trajectory_of(const DdpSolver& solver) { return {solver.xs(), solver.us()}; }

/// Returns the smallest range of a row that limits_around() uses, in the unit of the row.
double min_range(const LimitProblem& p, LimitKind kind) {
  switch (kind) {
    case LimitKind::Band:
      return 0.02 * p.force;
    case LimitKind::Effort:
      return 0.5;
    case LimitKind::Speed:
      return 0.02;
    case LimitKind::Inclination:
      return 0.01;
    case LimitKind::Range:
      return 0.005;
    case LimitKind::Box:
      return 0.002;
    case LimitKind::Cone:
      break;
  }
  return 0.0;
}

/// Smallest and largest value of each limited row along a trajectory.
struct Hull {
  Eigen::VectorXd lower, upper;
};

Hull hull_of(const LimitProblem& p, const Limit& limit, Problem& measured,
             const TrajectoryGuess& at) {
  Hull hull;
  for (int k = limit.late ? p.early : 0; k < measured.knots(); ++k) {
    const int term = measured.term_index(measured.stage_of(k), std::string(name_of(limit.kind)));
    Eigen::VectorXd rows =
        measured.residual(k, term, at.xs.row(k).transpose(), at.us.row(k).transpose());
    if (limit.kind == LimitKind::Band) rows = rows.tail<1>().eval();
    if (limit.kind == LimitKind::Box) rows = rows.head<2>().eval();
    if (hull.lower.size() == 0) hull = {rows, rows};
    hull.lower = hull.lower.cwiseMin(rows);
    hull.upper = hull.upper.cwiseMax(rows);
  }
  return hull;
}

/// Returns the largest ratio of tangential to normal force; infinite if the tool is pulled.
double max_force_ratio(const LimitProblem& p, const Limit& limit, Problem& measured,
                       const TrajectoryGuess& at) {
  double largest = 0.0;
  for (int k = limit.late ? p.early : 0; k < measured.knots(); ++k) {
    const Eigen::VectorXd f =
        measured.forces(k, at.xs.row(k).transpose(), at.us.row(k).transpose());
    if (!(f[2] > 0.05 * p.force)) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, f.head<2>().norm() / f[2]);
  }
  return largest;
}

bool is_of_state(LimitKind kind) {
  return kind == LimitKind::Inclination || kind == LimitKind::Speed || kind == LimitKind::Range ||
         kind == LimitKind::Box;
}

/// Returns the violations of a knot's rows, as fractions of their scales.
std::vector<double> violations_at(Problem& limited, int k, const TrajectoryGuess& at) {
  if (limited.rows(k) == 0) return {};
  const Eigen::VectorXd x = at.xs.row(k), u = at.us.row(std::min(k, limited.knots() - 1));
  std::vector<double> values = limited.row_values(k, x.data(), u.data());
  for (int r = 0; r < limited.rows(k); ++r) {
    double& y = values[static_cast<std::size_t>(r)];
    y = std::max({y - limited.row_upper(k)[r], limited.row_lower(k)[r] - y, 0.0}) /
        limited.row_scale(k)[r];
  }
  return values;
}

/// Returns the largest violation at the first knot, of rows that depend only on the state.
double violated_at_start(const LimitProblem& problem, Problem& limited, const TrajectoryGuess& at) {
  const std::vector<double> violations = violations_at(limited, 0, at);
  const std::vector<std::string> names = limited.row_names(0);
  double largest = 0.0;
  for (std::size_t r = 0; r < violations.size(); ++r)
    for (const Limit& limit : problem.limits)
      if (is_of_state(limit.kind) && names[r].starts_with(std::string(name_of(limit.kind)) + "/"))
        largest = std::max(largest, violations[r]);
  return largest;
}

bool is_symmetric(LimitKind kind) {
  return kind == LimitKind::Inclination || kind == LimitKind::Speed || kind == LimitKind::Effort;
}

}  // namespace

Case::Case(const LimitProblem& problem, const TextForm& form) {
  const ScratchFile scratch(text_of(problem, form));
  file_ = read_problem_file(scratch.path());
  problem_ = std::make_unique<Problem>(file_.spec);
  guess_ = make_guess(*problem_, file_.guess);
}

std::optional<TrajectoryGuess> solve_without_limits(const LimitProblem& problem) {
  Case free(problem, {.limits = false});
  DdpSolver solver(free.problem(), {.max_iterations = max_iterations_without_limits});
  solver.set_guess(free.guess().xs, free.guess().us);
  if (solver.solve().reason != StopReason::Converged) return {};
  return trajectory_of(solver);
}

double violation(Problem& limited, const TrajectoryGuess& at) {
  double largest = 0.0;
  for (int k = 0; k <= limited.knots(); ++k)
    for (const double v : violations_at(limited, k, at)) largest = std::max(largest, v);
  return largest;
}

double largest_gap(Problem& problem, const TrajectoryGuess& at) {
  const StateShape& shape = problem.state();
  Eigen::VectorXd next(shape.nx), gap(shape.ndx);
  double largest = 0.0;
  for (int k = 0; k < problem.knots(); ++k) {
    const Eigen::VectorXd x = at.xs.row(k), u = at.us.row(k), after = at.xs.row(k + 1);
    problem.roll(0, k, x.data(), u.data(), next.data());
    problem.difference(next.data(), after.data(), gap.data());
    largest = std::max(largest, gap.cwiseAbs().maxCoeff());
  }
  return largest;
}

std::optional<std::vector<Limit>> limits_around(Draws& draws, const LimitProblem& problem,
                                                const TrajectoryGuess& trajectory,
                                                double min_margin, double max_margin) {
  Case measured(problem, {});
  std::vector<Limit> limits = problem.limits;
  for (Limit& limit : limits) {
    const double margin = draws.log_uniform(min_margin, max_margin);
    if (limit.kind == LimitKind::Cone) {
      const double slope = max_force_ratio(problem, limit, measured.problem(), trajectory);
      if (!std::isfinite(slope)) return {};
      // The pyramid inscribed in this cone contains the cone of `slope`.
      const double inside = limit.sides > 0 ? std::cos(std::numbers::pi / limit.sides) : 1.0;
      limit.friction = (1.0 + margin) * std::max(slope, 0.01) / inside + 1e-3;
      continue;
    }
    const Hull hull = hull_of(problem, limit, measured.problem(), trajectory);
    if (is_symmetric(limit.kind) && draws.chance(0.5)) {
      const double size = std::max(hull.upper.maxCoeff(), -hull.lower.minCoeff()) +
                          margin * min_range(problem, limit.kind);
      limit.upper = Eigen::VectorXd::Constant(1, (1.0 + margin) * size);
      limit.lower = -limit.upper;
      continue;
    }
    const Eigen::VectorXd range =
        (hull.upper - hull.lower).cwiseMax(min_range(problem, limit.kind));
    const Eigen::VectorXd middle = 0.5 * (hull.lower + hull.upper);
    limit.lower = middle - (0.5 + margin) * range;
    limit.upper = middle + (0.5 + margin) * range;
  }
  return limits;
}

Judgement judge(const LimitProblem& problem, Problem& limited) {
  const Case free(problem, {.limits = false});
  TrajectoryGuess at = free.guess();
  Judgement result;
  result.start = violated_at_start(problem, limited, at);
  if (result.start > max_start_violation) {
    result.verdict = Judgement::Verdict::Infeasible;
    return result;
  }
  result.violation = 1.0;
  // Penalty weights from negligible to dominant, compared with the other costs.
  for (const double weight : {1e1, 1e3, 1e5, 1e7}) {
    Case elastic(problem, {.penalty = weight});
    const double resolution = 1e-8 + 1e-10 * weight * result.violation * result.violation;
    DdpSolver solver(elastic.problem(), {.max_iterations = 300, .stop_tolerance = resolution});
    solver.set_guess(at.xs, at.us);
    result.settled = solver.solve().reason == StopReason::Converged;
    at = trajectory_of(solver);
    result.before = result.violation;
    result.violation = violation(limited, at);
  }
  const double left = result.before > 0.0 ? result.violation / result.before : 0.0;
  if (result.violation < 1e-6 || (result.violation < 1e-3 && left < 0.2))
    result.verdict = Judgement::Verdict::Feasible;
  else if (result.settled && result.violation > 2e-3 && left > 0.7)
    result.verdict = Judgement::Verdict::Infeasible;
  return result;
}

}  // namespace burnish::bench
