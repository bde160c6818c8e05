// Tests of the step check: errors of a plan's steps against small steps, their limits, and warnings
// about steps that are too long for gains, friction and springs.
#include "burnish/ocp/step_check.hpp"

#include <gtest/gtest.h>

#include "support/ocp_cases.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

/// Returns a problem of one stage "go" with a dummy cost.
ProblemSpec going(ProblemSpec spec, Stage stage, int knots) {
  stage.name = "go";
  stage.costs = {{.residual = residual::JointVelocity{}}};
  spec.stages = {stage};
  spec.horizon = {{"go", knots}};
  return spec;
}

/// Returns the states of the problem's own steps from its initial state.
RowMatrix rolled(Problem& problem, const RowMatrix& us) {
  RowMatrix xs(problem.knots() + 1, problem.layout().nx());
  xs.row(0) = Eigen::Map<const Eigen::RowVectorXd>(problem.initial_state(), xs.cols());
  for (int k = 0; k < problem.knots(); ++k)
    EXPECT_LE(problem.roll(0, k, xs.row(k).data(), us.row(k).data(), xs.row(k + 1).data()).status,
              Status::NotConverged);
  return xs;
}

StepReport report_of(const Problem& problem, const RowMatrix& xs, const RowMatrix& us) {
  return check_steps(problem, {xs.data(), xs.rows(), xs.cols()}, {us.data(), us.rows(), us.cols()});
}

class StepCheckCases : public ::testing::TestWithParam<OcpCase> {
 protected:
  /// Returns the absolute error of a step in q and v against 400 Runge-Kutta steps, at knot 0.
  Eigen::VectorXd expected(const ProblemSpec& spec, const RowMatrix& xs, const RowMatrix& us) {
    constexpr int steps = 400;
    ProblemSpec fine = spec;
    fine.stages[0].step /= steps;
    fine.stages[0].integrator = Integrator::RungeKutta4;
    Problem problem(fine);
    Eigen::VectorXd x = xs.row(0), next = x, dx(problem.layout().ndx());
    for (int i = 0; i < steps; ++i) {
      EXPECT_LE(problem.roll(0, 0, x.data(), us.row(0).data(), next.data()).status,
                Status::NotConverged);
      x = next;
    }
    const Eigen::VectorXd planned = xs.row(1);
    problem.difference(planned.data(), x.data(), dx.data());
    return dx.head(2 * model.nv).cwiseAbs();
  }

  Model model = GetParam().robot.model();
  std::mt19937_64 generator{5};
};

