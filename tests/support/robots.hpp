// The robots that the kernels are tested on, and random states of them.
#pragma once

#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "burnish/model/robot.hpp"
#include "burnish/model/state.hpp"
#include "support/trees.hpp"

namespace burnish::test {

/// A robot that comes with the repository, or "every_joint": joints of every kind, in branches; or
/// "deep": a long trunk with two branches. Bolted down or floating. `tool` is a frame at its end.
struct TestRobot {
  std::string name;
  Base base;
  std::string tool;

  Model model() const {
    if (name == "every_joint") return tree_of_every_joint();
    if (name == "deep") return deep_tree();
    RobotOverrides overrides;
    overrides.base = base;
    return load_robot(std::string(BURNISH_ROBOTS_DIR) + "/" + name, overrides).model;
  }
  /// revolute - planar - prismatic - floating - continuous - revolute, with branches on the planar
  /// and the floating link.
  Model tree_of_every_joint() const {
    using enum JointType;
    std::mt19937_64 generator(6);
    TreeSpec tree;
    tree.name = name;
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
    ModelOptions options;
    options.base = base;
    return build_model(tree, options);
  }
  /// A trunk of 12 joints, from which a branch of 6 goes on and one of 3 leaves: entries have more
  /// relatives than are worth a sparse factor (Tree::deep). Small links, so that the tips are not
  /// metres away.
  Model deep_tree() const {
    using enum JointType;
    std::mt19937_64 generator(8);
    TreeSpec tree;
    tree.name = name;
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
    ModelOptions options;
    options.base = base;
    return build_model(tree, options);
  }
  /// A name that a test case may have.
  std::string label() const {
    std::string text = name + (base == Base::Fixed ? "_fixed" : "_floating");
    for (char& c : text)
      if (c == ':') c = '_';
    return text;
  }
};

/// How a test names it.
inline void PrintTo(const TestRobot& robot, std::ostream* out) { *out << robot.label(); }

inline std::vector<TestRobot> robots_on(Base base) {
  return {{"talos", base, "right_sole_link"},
          {"talos:right_arm", base, "tool"},
          {"arm7", base, "tool"},
          {"crane", base, "left_tip"},
          {"every_joint", base, "tip"},
          {"deep", base, "left_5"}};
}
inline std::vector<TestRobot> floating_robots() { return robots_on(Base::FreeFlyer); }
/// Every robot on both bases.
inline std::vector<TestRobot> test_robots() {
  std::vector<TestRobot> robots = robots_on(Base::Fixed);
  for (const TestRobot& robot : floating_robots()) robots.push_back(robot);
  return robots;
}

/// n entries, uniform in [-bound, bound].
inline Eigen::VectorXd random_vector(int n, double bound, std::mt19937_64& generator) {
  std::uniform_real_distribution<double> draw(-bound, bound);
  Eigen::VectorXd x(n);
  for (double& entry : x) entry = draw(generator);
  return x;
}

}  // namespace burnish::test
