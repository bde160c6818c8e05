// Tests of the policy between two solves: equal to the solver's at the knots, on the manifold in
// between.
#include "burnish/mpc/feedback.hpp"

#include <gtest/gtest.h>

#include "burnish/ocp/problem.hpp"
#include "burnish/solver/ddp.hpp"
#include "support/allocation_guard.hpp"
#include "support/refusal.hpp"
#include "support/robots.hpp"

namespace burnish {
namespace {

using testing::expect_words;
using testing::refusal;

constexpr double step = 0.02;

/// Robot that flies and rotates; the task is to keep its initial state with little torque. With
/// `impact`, a contact catches its tool in flight.
ProblemSpec thrown(const test::TestRobot& robot, bool impact = false) {
  ProblemSpec spec;
  spec.model = robot.model();
  std::mt19937_64 generator(11);
  spec.initial_state.resize(spec.model.nq + spec.model.nv);
  spec.initial_state << spec.model.q_neutral, test::random_vector(spec.model.nv, 1.5, generator);
  const CostTerm state{.residual = residual::State{spec.initial_state}, .weight = 1.0};
  const CostTerm control{.residual = residual::Control{}, .weight = 1e-2};
  spec.stages = {{.name = "fly", .costs = {state, control}, .step = step}};
  spec.terminal = {state};
  spec.horizon = {{"fly", 8}};
  if (impact) {
    spec.contacts = {{.name = "catch", .tool = robot.tool, .directions = Directions::z()}};
    spec.stages.push_back(
        {.name = "hit", .contacts = {"catch"}, .costs = {state}, .step = step, .impact = true});
    spec.horizon = {{"fly", 3}, {"hit", 1}, {"fly", 4}};
  }
  return spec;
}

struct SolvedProblem {
  explicit SolvedProblem(const ProblemSpec& spec)
      : problem(spec), solver(problem, {.max_iterations = 10}) {
    solver.solve();
  }
  Eigen::VectorXd x(int k) const { return solver.xs().row(k).transpose(); }
  Eigen::VectorXd difference(const Eigen::VectorXd& from, const Eigen::VectorXd& to) const {
    Eigen::VectorXd dx(problem.state().ndx);
    problem.difference(from.data(), to.data(), dx.data());
    return dx;
  }
  Problem problem;
  DdpSolver solver;
};

class FeedbackPlanOfRobot : public ::testing::TestWithParam<test::TestRobot> {};

TEST_P(FeedbackPlanOfRobot, AtKnots_EqualsTheSolversTrajectoryAndGain) {
  const SolvedProblem solved(thrown(GetParam()));
  FeedbackPlan plan(solved.problem, 5, step);
  EXPECT_TRUE(plan.empty());
  plan.load(solved.solver, 3.0);
  EXPECT_FALSE(plan.empty());
  EXPECT_EQ(plan.start(), 3.0);
  EXPECT_EQ(plan.knots(), 5);
  LinearFeedback policy = plan.make_feedback();
  for (int k = 0; k < 5; ++k) {
    plan.at(3.0 + k * step + 1e-12, policy);
    EXPECT_EQ(policy.feedforward, solved.solver.us().row(k).transpose().eval()) << k;
    EXPECT_EQ(policy.gain, Eigen::MatrixXd(solved.solver.gain(k))) << k;
    EXPECT_LT(solved.difference(solved.x(k), policy.state).norm(), 1e-9) << k;
  }
}

TEST_P(FeedbackPlanOfRobot, BetweenKnots_InterpolatesTheStateOnTheManifold) {
  const SolvedProblem solved(thrown(GetParam()));
  FeedbackPlan plan(solved.problem, 5, step);
  plan.load(solved.solver, -1.0);
  LinearFeedback policy = plan.make_feedback();
  for (const double fraction : {0.1, 0.5, 0.9}) {
    plan.at(-1.0 + (2 + fraction) * step, policy);
    const Eigen::VectorXd whole = solved.difference(solved.x(2), solved.x(3));
    const Eigen::VectorXd difference = solved.difference(solved.x(2), policy.state);
    ASSERT_GT(whole.norm(), 1e-3);
    EXPECT_LT((difference - fraction * whole).norm(), 1e-9 * (1.0 + whole.norm())) << fraction;
    EXPECT_EQ(policy.gain, Eigen::MatrixXd(solved.solver.gain(2)));
  }
}

TEST_P(FeedbackPlanOfRobot, StateFeedforwardAndGain_ReproduceTheControl) {
  const SolvedProblem solved(thrown(GetParam()));
  FeedbackPlan plan(solved.problem, 8, step);
  plan.load(solved.solver, 0.0);
  LinearFeedback policy = plan.make_feedback();
  plan.at(2.3 * step, policy);
  std::mt19937_64 generator(3);
  const Eigen::VectorXd dx = test::random_vector(solved.problem.state().ndx, 0.2, generator);
  Eigen::VectorXd x(solved.problem.state().nx), u(policy.feedforward.size());
  solved.problem.integrate(policy.state.data(), dx.data(), x.data());
  plan.control(policy, x, u);
  const Eigen::VectorXd by_hand = policy.feedforward + policy.gain * dx;
  EXPECT_LT((u - by_hand).norm(), 1e-9 * (1.0 + by_hand.norm()));
  plan.control(policy, policy.state, u);
  EXPECT_LT((u - policy.feedforward).norm(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Robots, FeedbackPlanOfRobot,
                         ::testing::Values(test::TestRobot{"arm7", Base::Fixed, "tool"},
                                           test::TestRobot{"arm7", Base::FreeFlyer, "tool"},
                                           test::TestRobot{"every_joint", Base::FreeFlyer, "tip"}),
                         [](const auto& test) { return test.param.label(); });

const test::TestRobot arm{"arm7", Base::Fixed, "tool"};

TEST(FeedbackPlan, UnevenSteps_PlaceKnotsAtTheirTimes) {
  ProblemSpec spec = thrown(arm);
  spec.horizon = {{.stage = "fly", .knots = 8, .step = step, .duration = 0.4}};
  const SolvedProblem solved(spec);
  const std::vector<double> steps = knot_steps(spec);
  FeedbackPlan plan(solved.problem, std::span(steps).first(5));
  EXPECT_EQ(plan.knots(), 5);
  plan.load(solved.solver, 2.0);
  LinearFeedback policy = plan.make_feedback();
  for (int k = 0; k < 5; ++k) {
    EXPECT_NEAR(plan.time_of(k), 2.0 + solved.problem.time_of(k), 1e-12);
    const double length = plan.time_of(k + 1) - plan.time_of(k);
    EXPECT_NEAR(length, steps[static_cast<std::size_t>(k)], 1e-12);
    plan.at(plan.time_of(k) + 0.25 * length, policy);
    EXPECT_EQ(policy.gain, Eigen::MatrixXd(solved.solver.gain(k))) << k;
    const Eigen::VectorXd whole = solved.difference(solved.x(k), solved.x(k + 1));
    const Eigen::VectorXd difference = solved.difference(solved.x(k), policy.state);
    EXPECT_LT((difference - 0.25 * whole).norm(), 1e-9) << k;
  }
  // The same knots shifted to other times.
  KnotTimes moved(steps);
  moved.move(1, 0.5 * steps[0]);
  plan.load(solved.solver, 3.0, moved);
  EXPECT_DOUBLE_EQ(plan.time_of(1), 3.0 + 0.5 * steps[0]);
  plan.at(3.0 + 0.6 * steps[0], policy);
  EXPECT_EQ(policy.gain, Eigen::MatrixXd(solved.solver.gain(1)));
  EXPECT_EQ(FeedbackPlan(solved.problem, std::vector<double>(100, step)).knots(), 8);
}

TEST(FeedbackPlan, TimeBeyondItsEnds_HoldsTheFirstOrLastKnot) {
  const SolvedProblem solved(thrown(arm));
  FeedbackPlan plan(solved.problem, 100, step);
  EXPECT_EQ(plan.knots(), 8);
  plan.load(solved.solver, 1.0);
  LinearFeedback policy = plan.make_feedback();
  plan.at(0.0, policy);
  EXPECT_EQ(policy.state, solved.x(0));
  EXPECT_EQ(policy.feedforward, solved.solver.us().row(0).transpose().eval());
  plan.at(100.0, policy);
  EXPECT_LT(solved.difference(solved.x(8), policy.state).norm(), 1e-12);
  EXPECT_EQ(policy.feedforward, solved.solver.us().row(7).transpose().eval());
}

TEST(FeedbackPlan, KnotWithoutControl_HasZeroGain) {
  SolvedProblem solved(thrown(arm, true));
  FeedbackPlan plan(solved.problem, 8, step);
  LinearFeedback policy = plan.make_feedback();
  const int fly = solved.problem.stage_index("fly"), hit = solved.problem.stage_index("hit");
  for (const int stage : {fly, hit}) {
    solved.problem.set_knot(3, stage, 3 * step);
    solved.solver.solve();
    plan.load(solved.solver, 0.0);
    plan.at(3.5 * step, policy);
    EXPECT_EQ(policy.gain.isZero(0.0), stage == hit);
    EXPECT_EQ(policy.feedforward.isZero(0.0), stage == hit);
  }
}

TEST(FeedbackPlan, EmptyPlan_LeavesThePolicyUnchanged) {
  const SolvedProblem solved(thrown(arm));
  FeedbackPlan plan(solved.problem, 4, step);
  LinearFeedback policy = plan.make_feedback();
  policy.state.setConstant(7.0);
  plan.at(0.0, policy);
  EXPECT_EQ(policy.state[0], 7.0);
  plan.load(solved.solver, 0.0);
  plan.clear();
  plan.at(0.0, policy);
  EXPECT_EQ(policy.state[0], 7.0);
}

TEST(FeedbackPlan, UseAfterConstruction_AllocatesNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  const SolvedProblem solved(thrown({"arm7", Base::FreeFlyer, "tool"}));
  FeedbackPlan plan(solved.problem, 4, step), other(plan);
  LinearFeedback policy = plan.make_feedback();
  Eigen::VectorXd u(policy.feedforward.size());
  const AllocationGuard guard;
  plan.load(solved.solver, 0.0);
  std::swap(plan, other);
  other.at(0.03, policy);
  other.control(policy, policy.state, u);
  EXPECT_EQ(guard.count(), 0);
}

TEST(FeedbackPlan, NoKnotsOrZeroStep_IsRefused) {
  const SolvedProblem solved(thrown(arm));
  expect_words(refusal([&] { FeedbackPlan(solved.problem, 0, step); }), {"0 knots"});
  expect_words(refusal([&] { FeedbackPlan(solved.problem, 3, 0.0); }), {"step", "positive"});
}

}  // namespace
}  // namespace burnish
