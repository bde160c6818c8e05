// Tests of knots of different lengths: steps of horizon segments, and steps of single knots.
#include <gtest/gtest.h>

#include "support/allocation_guard.hpp"
#include "support/ocp_cases.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

ProblemSpec two_stages(const Model& model) {
  ProblemSpec spec = bare_problem(arm, model);
  const CostTerm cost{.residual = residual::JointVelocity{}, .weight = 3.0};
  spec.stages = {{.name = "slow", .contacts = {"pad"}, .costs = {cost}, .step = 0.02},
                 {.name = "fast", .contacts = {"pad"}, .costs = {cost}, .step = 0.005},
                 {.name = "hit", .contacts = {"pad"}, .costs = {cost}, .impact = true}};
  spec.horizon = {{"slow", 3}, {"fast", 3}};
  return spec;
}

class KnotSteps : public ::testing::Test {
 protected:
  Model model = arm.robot.model();
  std::mt19937_64 generator{17};
};

TEST_F(KnotSteps, SegmentStep_OverridesTheStepOfTheStage) {
  ProblemSpec spec = two_stages(model);
  spec.horizon = {
      {"slow", 2}, {.stage = "slow", .knots = 2, .step = 0.03}, {"hit", 1}, {"fast", 1}};
  const std::vector<double> wanted = {0.02, 0.02, 0.03, 0.03, 0.0, 0.005};
  EXPECT_EQ(knot_steps(spec), wanted);
  const Problem problem(spec);
  double time = spec.start_time;
  for (int k = 0; k <= problem.knots(); ++k) {
    EXPECT_DOUBLE_EQ(problem.time_of(k), time);
    if (k == problem.knots()) break;
    EXPECT_EQ(problem.step_of(k), wanted[static_cast<std::size_t>(k)]);
    time += wanted[static_cast<std::size_t>(k)];
  }
}

TEST_F(KnotSteps, Duration_GivesGeometricSteps) {
  ProblemSpec spec = two_stages(model);
  for (const double duration : {0.6, 1.0, 0.2}) {  // growing steps, and shrinking ones
    spec.horizon = {{.stage = "slow", .knots = 30, .step = 0.01, .duration = duration}};
    const std::vector<double> steps = knot_steps(spec);
    EXPECT_EQ(steps[0], 0.01);
    double sum = steps[0];
    for (std::size_t k = 1; k < steps.size(); ++k) {
      EXPECT_NEAR(steps[k] / steps[k - 1], steps[1] / steps[0], 1e-12);
      sum += steps[k];
    }
    EXPECT_NEAR(sum, duration, 1e-12);
    EXPECT_EQ(steps[1] > steps[0], duration > 0.3);
  }
  spec.horizon = {{.stage = "slow", .knots = 3, .duration = 0.14}};  // starts at the stage's step
  EXPECT_EQ(knot_steps(spec)[0], 0.02);
  EXPECT_NEAR(knot_steps(spec)[2], 0.08, 1e-12);
}

TEST_F(KnotSteps, DurationOfEqualSteps_GivesExactlyEqualSteps) {
  ProblemSpec spec = two_stages(model);
  spec.horizon = {{.stage = "slow", .knots = 7, .step = 0.1, .duration = 0.7}};
  for (const double step : knot_steps(spec)) EXPECT_EQ(step, 0.1);
}

TEST_F(KnotSteps, BadStepOrDuration_IsRefused) {
  const auto refused = [&](const HorizonSegment& segment) {
    return testing::refusal([&] {
      ProblemSpec spec = two_stages(model);
      spec.horizon = {segment};
      Problem{spec};
    });
  };
  const auto expect = [&](const HorizonSegment& segment, const std::string& words) {
    EXPECT_NE(refused(segment).find(words), std::string::npos) << refused(segment);
  };
  expect({.stage = "slow", .knots = 3, .step = -0.01},
         "has a step of -0.01 s; wanted a positive time");
  expect({.stage = "slow", .knots = 3, .duration = std::nan("")}, "a duration of nan s");
  expect({.stage = "slow", .knots = 3, .step = 0.01, .duration = 0.071}, "0.0175 to 0.07 s");
  expect({.stage = "slow", .knots = 3, .step = 0.01, .duration = 0.017}, "0.0175 to 0.07 s");
  expect({.stage = "hit", .knots = 1, .step = 0.01}, "no time passes");
  expect({.stage = "slwo", .knots = 1, .step = 0.01}, "did you mean 'slow'");
}

TEST_F(KnotSteps, SetStep_ChangesOneKnotWithoutAllocation) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  Problem problem(two_stages(model));
  {
    const AllocationGuard guard;
    problem.set_step(1, 0.04);
    problem.set_knot(1, 1, 0.9);
    EXPECT_EQ(guard.count(), 0);
  }
  EXPECT_EQ(problem.step_of(1), 0.04) << "the knot's step is used in every stage";
  EXPECT_EQ(problem.time_of(1), 0.9);
  problem.set_knot(0, 1, 0.7);
  EXPECT_EQ(problem.step_of(0), 0.005) << "without a step of the knot, the stage's step is used";
  for (const double step : {0.0, -1.0, std::nan(""), HUGE_VAL})
    EXPECT_NE(testing::refusal([&] { problem.set_step(0, step); }).find("wanted a positive number"),
              std::string::npos);
  EXPECT_NE(testing::refusal([&] { problem.set_step(problem.knots(), 0.1); }).find("wanted 0 to 5"),
            std::string::npos);
  EXPECT_EQ(problem.step_of(0), 0.005);
}

