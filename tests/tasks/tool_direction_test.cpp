// Pressing direction of a tool, inferred from the joints that carry it.
#include <gtest/gtest.h>

#include "burnish/dynamics/placement.hpp"
#include "burnish/tasks/polishing/reach.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "support/refusal.hpp"
#include "support/scratch.hpp"
#include "support/six_joint_arm.hpp"

namespace burnish::testing {
namespace {

using namespace burnish::polishing;

/// Task and robot of an arm with a given wrist.
struct Loaded {
  explicit Loaded(const Wrist& wrist, const std::string& settings = "") {
    task.robot = scratch.write("arm.urdf", six_joint_arm(wrist)).string();
    if (!settings.empty()) task.robot = scratch.write("robot.yaml", settings).string();
    task.tool = settings.empty() ? "flange" : "tool";
    put_on(task, "table");
    robot = load_task_robot(task);
  }
  double z() const { return pressing_direction(task, robot.model).z(); }

  Scratch scratch;
  Task task;
  Robot robot;
};

TEST(ToolDirection, OffsetAlongTheLastAxis_GivesTheDirection) {
  struct Case {
    Wrist wrist;
    double z;
  };
  const Case cases[] = {{{.joint_before = -0.1, .mass_at = -0.02, .flange_at = 0.05}, 1.0},
                        {{.joint_before = 0.1, .mass_at = 0.02, .flange_at = -0.05}, -1.0},
                        {{.joint_before = 0.1, .mass_at = -0.02}, 1.0},
                        {{.joint_before = -0.1, .mass_at = 0.02}, -1.0},
                        {{.joint_before = 0.0, .mass_at = 0.02}, 1.0},
                        {{.joint_before = 0.0, .mass_at = -0.02}, -1.0}};
  for (const Case& each : cases) {
    const Loaded loaded(each.wrist);
    EXPECT_EQ(loaded.z(), each.z) << each.wrist.joint_before << " " << each.wrist.mass_at;
    EXPECT_TRUE(loaded.robot.notes.empty());
  }
}

TEST(ToolDirection, FrameFromSettings_PointsAwayFromTheArm) {
  const std::string settings = "urdf: arm.urdf\nframes: {tool: {parent: flange";
  EXPECT_EQ(Loaded({}, settings + "}}").z(), 1.0);
  EXPECT_EQ(Loaded({}, settings + ", rpy: [3.14159265, 0, 0]}}").z(), -1.0);
  EXPECT_EQ(Loaded({}, settings + ", xyz: [0, 0, -0.1]}}").z(), -1.0);
}

TEST(ToolDirection, NoOffset_NoteNamesTheAssumedDirection) {
  const Loaded ambiguous({.joint_before = 0.0, .mass_at = 0.0});
  EXPECT_EQ(ambiguous.z(), 1.0);
  ASSERT_EQ(ambiguous.robot.notes.size(), 1U);
  expect_words(ambiguous.robot.notes.front(),
               {"in which tool 'flange' presses", "tool.axis=[0, 0, 1] is assumed",
                "set tool.axis=[0, 0, -1] if the tool presses in the opposite direction"});
  Task stated = ambiguous.task;
  override_task(stated, {"tool.axis=[0, 0, -1]"});
  EXPECT_TRUE(load_task_robot(stated).notes.empty());
}

TEST(ToolDirection, SmallOffsetBesideTheAxis_IsIgnored) {
  const std::string tip =
      "<link name='tip'/><joint name='tip_joint' type='fixed'><parent link='l6'/><child "
      "link='tip'/><origin xyz='XX 0 0.002'/></joint>";
  const auto at = [&](const std::string& x) {
    std::string text = tip;
    Loaded loaded({.beyond = text.replace(text.find("XX"), 2, x)});
    loaded.task.tool = "tip";
    return pressing_direction(loaded.task, loaded.robot.model);
  };
  EXPECT_EQ(at("0.01"), Eigen::Vector3d::UnitZ());
  EXPECT_GT(at("0.1").x(), 0.99);
}

TEST(ToolDirection, FlangeAtTheLastJoint_FindsAPostureForTheTable) {
  const Loaded loaded({});
  const Setting setting = make_setting(loaded.task, loaded.robot);
  // The last link is between the wrist and the table.
  const auto height = [&](const char* frame) {
    return frame_placement(loaded.robot.model, setting.q_start, frame).translation().z();
  };
  EXPECT_LT(height("flange"), height("l5") - 0.05);
}

TEST(ToolDirection, NoPosture_RefusalNamesTheAxisAndItsOpposite) {
  Loaded loaded({.joint_before = -0.1});
  override_task(loaded.task, {"tool.axis=[0, 0, 1]", "search.body_distance=2"});
  expect_words(refusal([&] { make_setting(loaded.task, loaded.robot); }),
               {"no posture was found", "'flange' presses along tool.axis=[0, 0, 1]"});
  // Without a stated axis, the tool is assumed to press away from the wrist joints.
  loaded.task.tool_axis.reset();
  expect_words(refusal([&] { make_setting(loaded.task, loaded.robot); }),
               {"is assumed to press along tool.axis=[0, 0, -1]",
                "with tool.axis=[0, 0, 1] none is found either"});
}

}  // namespace
}  // namespace burnish::testing
