// Published robots, compiled and compared joint by joint with the result of another library. The
// files stay outside the repository.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "burnish/urdf/urdf.hpp"
#include "support/trees.hpp"

namespace burnish::testing {
namespace {

using nlohmann::json;

struct Published {
  std::string name;
  ModelOptions options;
};

Eigen::Isometry3d placement_of(const json& stated) {
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 3; ++i) {
    const auto row = static_cast<std::size_t>(i);
    placement.translation()[i] = stated["p"][row];
    for (int j = 0; j < 3; ++j) {
      placement.linear()(i, j) = stated["R"][row][static_cast<std::size_t>(j)];
    }
  }
  return placement;
}

class PublishedModel : public ::testing::TestWithParam<Published> {
 protected:
  void SetUp() override {
    const std::string shared = BURNISH_SHARED_DIR;
    const std::string file = shared + "/reference/" + GetParam().name + ".json";
    const std::string urdf = shared + "/robots/" + GetParam().name + ".urdf";
    if (!std::filesystem::exists(file) || !std::filesystem::exists(urdf)) {
      GTEST_SKIP() << "the published robot " << GetParam().name << " and its reference are not in "
                   << shared;
    }
    std::ifstream(file) >> reference_;
    model_ = build_model(read_urdf(urdf), GetParam().options);
  }
  json reference_;
  Model model_;
};

TEST_P(PublishedModel, Joints_HaveTheReferenceOrderPlacementAndMass) {
  const json& joints = reference_["joints"];
  ASSERT_EQ(model_.joints.size(), joints.size());
  EXPECT_EQ(model_.nq, reference_["nq"]);
  EXPECT_EQ(model_.nv, reference_["nv"]);
  std::vector<Eigen::Isometry3d> placed;
  const Eigen::VectorXd q0 = Eigen::VectorXd(model_.q_neutral);
  const auto ours = body_placements(model_, q0);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const json& theirs = joints[i];
    const Joint& joint = model_.joints[i];
    EXPECT_EQ(joint.name, theirs["name"]);
    EXPECT_EQ(joint.parent + 1, theirs["parent"]);
    EXPECT_EQ(joint.q_index, theirs["idx_q"]);
    EXPECT_EQ(joint.v_index, theirs["idx_v"]);
    EXPECT_EQ(joint.nq, theirs["nq"]);
    EXPECT_EQ(joint.nv, theirs["nv"]);
    const Eigen::Isometry3d at_zero = placement_of(theirs["placement"]);
    placed.push_back(joint.parent < 0 ? at_zero
                                      : placed[static_cast<std::size_t>(joint.parent)] * at_zero);
    // Joint frames of the reference keep the axes of the file, like our frames named after joints.
    const Eigen::Isometry3d frame = frame_placement(model_, q0, joint.name);
    EXPECT_TRUE(frame.isApprox(placed.back(), 1e-12)) << joint.name;
    const Eigen::Isometry3d turn = frame.inverse() * ours[i];
    Eigen::Vector3d com;
    Eigen::Matrix3d inertia;
    for (int r = 0; r < 3; ++r) {
      const auto row = static_cast<std::size_t>(r);
      com[r] = theirs["com"][row];
      for (int c = 0; c < 3; ++c) {
        inertia(r, c) = theirs["inertia_at_com"][row][static_cast<std::size_t>(c)];
      }
    }
    EXPECT_NEAR(joint.mass, theirs["mass"], 1e-12);
    EXPECT_LT((turn * joint.com - com).norm(), 1e-12) << joint.name;
    EXPECT_LT((turn.linear() * joint.inertia_at_com * turn.linear().transpose() - inertia).norm(),
              1e-12)
        << joint.name;
  }
}

TEST_P(PublishedModel, Frames_HaveTheReferencePlacements) {
  for (std::size_t i = 0; i < reference_["states"].size(); ++i) {
    const std::vector<double> values = reference_["states"][i]["q"];
    const Eigen::VectorXd q =
        Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
    for (const auto& [name, theirs] : reference_["free"][i]["frames"].items()) {
      EXPECT_TRUE(frame_placement(model_, q, name).isApprox(placement_of(theirs["oMf"]), 1e-11))
          << name;
    }
  }
}

ModelOptions locking(std::vector<std::string> joints) {
  ModelOptions options;
  options.locked = std::move(joints);
  return options;
}
ModelOptions floating() {
  ModelOptions options;
  options.base = Base::FreeFlyer;
  return options;
}

INSTANTIATE_TEST_SUITE_P(Published, PublishedModel,
                         ::testing::Values(Published{"panda", locking({"panda_finger_joint1",
                                                                       "panda_finger_joint2"})},
                                           Published{"ur10", {}}, Published{"solo12", floating()}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace burnish::testing
