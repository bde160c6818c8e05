// A joint that moves no mass makes M singular. Forward dynamics and its derivatives return a status
// and name the joint, for single states and batches. Evaluations without M^-1 still work.
#include <gtest/gtest.h>

#include "burnish/derivatives/contact_dynamics_batch.hpp"
#include "burnish/derivatives/diagnosis.hpp"
#include "support/contact_states.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

using testing::expect_words;
using testing::refusal;

/// Joints without children that are neither followers nor leaders.
std::vector<int> leaves(const Model& model) {
  std::vector<char> carries(model.joints.size(), 0);
  for (std::size_t i = 0; i < carries.size(); ++i) {
    const Joint& joint = model.joints[i];
    if (joint.parent >= 0) carries[joint.parent] = 1;
    if (joint.follows) carries[i] = carries[joint.follows->leader] = 1;
  }
  std::vector<int> result;
  for (int i = 0; i < static_cast<int>(carries.size()); ++i)
    if (carries[i] == 0) result.push_back(i);
  return result;
}

/// Removes the mass of a joint's body. Models are plain data, so no file needs to describe this.
void remove_mass(Model& model, int joint) {
  Joint& body = model.joints[joint];
  body.mass = 0.0;
  body.com.setZero();
  body.inertia_at_com.setZero();
  model.armature.segment(body.v_index, body.nv).setZero();
}

class MasslessJoint : public ::testing::TestWithParam<TestRobot> {
 protected:
  /// Checks every result at a state where `joint` moves no mass.
  void expect_named(const Model& model, const std::string& joint, const RobotState& state) {
    const std::vector<ContactSpec> contacts{
        contact(GetParam().tool, "world", Reference::local(), Directions::z())};
    ContactDynamics dynamics(model, contacts);
    EXPECT_EQ(dynamics.inverse(state.q, state.v, state.v, Eigen::VectorXd::Ones(1)), Status::Ok);
    EXPECT_EQ(dynamics.inverse_derivatives(), Status::Ok);
    EXPECT_EQ(dynamics.acceleration(state.q, state.v, state.v), Status::Ok);
    EXPECT_EQ(dynamics.acceleration_derivatives(), Status::Ok);
    ASSERT_EQ(dynamics.forward(state.q, state.v, state.tau), Status::SingularMass) << joint;
    EXPECT_EQ(dynamics.forward_derivatives(), Status::SingularMass);
    EXPECT_EQ(dynamics.a(), Eigen::VectorXd::Zero(model.nv));
    EXPECT_EQ(dynamics.da_dq(), RowMatrix::Zero(model.nv, model.nv));
    EXPECT_EQ(dynamics.dlambda_dtau(), RowMatrix::Zero(1, model.nv));
    expect_words(dynamics.explanation(), {"'" + joint + "'", "no mass"});
    expect_words(refusal([&] { diagnose(model, dynamics.contacts(), state.q); }), {joint});
    const int count = pack_width() + 1;
    ContactDynamicsBatch batch(model, contacts, count);
    EXPECT_EQ(
        batch.forward_with_derivatives(state.q.replicate(1, count), state.v.replicate(1, count),
                                       state.tau.replicate(1, count)),
        Status::SingularMass);
    for (int i = 0; i < count; ++i) {
      EXPECT_EQ(batch.explanation(i), dynamics.explanation());
      EXPECT_EQ(batch.da_dq(i), RowMatrix::Zero(model.nv, model.nv));
    }
  }

  Model model_ = GetParam().model();
  std::mt19937_64 generator_{92};
};

TEST_P(MasslessJoint, ForwardDynamics_GivesAStatusThatNamesTheJoint) {
  for (const int joint : leaves(model_)) {
    Model model = model_;
    remove_mass(model, joint);
    expect_named(model, model.joints[joint].name, random_state(model, generator_));
  }
}

TEST_P(MasslessJoint, PointMassOnTheAxis_IsNamedToo) {
  // The inertia about the axis is zero up to rounding errors.
  for (const int joint : leaves(model_)) {
    Model model = model_;
    Joint& body = model.joints[joint];
    if (body.kind != JointKind::Revolute && body.kind != JointKind::Continuous) continue;
    body.mass = 2.0;
    body.com = Eigen::Vector3d(0.0, 0.0, 0.3);
    body.inertia_at_com.setZero();
    model.armature[body.v_index] = 0.0;
    expect_named(model, body.name, random_state(model, generator_));
  }
}

TEST_P(MasslessJoint, Armature_MakesForwardDynamicsOk) {
  for (const int joint : leaves(model_)) {
    Model model = model_;
    remove_mass(model, joint);
    // Massless bodies between the joint and the root need an armature, too.
    for (int j = joint; j >= 0 && model.joints[j].mass == 0.0; j = model.joints[j].parent)
      model.armature.segment(model.joints[j].v_index, model.joints[j].nv).setConstant(0.01);
    const RobotState state = random_state(model, generator_);
    ContactDynamics dynamics(model);
    EXPECT_EQ(dynamics.forward(state.q, state.v, state.tau), Status::Ok);
    EXPECT_EQ(dynamics.explanation(), "ok");
  }
}

TEST(MasslessFollower, LeaderAndFollowersWithoutMass_AreSingular) {
  TreeSpec tree;
  tree.name = "gripper";
  for (const char* name : {"base", "hand", "left", "right"})
    tree.links.push_back(testing::link(name));
  tree.joints = {testing::joint("wrist", JointType::Revolute, "base", "hand"),
                 testing::joint("left", JointType::Prismatic, "hand", "left"),
                 testing::joint("right", JointType::Prismatic, "hand", "right")};
  tree.joints[1].mimic = MimicSpec{"right", -1.0, 0.0};
  Model model = build_model(tree);
  std::mt19937_64 generator(4);
  const RobotState state = random_state(model, generator);
  remove_mass(model, model.joint_index("right"));
  EXPECT_EQ(ContactDynamics(model).forward(state.q, state.v, state.tau), Status::Ok);
  remove_mass(model, model.joint_index("left"));
  ContactDynamics dynamics(model);
  EXPECT_EQ(dynamics.forward(state.q, state.v, state.tau), Status::SingularMass);
  expect_words(dynamics.explanation(), {"'right'", "no mass"});
}

INSTANTIATE_TEST_SUITE_P(EveryRobot, MasslessJoint, ::testing::ValuesIn(available(test_robots())),
                         [](const auto& test) { return test.param.label(); });

}  // namespace
}  // namespace burnish::test
