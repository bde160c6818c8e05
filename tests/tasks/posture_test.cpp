// Search for a posture on a surface: fitting, repeatable, and refused with a reason if none exists.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "burnish/dynamics/placement.hpp"
#include "burnish/tasks/polishing/reach.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "support/refusal.hpp"
#include "support/scratch.hpp"

namespace burnish::testing {
namespace {

using namespace burnish::polishing;

const Robot& arm() {
  static const Robot robot = load_robot("talos:right_arm");
  return robot;
}

Task task_on(const Eigen::Vector3d& normal) {
  Task task;
  task.normal_base = normal;
  task.posture = searched_posture;
  return task;
}

const Eigen::Vector3d up(0.0, 0.0, 1.0), facing(-1.0, 0.0, 0.0), left(0.0, 1.0, 0.0),
    slanted(-0.5, 0.3, 0.8);

TEST(Posture, SurfaceOfAnyOrientation_GetsAFittingPosture) {
  for (const Eigen::Vector3d& normal : {up, facing, left, slanted}) {
    const Task task = task_on(normal);
    const FoundPosture found = find_posture(task, arm());
    EXPECT_TRUE(found.reach.ok()) << found.reach.text;
    EXPECT_LT(found.tilt, 0.3);
    EXPECT_GT(found.reach.joint_margin, 0.15);
    EXPECT_LT(found.reach.torque_share, 0.5);
    const Eigen::Vector3d axis = pressing_axis(frame_placement(arm().model, found.q, task.tool));
    const double tilt = std::atan2(axis.cross(normal).norm(), -axis.dot(normal));
    EXPECT_NEAR(tilt, found.tilt, 1e-6);
    for (int k = 0; k < arm().model.nq; ++k) {
      EXPECT_GE(found.q[k] - arm().model.q_lower[k], 0.15 - 1e-9);
      EXPECT_GE(arm().model.q_upper[k] - found.q[k], 0.15 - 1e-9);
    }
  }
}

TEST(Posture, NamedPostures_PressIntoTheirSurfaces) {
  for (const NamedSurface& surface : named_surfaces()) {
    const Eigen::Vector3d axis =
        pressing_axis(frame_placement(arm().model, arm().posture(surface.posture), "tool"));
    EXPECT_GT(-axis.dot(surface.normal_world), std::cos(0.9)) << surface.name;
  }
}

TEST(Posture, RepeatedSearch_GivesTheSamePosture) {
  const Task task = task_on(slanted);
  EXPECT_EQ(find_posture(task, arm()).q, find_posture(task, arm()).q);
}

TEST(Posture, LengthOfTheNormal_ChangesNothing) {
  const FoundPosture one = find_posture(task_on(slanted), arm());
  const FoundPosture two = find_posture(task_on(2.0 * slanted), arm());
  EXPECT_LT((one.q - two.q).norm(), 1e-6);
}

TEST(Posture, SurfacePoint_StartsAboveIt) {
  Task task = task_on(facing);
  task.point_base = Eigen::Vector3d(0.55, -0.2, 1.2);
  const FoundPosture found = find_posture(task, arm());
  const Eigen::Vector3d above = *task.point_base + (task.tip_radius + task.clearance) * facing;
  EXPECT_LT((frame_placement(arm().model, found.q, task.tool).translation() - above).norm(), 1e-4);
  const Setting setting = make_setting(task);
  EXPECT_LT((setting.p_center - (*task.point_base + task.tip_radius * facing)).norm(), 2e-4);
}

TEST(Posture, PostureSearch_GivesTheStartOfTheTask) {
  const Task task = task_on(slanted);
  EXPECT_EQ(make_setting(task).q_start, find_posture(task, arm()).q);
  Task read = task_on(up);
  override_task(read, {"surface.normal=[-0.5, 0.3, 0.8]"});
  EXPECT_EQ(read.posture, "search");
  EXPECT_EQ(make_setting(read).q_start, find_posture(task, arm()).q);
  EXPECT_NE(task_text(read).find("posture: search"), std::string::npos);
}

TEST(Posture, TightLimits_AreRefusedNamingTheFailedLimit) {
  const Task task = task_on(up);
  const auto refused = [&](const PostureOptions& options, const std::string& words) {
    expect_words(refusal([&] { find_posture(task, arm(), options); }),
                 {"no posture was found for the surface: ", words});
  };
  refused({.body_distance = 3.0}, "m of the robot's body; wanted at least 3 m");
  refused({.tilt_limit = -0.1}, "degrees off the surface's normal");
  refused({.joint_margin = 2.0}, "rad of its limit; wanted at least 2");
  PostureOptions strict;
  strict.reach.torque_share = 0.01;
  refused(strict, "permits the path; the best of them fails: ");
}

/// Task for arm7, whose wrist is compact.
Task task_for_arm7(const std::string& tool) {
  Task task;
  task.robot = "arm7";
  task.posture = searched_posture;
  task.tool = tool;
  return task;
}

TEST(Posture, CompactWrist_GetsAPosture) {
  for (const char* tool : {"tool", "flange"})
    for (const Eigen::Vector3d& normal : {up, facing, slanted}) {
      Task task = task_for_arm7(tool);
      task.normal_base = normal;
      const Setting setting = make_setting(task);
      const Model& model = setting.robot.model;
      const Eigen::Vector3d axis =
          frame_placement(model, setting.q_start, tool).linear() * pressing_direction(task, model);
      EXPECT_GT(-axis.dot(normal.normalized()), std::cos(0.5)) << tool;
      EXPECT_TRUE(check_reach(task, setting).ok());
    }
}

TEST(Posture, BodyDistanceKey_ConstrainsTheSearch) {
  Task task = task_for_arm7("tool");
  override_task(task, {"search.body_distance=2"});
  expect_words(refusal([&] { make_setting(task); }),
               {"m of the robot's body; wanted at least", "(search.body_distance)",
                "with search.body_distance=0.15 a posture is found"});
  override_task(task, {"search.body_distance=0.25", "search.joint_margin=2"});
  expect_words(refusal([&] { make_setting(task); }), {"rad of its limit; wanted at least 2"});
}

TEST(Posture, FingerBesideAnother_MayPress) {
  // Two coupled fingers of a gripper are near each other in every posture of the arm.
  std::string text = contents(std::filesystem::path(BURNISH_ROBOTS_DIR) / "arm7/arm7.urdf");
  const auto finger = [](const std::string& side, const std::string& y, const std::string& mimic) {
    return "<joint name='" + side +
           "_joint' type='prismatic'><parent link='flange'/><child link='" + side +
           "'/><origin xyz='0 " + y + " 0.1'/><axis xyz='0 1 0'/>" + mimic +
           "<limit lower='0' upper='0.04' effort='20' velocity='0.2'/></joint><link name='" + side +
           "'><inertial><mass value='0.02'/><inertia ixx='1e-5' iyy='1e-5' izz='1e-5' ixy='0' "
           "ixz='0' iyz='0'/></inertial></link>";
  };
  text.replace(text.find("</robot>"), 8,
               finger("finger", "-0.03", "") +
                   finger("thumb", "0.03", "<mimic joint='finger_joint' multiplier='-1'/>") +
                   "</robot>");
  const Scratch scratch;
  Task task;
  scratch.write("gripper.urdf", text);
  // With a settings file the fingers can move; without one they are locked.
  task.robot = scratch.write("robot.yaml", "urdf: gripper.urdf\n").string();
  task.posture = searched_posture;
  task.tool = "finger";
  override_task(task, {"tool.axis=[0, 0, 1]"});
  const Robot robot = load_task_robot(task);
  EXPECT_TRUE(find_posture(task, robot).reach.ok());
}

TEST(Posture, ToolOfTheDescription_PressesAlongItsLastJointAxis) {
  const Robot arm = load_robot("arm7");
  Task task = task_for_arm7("flange");
  // The z axis of the flange is the axis of joint_7 and points away from the arm.
  EXPECT_LT((pressing_direction(task, arm.model) - Eigen::Vector3d::UnitZ()).norm(), 1e-9);
  task.tool = "tool";  // from the settings file
  EXPECT_EQ(pressing_direction(task, arm.model), Eigen::Vector3d::UnitZ());
  EXPECT_EQ(pressing_direction({}, ::burnish::testing::arm().model),
            Eigen::Vector3d(-Eigen::Vector3d::UnitZ()));
  override_task(task, {"tool.axis=[0, 2, 0]"});
  EXPECT_EQ(pressing_direction(task, arm.model), Eigen::Vector3d::UnitY());
  // If the last joint axis is perpendicular to the line to the tool, the tool presses along that
  // line.
  task = {};
  task.tool = "wrist_right_ft_tool_link";
  const Model& talos = ::burnish::testing::arm().model;
  const Eigen::Isometry3d at = frame_placement(talos, talos.q_neutral, task.tool);
  const Eigen::Vector3d elbow =
      frame_placement(talos, talos.q_neutral, "arm_right_4_joint").translation();
  EXPECT_LT(
      (at.linear() * pressing_direction(task, talos) - (at.translation() - elbow).normalized())
          .norm(),
      1e-9);
}

TEST(Posture, RobotWithoutThePosture_SearchesOne) {
  Task task = task_for_arm7("flange");
  const Robot arm = load_robot("arm7");
  EXPECT_TRUE(searches_posture(task, arm));
  task.posture = "";  // arm7 has a default
  EXPECT_FALSE(searches_posture(task, arm));
  put_on(task, "table");
  EXPECT_TRUE(searches_posture(task, arm));
  task.posture = "bent";
  EXPECT_FALSE(searches_posture(task, arm));
  task.posture = "bentt";
  EXPECT_FALSE(searches_posture(task, arm));
  expect_words(refusal([&] { make_setting(task); }), {"did you mean 'bent'?"});
}

TEST(Posture, JointsWithTwoTurns_StayWithinHalfATurnOfTheMiddle) {
  Robot arm = load_robot("arm7");
  arm.postures.clear();
  arm.model.q_lower.setConstant(-2.0 * std::numbers::pi);
  arm.model.q_upper.setConstant(2.0 * std::numbers::pi);
  Task task = task_for_arm7("tool");
  for (const std::uint64_t seed : {0, 1, 2}) {
    PostureOptions options = posture_options(task);
    options.seed = seed;
    const FoundPosture found = find_posture(task, arm, options);
    EXPECT_LE(found.q.cwiseAbs().maxCoeff(), std::numbers::pi + 1e-9) << found.q.transpose();
  }
}

TEST(Posture, BareDescription_MovesOnlyJointsThatCarryTheTool) {
  Task task;
  task.robot = std::string(BURNISH_ROBOTS_DIR) + "/quadruped/quadruped.urdf";
  task.tool = "fl_shank_link";
  EXPECT_EQ(load_task_robot(task).model.nv, 3);
  task.tool = "fl_shank_lik";
  expect_words(refusal([&] { load_task_robot(task); }),
               {"the tool's frame 'fl_shank_lik' does not exist on robot", "'fl_shank_link'"});
  task.tool = "nothing_like_it_at_all";
  expect_words(refusal([&] { load_task_robot(task); }),
               {"end links: ", "fl_shank_link", "tool.frame or --tool FRAME"});
}

TEST(Posture, MissingTool_ListsSitesAndEndLinks) {
  const Scratch scratch;
  const auto hinge = [](const std::string& name, const std::string& inside) {
    return "<body name='" + name + "' pos='0 0 0.3'><joint name='j" + name + "' axis='0 1 0'/>" +
           "<geom size='0.1'/><site name='on_" + name + "'/>" + inside + "</body>";
  };
  Task task;
  task.robot = scratch
                   .write("arm.xml", "<mujoco><worldbody><site name='floor'/>" +
                                         hinge("a", hinge("b", "")) + "</worldbody></mujoco>")
                   .string();
  task.tool = "nothing_like_it_at_all";
  const std::string message = refusal([&] { load_task_robot(task); });
  expect_words(message, {"frames: on_b, on_a; end links: b"});
  EXPECT_EQ(message.find("floor"), std::string::npos);
}

TEST(Posture, FloatingBase_IsRefused) {
  Task task = task_for_arm7("tool");
  task.robot = "arm7:floating";
  expect_words(refusal([&] { make_setting(task); }),
               {"the base of robot 'arm7' floats free", "a fixed base"});
}

TEST(Posture, PointOutOfReach_IsRefused) {
  Task task = task_on(facing);
  task.point_base = Eigen::Vector3d(2.0, 0.0, 1.0);
  expect_words(refusal([&] { find_posture(task, arm()); }),
               {"m away from its start position above the surface"});
  expect_words(refusal([&] { make_setting(task); }), {"no posture was found"});
}

}  // namespace
}  // namespace burnish::testing
