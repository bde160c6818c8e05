// Reach check before a run: reachable surfaces, and the message for each kind of failure.
#include "burnish/tasks/polishing/reach.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "burnish/dynamics/placement.hpp"
#include "burnish/tasks/polishing/reach.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "support/refusal.hpp"

namespace burnish::testing {
namespace {

using namespace burnish::polishing;

Task task_on(const std::string& surface) {
  Task task;
  put_on(task, surface);
  return task;
}

ReachReport reach_of(const Task& task, const ReachOptions& options = {}) {
  return check_reach(task, make_setting(task), options);
}

TEST(Reach, NamedSurfaces_AreReachable) {
  for (const NamedSurface& surface : named_surfaces()) {
    const ReachReport report = reach_of(task_on(surface.name));
    EXPECT_TRUE(report.ok()) << surface.name << ": " << report.text;
    EXPECT_EQ(report.text, "");
    EXPECT_GT(report.joint_margin, 0.1) << surface.name << " " << report.tightest_joint;
    EXPECT_GT(report.torque_share, 0.05) << surface.name;
    EXPECT_LT(report.torque_share, 0.6) << surface.name << " " << report.tightest_torque;
    EXPECT_GT(report.points, 50);
    // Lever arms of the pressing force are 0.1 to 2 m.
    EXPECT_GT(report.force_per_torque, 0.5) << surface.name;
    EXPECT_LT(report.force_per_torque, 10.0) << surface.name << " " << report.force_joint;
  }
}

TEST(Reach, NamedSurfaces_KeepClearOfTheArm) {
  for (const NamedSurface& surface : named_surfaces()) {
    const ReachReport report = reach_of(task_on(surface.name));
    EXPECT_GT(report.clearance, 0.05) << surface.name << " " << report.tightest_clearance;
    EXPECT_LT(report.clearance, 1.0) << surface.name;
    EXPECT_NE(report.tightest_clearance, "torso_1_joint") << "this joint has a fixed distance";
  }
  // The table lies below the pitch joint of the torso, whose origin does not move.
  Task endless = task_on("table");
  endless.extent = std::numeric_limits<double>::infinity();
  const ReachReport table = reach_of(endless);
  const Setting setting = make_setting(endless);
  EXPECT_EQ(table.tightest_clearance, "torso_2_joint");
  EXPECT_NEAR(table.clearance, 1.0922 - setting.scene.tool().surface.point.z() - 0.03, 1e-4);
}

TEST(Reach, ArmTouchingTheSurface_IsRefusedWithJointAndDepth) {
  ReachOptions options;
  Task board = task_on("board_y");
  board.extent = std::numeric_limits<double>::infinity();
  const ReachReport free = reach_of(board);
  options.link_radius = 0.03 + free.clearance + 0.01;
  const ReachReport thick = reach_of(board, options);
  ASSERT_EQ(thick.problem, ReachProblem::Collision);
  EXPECT_EQ(thick.joint, free.tightest_clearance);
  EXPECT_EQ(thick.limit, options.link_radius);
  EXPECT_LT(thick.value, thick.limit);
  expect_words(thick.text, {"joint '" + thick.joint + "' would be 0.3", "m from the surface",
                            "wanted at least 0.3"});

  // A board that faces away from the robot: the tool would reach around it.
  Task behind = task_on("table");
  behind.normal_base = -Eigen::Vector3d::UnitZ();
  behind.extent = std::numeric_limits<double>::infinity();
  behind.clearance = 0.01;
  const ReachReport inside = reach_of(behind);
  ASSERT_EQ(inside.problem, ReachProblem::Collision) << inside.text;
  EXPECT_LT(inside.value, 0.0);
  expect_words(inside.text, {"before the start of the path",
                             "joint '" + inside.joint + "' would be", "m inside the surface"});
}

/// Plate in front of the shoulder of the arm, at the height of the shoulder.
Task plate_before_an_arm() {
  Task task;
  task.robot = "arm7";
  task.posture = searched_posture;
  task.point_base = Eigen::Vector3d(0.45, 0.05, 0.4);
  task.path.radius = 0.04;
  return task;
}

TEST(Reach, ArmBesideTheSurface_IsAllowed) {
  Task task = plate_before_an_arm();
  const Setting setting = make_setting(task);
  const ReachReport beside = check_reach(task, setting);
  EXPECT_TRUE(beside.ok()) << beside.text;
  EXPECT_NEAR(setting.scene.tool().surface.extent, 0.14, 1e-12);
  // An infinite plate would pass through the shoulder.
  task.extent = std::numeric_limits<double>::infinity();
  const ReachReport through = check_reach(task, make_setting(task, setting.robot, setting.q_start));
  ASSERT_EQ(through.problem, ReachProblem::Collision);
  expect_words(through.text, {"joint 'joint_2' would be", "m inside the surface"});
}

TEST(Reach, LinkInsideTheMaterial_IsRefused) {
  Task task = plate_before_an_arm();
  Setting setting = make_setting(task);
  // A thin column in the middle of the forearm, far from every joint.
  const auto origin = [&](const char* joint) {
    return Eigen::Vector3d(
        frame_placement(setting.robot.model, setting.q_start, joint).translation());
  };
  const Eigen::Vector3d middle = 0.5 * (origin("joint_4") + origin("joint_5"));
  SurfaceSpec& column = setting.scene.tool().surface;
  column.extent = 0.01;
  column.point = middle + 0.01 * column.normal;
  const ReachReport report = check_reach(task, setting);
  ASSERT_EQ(report.problem, ReachProblem::Collision);
  EXPECT_LT(report.value, 0.0);
}

TEST(Reach, Path_IsCheckedOnceOverItsWholeLength) {
  Task task = task_on("table");
  task.polish_duration = 100.0;
  // One turn of the circle, and the path from the centre to it, which is longer than the radius.
  const double turn = 2.0 * 3.14159265 * 0.07;
  const double length = reach_of(task).path_length;
  EXPECT_GT(length, turn + 0.07);
  EXPECT_LT(length, turn + 0.07 * 2.1);
  task.path = {.kind = PathKind::Points, .points = {{0.05, 0.0}, {0.05, 0.04}}};
  EXPECT_NEAR(reach_of(task).path_length, 0.09, 1e-6);
  task.polish_duration = 0.3;  // ends before the path does
  EXPECT_LT(reach_of(task).path_length, 0.05);
}

TEST(Reach, FarSurface_IsRefused) {
  Task task = task_on("table");
  task.point_base = Eigen::Vector3d(0.4, -0.3, -1.0);
  const ReachReport report = reach_of(task);
  EXPECT_NE(report.problem, ReachProblem::None);
  EXPECT_NE(report.problem, ReachProblem::Torque);
  EXPECT_LT(report.s, -1.0);  // long before the surface
  expect_words(report.text, {"mm before the start of the path, with the tool at (0.4"});
}

TEST(Reach, PointBeyondTheArm_IsReportedAsOutOfReach) {
  Task task = task_on("board");
  task.point_base = Eigen::Vector3d(2.5, 0.0, 1.15);
  ReachOptions options;
  options.joint_margin = -10.0;  // disables the joint limits
  const ReachReport report = reach_of(task, options);
  EXPECT_EQ(report.problem, ReachProblem::Position);
  EXPECT_EQ(report.joint, "");
  EXPECT_GT(report.value, report.limit);
  expect_words(report.text,
               {"the arm cannot reach this point: the tool stays", "wanted at most 0.0001 m"});
}

TEST(Reach, LargeCircle_IsRefusedWithTheJoint) {
  Task task = task_on("table");
  task.path.radius = 0.6;
  const ReachReport report = reach_of(task);
  ASSERT_FALSE(report.ok());
  EXPECT_GT(report.s, 0.0);
  expect_words(report.text, {"mm along the path, with the tool at ("});
  ASSERT_EQ(report.problem, ReachProblem::Joint);
  expect_words(report.text, {"joint '" + report.joint + "' would be at", "wanted at"});
}

TEST(Reach, LargeForce_IsRefusedWithJointAndTorques) {
  Task task = task_on("table");
  task.force = 300.0;
  const ReachReport report = reach_of(task);
  ASSERT_EQ(report.problem, ReachProblem::Torque) << report.text;
  EXPECT_GT(report.value, report.limit);
  EXPECT_EQ(report.joint, "arm_right_2_joint");
  expect_words(report.text, {"pressing with 300 N needs ", "Nm in joint 'arm_right_2_joint'",
                             "wanted at most 80"});
}

TEST(Reach, ArmWeightBeyondTheMotors_IsRefused) {
  Task task = task_on("table");
  Setting setting = make_setting(task);
  setting.robot.model.effort_limit.setConstant(5.0);
  const ReachReport report = check_reach(task, setting);
  EXPECT_EQ(report.problem, ReachProblem::Torque);
  EXPECT_LT(report.s, 0.0);  // still in the air
  expect_words(report.text, {"the weight of the arm alone needs"});
}

TEST(Reach, RequestedMargins_AreApplied) {
  const Task task = task_on("board");
  const ReachReport free = reach_of(task);
  ReachOptions options;
  options.torque_share = 0.9 * free.torque_share;
  const ReachReport report = reach_of(task, options);
  EXPECT_EQ(report.problem, ReachProblem::Torque);
  EXPECT_GT(report.value, report.limit);
  // A larger joint margin, which the null space of the arm can provide.
  options = {};
  options.joint_margin = free.joint_margin + 0.005;
  const ReachReport wider = reach_of(task, options);
  EXPECT_TRUE(wider.ok() || wider.problem == ReachProblem::Joint) << wider.text;
  if (wider.ok()) {
    EXPECT_GE(wider.joint_margin, options.joint_margin - 1e-9);
  }
}

}  // namespace
}  // namespace burnish::testing
