// Tests of the library's robots: joints, masses, tools, postures.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "burnish/dynamics/placement.hpp"
#include "burnish/model/state.hpp"
#include "burnish/robots/robot.hpp"

namespace burnish::testing {
namespace {

struct Expected {
  std::string name;
  int nv;
  double mass;  // of the moving bodies [kg]
  std::string default_posture;
  std::vector<std::string> tools;
};

void PrintTo(const Expected& expected, std::ostream* out) { *out << expected.name; }

const std::vector<Expected> robots{
    {"talos", 6 + 30, 94.00319, "half_sitting", {"tool", "left_sole_link", "right_sole_link"}},
    {"talos:right_arm", 6, 45.38333, "table", {"tool"}},
    {"talos:two_arms", 16, 46.38333, "two_arms", {"tool", "plate"}},
    {"talos:with_plate", 6 + 30, 95.00319, "standing_two_arms", {"tool", "plate"}},
    {"talos:fixed", 30, 78.64035, "half_sitting", {"tool", "left_sole_link", "right_sole_link"}},
    {"arm7", 7, 16.0, "ready", {"tool", "flange"}},
    {"arm7:six", 6, 16.0, "ready", {"tool", "flange"}},
    {"arm7:wall", 7, 16.0, "ready", {"tool", "flange"}},
    {"arm7:floating", 6 + 7, 20.0, "adrift", {"tool", "flange"}},
    {"pendulum", 1, 1.1, "hanging", {"tip"}},
    {"quadruped", 6 + 12, 20.0, "standing", {"fl_foot", "rr_foot"}},
    {"crane", 10, 157.74, "work", {"left_tip", "right_tip"}},
    {"crane:left_only", 6, 157.74, "work", {"left_tip", "right_tip"}},
    {"four_bar", 3, 1.4, "start", {"tool"}},
    {"parallel_ankle", 9, 4.7071429, "bent", {"tool", "sole"}},
    {"gripper", 5, 0.2, "half_open", {"tool", "right_tip"}},
    {"crane:floating", 6 + 10, 477.74, "afloat", {"left_tip", "right_tip"}},
};

Robot load(const std::string& name) {
  return load_robot(std::string(BURNISH_ROBOTS_DIR) + "/" + name);
}

class RepositoryRobot : public ::testing::TestWithParam<Expected> {};

TEST_P(RepositoryRobot, Model_HasItsJointsMassAndDefaultPosture) {
  const Robot robot = load(GetParam().name);
  EXPECT_EQ(robot.model.nv, GetParam().nv);
  EXPECT_NEAR(robot.model.total_mass(), GetParam().mass, 1e-6);
  EXPECT_EQ(robot.default_posture, GetParam().default_posture);
}

TEST_P(RepositoryRobot, ToolFrames_ExistAndMove) {
  const Robot robot = load(GetParam().name);
  for (const std::string& tool : GetParam().tools) {
    ASSERT_TRUE(robot.model.has_frame(tool)) << tool;
  }
  // The first tool moves with a joint.
  const auto frame = static_cast<std::size_t>(robot.model.frame_index(GetParam().tools.front()));
  EXPECT_GE(robot.model.frames[frame].body, 0);
}

TEST_P(RepositoryRobot, Postures_AreWithinTheLimits) {
  const Robot robot = load(GetParam().name);
  const Model& model = robot.model;
  for (const auto& named : robot.postures) {
    const std::string& name = named.first;
    const Eigen::VectorXd q = robot.posture(name);
    EXPECT_NO_THROW(check_configuration(model, q)) << name;
    for (int i = 0; i < model.nq; ++i) {
      EXPECT_GE(q[i], model.q_lower[i]) << name << ": " << model.q_name(i);
      EXPECT_LE(q[i], model.q_upper[i]) << name << ": " << model.q_name(i);
    }
  }
}

std::string label(const ::testing::TestParamInfo<Expected>& robot) {
  std::string text = robot.param.name;
  for (char& c : text) {
    if (c == ':') c = '_';
  }
  return text;
}

INSTANTIATE_TEST_SUITE_P(All, RepositoryRobot, ::testing::ValuesIn(robots), label);

TEST(TalosPosture, HalfSitting_HasLevelSolesOnTheGround) {
  for (const char* name : {"talos", "talos:fixed"}) {
    const Robot robot = load(name);
    const Eigen::VectorXd q = robot.posture("half_sitting");
    for (const char* sole : {"left_sole_link", "right_sole_link"}) {
      const Eigen::Isometry3d placement = frame_placement(robot.model, q, sole);
      EXPECT_NEAR(placement.translation().z(), 0.0, 1e-4) << name << ", " << sole;
      EXPECT_NEAR(placement.linear()(2, 2), 1.0, 1e-4) << name << ", " << sole << " is not level";
    }
  }
}

// The positions are those that the comments of robot.yaml state.
TEST(TalosPosture, PolishingPostures_HaveTheToolAtItsStatedPosition) {
  const Robot robot = load("talos:right_arm");
  const std::vector<std::pair<std::string, Eigen::Vector3d>> stated{
      {"table", {0.431, -0.330, 1.021}},   {"board_x", {0.489, -0.336, 1.152}},
      {"board_y", {0.116, -0.764, 1.412}}, {"board_minus_y", {0.313, 0.199, 1.224}},
      {"tilt_45", {0.300, -0.432, 1.001}},
  };
  for (const auto& [name, position] : stated) {
    const Eigen::Isometry3d tool = frame_placement(robot.model, robot.posture(name), "tool");
    EXPECT_LT((tool.translation() - position).cwiseAbs().maxCoeff(), 1e-3) << name;
  }
}

}  // namespace
}  // namespace burnish::testing
