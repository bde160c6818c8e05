// Tests of fade speeds of friction: defaults that follow from a problem's steps, and values that
// are too small for them.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/ocp/step_check.hpp"
#include "support/ocp_cases.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

class FadeSpeed : public ::testing::Test {
 protected:
  ProblemSpec spec(std::optional<double> speed, double step = 0.01, double force = 20.0) {
    ProblemSpec result{.model = model};
    ContactSpec pad{.name = "pad", .tool = "tool", .directions = Directions::z()};
    pad.friction = SlidingFriction{0.3, speed};
    result.contacts = {pad};
    result.initial_state = Eigen::VectorXd::Zero(2 * model.nv);
    result.initial_state.head(model.nq) = arm7::ready();
    Stage stage{.name = "press", .contacts = {"pad"}, .step = step};
    const Eigen::VectorXd target = Eigen::VectorXd::Constant(1, force);
    stage.costs = {{.residual = residual::JointVelocity{}}};
    if (force > 0.0)
      stage.costs.push_back(
          {.residual = residual::ContactForce{.contact = "pad", .target = target}});
    result.stages = {stage};
    result.horizon = {{"press", 3}};
    return result;
  }
  static double speed_of(const ProblemSpec& spec) {
    return *Problem(spec).spec().contacts[0].friction->speed;
  }
  /// Returns the smallest effective mass of the tool along x and y while z is constrained [kg].
  double min_mass() {
    ContactDynamics constrained(
        model, {ContactSpec{.name = "pad", .tool = "tool", .directions = Directions::z()}});
    RigidBody body(model);
    const Eigen::VectorXd q = arm7::ready(), zero = Eigen::VectorXd::Zero(model.nv);
    FrameDerivatives tool;
    EXPECT_EQ(body.update(q, zero, zero), Status::Ok);
    body.frame_derivatives(body.frame("tool"), Reference::centered(), tool);
    const Eigen::MatrixXd J = tool.jacobian.topRows(2);
    EXPECT_EQ(constrained.forward(q, zero, zero), Status::Ok);
    EXPECT_EQ(constrained.forward_derivatives(), Status::Ok);
    const Eigen::Matrix2d mobility = J * constrained.da_dtau() * J.transpose();
    return 1.0 / Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(mobility).eigenvalues()[1];
  }
  Model model = arm7::model(Base::Fixed);
};

TEST_F(FadeSpeed, UnstatedSpeed_FollowsFromStepForceAndMass) {
  const double m = min_mass();
  EXPECT_NEAR(speed_of(spec({})), std::max(0.01, 4.0 * 0.3 * 20.0 * 0.01 / m), 1e-6);
  EXPECT_NEAR(speed_of(spec({}, 0.04)), 4.0 * 0.3 * 20.0 * 0.04 / m, 1e-6);
  EXPECT_NEAR(speed_of(spec({}, 0.04, 0.0)), 4.0 * 0.3 * 9.80665 * 0.04, 1e-6);  // by the weight
  EXPECT_EQ(speed_of(spec({}, 1e-5)), 0.01);
  ProblemSpec band = spec({}, 0.04, 0.0);
  band.stages[0].constraints = {{.residual = residual::ContactForce{.contact = "pad"},
                                 .lower = Eigen::VectorXd::Constant(1, 30.0),
                                 .upper = Eigen::VectorXd::Constant(1, 50.0)}};
  EXPECT_NEAR(speed_of(band), 4.0 * 0.3 * 50.0 * 0.04 / m, 1e-6);
  ProblemSpec later = spec({}, 0.04);
  later.contacts[0].friction->coefficient = 0.0;  // set by the controller later
  EXPECT_NEAR(speed_of(later), 4.0 * 0.3 * 20.0 * 0.04 / m, 1e-6);
}

TEST_F(FadeSpeed, StatedSpeed_StaysAndIsReportedIfTooSmall) {
  EXPECT_EQ(speed_of(spec(0.02)), 0.02);
  const double lost = 0.3 * 20.0 * 0.02 / min_mass();  // loss of speed in a step [m/s]
  EXPECT_TRUE(step_complaints(Problem(spec(1.01 * lost, 0.02))).empty());
  EXPECT_TRUE(step_complaints(Problem(spec({}, 0.02))).empty());
  const std::vector<std::string> sentences = step_complaints(Problem(spec(0.9 * lost, 0.02)));
  ASSERT_EQ(sentences.size(), 1U);
  testing::expect_words(sentences[0], {"stage 'press'", "contact 'pad'", "0.02 s", "at least"});
}

TEST_F(FadeSpeed, WithoutAProblem_IsOneCentimetrePerSecond) {
  EXPECT_EQ(SlidingFriction().fade_speed(), 0.01);
  EXPECT_FALSE(SlidingFriction().speed.has_value());
}

}  // namespace
}  // namespace burnish::test
