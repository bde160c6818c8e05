// Tests of the torques of damping and smoothed friction in joints.
#include "dynamics/passive.hpp"

#include <cmath>
#include <limits>

#include "support/kernel_law.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

struct PassiveKernel {
  template <class S>
  std::vector<S> values(const S* /*q*/, const S* v, const S* /*a*/) const {
    std::vector<S> tau(joints.damping.size(), S(0.0)), slope(tau);
    passive_torque(joints, v, tau.data(), slope.data());
    return tau;
  }
  template <class S>
  Blocks<S> derivatives(const S* /*q*/, const S* v, const S* /*a*/) const {
    const std::size_t n = joints.damping.size();
    std::vector<S> tau(n, S(0.0)), slope(tau);
    passive_torque(joints, v, tau.data(), slope.data());
    Blocks<S> out{std::vector<S>(n * n, S(0.0)), std::vector<S>(n * n, S(0.0))};
    for (std::size_t k = 0; k < n; ++k) out.dv[k * n + k] = slope[k];
    return out;
  }
  PassiveJoints joints;
};

Model arm_with_friction() {
  Model model = TestRobot{"arm7", Base::Fixed, "tool"}.model();
  for (int k = 0; k < model.nv; ++k) {
    model.damping[k] = 0.3 + 0.1 * k;
    model.friction[k] = 2.0 - 0.2 * k;
  }
  return model;
}

TEST(PassiveTorque, Derivatives_EqualAutodiffAndDifferences) {
  const Model model = arm_with_friction();
  const PassiveKernel kernel{PassiveJoints(model, 0.5)};
  expect_kernel_law(model, kernel);
  expect_lanes_alike(model, kernel);
}

TEST(PassiveTorque, MovingJoint_IsBrakedByDampingAndCoulombFriction) {
  const Model model = arm_with_friction();
  const PassiveKernel kernel{PassiveJoints(model)};
  std::mt19937_64 generator(31);
  const Eigen::VectorXd v = random_vector(model.nv, 1.0, generator);
  const auto tau = kernel.values<double>(nullptr, v.data(), nullptr);
  for (int k = 0; k < model.nv; ++k) {
    const double level = model.friction[k] * (v[k] < 0.0 ? -1.0 : 1.0);
    const double torque = tau[static_cast<std::size_t>(k)];
    EXPECT_LT(torque * v[k], 0.0);
    if (std::abs(v[k]) < 0.1) continue;
    EXPECT_NEAR(torque, -model.damping[k] * v[k] - level, 1e-7);
  }
}

TEST(PassiveTorque, SlipVelocityThatIsNotPositive_IsRefused) {
  const Model model = arm_with_friction();
  for (const double slip : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    testing::expect_words(testing::refusal([&] { PassiveJoints(model, slip); }),
                          {"slip_velocity", "positive"});
}

}  // namespace
}  // namespace burnish::test
