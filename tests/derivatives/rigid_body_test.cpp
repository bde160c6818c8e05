// RigidBody: results against ContactDynamics and differences, and refused input.
#include "burnish/derivatives/rigid_body.hpp"

#include <limits>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/dynamics/placement.hpp"
#include "support/kernel_law.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

class RigidBodyState : public OnRobots {
 protected:
  void SetUp() override {
    std::mt19937_64 generator(51);
    s = random_kernel_state(model, generator);
    ASSERT_EQ(body.update(s.q, s.v, s.a), Status::Ok);
    body.update_derivatives();
  }
  /// d(value)/dq by central differences, with v and a fixed. `value` maps a RigidBody to a vector.
  auto by_q(const auto& value) const {
    return by(
        [&](const Eigen::VectorXd& h) {
          return KernelState{integrate(model, s.q, h), s.v, s.a};
        },
        value);
  }
  /// d(value)/dv by central differences, with q and a fixed.
  auto by_v(const auto& value) const {
    return by([&](const Eigen::VectorXd& h) { return KernelState{s.q, s.v + h, s.a}; }, value);
  }
  auto by(const auto& moved, const auto& value) const {
    using Value = decltype(value(std::declval<RigidBody&>()));
    RigidBody other(model);
    const auto value_at = [&](const KernelState& at) {
      EXPECT_EQ(other.update(at.q, at.v, at.a), Status::Ok);
      return value(other);
    };
    const double step = 1e-6;
    Eigen::Matrix<double, Value::RowsAtCompileTime, Eigen::Dynamic> result(Value::RowsAtCompileTime,
                                                                           model.nv);
    for (int k = 0; k < model.nv; ++k) {
      const Eigen::VectorXd h = step * Eigen::VectorXd::Unit(model.nv, k);
      result.col(k) = (value_at(moved(h)) - value_at(moved(-h))) / (2.0 * step);
    }
    return result;
  }
  static Eigen::Matrix<double, 1, 1> scalar(double x) { return Eigen::Matrix<double, 1, 1>(x); }

  RigidBody body{model};
  KernelState s;
  int tool = body.frame(GetParam().tool);
};

TEST_P(RigidBodyState, FrameDerivatives_EqualDifferences) {
  for (const Reference& axes : {Reference::local(), Reference::centered(), Reference::world()}) {
    SCOPED_TRACE(axes.name());
    FrameDerivatives d;
    body.frame_derivatives(tool, axes, d);
    const auto velocity = [&](RigidBody& b) { return b.velocity(tool, axes); };
    const auto acceleration = [&](RigidBody& b) { return b.acceleration(tool, axes); };
    EXPECT_LE(relative_error(d.jacobian, by_v(velocity)), 1e-7);
    EXPECT_LE(relative_error(d.velocity_dq, by_q(velocity)), 1e-7);
    EXPECT_LE(relative_error(d.acceleration_dq, by_q(acceleration)), 1e-7);
    EXPECT_LE(relative_error(d.acceleration_dv, by_v(acceleration)), 1e-7);
  }
}

TEST_P(RigidBodyState, PlacementDerivatives_EqualDifferences) {
  Eigen::Isometry3d target = body.placement(tool);
  target.rotate(Eigen::AngleAxisd(1.1, Eigen::Vector3d(1.0, 2.0, -0.5).normalized()));
  target.translation() += Eigen::Vector3d(0.2, -0.1, 0.3);
  PlacementDerivatives d;
  body.placement_derivatives(tool, target, d);
  const Eigen::MatrixXd error = by_q([&](RigidBody& b) { return b.placement_error(tool, target); });
  EXPECT_LE(relative_error(d.placement_error, error), 1e-7);
  EXPECT_LE(relative_error(d.rotation_error, error.bottomRows(3)), 1e-7);
  const auto position = [&](RigidBody& b) {
    return Eigen::Vector3d(b.placement(tool).translation());
  };
  EXPECT_LE(relative_error(d.position, by_q(position)), 1e-7);
  FrameDerivatives motion;
  body.frame_derivatives(tool, Reference::local(), motion);
  RowMatrix jacobian;
  body.frame_jacobian(tool, Reference::local(), jacobian);
  EXPECT_EQ(jacobian, motion.jacobian);
  EXPECT_LE(relative_error(d.rotation, motion.jacobian.bottomRows(3)), 1e-13);
}

TEST_P(RigidBodyState, Placements_EqualFramePlacements) {
  const auto placements = frame_placements(model, s.q);
  for (std::size_t i = 0; i < model.frames.size(); ++i)
    EXPECT_TRUE(body.placement(static_cast<int>(i)).isApprox(placements[i], 1e-13));
  EXPECT_TRUE(body.placement(body.frame("world")).isApprox(Eigen::Isometry3d::Identity()));
}

