// Tests of problems over time: moving horizons, ranges, rest, forces at the end, NaN, allocations.
#include "burnish/ocp/problem.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "burnish/derivatives/rigid_body.hpp"
#include "support/allocation_guard.hpp"
#include "support/ocp_cases.hpp"

namespace burnish::test {
namespace {

/// Returns a problem with stages "reach" (targets over time), "touch" (an impact) and "hold"
/// (contacts, Runge-Kutta, a custom residual).
ProblemSpec moving_spec(const OcpCase& test, const Model& model) {
  ProblemSpec spec = bare_problem(test, model);
  const std::string tool = test.robot.tool;
  const auto circle = Signal::over_time(3, [](double t, Eigen::Ref<Eigen::VectorXd> p) {
    p << 0.4 + 0.1 * std::cos(t), 0.1 * std::sin(t), 0.5;
  });
  const auto turning = Signal::over_time(4, [](double t, Eigen::Ref<Eigen::VectorXd> q) {
    q << 0.0, 0.0, std::sin(0.5 * t), std::cos(0.5 * t);
  });
  Stage reach{.name = "reach",
              .costs = {{.name = "position", .residual = residual::FramePosition{tool, circle}},
                        {.name = "rotation", .residual = residual::FrameRotation{tool, turning}},
                        {.name = "control", .residual = residual::Control{}, .weight = 1e-3}}};
  Stage touch{.name = "touch",
              .contacts = {"brace", "pad"},
              .costs = {{.residual = residual::JointVelocity{}}},
              .impact = true};
  Stage hold{.name = "hold",
             .contacts = {"brace", "pad"},
             .costs = {{.name = "force", .residual = residual::ContactForce{"pad"}},
                       {.residual = residual::custom(
                            WithoutJacobian{.frames = {tool}, .contacts = {"pad"}})},
                       {.residual = residual::CentroidalMomentum{}}},
             .step = 0.005,
             .integrator = Integrator::RungeKutta4};
  spec.stages = {reach, touch, hold};
  spec.horizon = {{"reach", 7}, {"touch", 1}, {"hold", 5}};
  spec.terminal = {{.name = "position", .residual = residual::FramePosition{tool, circle}}};
  return spec;
}

/// Expects that two problems give a solver equal values.
void expect_alike(Problem& a, Problem& b) {
  ASSERT_EQ(a.knots(), b.knots());
  std::mt19937_64 generator(8);
  OcpHorizon at_a(a, generator);
  generator.seed(8);
  OcpHorizon at_b(b, generator);
  at_a.expand(a);
  at_b.expand(b);
  EXPECT_EQ(at_a.x, at_b.x);
  EXPECT_EQ(at_a.next, at_b.next);
  for (int k = 0; k <= a.knots(); ++k) {
    const auto at = static_cast<std::size_t>(k);
    EXPECT_EQ(a.knot_name(k), b.knot_name(k));
    EXPECT_EQ(a.time_of(k), b.time_of(k));
    EXPECT_EQ(at_a.values[at].cost, at_b.values[at].cost) << a.knot_name(k);
    const int nz = a.controls(k) + a.state().ndx;
    EXPECT_EQ(at_a.gradient[at].head(nz), at_b.gradient[at].head(nz)) << a.knot_name(k);
  }
}

TEST(Horizon, Advance_EqualsAProblemBuiltThere) {
  const Model model = arm.robot.model();
  ProblemSpec spec = moving_spec(arm, model);
  Problem problem(spec);
  for (int i = 0; i < 2; ++i) problem.advance(problem.stage_index("hold"));
  problem.advance(problem.stage_index("reach"));
  spec.start_time = problem.time_of(0);
  spec.horizon = {{"reach", 4}, {"touch", 1}, {"hold", 7}, {"reach", 1}};
  Problem there(spec);
  expect_alike(problem, there);
}

TEST(Horizon, SetKnots_EqualAProblemBuiltThere) {
  const Model model = arm.robot.model();
  ProblemSpec spec = moving_spec(arm, model);
  spec.horizon = {{"reach", 6}};
  Problem problem(spec);
  ProblemSpec wanted = spec;
  wanted.horizon = {{"hold", 2}, {"touch", 1}, {"reach", 3}};
  wanted.start_time = 2.5;
  Problem there(wanted);
  for (int k = 0; k <= there.knots(); ++k) problem.set_knot(k, there.stage_of(k), there.time_of(k));
  expect_alike(problem, there);
}

TEST(Horizon, SetTarget_LastsUntilTheKnotIsSet) {
  Problem problem(moving_spec(arm, arm.robot.model()));
  std::mt19937_64 generator(2);
  const OcpState at = random_ocp_state(problem, generator);
  const Eigen::VectorXd before = problem.residual(2, 0, at.x, at.u);
  const Eigen::Vector3d target(1.0, 2.0, 3.0);
  EXPECT_EQ(problem.set_target(2, problem.term_index(0, "position"), target), Status::Ok);
  const Eigen::VectorXd moved = problem.residual(2, 0, at.x, at.u);
  Eigen::Vector3d circle(0.4 + 0.1 * std::cos(problem.time_of(2)),
                         0.1 * std::sin(problem.time_of(2)), 0.5);
  EXPECT_LT((before - moved - (target - circle)).norm(), 1e-12);
  problem.set_knot(2, 0, problem.time_of(2));
  EXPECT_EQ(problem.residual(2, 0, at.x, at.u), before);
}

TEST(Horizon, Ranges_HaveOneStageAndCoverAllKnots) {
  Problem problem(moving_spec(arm, arm.robot.model()));
  int next = 0;
  for (const KnotRange range : problem.ranges()) {
    EXPECT_EQ(range.begin, next);
    EXPECT_GT(range.end, range.begin);
    EXPECT_LE(range.end - range.begin, native_lanes);
    for (int k = range.begin; k < range.end; ++k)
      EXPECT_EQ(problem.stage_of(k), problem.stage_of(range.begin));
    next = range.end;
  }
  EXPECT_EQ(next, problem.knots() + 1);
  EXPECT_EQ(problem.ranges().back().begin, problem.knots());
  const std::vector<KnotRange> before(problem.ranges().begin(), problem.ranges().end());
  problem.prepare(3);
  EXPECT_EQ(before.size(), problem.ranges().size());
  EXPECT_EQ(problem.stage_names(),
            (std::vector<std::string>{"reach", "touch", "hold", "terminal"}));
  EXPECT_EQ(problem.knot_name(7), "touch, knot 7");
  EXPECT_EQ(problem.knot_name(13), "the terminal state");
}

TEST(Horizon, TwoWorkers_GiveTheSameBits) {
  Problem problem(moving_spec(arm, arm.robot.model()));
  problem.prepare(2);
  std::mt19937_64 generator(4);
  OcpHorizon first(problem, generator);
  generator.seed(4);
  OcpHorizon second(problem, generator);
  first.expand(problem);
  const auto ranges = problem.ranges();
  // Backwards, on another worker: no data of earlier knots may have an effect.
  for (std::size_t i = ranges.size(); i-- > 0;)
    problem.expand(1, ranges[i], second.view(), second.next.data(), second.values.data(),
                   second.out.data());
  EXPECT_EQ(first.next, second.next);
  for (std::size_t k = 0; k < first.values.size(); ++k)
    EXPECT_EQ(first.values[k].cost, second.values[k].cost);
}

/// A residual that reads the acceleration, which impacts and the end do not have.
struct SeesAcceleration {
  int rows = 1;
  void value(const NodeView& at, Eigen::Ref<Eigen::VectorXd> out) const {
    out[0] = at.acceleration().norm();
  }
};

TEST(Horizon, ImpactsAndTheEnd_HaveZeroAcceleration) {
  const Model model = arm.robot.model();
  ProblemSpec spec = moving_spec(arm, model);
  const CostTerm sees{.residual = residual::custom(SeesAcceleration{})};
  for (Stage& stage : spec.stages) stage.costs.push_back(sees);
  spec.terminal.push_back(sees);
  Problem problem(spec);
  std::mt19937_64 generator(6);
  const OcpState at = random_ocp_state(problem, generator);
  EXPECT_GT(problem.residual(0, 3, at.x, at.u)[0], 0.0);
  EXPECT_EQ(problem.residual(7, 1, at.x, at.u)[0], 0.0);
  EXPECT_EQ(problem.residual(13, 1, at.x, at.u)[0], 0.0);
}

class QuasiStatic : public ::testing::TestWithParam<OcpCase> {};

TEST_P(QuasiStatic, Control_BalancesGravityUpToItsResidual) {
  const Model model = GetParam().robot.model();
  ProblemSpec spec = moving_spec(GetParam(), model);
  spec.horizon = {{"hold", 1}};
  Problem problem(spec);
  std::mt19937_64 generator(7);
  const StateLayout& l = problem.layout();
  const int stage = problem.stage_index("hold");
  Eigen::VectorXd x = random_ocp_state(problem, generator).x;
  x.segment(l.nq, l.nv).setZero();
  const Eigen::VectorXd bias = random_vector(l.nv, 1.0, generator);
  ASSERT_EQ(problem.set_torque_bias(bias), Status::Ok);
  const Problem::QuasiStatic rest = problem.quasi_static(stage, x);
  EXPECT_EQ(rest.force.size(), 7);
  // Controls, springs and contact forces balance gravity, except for the stated residual.
  ContactDynamics dynamics(model, contacts_at(spec.contacts, spec.start_time));
  dynamics.set_active(0, false);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(l.nv);
  RigidBody body(model);
  ASSERT_EQ(body.update(x.head(l.nq), zero), Status::Ok);
  Eigen::VectorXd torque = bias + body.passive_torque();
  for (int i = 0; i < l.nu; ++i) torque[l.actuated[static_cast<std::size_t>(i)]] += rest.control[i];
  dynamics.inverse(x.head(l.nq), zero, zero, rest.force);
  const Eigen::VectorXd left = dynamics.tau() - torque;
  EXPECT_NEAR(left.cwiseAbs().maxCoeff(), rest.residual, 1e-8);
  // Two passive joints in a row with one contact row fall: a residual remains.
  if (GetParam().robot.name != "every_joint") {
    EXPECT_LT(rest.residual, 1e-8);
  }
  EXPECT_LT((dynamics.jacobian() * left).cwiseAbs().maxCoeff(), 1e-7);
  for (const int k : l.actuated) EXPECT_NEAR(left[k], 0.0, 1e-7);
  // The same force as a given force needs the same control.
  const Problem::QuasiStatic again = problem.quasi_static(stage, x, rest.force);
  EXPECT_LT((again.control - rest.control).norm(), 1e-7 * std::max(1.0, rest.control.norm()));
}

INSTANTIATE_TEST_SUITE_P(Robots, QuasiStatic, ::testing::ValuesIn(ocp_cases()),
                         [](const auto& test) { return test.param.label(); });

TEST(QuasiStaticArm, Control_KeepsTheArmAtRest) {
  const Model model = arm.robot.model();
  ProblemSpec spec = moving_spec(arm, model);
  spec.initial_state.tail(model.nv).setZero();
  Problem problem(spec);
  const Eigen::VectorXd u = problem.quasi_static(0, spec.initial_state).control;
  Eigen::VectorXd next(spec.initial_state.size());
  problem.roll(0, 0, spec.initial_state.data(), u.data(), next.data());
  EXPECT_LT((next - spec.initial_state).norm(), 1e-12);
}

TEST(TerminalForces, TorqueModel_GivesForcesAtTheEnd) {
  const OcpCase filtered{arm.robot, true};
  const Model model = filtered.robot.model();
  ProblemSpec spec = moving_spec(filtered, model);
  spec.terminal.push_back({.name = "force", .residual = residual::ContactForce{"pad"}});
  Problem problem(spec);
  std::mt19937_64 generator(9);
  const OcpState at = random_ocp_state(problem, generator);
  const int last = problem.knots();
  problem.set_knot(last - 1, problem.stage_of(last - 1), problem.time_of(last));
  // With the same torques, the terminal state has the forces of "hold", whose contacts it uses.
  const Eigen::VectorXd end = problem.residual(last, 1, at.x, at.u);
  EXPECT_LT(relative_error(end, problem.residual(last - 1, 0, at.x, at.u)), 1e-12);
  EXPECT_EQ(problem.force_names(last), problem.force_names(last - 1));
  EXPECT_EQ(problem.force_names(last).front(), "brace/z");
  EXPECT_EQ(problem.forces(last, at.x, at.u).size(), 7);
}

TEST(TorqueBias, ConstantBias_AddsToTheActuators) {
  const Model model = arm.robot.model();
  Problem problem(moving_spec(arm, model));
  std::mt19937_64 generator(10);
  const OcpState at = random_ocp_state(problem, generator);
  const Eigen::VectorXd bias = random_vector(model.nv, 2.0, generator);
  const Eigen::VectorXd wanted = problem.acceleration(0, at.x, at.u + bias);
  problem.set_torque_bias(bias);
  EXPECT_LT(relative_error(problem.acceleration(0, at.x, at.u), wanted), 1e-12);
}

TEST(TorqueBias, DecayingBias_DecaysWithTheTimesOfKnots) {
  const Model model = arm.robot.model();
  Problem problem(moving_spec(arm, model));
  std::mt19937_64 generator(11);
  const OcpState at = random_ocp_state(problem, generator);
  const Eigen::VectorXd lasting = random_vector(model.nv, 2.0, generator);
  const Eigen::VectorXd decaying = random_vector(model.nv, 2.0, generator);
  const double decay_time = 0.03;
  double since = 0.0;
  for (int k = 0; k < 3; ++k) {
    ASSERT_EQ(problem.set_torque_bias(lasting + std::exp(-since / decay_time) * decaying),
              Status::Ok);
    const Eigen::VectorXd wanted = problem.acceleration(k, at.x, at.u);
    ASSERT_EQ(problem.set_torque_bias(lasting, decaying, decay_time), Status::Ok);
    EXPECT_LT(relative_error(problem.acceleration(k, at.x, at.u), wanted), 1e-12) << k;
    since += problem.step_of(k);
  }
  EXPECT_EQ(problem.set_torque_bias(lasting, decaying, 0.0), Status::NotFinite);
  EXPECT_EQ(problem.set_torque_bias(lasting, decaying.head(1), decay_time), Status::WrongSize);
}

TEST(NonFiniteValue, NanTarget_IsReportedWithItsTermAndKnot) {
  const Model model = arm.robot.model();
  for (const std::optional<Penalty>& penalty :
       {std::optional<Penalty>{}, std::optional(Penalty::at_least(-100.0)),
        std::optional(Penalty::smooth_absolute(0.1)),
        std::optional(Penalty::log_barrier(Eigen::VectorXd::Constant(1, -9.0), {}, 0.1))}) {
    ProblemSpec spec = moving_spec(arm, model);
    spec.stages[0].costs[1].penalty = penalty;
    Problem problem(spec);
    const Eigen::Vector4d nan = Eigen::Vector4d::Constant(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(problem.set_target(3, 1, nan), Status::Ok);
    std::mt19937_64 generator(3);
    OcpHorizon horizon(problem, generator);
    horizon.expand(problem);
    for (int k = 0; k <= problem.knots(); ++k) {
      const KnotValue& value = horizon.values[static_cast<std::size_t>(k)];
      EXPECT_EQ(value.status, k == 3 ? Status::NotFinite : Status::Ok) << problem.knot_name(k);
      EXPECT_EQ(value.term, k == 3 ? 1 : -1) << problem.knot_name(k);
    }
    EXPECT_EQ(problem.term_names(3)[1], "rotation");
    Eigen::VectorXd next(problem.state().nx);
    const KnotValue rolled = problem.roll(0, 3, horizon.x_of(problem, 3).data(),
                                          horizon.u_of(problem, 3).data(), next.data());
    EXPECT_EQ(rolled.status, Status::NotFinite);
    EXPECT_EQ(rolled.term, 1);
  }
}

TEST(NonFiniteValue, NanStateOrControl_IsReportedWithItsKnot) {
  Problem problem(moving_spec(arm, arm.robot.model()));
  std::mt19937_64 generator(3);
  for (const bool in_state : {true, false}) {
    OcpHorizon horizon(problem, generator);
    (in_state ? horizon.x[2 * 14 + 3] : horizon.u[2 * 7 + 3]) =
        std::numeric_limits<double>::quiet_NaN();
    horizon.expand(problem);
    for (int k = 0; k <= problem.knots(); ++k)
      EXPECT_EQ(horizon.values[static_cast<std::size_t>(k)].status,
                k == 2 ? Status::NotFinite : Status::Ok)
          << problem.knot_name(k);
  }
}

class ProblemAllocation : public ::testing::TestWithParam<OcpCase> {};

TEST_P(ProblemAllocation, CallsAfterConstruction_AllocateNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  const Model model = GetParam().robot.model();
  Problem problem(moving_spec(GetParam(), model));
  std::mt19937_64 generator(1);
  OcpHorizon horizon(problem, generator);
  std::vector<double> next(static_cast<std::size_t>(problem.state().nx));
  const Eigen::VectorXd initial = horizon.x_of(problem, 0);
  const Eigen::Vector3d target(0.1, 0.2, 0.3);
  const int hold = problem.stage_index("hold"), reach = problem.stage_index("reach");
  const AllocationGuard guard;
  horizon.expand(problem);
  horizon.evaluate(problem);
  for (int i = 0; i < 4; ++i) {
    problem.set_initial_state(initial);
    problem.set_target(1, 0, target);
    problem.advance(i % 2 == 0 ? hold : reach);
    problem.set_knot(3, hold, 1.0);
    horizon.expand(problem);
    horizon.evaluate(problem);
    for (int k = 0; k <= problem.knots(); ++k)
      problem.roll(0, k, initial.data(), horizon.u.data(), next.data());
  }
  EXPECT_EQ(guard.count(), 0);
}

INSTANTIATE_TEST_SUITE_P(Robots, ProblemAllocation, ::testing::ValuesIn(ocp_cases()),
                         [](const auto& test) { return test.param.label(); });

TEST(ConstraintScale, RowsWithoutARange_AreScaledByTheRobot) {
  const OcpCase arm{{"arm7", Base::Fixed, "tool"}};
  ProblemSpec spec = bare_problem(arm, arm.robot.model());
  spec.contact_solver.mu = 1e-3;
  spec.stages = {
      {.name = "press", .contacts = {"pad"}, .costs = {{.residual = residual::Control{}}}}};
  spec.horizon = {{"press", 3}};
  const Eigen::VectorXd bound = Eigen::VectorXd::Constant(1, 0.4), zero = Eigen::VectorXd::Zero(1);
  spec.stages[0].constraints = {
      {"slow", residual::JointVelocity{{"joint_2"}}, {}, bound},
      {"weak", residual::JointTorque{{"joint_2"}}, zero, {}},
      {"low", residual::JointPosition{{"joint_2"}}, {}, bound},
      {"pressed", residual::ContactForce{"pad"}, zero, {}},
      {"near", residual::FramePosition{"tool", Eigen::Vector3d::Zero()}, -bound, bound},
      {"clear", residual::FrameDistance{"tool", Eigen::Vector3d::Zero()}, bound, {}},
      {"tube", residual::FrameDistance{"tool", Eigen::Vector3d::Zero()}, {}, 2.0 * bound},
      {"still", residual::JointVelocity{{"joint_2"}}, zero, zero, Eigen::VectorXd::Constant(1, 3.0),
       7.0, 2.0}};
  Problem problem(spec);
  const Model& m = problem.spec().model;
  const int q = m.joints[static_cast<std::size_t>(m.joint_index("joint_2"))].v_index;
  const double* scale = problem.row_scale(0);
  EXPECT_EQ(scale[0], m.velocity_limit[q]);
  EXPECT_EQ(scale[1], m.effort_limit[q]);
  EXPECT_EQ(scale[2], 0.5 * (m.q_upper[q] - m.q_lower[q]));
  EXPECT_EQ(scale[3], m.total_mass() * m.gravity.norm());
  const int rows = problem.rows(0);
  EXPECT_EQ(scale[rows - 4], 0.4);
  EXPECT_EQ(scale[rows - 3], 0.4) << "distance";
  EXPECT_EQ(scale[rows - 2], 0.8);
  EXPECT_EQ(scale[rows - 1], 3.0);
  EXPECT_EQ(problem.row_l1_weight(0)[rows - 1], 7.0);
  EXPECT_EQ(problem.row_quadratic_weight(0)[rows - 1], 2.0);
  EXPECT_TRUE(std::isinf(problem.row_l1_weight(0)[0]));
}

TEST(ConstraintScale, TorqueRates_AreScaledByCutoffAndEffortLimit) {
  const OcpCase arm{{"arm7", Base::Fixed, "tool"}, true};
  ProblemSpec spec = bare_problem(arm, arm.robot.model());
  spec.stages = {{.name = "go",
                  .costs = {{.residual = residual::Control{}}},
                  .constraints = {{"rate",
                                   residual::JointTorqueRate{{"joint_3", "joint_2"}},
                                   {},
                                   Eigen::VectorXd::Constant(1, 50.0)}}}};
  spec.horizon = {{"go", 3}};
  const Problem problem(spec);
  const Model& m = problem.model();
  EXPECT_EQ(problem.row_scale(0)[0], spec.torque_model->cutoff * m.effort_limit[2]);
  EXPECT_EQ(problem.row_scale(0)[1], spec.torque_model->cutoff * m.effort_limit[1]);
}

}  // namespace
}  // namespace burnish::test
