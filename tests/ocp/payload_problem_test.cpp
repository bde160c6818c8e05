// Tests of a payload as data of a problem, and of the derivative of the optimal cost by it.
#include <gtest/gtest.h>

#include <limits>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/ocp/sensitivity.hpp"
#include "support/allocation_guard.hpp"
#include "support/ocp_cases.hpp"

namespace burnish::test {
namespace {

InertiaSpec brick() {
  InertiaSpec result;
  result.mass = 0.8;
  result.com = {0.02, -0.01, 0.05};
  result.inertia_at_com << 4e-3, 2e-4, -1e-4, 2e-4, 3e-3, 3e-4, -1e-4, 3e-4, 5e-3;
  return result;
}

/// Returns a problem in which the arm swings in the air, then presses at its tool. `limited` bounds
/// the force below its target.
ProblemSpec pressing(const Model& model, bool limited) {
  ProblemSpec spec{.model = model};
  Eigen::VectorXd q = model.q_neutral;
  for (int k = 0; k < model.nv; ++k) q[k] = k % 2 == 0 ? 0.2 : -0.7;
  spec.initial_state = Eigen::VectorXd::Zero(model.nq + model.nv);
  spec.initial_state.head(model.nq) = q;
  RigidBody body(model);
  EXPECT_EQ(body.update(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
  const Eigen::Vector3d p = body.placement(body.frame("tool")).translation();
  spec.contacts = {contact("tool", "world", Reference::centered(), Directions::z())};
  spec.contacts[0].name = "pad";
  spec.contacts[0].with_gains(0.0, 30.0);
  const std::vector<CostTerm> shared = {
      {.name = "position",
       .residual =
           residual::FramePosition{"tool", Eigen::VectorXd(p + Eigen::Vector3d(0.03, 0.05, 0.0))},
       .weight = 100.0},
      {.name = "speed", .residual = residual::JointVelocity{}, .weight = 0.1},
      {.name = "momentum", .residual = residual::CentroidalMomentum{}, .weight = 0.1},
      {.name = "control", .residual = residual::Control{}, .weight = 1e-3}};
  Stage swing{.name = "swing", .costs = shared, .step = 0.01};
  Stage press{.name = "press", .contacts = {"pad"}, .costs = shared, .step = 0.01};
  press.costs.push_back(
      {.name = "force",
       .residual =
           residual::ContactForce{.contact = "pad",
                                  .target = Eigen::VectorXd(Eigen::VectorXd::Constant(1, 20.0))},
       .weight = 0.01});
  if (limited)
    press.constraints = {{.name = "limit",
                          .residual = residual::ContactForce{"pad"},
                          .upper = Eigen::VectorXd::Constant(1, 12.0)}};
  spec.stages = {swing, press};
  spec.horizon = {{"swing", 8}, {"press", 12}};
  spec.terminal = {shared[0], shared[1], shared[2]};
  return spec;
}

DdpOptions tight() {
  DdpOptions options;
  options.max_iterations = 300;
  options.stop_tolerance = 1e-13;
  return options;
}

class PayloadSensitivity : public ::testing::TestWithParam<bool> {};

TEST_P(PayloadSensitivity, CostDerivative_EqualsDifferencesOfSolvedProblems) {
  const Model model = named_robot("arm7");
  Problem problem(pressing(model, GetParam()));
  ASSERT_EQ(problem.set_payload("tool", brick()), Status::Ok);
  DdpSolver solver(problem, tight());
  ASSERT_EQ(solver.solve().reason, StopReason::Converged) << solver.text();
  if (GetParam()) {
    EXPECT_GT(solver.summary().active_constraints, 0) << "the limit must be active";
  }
  const double cost = solver.summary().cost;
  const Vector10 got = cost_by_payload(problem, solver, "tool");
  // The problem is unchanged.
  DdpSolver same(problem, tight());
  same.set_guess(solver.xs(), solver.us());
  same.solve();
  EXPECT_NEAR(same.summary().cost, cost, 1e-7 * cost);

  const Vector10 theta = inertia_parameters(brick());
  Problem changed(pressing(model, GetParam()));
  const auto cost_at = [&](int k, double h) {
    Vector10 other = theta;
    other[k] += h;
    EXPECT_EQ(changed.set_payload("tool", inertia_of(other)), Status::Ok);
    DdpSolver again(changed, tight());
    again.set_guess(solver.xs(), solver.us());
    EXPECT_EQ(again.solve().reason, StopReason::Converged);
    return again.summary().cost;
  };
  Vector10 wanted;
  for (int k = 0; k < 10; ++k) {
    const double h = k == 0 ? 1e-3 : k < 4 ? 1e-4 : 1e-4;
    wanted[k] = (cost_at(k, h) - cost_at(k, -h)) / (2.0 * h);
  }
  for (int k = 0; k < 10; ++k)
    EXPECT_NEAR(got[k], wanted[k], 1e-4 * std::abs(wanted[k]) + 1e-5 * wanted.cwiseAbs().maxCoeff())
        << inertia_parameter_names[static_cast<std::size_t>(k)];
}

INSTANTIATE_TEST_SUITE_P(Limited, PayloadSensitivity, ::testing::Bool(),
                         [](const auto& of) { return of.param ? "yes" : "no"; });

TEST(PayloadCost, UnsolvedProblem_IsRefused) {
  Problem problem(pressing(named_robot("arm7"), false));
  DdpOptions once = tight();
  once.max_iterations = 1;
  DdpSolver solver(problem, once);
  solver.solve();
  EXPECT_THROW((void)cost_by_payload(problem, solver, "tool"), Error);
  EXPECT_THROW((void)cost_by_payload(problem, solver, "tol"), Error);
}

TEST(ProblemPayload, SetPayload_EqualsAPayloadInTheModel) {
  const Model model = named_robot("arm7");
  Problem set(pressing(model, true)), built(pressing(with_payload(model, {"tool", brick()}), true));
  set.prepare(2);
  ASSERT_EQ(set.set_payload("tool", brick()), Status::Ok);
  set.prepare(3);  // a worker that is added later has the payload, too
  EXPECT_NEAR(set.model().total_mass(), built.model().total_mass(), 1e-12);
  std::mt19937_64 generator(4);
  for (int k = 0; k < set.knots(); ++k) {
    const OcpState s = random_ocp_state(built, generator);
    for (int worker = 0; worker < 3; ++worker) {
      built.prepare(worker + 1);
      Eigen::VectorXd a(set.state().nx), b(a);
      const double cost = set.roll(worker, k, s.x.data(), s.u.data(), a.data()).cost;
      EXPECT_NEAR(cost, built.roll(worker, k, s.x.data(), s.u.data(), b.data()).cost,
                  1e-12 * std::abs(cost));
      EXPECT_LE((a - b).cwiseAbs().maxCoeff(), 1e-12 * std::max(1.0, b.cwiseAbs().maxCoeff()));
    }
  }
  // The same in packs.
  OcpHorizon in_set(set, generator);
  std::mt19937_64 first(7), second(7);
  OcpHorizon one(set, first), other(built, second);
  one.expand(set);
  other.expand(built);
  EXPECT_EQ(one.x, other.x);
  for (std::size_t i = 0; i < one.next.size(); ++i)
    EXPECT_NEAR(one.next[i], other.next[i], 1e-11 * std::max(1.0, std::abs(other.next[i])));
}

TEST(ProblemPayload, SetPayload_AllocatesNothingAndRefusesBadValues) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  Problem problem(pressing(named_robot("arm7"), false));
  InertiaSpec bad = brick();
  bad.mass = std::numeric_limits<double>::quiet_NaN();
  const double before = problem.model().total_mass();
  EXPECT_EQ(problem.set_payload("tool", bad), Status::NotFinite);
  EXPECT_EQ(problem.model().total_mass(), before);
  EXPECT_THROW((void)problem.set_payload("toll", brick()), Error);
  const InertiaSpec good = brick();
  const AllocationGuard guard;
  EXPECT_EQ(problem.set_payload("tool", good), Status::Ok);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace
}  // namespace burnish::test
