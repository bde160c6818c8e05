// Contact dynamics allocate nothing after set-up, for single states and batches.
#include <gtest/gtest.h>

#include "burnish/derivatives/contact_dynamics_batch.hpp"
#include "support/allocation_guard.hpp"
#include "support/contact_states.hpp"
#include "support/robots.hpp"

namespace burnish::test {
namespace {

class ContactAllocation : public ::testing::TestWithParam<TestRobot> {
 protected:
  /// Two contacts on one frame that use every option. They are redundant, hence compliant.
  std::vector<ContactSpec> contacts() const {
    ContactSpec pad{.name = "pad", .tool = GetParam().tool, .directions = Directions::pad_z()};
    pad.with_gains(10.0, 5.0);
    ContactSpec pose{.name = "pose", .tool = GetParam().tool, .reference = Reference::world()};
    pose.error = PoseError::Log6;
    pose.with_gains(10.0, 5.0);
    return {pad, pose};
  }

  Model model = GetParam().model();
  std::mt19937_64 generator{43};
  ContactSolver solver{.mu = 1e-3, .max_proximal_iterations = 5};
};

TEST_P(ContactAllocation, SingleStates_AllocateNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  ContactDynamics dynamics(model, contacts(), solver);
  Eigen::VectorXd q = random_configuration(model, generator);
  const Eigen::VectorXd v = random_vector(model.nv, 1.0, generator);
  const Eigen::VectorXd lambda = random_vector(dynamics.rows(), 1.0, generator);
  const Eigen::VectorXd fewer = lambda.head(6);
  // The last references are fixed in a body that no contact uses.
  const std::vector<Reference> references = all_references(model, GetParam().tool, "world");
  const Eigen::Matrix3d rotation = tilt();
  WrenchDerivatives wrench;
  dynamics.forward(q, v, v);
  dynamics.forward_derivatives();
  dynamics.wrench_derivatives(0, Reference::local(), wrench);  // resizes
  double sum = 0.0;
  const AllocationGuard guard;
  for (const bool both : {true, false, true}) {
    dynamics.set_active(0, both);
    sum += static_cast<double>(dynamics.set_reference_rotation(1, rotation));
    dynamics.forward(q, v, v);
    dynamics.forward_derivatives();
    sum += dynamics.da_dq().sum() + dynamics.dlambda_dtau().sum() + dynamics.mass_matrix().sum();
    for (const Reference& reference : references) {
      sum += dynamics.wrench(1, reference).sum();
      dynamics.wrench_derivatives(1, reference, wrench);
    }
    dynamics.inverse(q, v, v, both ? lambda : fewer);
    dynamics.inverse_derivatives();
    dynamics.acceleration(q, v, v);
    dynamics.acceleration_derivatives();
    sum += dynamics.dtau_dq().sum() + dynamics.dalpha_dq().sum();
    sum += dynamics.contact_velocity().sum() + dynamics.contact_error().sum();
  }
  q[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(dynamics.forward(q, v, v), Status::NotFinite);
  EXPECT_EQ(dynamics.forward_derivatives(), Status::NotFinite);
  EXPECT_EQ(guard.count(), 0);
  EXPECT_TRUE(std::isfinite(sum));
}

TEST_P(ContactAllocation, Batches_AllocateNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  const int states = 2 * pack_width() + 1;
  ContactDynamicsBatch batch(model, contacts(), states, solver);
  Eigen::MatrixXd q(model.nq, states), v(model.nv, states);
  for (int i = 0; i < states; ++i) {
    q.col(i) = random_configuration(model, generator);
    v.col(i) = random_vector(model.nv, 1.0, generator);
  }
  double sum = 0.0;
  const AllocationGuard guard;
  for (const bool both : {true, false, true}) {
    batch.set_active(0, both);
    batch.forward(q, v, v);
    batch.forward_with_derivatives(q, v, v);
    sum += batch.a(0).sum() + batch.da_dq(states - 1).sum() + batch.dlambda_dv(1).sum();
  }
  EXPECT_EQ(guard.count(), 0);
  EXPECT_TRUE(std::isfinite(sum));
}

INSTANTIATE_TEST_SUITE_P(robots, ContactAllocation, ::testing::ValuesIn(test_robots()),
                         [](const auto& robot) { return robot.param.label(); });

}  // namespace
}  // namespace burnish::test
