// Tests of the segmented recursion: values, gains and directions equal a single sweep up to
// rounding.
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

class SegmentedHorizon : public ::testing::TestWithParam<Horizon> {};

template <class A, class B>
double difference(const A& a, const B& b) {
  if (a.size() == 0) return 0.0;
  return (a - b).cwiseAbs().maxCoeff() / (1.0 + b.cwiseAbs().maxCoeff());
}

TEST_P(SegmentedHorizon, GainsAndValues_EqualASingleSweep) {
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
      const DdpSolver single = solve(1, regularization);
      for (const int segments : {2, 3, 4, 7}) {
        const DdpSolver segmented = solve(segments, regularization);
        EXPECT_NEAR(segmented.summary().expected_improvement, single.summary().expected_improvement,
                    1e-9 * std::abs(single.summary().expected_improvement));
        EXPECT_LT(difference(segmented.xs(), single.xs()), 1e-9);
        EXPECT_LT(difference(segmented.us(), single.us()), 1e-9);
        for (int k = 0; k < lq.problem.knots(); ++k) {
          EXPECT_LT(difference(segmented.gain(k), single.gain(k)), 1e-9) << segments << " " << k;
          EXPECT_LT(difference(segmented.feedforward(k), single.feedforward(k)), 1e-9);
          EXPECT_LT(difference(segmented.value_hessian(k), single.value_hessian(k)), 1e-9);
          EXPECT_LT(difference(segmented.value_gradient(k), single.value_gradient(k)), 1e-9);
        }
        // Two segments equal a single sweep to the bit.
        if (segments == 2) {
          EXPECT_EQ(segmented.xs(), single.xs());
        }
      }
    }
  }
}

TEST_P(SegmentedHorizon, AnyNumberOfThreads_GivesTheSameBits) {
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
    Horizons, SegmentedHorizon,
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

TEST(SegmentedSolver, NonlinearProblem_GivesTheSameSolution) {
  for (const StepUpdate update : {StepUpdate::Rollout, StepUpdate::MultipleShooting}) {
    TestProblem p = unicycle();
    DdpSolver single(p, {.update = update});
    DdpSolver segmented(p, {.update = update, .threads = 2, .segments = 5});
    EXPECT_EQ(single.solve().reason, StopReason::Converged);
    EXPECT_EQ(segmented.solve().reason, StopReason::Converged);
    EXPECT_EQ(segmented.summary().iterations, single.summary().iterations);
    EXPECT_LT(difference(segmented.us(), single.us()), 1e-8);
    EXPECT_LT(difference(segmented.gain(11), single.gain(11)), 1e-8);
  }
}

TEST(SegmentedSolver, BoundedControls_UseASingleSweep) {
  TestProblem p = pendulum_swing_up();
  set_bounds(p, -5.0, 5.0);
  DdpSolver single(p, {.max_iterations = 15});
  DdpSolver segmented(p, {.max_iterations = 15, .threads = 2, .segments = 6});
  single.solve();
  segmented.solve();
  EXPECT_EQ(RowMatrix(segmented.xs()), RowMatrix(single.xs()));
  EXPECT_EQ(RowMatrix(segmented.us()), RowMatrix(single.us()));
}

/// Problem in which only the following costs weigh a control.
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

TEST(SegmentedSolver, SingularSegments_UseASingleSweep) {
  LqProblem lq = without_control_cost(1.0);
  DdpSolver single(lq.problem, {.max_iterations = 1});
  DdpSolver segmented(lq.problem, {.max_iterations = 1, .segments = 4});
  single.solve();
  segmented.solve();
  EXPECT_EQ(single.summary().regularization, 0.0);
  EXPECT_EQ(segmented.summary().regularization, 0.0);
  for (int k = 0; k < 12; ++k) EXPECT_EQ(segmented.gain(k), single.gain(k));
}

TEST(SegmentedSolver, IndefiniteProblem_NamesTheSameKnot) {
  LqProblem lq = without_control_cost(-100.0);
  for (const int segments : {1, 4}) {
    DdpSolver solver(lq.problem, {.segments = segments, .regularization = {.largest = 1e-6}});
    EXPECT_EQ(solver.solve().reason, StopReason::NotPositiveDefinite);
    EXPECT_EQ(solver.summary().knot, 10);
  }
}

TEST(SegmentedSolver, Solve_AllocatesNothing) {
  if (AllocationGuard::unavailable() != nullptr) GTEST_SKIP() << AllocationGuard::unavailable();
  for (const int threads : {1, 2}) {
    TestProblem p = unicycle();
    DdpSolver solver(p, {.threads = threads, .segments = 4});
    const AllocationGuard guard;
    EXPECT_EQ(solver.solve().reason, StopReason::Converged);
    EXPECT_EQ(guard.count(), 0);
  }
}

TEST(SegmentedSolver, SegmentsNotFewerThanKnots_AreRefused) {
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
