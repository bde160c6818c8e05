// Robot with two legs and one arm, in code: the humanoid of builds that read no files.
#pragma once

#include <string>

#include "burnish/model/model.hpp"

namespace burnish::test::biped {

/// Solid box with a mass [kg] and full lengths [m], centered at `com`.
inline LinkSpec box(const std::string& name, double mass, const Eigen::Vector3d& size,
                    const Eigen::Vector3d& com) {
  const Eigen::Vector3d squares = size.cwiseProduct(size);
  const Eigen::Vector3d about(squares.y() + squares.z(), squares.x() + squares.z(),
                              squares.x() + squares.y());
  return {name, {mass, com, (mass / 12.0 * about).asDiagonal()}, {}};
}

/// Limb that grows by a link on its last link, with a revolute joint.
struct Limb {
  TreeSpec& tree;
  std::string name;  ///< prefix of the names of its links
  std::string last = "pelvis";
  int count = 0;

  void add(const Eigen::Vector3d& at, const Eigen::Vector3d& axis, double lower, double upper,
           double mass, const Eigen::Vector3d& size, const Eigen::Vector3d& com) {
    const std::string number = std::to_string(++count);
    JointSpec joint;
    joint.name = name + number + "_joint";
    joint.type = JointType::Revolute;
    joint.parent_link = last;
    joint.child_link = last = name + number + "_link";
    joint.placement.translation() = at;
    joint.axis = axis;
    joint.lower = lower;
    joint.upper = upper;
    joint.effort_limit = 200.0;
    joint.velocity_limit = 5.0;
    joint.armature = 0.02;
    tree.joints.push_back(joint);
    tree.links.push_back(box(last, mass, size, com));
  }
  /// Adds a link without mass, fixed to the last link.
  void end(const std::string& link, const Eigen::Vector3d& at) {
    JointSpec joint;
    joint.name = link + "_joint";
    joint.parent_link = last;
    joint.child_link = link;
    joint.placement.translation() = at;
    tree.joints.push_back(joint);
    tree.links.push_back({link, {}, {}});
  }
};

inline TreeSpec tree() {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                        z = Eigen::Vector3d::UnitZ();
  TreeSpec tree;
  tree.name = "biped";
  tree.links.push_back(box("pelvis", 30.0, {0.25, 0.4, 0.6}, {-0.01, 0.0, 0.25}));
  for (const double side : {1.0, -1.0}) {
    Limb leg{tree, side > 0.0 ? "leg_left_" : "leg_right_"};
    leg.add({-0.02, 0.09 * side, -0.1}, z, -1.0, 1.0, 2.0, {0.1, 0.1, 0.1}, {0.0, 0.01, -0.03});
    leg.add({0.0, 0.0, -0.05}, x, -0.6, 0.6, 2.5, {0.12, 0.1, 0.1}, {0.01, 0.0, -0.01});
    leg.add({0.0, 0.0, -0.02}, y, -2.0, 0.7, 6.0, {0.15, 0.14, 0.4}, {0.01, 0.02 * side, -0.18});
    leg.add({0.0, 0.0, -0.38}, y, 0.0, 2.5, 3.5, {0.1, 0.1, 0.35}, {0.01, 0.0, -0.15});
    leg.add({0.0, 0.0, -0.33}, y, -1.2, 0.7, 1.2, {0.1, 0.08, 0.1}, {-0.01, 0.0, 0.0});
    leg.add({0.0, 0.0, 0.0}, x, -0.5, 0.5, 1.6, {0.22, 0.12, 0.06}, {0.02, 0.0, -0.07});
    leg.end(side > 0.0 ? "left_sole_link" : "right_sole_link", {0.0, 0.0, -0.1});
  }
  Limb arm{tree, "arm_"};
  arm.add({0.02, -0.25, 0.5}, y, -2.0, 2.0, 2.0, {0.1, 0.1, 0.1}, {0.0, -0.03, 0.0});
  arm.add({0.0, -0.06, 0.0}, x, -2.5, 0.1, 1.8, {0.1, 0.1, 0.3}, {0.0, 0.01, -0.13});
  arm.add({0.0, 0.0, -0.28}, z, -2.0, 2.0, 1.0, {0.08, 0.08, 0.1}, {0.01, 0.0, -0.02});
  arm.add({0.0, 0.0, -0.03}, y, -2.4, 0.0, 1.5, {0.08, 0.08, 0.3}, {0.0, 0.0, -0.13});
  arm.end("tool", {0.02, 0.0, -0.35});
  return tree;
}

inline Model model(Base base) {
  ModelOptions options;
  options.base = base;
  options.base_placement.translation().z() = 0.92;
  return build_model(tree(), options);
}

/// Floating base with bent knees: hip, knee and ankle of each leg at -0.4, 0.8 and -0.4 rad, and
/// the elbow at -0.5 rad.
inline Eigen::VectorXd half_sitting(const Model& model) {
  Eigen::VectorXd q = model.q_neutral;
  const auto set = [&](const std::string& joint, double angle) {
    q[model.joints[static_cast<std::size_t>(model.joint_index(joint))].q_index] = angle;
  };
  for (const std::string leg : {"leg_left_", "leg_right_"}) {
    set(leg + "3_joint", -0.4);
    set(leg + "4_joint", 0.8);
    set(leg + "5_joint", -0.4);
  }
  set("arm_4_joint", -0.5);
  return q;
}

}  // namespace burnish::test::biped
