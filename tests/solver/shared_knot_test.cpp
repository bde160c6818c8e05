// Tests of a thread team that shares the knots of the recursion: its results equal a single
// thread's to the bit.
#include <gtest/gtest.h>

#include <cstring>

#include "base/thread_pool.hpp"
#include "burnish/solver/ddp.hpp"
#include "solver/riccati.hpp"
#include "solver/test_problem.hpp"

namespace burnish::testing {
namespace {

struct Shape {
  std::string name;
  LqSpec spec;
  bool bounded = false;
};

void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }

/// Recursion over a random problem, with the memory that it reads and writes.
class Sweep {
 public:
  Sweep(const Shape& shape, int workers)
      : shape_(shape),
        lq_(random_lq(shape.spec)),
        state_(lq_.problem.shape),
        knots_(lq_.problem.knots()),
        recursion_(state_, lq_.problem.max_nu, workers) {
    const RiccatiLayout& layout = recursion_.layout();
    const auto memory = [&](int rows, int stride) {
      return Buffer(static_cast<std::size_t>(rows * stride + 64 + layout.spare));
    };
    for (int k = 0; k <= knots_; ++k) {
      expansion_memory_.push_back(
          memory(layout.expansion_rows + state_.ndx + 2, layout.expansion_stride));
      tangent_memory_.push_back(memory(4, 64));
      values_.push_back(memory(state_.ndx + 1, layout.value_stride));
      policies_.push_back(memory(lq_.problem.max_nu + 1, layout.gain_stride));
      gaps_.push_back(memory(2, layout.value_stride));
      expansions_.push_back(expansion(k));
      for (int i = 0; i < state_.ndx; ++i) gap(k)[i] = 0.1 * std::sin(i + k);
    }
    const auto nu = static_cast<std::size_t>(lq_.problem.max_nu);
    lower_.assign(nu, -0.4);
    upper_.assign(nu, 0.3);
    u_.assign(nu, 0.1);
  }

  /// Collects the steps that the leader gets; stops at a failed control.
  void run(const ThreadTeam& team, double regularization, std::vector<RiccatiStep>& steps) {
    if (team.leads()) recursion_.terminal(expansions_.back(), value(knots_));
    team.meet();
    for (int k = knots_ - 1; k >= 0; --k) {
      const ControlBox box{lower_.data(), upper_.data(), u_.data()};
      const RiccatiStep step = recursion_.step(
          {expansions_[static_cast<std::size_t>(k)], lq_.stages[static_cast<std::size_t>(k)].nu,
           gap(k), value(k + 1), policy(k), value(k), gap(k) + recursion_.layout().value_stride},
          {regularization, shape_.bounded ? box : ControlBox{}}, team);
      if (team.leads()) steps.push_back(step);
      if (step.failed_control >= 0) return;
    }
  }

  void expect_same_bits(Sweep& other) {
    const auto same = [](const double* a, const double* b, int n) {
      return std::memcmp(a, b, sizeof(double) * static_cast<std::size_t>(n)) == 0;
    };
    for (int k = 0; k <= knots_; ++k) {
      const RiccatiLayout& layout = recursion_.layout();
      EXPECT_TRUE(same(value(k).gradient, other.value(k).gradient, state_.ndx)) << k;
      for (int i = 0; i < state_.ndx; ++i) {
        const int row = i * layout.value_stride;
        EXPECT_TRUE(same(value(k).hessian + row, other.value(k).hessian + row, state_.ndx)) << k;
      }
      if (k == knots_) break;
      const int nu = lq_.stages[static_cast<std::size_t>(k)].nu;
      EXPECT_TRUE(same(policy(k).feedforward, other.policy(k).feedforward, nu)) << k;
      EXPECT_TRUE(
          same(gap(k) + layout.value_stride, other.gap(k) + layout.value_stride, state_.ndx));
      for (int i = 0; i < nu; ++i) {
        const int row = i * layout.gain_stride;
        EXPECT_TRUE(same(policy(k).gain + row, other.policy(k).gain + row, state_.ndx)) << k;
      }
    }
  }

