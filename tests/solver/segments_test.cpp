// A recursion by segments finds the values, gains and directions of one sweep, to rounding.
#include <gtest/gtest.h>

#include "burnish/solver/ddp.hpp"
#include "solver/nonlinear_problems.hpp"
#include "support/allocation_guard.hpp"
#include "support/refusal.hpp"

namespace burnish::testing {
namespace {

struct Horizon {
  std::string name;
  LqSpec spec;
};

void PrintTo(const Horizon& horizon, std::ostream* out) { *out << horizon.name; }

class Segments : public ::testing::TestWithParam<Horizon> {};

template <class A, class B>
double difference(const A& a, const B& b) {
  if (a.size() == 0) return 0.0;
  return (a - b).cwiseAbs().maxCoeff() / (1.0 + b.cwiseAbs().maxCoeff());
}

TEST_P(Segments, give_gains_and_values_of_the_whole_horizon) {
  for (const StepUpdate update : {StepUpdate::Rollout, StepUpdate::MultipleShooting}) {
    LqProblem lq = random_lq(GetParam().spec);
    const auto solve = [&](int segments, double regularization) {
      DdpSolver solver(lq.problem, {.update = update,
                                    .max_iterations = 1,
                                    .segments = segments,
                                    .regularization = {.initial = regularization}});
      solver.solve();
      return solver;
    };
    for (const double regularization : {0.0, 0.3}) {
      const DdpSolver whole = solve(1, regularization);
      for (const int segments : {2, 3, 4, 7}) {
        const DdpSolver cut = solve(segments, regularization);
        EXPECT_NEAR(cut.summary().expected_improvement, whole.summary().expected_improvement,
                    1e-9 * std::abs(whole.summary().expected_improvement));
        EXPECT_LT(difference(cut.xs(), whole.xs()), 1e-9);
        EXPECT_LT(difference(cut.us(), whole.us()), 1e-9);
        for (int k = 0; k < lq.problem.knots(); ++k) {
          EXPECT_LT(difference(cut.gain(k), whole.gain(k)), 1e-9) << segments << " " << k;
          EXPECT_LT(difference(cut.feedforward(k), whole.feedforward(k)), 1e-9);
          EXPECT_LT(difference(cut.value_hessian(k), whole.value_hessian(k)), 1e-9);
          EXPECT_LT(difference(cut.value_gradient(k), whole.value_gradient(k)), 1e-9);
        }
        // Two segments are one sweep, to the bit.
        if (segments == 2) {
          EXPECT_EQ(cut.xs(), whole.xs());
        }
      }
    }
  }
}

TEST_P(Segments, have_the_same_bits_for_any_number_of_threads) {
  LqProblem lq = random_lq(GetParam().spec);
  RowMatrix us;
  Eigen::MatrixXd gain;
  for (const int threads : {1, 2, 3}) {
    DdpSolver solver(lq.problem, {.max_iterations = 2, .threads = threads, .segments = 4});
    solver.solve();
    if (threads == 1) {
      us = solver.us();
      gain = solver.gain(3);
    }
    EXPECT_EQ(RowMatrix(solver.us()), us);
    EXPECT_EQ(Eigen::MatrixXd(solver.gain(3)), gain);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Horizons, Segments,
    ::testing::Values(
        Horizon{"dense", {.ndx = 5, .nu = std::vector<int>(13, 3)}},
        Horizon{"arm", {.nv = 7, .nu = std::vector<int>(17, 7), .form = DynamicsForm::SecondOrder}},
        Horizon{"filtered",
                {.nv = 4,
                 .filtered = 3,
                 .nu = {3, 3, 2, 3, 0, 3, 3, 1, 3, 3, 3},
                 .form = DynamicsForm::SecondOrder}},
        Horizon{"free_flyer",
                {.nv = 17,
                 .blocks = {{0, 6}, {9, 3}},
                 .nu = std::vector<int>(12, 11),
                 .form = DynamicsForm::SecondOrder}}),
    [](const auto& param) { return param.param.name; });

TEST(SegmentsOf, nonlinear_problems_lead_to_the_same_solution) {
  for (const StepUpdate update : {StepUpdate::Rollout, StepUpdate::MultipleShooting}) {
    TestProblem p = unicycle();
    DdpSolver whole(p, {.update = update});
    DdpSolver cut(p, {.update = update, .threads = 2, .segments = 5});
    EXPECT_EQ(whole.solve().reason, StopReason::Converged);
    EXPECT_EQ(cut.solve().reason, StopReason::Converged);
    EXPECT_EQ(cut.summary().iterations, whole.summary().iterations);
    EXPECT_LT(difference(cut.us(), whole.us()), 1e-8);
    EXPECT_LT(difference(cut.gain(11), whole.gain(11)), 1e-8);
  }
}

TEST(SegmentsOf, a_problem_with_bounds_are_one_sweep) {
  TestProblem p = pendulum_swing_up();
  set_bounds(p, -5.0, 5.0);
  DdpSolver whole(p, {.max_iterations = 15});
  DdpSolver cut(p, {.max_iterations = 15, .threads = 2, .segments = 6});
  whole.solve();
  cut.solve();
  EXPECT_EQ(RowMatrix(cut.xs()), RowMatrix(whole.xs()));
  EXPECT_EQ(RowMatrix(cut.us()), RowMatrix(whole.us()));
}

/// Controls that only what follows them gives a price.
LqProblem without_control_cost(double sign) {
  LqProblem lq = random_lq({.ndx = 4, .nu = std::vector<int>(12, 2)});
  for (std::size_t k = 0; k < 12; ++k) {
    LqStage& s = lq.stages[k];
    s.H.setZero();
    s.H.bottomRightCorner(4, 4) = 0.1 * sign * Eigen::Matrix4d::Identity();
    lq.problem.stages[k].expand = [s](const double* x, const double* u, KnotExpansion& out) {
      Eigen::VectorXd z(6);
      z << Eigen::Map<const Eigen::Vector2d>(u), Eigen::Map<const Eigen::Vector4d>(x);
      fill_expansion(s, z, DynamicsForm::Dense, false, out);
    };
  }
  return lq;
}

TEST(SegmentsOf, a_problem_whose_parts_have_no_solution_are_one_sweep) {
  LqProblem lq = without_control_cost(1.0);
  DdpSolver whole(lq.problem, {.max_iterations = 1});
  DdpSolver cut(lq.problem, {.max_iterations = 1, .segments = 4});
  whole.solve();
  cut.solve();
  EXPECT_EQ(whole.summary().regularization, 0.0);
  EXPECT_EQ(cut.summary().regularization, 0.0);
  for (int k = 0; k < 12; ++k) EXPECT_EQ(cut.gain(k), whole.gain(k));
}

TEST(SegmentsOf, a_problem_without_a_minimum_name_the_same_control) {
  LqProblem lq = without_control_cost(-100.0);
  for (const int segments : {1, 4}) {
    DdpSolver solver(lq.problem, {.segments = segments, .regularization = {.largest = 1e-6}});
    EXPECT_EQ(solver.solve().reason, StopReason::NotPositiveDefinite);
    EXPECT_EQ(solver.summary().knot, 10);
  }
}

TEST(SegmentsOf, a_solver_allocate_nothing_in_a_solve) {
  if (AllocationGuard::unavailable() != nullptr) GTEST_SKIP() << AllocationGuard::unavailable();
  for (const int threads : {1, 2}) {
    TestProblem p = unicycle();
    DdpSolver solver(p, {.threads = threads, .segments = 4});
    const AllocationGuard guard;
    EXPECT_EQ(solver.solve().reason, StopReason::Converged);
    EXPECT_EQ(guard.count(), 0);
  }
}

TEST(SegmentsOf, a_horizon_are_fewer_than_its_knots) {
  TestProblem p = unicycle();
  expect_words(refusal([&] { DdpSolver(p, {.segments = 0}); }), {"segments is 0", "1 to"});
  DdpSolver solver(p, {.segments = 39});
  EXPECT_EQ(solver.solve().reason, StopReason::Converged);
  expect_words(refusal([&] { solver.set_options({.segments = 40}); }),
               {"40 segments", "40 knots", "fewer"});
  EXPECT_EQ(solver.options().segments, 39);
  solver.set_options({.segments = 1});
  solver.set_guess(RowMatrix::Zero(41, 3), RowMatrix::Zero(40, 2));
  EXPECT_EQ(solver.solve().reason, StopReason::Converged);
}

}  // namespace
}  // namespace burnish::testing
