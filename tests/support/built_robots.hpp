// Robots in code: some that every build tests with, and some that replace robots in files in builds
// that read none.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "support/arm7.hpp"
#include "support/biped.hpp"
#include "support/trees.hpp"
#ifndef BURNISH_HAS_ROBOTS
#error "link burnish_test_robots: without it, the tests would silently cover fewer robots"
#endif

namespace burnish::test {

/// revolute - planar - prismatic - floating - continuous - revolute, with branches on the planar
/// and the floating link, and a ball joint on a branch at the root. Every kind of joint that may
/// have a spring has one; a tendon with a spring and a damper acts on three joints.
inline TreeSpec tree_of_every_joint() {
  using enum JointType;
  std::mt19937_64 generator(6);
  TreeSpec tree;
  tree.name = "every_joint";
  const auto add = [&](const std::string& link, JointType type, const std::string& parent) {
    JointSpec joint =
        testing::joint("to_" + link, type, parent, link, testing::random_vector(generator));
    joint.axis.normalize();
    joint.placement = testing::random_placement(generator);
    joint.armature = testing::uniform(generator, 0.0, 0.2);
    tree.joints.push_back(joint);
    tree.links.push_back({link, testing::random_inertia(generator), {}});
  };
  tree.links.push_back({"root", testing::random_inertia(generator), {}});
  add("a", Revolute, "root");
  add("b", Planar, "a");
  add("c", Prismatic, "b");
  add("d", Floating, "c");
  add("e", Continuous, "d");
  add("tip", Revolute, "e");
  add("b_side", Continuous, "b");
  add("d_side", Planar, "d");
  add("root_side", Prismatic, "root");
  add("root_ball", Ball, "root_side");
  const auto spring = [&](const std::string& link, double stiffness, double rest) {
    for (JointSpec& joint : tree.joints)
      if (joint.name == "to_" + link) joint.stiffness = stiffness, joint.rest = rest;
  };
  spring("a", 6.0, -0.3);
  spring("root_side", 9.0, 0.2);
  spring("e", 4.0, 2.0);
  spring("root_ball", 5.0, 0.0);
  tree.tendons.push_back(
      {"tendon", {{"to_a", 0.8}, {"to_c", -1.2}, {"to_tip", 0.5}}, false, 0.3, 7.0, 1.5});
  return tree;
}

/// Bodies on several joints in a row, with massless links between them: slide - slide - ball, hinge
/// - hinge - slide, ball - slide; beside them hinge - slide and hinge - ball, both with rotors. The
/// axes are chosen such that in no posture two joints move a body in the same direction.
inline TreeSpec tree_of_joints_in_a_row() {
  using enum JointType;
  using Eigen::Vector3d;
  std::mt19937_64 generator(16);
  TreeSpec tree;
  tree.name = "in_a_row";
  tree.links.push_back({"root", testing::random_inertia(generator), {}});
  const auto add = [&](const std::string& link, JointType type, const std::string& parent,
                       const Vector3d& axis = Vector3d::UnitZ()) {
    JointSpec joint = testing::joint("to_" + link, type, parent, link, axis);
    joint.placement.translation().setZero();
    tree.joints.push_back(joint);
    tree.links.push_back({link, {}, {}});
  };
  const auto place = [&] {
    tree.joints.back().placement = testing::random_placement(generator);
    tree.joints.back().placement.translation() *= 0.5;
  };
  const auto add_mass = [&] { tree.links.back().inertia = testing::random_inertia(generator); };
  add("a_1", Prismatic, "root", Vector3d::UnitX());
  place();
  add("a_2", Prismatic, "a_1", Vector3d(0.6, 0.8, 0.0));
  add("a", Ball, "a_2");
  add_mass();
  add("b_1", Revolute, "a", Vector3d::UnitX());
  place();
  add("b_2", Revolute, "b_1", Vector3d::UnitY());
  add("b", Prismatic, "b_2", Vector3d::UnitZ());
  add_mass();
  add("c", Ball, "b");
  place();
  add("tip", Prismatic, "c", Vector3d(0.0, 0.6, 0.8));
  add_mass();
  add("side_1", Continuous, "a_2", Vector3d::UnitY());
  place();
  add("side", Prismatic, "side_1", Vector3d(0.8, 0.6, 0.0));
  add_mass();
  add("rotor", Revolute, "b", Vector3d::UnitY());
  place();
  tree.joints.back().armature = 0.3;
  add("end", Ball, "rotor");
  tree.joints.back().armature = 0.1;
  add_mass();
  return tree;
}

/// Trunk of 12 joints, followed by a branch of 6 and a branch of 3 joints. Entries have too many
/// relatives for a sparse factorization to pay off (Tree::deep). Links are small, so that the tips
/// are not metres away.
inline TreeSpec deep_tree() {
  using enum JointType;
  std::mt19937_64 generator(8);
  TreeSpec tree;
  tree.name = "deep";
  tree.links.push_back({"root", testing::random_inertia(generator), {}});
  const auto grow = [&](const std::string& branch, int count, std::string parent) {
    for (int i = 0; i < count; ++i) {
      const std::string link = branch + "_" + std::to_string(i);
      const JointType type = i % 7 == 3 ? Planar : i % 5 == 2 ? Prismatic : Revolute;
      JointSpec joint = testing::joint("to_" + link, type, parent, link,
                                       testing::random_vector(generator).normalized());
      joint.placement = testing::random_placement(generator);
      joint.placement.translation() *= 0.1;
      joint.armature = testing::uniform(generator, 0.0, 0.05);
      InertiaSpec inertia = testing::random_inertia(generator);
      inertia.com *= 0.1;
      inertia.inertia_at_com *= 0.01;
      tree.joints.push_back(joint);
      tree.links.push_back({link, inertia, {}});
      parent = link;
    }
  };
  grow("trunk", 12, "root");
  grow("left", 6, "trunk_11");
  grow("right", 3, "trunk_11");
  return tree;
}

/// Follower joints of every kind: ancestors and relatives of their leaders, earlier and later in
/// the order, followers of followers, continuous, sliding by an angle, with multiplier 0, with
/// joints beyond them, and on both sides of contacts between branches.
inline TreeSpec tree_with_followers() {
  using enum JointType;
  std::mt19937_64 generator(15);
  TreeSpec tree;
  tree.name = "followers";
  tree.links.push_back({"root", testing::random_inertia(generator), {}});
  const auto add = [&](const std::string& link, JointType type, const std::string& parent) {
    JointSpec joint =
        testing::joint("to_" + link, type, parent, link, testing::random_vector(generator));
    joint.axis.normalize();
    joint.placement = testing::random_placement(generator);
    joint.placement.translation() *= 0.5;
    const double armature = testing::uniform(generator, 0.0, 0.1);
    if (type != Floating) joint.armature = armature;  // MuJoCo's rotors have fixed axes
    tree.joints.push_back(joint);
    tree.links.push_back({link, testing::random_inertia(generator), {}});
  };
  const auto follow = [&](const std::string& leader, double multiplier, double offset) {
    tree.joints.back().mimic = MimicSpec{"to_" + leader, multiplier, offset};
  };
  add("a", Revolute, "root");
  add("b", Prismatic, "a");
  follow("z", 0.3, 0.1);
  add("c", Revolute, "b");
  add("tip", Revolute, "c");
  follow("a", -0.7, 0.2);
  add("wheel", Continuous, "b");
  add("wheel_2", Continuous, "wheel");
  follow("wheel", -2.0, 0.4);
  add("z", Revolute, "root");
  add("z_2", Revolute, "z");
  follow("b", 2.0, -0.1);
  add("z_3", Floating, "z_2");
  add("z_4", Prismatic, "z_3");
  follow("a", 0.5, 0.0);
  add("z_5", Revolute, "z_4");
  follow("wheel", 3.0, -0.3);
  add("z_6", Continuous, "z_4");
  follow("z", 1.0, 0.0);
  add("z_7", Revolute, "z_4");
  follow("c", 0.0, 0.5);
  return tree;
}

inline Model compiled(const TreeSpec& tree, Base base) {
  ModelOptions options;
  options.base = base;
  return build_model(tree, options);
}

/// Whether this build reads robots from files.
constexpr bool has_robot_files = BURNISH_HAS_ROBOTS;

/// Robot in code, with a frame at its end, and a frame on another branch or nearer to the base.
struct BuiltRobot {
  std::string name;
  Model (*model)(Base);
  std::string tool, other_tool;
  Base usual = Base::Fixed;  ///< base in tests that use only one base
};

/// Robots in code of this build. A new robot joins the law suites with one line.
inline const std::vector<BuiltRobot>& built_robots() {
  static const std::vector<BuiltRobot> in_every_build = {
      {"every_joint", [](Base base) { return compiled(tree_of_every_joint(), base); }, "tip",
       "d_side"},
      {"in_a_row", [](Base base) { return compiled(tree_of_joints_in_a_row(), base); }, "tip",
       "side"},
      {"followers", [](Base base) { return compiled(tree_with_followers(), base); }, "tip", "z_5"},
      {"deep", [](Base base) { return compiled(deep_tree(), base); }, "left_5", "right_2"},
  };
  static const std::vector<BuiltRobot> without_files = [] {
    std::vector<BuiltRobot> robots = {
        {"arm7", arm7::model, "tool", "link_1"},
        {"biped", biped::model, "right_sole_link", "left_sole_link", Base::FreeFlyer},
    };
    robots.insert(robots.end(), in_every_build.begin(), in_every_build.end());
    return robots;
  }();
  return has_robot_files ? in_every_build : without_files;
}

}  // namespace burnish::test
