// Tests of the example problems: each converges, to the same bits with any number of threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "burnish/files/problem_file.hpp"
#include "burnish/ocp/step_check.hpp"
#include "burnish/solver/ddp.hpp"

namespace burnish::testing {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> examples() {
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::directory_iterator(fs::path(BURNISH_ROBOTS_DIR).parent_path() / "examples/problems"))
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

class ExampleProblem : public ::testing::TestWithParam<fs::path> {};

/// Returns the multipliers times the rows' changes since the solution.
double limit_terms(Problem& problem, const DdpSolver& solver, int knot, const Eigen::VectorXd& x,
                   const Eigen::VectorXd& u) {
  if (problem.rows(knot) == 0) return 0.0;
  const RowMatrix xs = solver.xs(), us = solver.us();
  const Eigen::VectorXd x_planned = xs.row(knot),
                        u_planned = us.row(std::min<Eigen::Index>(knot, us.rows() - 1));
  const bool ends = knot == problem.knots();
  const std::vector<double> current = problem.row_values(knot, x.data(), ends ? nullptr : u.data());
  const std::vector<double> planned =
      problem.row_values(knot, x_planned.data(), ends ? nullptr : u_planned.data());
  double sum = 0.0;
  for (std::size_t i = 0; i < current.size(); ++i)
    sum += solver.multipliers(knot)[static_cast<Eigen::Index>(i)] * (current[i] - planned[i]);
  return sum;
}

/// Returns the Lagrangian of the solution's policy with h times `change` (N x nu) added to the
/// controls. Controls that rest on a bound stay there; the others may move both ways.
double changed_lagrangian(Problem& problem, const DdpSolver& solver, const RowMatrix& change,
                          double h) {
  const StateShape& shape = problem.state();
  const RowMatrix xs = solver.xs(), us = solver.us();
  Eigen::VectorXd x = xs.row(0), next = x, dx(shape.ndx);
  double cost = 0.0;
  for (int k = 0; k < problem.knots(); ++k) {
    const int nu = problem.controls(k);
    Eigen::VectorXd u = us.row(k);
    if (nu > 0) {
      const Eigen::VectorXd x_planned = xs.row(k);
      problem.difference(x_planned.data(), x.data(), dx.data());
      u.head(nu) += solver.gain(k) * dx + h * change.row(k).head(nu).transpose();
      const double *lower = problem.control_lower(k), *upper = problem.control_upper(k);
      for (int i = 0; i < nu && lower != nullptr; ++i)
        if (us(k, i) < lower[i] + 1e-6 || us(k, i) > upper[i] - 1e-6) u[i] = us(k, i);
    }
    cost += problem.roll(0, k, x.data(), u.data(), next.data()).cost +
            limit_terms(problem, solver, k, x, u);
    x = next;
  }
  return cost + problem.roll(0, problem.knots(), x.data(), nullptr, nullptr).cost +
         limit_terms(problem, solver, problem.knots(), x, x);
}

TEST_P(ExampleProblem, Solution_IsALocalMinimum) {
  const ProblemFile file = read_problem_file(GetParam());
  Problem problem(file.spec);
  DdpSolver solver(problem, file.solver);
  const TrajectoryGuess guess = make_guess(problem, file.guess);
  solver.set_guess(guess.xs, guess.us);
  ASSERT_EQ(solver.solve().reason, StopReason::Converged) << solver.text();
  const double cost = solver.summary().cost;
  EXPECT_NEAR(changed_lagrangian(problem, solver, 0.0 * solver.us(), 0.0), cost, 1e-9 * cost);
  std::mt19937_64 generator(5);
  for (int direction = 0; direction < 8; ++direction) {
    RowMatrix change = solver.us();
    for (Eigen::Index i = 0; i < change.size(); ++i)
      change.data()[i] = static_cast<double>(generator() >> 11) * 0x1p-52 - 1.0;
    const double h = 1e-3;
    const double plus = changed_lagrangian(problem, solver, change, h);
    const double minus = changed_lagrangian(problem, solver, change, -h);
    const double slope = (plus - minus) / (2.0 * h);
    const double curvature = (plus - 2.0 * cost + minus) / (h * h);
    ASSERT_GT(curvature, 0.0);
    // The saving along this direction, by the parabola through the three costs.
    EXPECT_LT(slope * slope / (2.0 * curvature), 1e-6 * cost) << "direction " << direction;
  }
}

TEST_P(ExampleProblem, OneAndTwoThreads_GiveTheSameBits) {
  const ProblemFile file = read_problem_file(GetParam());
  const auto solve = [&](int threads, RowMatrix& us) {
    Problem problem(file.spec);
    DdpOptions options = file.solver;
    options.threads = threads;
    DdpSolver solver(problem, options);
    const TrajectoryGuess guess = make_guess(problem, file.guess);
    solver.set_guess(guess.xs, guess.us);
    solver.solve();
    us = solver.us();
    return RowMatrix(solver.xs());
  };
  RowMatrix us_one, us_two;
  const RowMatrix xs_one = solve(1, us_one), xs_two = solve(2, us_two);
  EXPECT_EQ(xs_one, xs_two);
  EXPECT_EQ(us_one, us_two);
}

TEST_P(ExampleProblem, Solve_ConvergesFromItsOwnGuess) {
  const ProblemFile file = read_problem_file(GetParam());
  EXPECT_NE(file.description, "");
  Problem problem(file.spec);
  DdpSolver solver(problem, file.solver);
  const TrajectoryGuess guess = make_guess(problem, file.guess);
  solver.set_guess(guess.xs, guess.us);
  EXPECT_EQ(solver.solve().reason, StopReason::Converged) << solver.text();
  const StepReport steps = check_steps(problem, solver.xs(), solver.us());
  EXPECT_FALSE(steps.coarse) << steps.warning();
  EXPECT_EQ(step_complaints(problem), std::vector<std::string>{});
}

INSTANTIATE_TEST_SUITE_P(All, ExampleProblem, ::testing::ValuesIn(examples()),
                         [](const auto& file) { return file.param.stem().string(); });

}  // namespace
}  // namespace burnish::testing