TEST_P(RigidBodyState, MomentumAndEnergyDerivatives_EqualDifferences) {
  const auto com = [](RigidBody& b) { return b.com(); };
  const auto com_velocity = [](RigidBody& b) { return b.com_velocity(); };
  const auto momentum = [](RigidBody& b) { return b.momentum(); };
  const auto centroidal = [](RigidBody& b) { return b.centroidal_momentum(); };
  const auto kinetic = [](RigidBody& b) { return scalar(b.kinetic_energy()); };
  const auto potential = [](RigidBody& b) { return scalar(b.potential_energy()); };
  EXPECT_LE(relative_error(body.com_dq(), by_q(com)), 1e-7);
  EXPECT_LE(relative_error(body.com_velocity_dq(), by_q(com_velocity)), 1e-7);
  EXPECT_LE(relative_error(body.com_dq(), by_v(com_velocity)), 1e-7);
  EXPECT_LE(relative_error(body.momentum_dq(), by_q(momentum)), 1e-7);
  EXPECT_LE(relative_error(body.momentum_dv(), by_v(momentum)), 1e-7);
  EXPECT_LE(relative_error(body.centroidal_momentum_dq(), by_q(centroidal)), 1e-7);
  EXPECT_LE(relative_error(body.centroidal_momentum_dv(), by_v(centroidal)), 1e-7);
  EXPECT_LE(relative_error(body.kinetic_energy_dq().transpose(), by_q(kinetic)), 1e-7);
  EXPECT_LE(relative_error(body.kinetic_energy_dv().transpose(), by_v(kinetic)), 1e-7);
  EXPECT_LE(relative_error(body.potential_energy_dq().transpose(), by_q(potential)), 1e-7);
}

TEST_P(RigidBodyState, EnergyAndGravityTorque_AgreeWithDynamicsWithoutContacts) {
  ContactDynamics free(model);
  const Eigen::VectorXd none(0);
  ASSERT_EQ(free.inverse(s.q, s.v, s.a, none), Status::Ok);
  const double power = free.tau().dot(s.v);
  const double rate = (body.kinetic_energy_dq() + body.potential_energy_dq()).dot(s.v) +
                      body.kinetic_energy_dv().dot(s.a);
  EXPECT_NEAR(rate, power, 1e-11 * std::max(1.0, std::abs(power)));
  EXPECT_LE(relative_error(body.kinetic_energy_dv(), free.mass_matrix() * s.v), 1e-12);
  const Eigen::VectorXd tau = free.tau();
  ASSERT_EQ(free.forward(s.q, s.v, tau), Status::Ok);
  EXPECT_LE(relative_error(free.a(), s.a), 1e-9);
  ASSERT_EQ(
      free.inverse(s.q, Eigen::VectorXd::Zero(model.nv), Eigen::VectorXd::Zero(model.nv), none),
      Status::Ok);
  EXPECT_LE(relative_error(body.gravity_torque(), free.tau()), 1e-12);
}

TEST_P(RigidBodyState, UpdateWithoutAcceleration_AssumesZero) {
  RigidBody other(model);
  ASSERT_EQ(other.update(s.q, s.v), Status::Ok);
  ASSERT_EQ(body.update(s.q, s.v, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
  EXPECT_EQ(other.acceleration(tool, Reference::world()),
            body.acceleration(tool, Reference::world()));
}

TEST_P(RigidBodyState, RefusedState_ChangesNothing) {
  const Vector6 before = body.velocity(tool, Reference::world());
  Eigen::VectorXd q = s.q, v = s.v, a = s.a;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(body.update(Eigen::VectorXd::Zero(model.nq + 1), v, a), Status::WrongSize);
  EXPECT_EQ(body.update(q, Eigen::VectorXd::Zero(model.nv - 1), a), Status::WrongSize);
  EXPECT_EQ(body.update(q, v, Eigen::VectorXd(0)), Status::WrongSize);
  q[0] = nan;
  EXPECT_EQ(body.update(q, v, a), Status::NotFinite);
  v[0] = infinity;
  EXPECT_EQ(body.update(s.q, v, a), Status::NotFinite);
  a[0] = -infinity;
  EXPECT_EQ(body.update(s.q, s.v, a), Status::NotFinite);
  q = s.q;
  if (GetParam().base == Base::FreeFlyer) {
    q.segment<4>(3) *= 1.00001;
    EXPECT_EQ(body.update(q, s.v, s.a), Status::NotNormalized);
    q.segment<4>(3) /= 1.00001 * 1.0000002;
    RigidBody other(model);
    EXPECT_EQ(other.update(q, s.v, s.a), Status::Ok);
  }
  EXPECT_EQ(body.velocity(tool, Reference::world()), before);
}

INSTANTIATE_TEST_SUITE_P(robots, RigidBodyState, ::testing::ValuesIn(test_robots()), robot_label);

TEST(RigidBody, NewObject_IsNeutralAndAtRest) {
  const Model model = humanoid().model();
  const RigidBody body(model);
  const auto placements = frame_placements(model, model.q_neutral);
  const int sole = body.frame("right_sole_link");
  EXPECT_TRUE(body.placement(sole).isApprox(placements[static_cast<std::size_t>(sole)], 1e-13));
  EXPECT_EQ(body.velocity(sole, Reference::local()), Vector6::Zero());
  EXPECT_LE(body.acceleration(sole, Reference::world()).norm(), 1e-12);
  EXPECT_EQ(body.kinetic_energy(), 0.0);
}

TEST(RigidBody, UnknownFrame_IsRefusedWithTheNearestName) {
  const RigidBody body(humanoid().model());
  testing::expect_words(testing::refusal([&] { body.frame("right_sole_lnk"); }),
                        {"'right_sole_lnk'", "'right_sole_link'"});
}

TEST(RigidBody, SlipVelocityThatIsNotPositive_IsRefused) {
  const Model model = TestRobot{"arm7", Base::Fixed, ""}.model();
  testing::expect_words(testing::refusal([&] { RigidBody(model, 0.0); }),
                        {"slip_velocity", "positive"});
}

}  // namespace
}  // namespace burnish::test