TEST_P(StepCheckCases, ReportedError_EqualsTheErrorAgainstSmallSteps) {
  for (const Integrator integrator : {Integrator::SemiImplicitEuler, Integrator::RungeKutta4}) {
    const ProblemSpec spec =
        going(bare_problem(GetParam(), model),
              {.contacts = {"brace", "pad"}, .step = 0.04, .integrator = integrator}, 1);
    Problem problem(spec);
    const RowMatrix us = uniform(problem.layout().nu, 3.0, generator).transpose();
    const RowMatrix xs = rolled(problem, us);
    const StepReport report = report_of(problem, xs, us);
    ASSERT_EQ(report.status, Status::Ok) << report.text();
    const Eigen::VectorXd error = expected(spec, xs, us);
    for (const StepError* worst : {&report.position, &report.velocity}) {
      const bool speed = worst == &report.velocity;
      int entry = 0;
      while (model.v_name(entry) != worst->entry) ++entry;
      const double wanted = error[entry + (speed ? model.nv : 0)];
      EXPECT_NEAR(worst->error, wanted, 0.03 * std::max(wanted, worst->limit)) << worst->entry;
      EXPECT_EQ(worst->knot, 0);
      EXPECT_EQ(worst->step, 0.04);
      EXPECT_EQ(worst->unit.ends_with("/s"), speed);
      // No entry has a larger error, unless that error is within its limit.
      const double largest = error.segment(speed ? model.nv : 0, model.nv).maxCoeff();
      EXPECT_TRUE(worst->error > worst->limit || worst->error > 0.97 * largest - 1e-3);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, StepCheckCases, ::testing::ValuesIn(ocp_cases()),
                         [](const auto& named) { return std::to_string(named.index); });

class StepCheck : public ::testing::Test {
 protected:
  ProblemSpec spec(double step, int knots, Integrator integrator = Integrator::SemiImplicitEuler) {
    ProblemSpec result =
        going(bare_problem(arm, model), {.step = step, .integrator = integrator}, knots);
    result.actuation.passive_torques = false;
    return result;
  }
  RowMatrix at_rest(const Problem& problem) {
    return problem.quasi_static(0, problem.spec().initial_state)
        .control.transpose()
        .replicate(problem.knots(), 1);
  }
  Model model = arm.robot.model();
};

TEST_F(StepCheck, LongStep_IsNamedWithASufficientStep) {
  ProblemSpec coarse = spec(0.01, 6);
  coarse.horizon = {{"go", 3}, {.stage = "go", .knots = 1, .step = 0.3}, {"go", 2}};
  Problem problem(coarse);
  const RowMatrix us = at_rest(problem);
  const RowMatrix xs = rolled(problem, us);
  const StepReport report = report_of(problem, xs, us);
  EXPECT_TRUE(report.coarse);
  EXPECT_EQ(report.position.knot, 3);
  EXPECT_DOUBLE_EQ(report.position.time, coarse.start_time + 0.03);
  EXPECT_EQ(report.position.step, 0.3);
  EXPECT_GT(report.position.error, report.position.limit);
  testing::expect_words(report.warning(), {"too coarse", "0.3 s", "go, knot 3", "short enough"});
  ASSERT_GT(report.sufficient_step, 0.0);
  coarse.horizon[1].step = report.sufficient_step;
  Problem shorter(coarse);
  const RowMatrix short_xs = rolled(shorter, us);
  EXPECT_FALSE(report_of(shorter, short_xs, us).coarse) << report.sufficient_step;
}

TEST_F(StepCheck, ShortSteps_GiveNoWarning) {
  Problem problem(spec(0.01, 20));
  const RowMatrix us = at_rest(problem);
  const StepReport report = report_of(problem, rolled(problem, us), us);
  EXPECT_FALSE(report.coarse);
  EXPECT_EQ(report.warning(), "");
  EXPECT_EQ(report.sufficient_step, 0.0);
  EXPECT_GT(report.position.error, 0.0);
}

TEST_F(StepCheck, Gaps_AreNotStepErrors) {
  Problem problem(spec(0.01, 4));
  const RowMatrix us = at_rest(problem);
  RowMatrix xs = rolled(problem, us);
  const StepReport before = report_of(problem, xs, us);
  xs(3, 1) += 0.5;  // a gap, as of a solver that did not converge
  const StepReport after = report_of(problem, xs, us);
  EXPECT_FALSE(after.coarse);
  EXPECT_LT(after.position.error, 100.0 * before.position.error);
}

TEST_F(StepCheck, NanStates_GiveAStatus) {
  Problem problem(spec(0.01, 3));
  const RowMatrix us = at_rest(problem);
  RowMatrix xs = rolled(problem, us);
  xs(2, 0) = std::nan("");
  const StepReport report = report_of(problem, xs, us);
  EXPECT_EQ(report.status, Status::NotFinite);
  EXPECT_EQ(report.knot, 2);
  EXPECT_TRUE(report.coarse);
  testing::expect_words(report.warning(), {"error is unknown", "knot 2"});
  const std::string refused = testing::refusal([&] { report_of(problem, xs.topRows(2), us); });
  testing::expect_words(refused, {"check_steps: xs is 2 x 14; wanted 4 x 14"});
}

TEST_F(StepCheck, Impact_TakesNoTime) {
  ProblemSpec hit = spec(0.01, 2);
  Stage stage{.name = "hit", .contacts = {"pad"}, .impact = true};
  stage.costs = hit.stages[0].costs;
  hit.stages.push_back(stage);
  hit.horizon = {{"hit", 1}};
  Problem problem(hit);
  const RowMatrix us = RowMatrix::Zero(1, problem.max_controls());
  const StepReport report = report_of(problem, rolled(problem, us), us);
  EXPECT_FALSE(report.coarse);
  EXPECT_EQ(report.position.knot, -1);
  EXPECT_EQ(report.text(), "discretisation: no time passes");
}

/// Returns the warnings about a stage with this contact.
std::vector<std::string> about(const ContactSpec& contact, Stage stage, const Model& model) {
  ProblemSpec spec = bare_problem(arm, model);
  spec.actuation.passive_torques = false;
  spec.contacts = {contact};
  stage.contacts = {contact.name};
  return step_complaints(Problem(going(spec, stage, 2)));
}

TEST_F(StepCheck, UnstableGains_NameTheLongestStep) {
  ContactSpec pad{.name = "pad", .tool = "tool"};
  const auto of = [&](double kp, double kd, double step, Integrator integrator) {
    pad.with_gains(kp, kd);
    return about(pad, {.step = step, .integrator = integrator}, model);
  };
  const auto euler = Integrator::SemiImplicitEuler, rk4 = Integrator::RungeKutta4;
  EXPECT_EQ(of(0.0, 40.0, 0.049, euler).size(), 0U);
  ASSERT_EQ(of(0.0, 40.0, 0.051, euler).size(), 1U);
  testing::expect_words(of(0.0, 40.0, 0.2, euler)[0],
                        {"stage 'go'", "contact 'pad'", "kd 40", "0.2 s", "at most 0.05 s"});
  // Semi-implicit: h^2 kp + 2 h kd < 4. Runge-Kutta: kd h below 2.785.
  EXPECT_EQ(of(1e4, 0.0, 0.0199, euler).size(), 0U);
  EXPECT_EQ(of(1e4, 0.0, 0.0201, euler).size(), 1U);
  EXPECT_EQ(of(1e4, 200.0, 0.008, euler).size(), 0U);
  EXPECT_EQ(of(1e4, 200.0, 0.0083, euler).size(), 1U);
  EXPECT_EQ(of(0.0, 40.0, 0.0696, rk4).size(), 0U);
  EXPECT_EQ(of(0.0, 40.0, 0.0697, rk4).size(), 1U);
}

TEST_F(StepCheck, LongerKnots_SoftenGainsWithoutAWarning) {
  ContactSpec pad{.name = "pad", .tool = "tool"};
  ProblemSpec spec = bare_problem(arm, model);
  spec.actuation.passive_torques = false;
  spec.contacts = {pad.with_gains(0.0, 40.0)};
  spec = going(spec, {.contacts = {"pad"}, .step = 0.04}, 2);
  spec.horizon = {{.stage = "go", .knots = 2, .step = 0.2}};
  EXPECT_TRUE(step_complaints(Problem(spec)).empty());
  spec.stages[0].step = 0.2;
  EXPECT_EQ(step_complaints(Problem(spec)).size(), 1U);
  spec.horizon = {{.stage = "go", .knots = 2, .step = 0.04}};
  EXPECT_TRUE(step_complaints(Problem(spec)).empty());
}

TEST_F(StepCheck, OvershootingJointFriction_NamesSlipVelocity) {
  ProblemSpec spec = going(bare_problem(arm, model), {.step = 0.01}, 2);
  EXPECT_TRUE(step_complaints(Problem(spec)).empty());  // slip_velocity 0.5
  spec.actuation.slip_velocity = 1e-4;
  const std::vector<std::string> sentences = step_complaints(Problem(spec));
  ASSERT_EQ(sentences.size(), 1U);
  testing::expect_words(sentences[0], {"stage 'go'", "slip_velocity", "0.0001", "at most"});
}

TEST_F(StepCheck, UnstableJointDamping_NamesTheJoint) {
  Model sprung = model;
  sprung.damping[6] = 1e3;
  ProblemSpec spec = going(bare_problem(arm, sprung), {.step = 0.01}, 2);
  const std::vector<std::string> sentences = step_complaints(Problem(spec));
  ASSERT_EQ(sentences.size(), 1U);
  testing::expect_words(sentences[0], {"'joint_7'", "damping", "0.01 s", "at most"});
}

}  // namespace
}  // namespace burnish::test
