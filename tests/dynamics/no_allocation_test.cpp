// RigidBody allocates nothing after set-up: every evaluation runs inside an AllocationGuard.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "burnish/derivatives/rigid_body.hpp"
#include "support/allocation_guard.hpp"
#include "support/robots.hpp"

namespace burnish::test {
namespace {

TEST(AllocationGuard, EveryKindOfAllocation_IsCounted) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  const auto allocations_of = [](auto&& call) {
    const AllocationGuard guard;
    call();
    return guard.count();
  };
  // Volatile, so that the compiler keeps every pair of allocation and release.
  volatile std::size_t size = 100;
  void* volatile kept = nullptr;
  EXPECT_EQ(allocations_of([] {}), 0);
  EXPECT_GE(allocations_of([&] { kept = std::malloc(size), std::free(kept); }), 1);
  EXPECT_GE(allocations_of([&] { kept = std::calloc(size, 1), std::free(kept); }), 1);
  EXPECT_GE(allocations_of([&] { std::vector<double> x(size); }), 1);
  EXPECT_GE(allocations_of([&] { std::string x(size, 'x'); }), 1);
  EXPECT_GE(allocations_of([&] { Eigen::VectorXd::Zero(static_cast<long>(size)).eval(); }), 1);
}

class RigidBodyAllocation : public ::testing::TestWithParam<TestRobot> {
 protected:
  Model model = GetParam().model();
  std::mt19937_64 generator{41};
  Eigen::VectorXd q = random_configuration(model, generator);
  Eigen::VectorXd v = random_vector(model.nv, 1.0, generator);
  Eigen::VectorXd a = random_vector(model.nv, 1.0, generator);
};

TEST_P(RigidBodyAllocation, EvaluationAfterSetUp_AllocatesNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  RigidBody body(model);
  const int tool = body.frame(GetParam().tool);
  const Eigen::Isometry3d target = Eigen::Isometry3d::Identity();
  FrameDerivatives motion;
  PlacementDerivatives placement;
  body.frame_derivatives(tool, Reference::local(), motion);  // resizes
  body.placement_derivatives(tool, target, placement);
  double sum = 0.0;
  const AllocationGuard guard;
  EXPECT_EQ(body.update(q, v), Status::Ok);
  EXPECT_EQ(body.update(q, v, a), Status::Ok);
  for (const Reference& axes : {Reference::local(), Reference::centered(), Reference::world()}) {
    sum += body.velocity(tool, axes).sum() + body.acceleration(tool, axes).sum();
    body.frame_derivatives(tool, axes, motion);
  }
  sum += body.placement(tool).translation().sum() + body.placement_error(tool, target).sum();
  body.placement_derivatives(tool, target, placement);
  sum += body.com().sum() + body.com_velocity().sum() + body.momentum().sum() +
         body.centroidal_momentum().sum() + body.kinetic_energy() + body.potential_energy() +
         body.gravity_torque().sum() + body.passive_torque().sum() + body.mass();
  body.update_derivatives();
  sum += body.com_dq().sum() + body.com_velocity_dq().sum() + body.momentum_dq().sum() +
         body.momentum_dv().sum() + body.centroidal_momentum_dq().sum() +
         body.centroidal_momentum_dv().sum() + body.kinetic_energy_dq().sum() +
         body.kinetic_energy_dv().sum() + body.potential_energy_dq().sum() +
         body.passive_torque_dv().sum();
  v[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(body.update(q, v), Status::NotFinite);
  EXPECT_EQ(guard.count(), 0);
  EXPECT_TRUE(std::isfinite(sum));
}

INSTANTIATE_TEST_SUITE_P(robots, RigidBodyAllocation, ::testing::ValuesIn(test_robots()),
                         [](const auto& robot) { return robot.param.label(); });

}  // namespace
}  // namespace burnish::test