TEST_F(KnotSteps, Advance_MovesStepsWithTheirKnots) {
  ProblemSpec spec = two_stages(model);
  spec.horizon = {{"slow", 1}, {.stage = "slow", .knots = 2, .step = 0.03}};
  Problem problem(spec);
  problem.advance(1);
  EXPECT_EQ(problem.step_of(0), 0.03);
  EXPECT_EQ(problem.step_of(2), 0.03);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(problem.time_of(k + 1), problem.time_of(k) + 0.03, 1e-12);
}

/// Compares knots with their own steps to knots of stages with the same steps.
TEST_F(KnotSteps, StepOfAKnot_EqualsAStageWithThatStep) {
  for (const OcpCase& test : ocp_cases()) {
    SCOPED_TRACE(test.label());
    const Model of = test.robot.model();
    for (const Integrator integrator : {Integrator::SemiImplicitEuler, Integrator::RungeKutta4}) {
      ProblemSpec own = bare_problem(test, of), stages = own;
      const auto steps = {0.01, 0.017, 0.03};
      Stage stage{.name = "go", .contacts = {"brace", "pad"}, .integrator = integrator};
      stage.costs = {{.residual = residual::JointVelocity{}, .weight = 0.3},
                     {.residual = residual::FramePosition{test.robot.tool, Eigen::Vector3d::Zero()},
                      .weight = 2.0}};
      if (test.torque_model)
        stage.costs.push_back({.residual = residual::JointTorqueRate{}, .weight = 1e-3});
      if (test.has_force_states)
        stage.costs.push_back({.residual = residual::ContactForceRate{"pad"}, .weight = 1e-4});
      own.stages = {stage};
      own.stages[0].step = 0.03;  // the longest knot
      for (const double step : steps) {
        own.horizon.push_back({.stage = "go", .knots = 1, .step = step});
        stages.stages.push_back(stage);
        stages.stages.back().name = std::to_string(step);
        stages.stages.back().step = step;
        stages.horizon.push_back({stages.stages.back().name, 1});
      }
      Problem a(own), b(stages);
      OcpHorizon at_a(a, generator), at_b = at_a;
      for (std::size_t k = 0; k < at_b.out.size(); ++k) at_b.point_at(k);
      at_a.expand(a);
      at_b.expand(b);
      EXPECT_EQ(at_a.next, at_b.next);
      for (std::size_t k = 0; k < at_a.values.size(); ++k) {
        EXPECT_EQ(a.time_of(static_cast<int>(k)), b.time_of(static_cast<int>(k)));
        EXPECT_EQ(at_a.values[k].cost, at_b.values[k].cost);
        // The last knot has no controls, and a shorter gradient.
        const int nz = a.controls(static_cast<int>(k)) + a.state().ndx;
        EXPECT_EQ(at_a.gradient[k].head(nz), at_b.gradient[k].head(nz));
        if (k + 1 == at_a.values.size()) break;
        EXPECT_EQ(at_a.decay[k], at_b.decay[k]);
        EXPECT_EQ(at_a.out[k].step, at_b.out[k].step);
      }
    }
  }
}

/// Gains and friction speeds suit the stage's step; for a longer knot they are softened so that the
/// explicit integration stays stable.
TEST_F(KnotSteps, LongerStep_SoftensGainsAndFriction) {
  const OcpCase sliding{{"arm7", Base::Fixed, "tool"}, false, false, false, true};
  ProblemSpec spec = bare_problem(sliding, model);
  for (ContactSpec& contact : spec.contacts) contact.with_gains(36.0, 6.0);
  spec.stages = {{.name = "go",
                  .contacts = {"brace", "pad"},
                  .costs = {{.residual = residual::JointVelocity{}}},
                  .step = 0.02}};
  spec.horizon = {{"go", 1}};
  ProblemSpec soft = spec;
  soft.stages[0].step = 0.04;
  for (ContactSpec& contact : soft.contacts) {
    contact.with_gains(9.0, 3.0);
    if (contact.friction) contact.friction->speed = 2.0 * contact.friction->fade_speed();
  }
  soft.actuation.slip_velocity *= 2.0;
  Problem problem(spec), wanted(soft);
  for (int i = 0; i < 5; ++i) {
    const OcpState at = random_ocp_state(problem, generator);
    Eigen::VectorXd got(at.x.size()), want(at.x.size());
    problem.set_step(0, 0.04);
    wanted.set_step(0, 0.04);
    problem.roll(0, 0, at.x.data(), at.u.data(), got.data());
    wanted.roll(0, 0, at.x.data(), at.u.data(), want.data());
    EXPECT_LT(relative_error(got, want), 1e-12);
    EXPECT_LT(relative_error(problem.forces(0, at.x, at.u), wanted.forces(0, at.x, at.u)), 1e-12);
    problem.set_step(0, 0.01);
    problem.roll(0, 0, at.x.data(), at.u.data(), got.data());
    wanted.set_step(0, 0.01);
    wanted.roll(0, 0, at.x.data(), at.u.data(), want.data());
    EXPECT_GT(relative_error(got, want), 1e-6) << "a shorter knot must use the stated values";
  }
}

}  // namespace
}  // namespace burnish::test