 private:
  ValueStorage value(int k) {
    double* m = values_[static_cast<std::size_t>(k)].data();
    return {m, m + recursion_.layout().value_stride};
  }
  PolicyStorage policy(int k) {
    double* m = policies_[static_cast<std::size_t>(k)].data();
    return {m, m + recursion_.layout().gain_stride};
  }
  double* gap(int k) { return gaps_[static_cast<std::size_t>(k)].data(); }
  KnotExpansion expansion(int k) {
    const RiccatiLayout& layout = recursion_.layout();
    const LqStage& stage = lq_.stages[static_cast<std::size_t>(k)];
    KnotExpansion e;
    e.stride = layout.expansion_stride;
    e.gradient = expansion_memory_.back().data();
    e.hessian = e.gradient + layout.expansion_stride;
    e.dynamics = e.hessian + layout.expansion_rows * layout.expansion_stride;
    e.decay = e.dynamics + state_.ndx * layout.expansion_stride;
    e.tangent_blocks = tangent_memory_.back().data();
    fill_expansion(stage, Eigen::VectorXd::Constant(stage.nu + state_.ndx, 0.2), shape_.spec.form,
                   k == knots_, e);
    return e;
  }

  Shape shape_;
  LqProblem lq_;
  StateShape state_;
  int knots_;
  RiccatiRecursion recursion_;
  std::vector<Buffer> expansion_memory_, tangent_memory_, values_, policies_, gaps_;
  std::vector<KnotExpansion> expansions_;
  std::vector<double> lower_, upper_, u_;
};

class SharedKnot : public ::testing::TestWithParam<Shape> {};

TEST_P(SharedKnot, AnyNumberOfWorkers_GivesTheSameBits) {
  Sweep single(GetParam(), 1);
  std::vector<RiccatiStep> expected;
  single.run({}, 1e-3, expected);
  ASSERT_EQ(expected.size(), GetParam().spec.nu.size());
  for (const int workers : {1, 2, 3, 5}) {
    ThreadPool pool(workers);
    Sweep team(GetParam(), workers);
    std::vector<RiccatiStep> steps;
    steps.reserve(expected.size());
    pool.together([&](const ThreadTeam& member) noexcept { team.run(member, 1e-3, steps); });
    team.expect_same_bits(single);
    ASSERT_EQ(steps.size(), expected.size());
    for (std::size_t k = 0; k < steps.size(); ++k) {
      EXPECT_EQ(steps[k].failed_control, -1);
      EXPECT_EQ(steps[k].slope, expected[k].slope);
      EXPECT_EQ(steps[k].curvature, expected[k].curvature);
      EXPECT_EQ(steps[k].gap_slope, expected[k].gap_slope);
      EXPECT_EQ(steps[k].gap_curvature, expected[k].gap_curvature);
    }
  }
}

TEST_P(SharedKnot, FailedControl_StopsEveryWorker) {
  if (GetParam().spec.nu.back() == 0) GTEST_SKIP() << "no control to fail";
  Sweep single(GetParam(), 1);
  std::vector<RiccatiStep> expected;
  single.run({}, -1e3, expected);
  ASSERT_EQ(expected.size(), 1U);
  EXPECT_EQ(expected[0].failed_control, 0);
  for (const int workers : {2, 3}) {
    ThreadPool pool(workers);
    Sweep team(GetParam(), workers);
    std::vector<RiccatiStep> steps;
    pool.together([&](const ThreadTeam& member) noexcept { team.run(member, -1e3, steps); });
    ASSERT_EQ(steps.size(), 1U);
    EXPECT_EQ(steps[0].failed_control, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, SharedKnot,
    ::testing::Values(
        Shape{"small", {.ndx = 3, .nu = {2, 1, 2}}},
        Shape{"impact", {.nv = 9, .nu = {5, 0, 5}, .form = DynamicsForm::SecondOrder}},
        Shape{"dense", {.ndx = 37, .nu = {13, 13}}},
        Shape{"dense_bounded", {.ndx = 29, .nu = {11, 11}}, true},
        Shape{"arm", {.nv = 7, .nu = {7, 7, 7}, .form = DynamicsForm::SecondOrder}},
        Shape{"filtered",
              {.nv = 13, .filtered = 9, .nu = {11, 9, 4}, .form = DynamicsForm::SecondOrder}},
        Shape{
            "free_flyer",
            {.nv = 30, .blocks = {{0, 6}}, .nu = {24, 24, 24}, .form = DynamicsForm::SecondOrder}},
        Shape{"blocks_in_the_middle",
              {.nv = 21,
               .filtered = 6,
               .blocks = {{5, 3}, {14, 6}},
               .nu = {17, 17},
               .form = DynamicsForm::SecondOrder}},
        Shape{"free_flyer_bounded",
              {.nv = 22, .blocks = {{0, 6}}, .nu = {16, 16, 16}, .form = DynamicsForm::SecondOrder},
              true}),
    [](const auto& param) { return param.param.name; });

LqSpec humanoid() {
  return {.nv = 30,
          .blocks = {{0, 6}},
          .nu = std::vector<int>(6, 24),
          .form = DynamicsForm::SecondOrder};
}

TEST(SharedKnotSolver, SharedKnots_GiveTheSameBits) {
  for (const bool bounded : {false, true})
    for (const StepUpdate update : {StepUpdate::Rollout, StepUpdate::MultipleShooting}) {
      std::vector<LqProblem> problems;
      std::vector<DdpSolver> solvers;
      problems.reserve(4);
      for (const auto& [threads, shared] : {std::pair(1, true), {2, true}, {2, false}, {3, true}}) {
        LqProblem& lq = problems.emplace_back(random_lq(humanoid()));
        if (bounded) {
          lq.problem.lower.assign(6, std::vector<double>(24, -0.3));
          lq.problem.upper.assign(6, std::vector<double>(24, 0.2));
        }
        solvers.emplace_back(
            lq.problem,
            DdpOptions{
                .update = update, .max_iterations = 4, .threads = threads, .share_knots = shared});
        solvers.back().solve();
        const DdpSolver& one = solvers.front();
        const DdpSolver& it = solvers.back();
        EXPECT_EQ(it.xs(), one.xs());
        EXPECT_EQ(it.us(), one.us());
        for (int k = 0; k < 6; ++k) {
          EXPECT_EQ(it.gain(k), one.gain(k));
          EXPECT_EQ(it.value_hessian(k), one.value_hessian(k));
          EXPECT_EQ(it.value_gradient(k), one.value_gradient(k));
        }
        EXPECT_EQ(it.summary().cost, one.summary().cost);
        EXPECT_EQ(it.summary().expected_improvement, one.summary().expected_improvement);
      }
    }
}

TEST(SharedKnotSolver, OnlyLargeProblems_ExceedTheSharingThreshold) {
  const auto work = [](const LqSpec& spec) {
    const LqProblem lq = random_lq(spec);
    return RiccatiRecursion(lq.problem.shape, spec.nu[0]).multiplications(spec.nu[0], spec.form);
  };
  // The solver shares knots above 2e5 multiplications: the humanoid's knots are above, the arm's
  // below.
  EXPECT_GT(work(humanoid()), 2e5);
  EXPECT_LT(work({.nv = 7, .filtered = 7, .nu = {7}, .form = DynamicsForm::SecondOrder}), 1e4);
}

TEST(SharedKnotSolver, IndefiniteProblem_NamesTheControl) {
  for (const int threads : {1, 2}) {
    LqProblem lq = random_lq(humanoid());
    for (LqStage& stage : lq.stages) stage.H *= -1.0;
    for (std::size_t k = 0; k < 6; ++k)
      lq.problem.stages[k].expand = [s = lq.stages[k]](const double* x, const double* u,
                                                       KnotExpansion& out) {
        Eigen::VectorXd z(s.H.rows());
        z.head(s.nu) = Eigen::Map<const Eigen::VectorXd>(u, s.nu);
        z.tail(s.H.rows() - s.nu) = Eigen::Map<const Eigen::VectorXd>(x, s.H.rows() - s.nu);
        fill_expansion(s, z, DynamicsForm::SecondOrder, false, out);
      };
    DdpSolver solver(lq.problem, {.threads = threads, .regularization = {.largest = 1e-6}});
    EXPECT_EQ(solver.solve().reason, StopReason::NotPositiveDefinite);
    EXPECT_EQ(solver.summary().knot, 5);
    EXPECT_EQ(solver.summary().control, 0);
  }
}

}  // namespace
}  // namespace burnish::testing
