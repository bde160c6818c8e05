// Mechanisms with kinematic loops, in code.
#pragma once

#include <string>

#include "support/trees.hpp"

namespace burnish::testing {

/// Bar of uniform mass along x of its link.
inline LinkSpec bar(const std::string& name, double length) {
  LinkSpec result;
  result.name = name;
  result.inertia.mass = 2.0 * length;
  result.inertia.com.x() = 0.5 * length;
  const double I = result.inertia.mass * length * length / 12.0;
  result.inertia.inertia_at_com = Eigen::Vector3d(0.02 * I + 1e-5, I, I).asDiagonal();
  return result;
}

/// crank (0.1 m) - coupler (0.3 m) - rocker (0.25 m) over a base of 0.3 m, with hinges along y and
/// bars along x at zero. `directions` connect the coupler's tip to the rocker's tip.
inline TreeSpec four_bar(const Directions& directions = Directions::linear()) {
  TreeSpec tree;
  tree.name = "four_bar";
  tree.source = "four_bar.urdf";
  tree.links = {link("base"), bar("crank", 0.1), bar("coupler", 0.3), bar("rocker", 0.25)};
  const auto hinge = [&](const std::string& name, const std::string& parent,
                         const std::string& child, double at) {
    JointSpec spec = joint(name, JointType::Revolute, parent, child, -Eigen::Vector3d::UnitY());
    spec.placement.translation() = Eigen::Vector3d(at, 0.0, 0.0);
    tree.joints.push_back(spec);
  };
  hinge("drive", "base", "crank", 0.0);
  hinge("knee", "crank", "coupler", 0.1);
  hinge("pivot", "base", "rocker", 0.3);
  LoopSpec loop;
  loop.name = "pin";
  loop.first_link = "coupler";
  loop.second_link = "rocker";
  loop.first.translation().x() = 0.3;
  loop.second.translation().x() = 0.25;
  loop.directions = directions;
  tree.loops = {loop};
  return tree;
}

/// Plate on three legs of two links each, in space. Each leg has a hip hinge about a tangent of the
/// base and a knee hinge; its shank ends in a spherical joint at the plate. The plate floats, and
/// three loops of three directions close the mechanism. With `turned`, the loop frames are not
/// aligned with the hinges.
inline TreeSpec tripod(bool turned = true) {
  TreeSpec tree;
  tree.name = "tripod";
  tree.links = {link("base"), link("plate", 0.5)};
  JointSpec floating = joint("plate_joint", JointType::Floating, "base", "plate");
  floating.placement.translation() = Eigen::Vector3d(0.0, 0.0, 0.35);
  tree.joints.push_back(floating);
  for (int i = 0; i < 3; ++i) {
    const std::string leg = std::to_string(i);
    tree.links.push_back(bar("thigh_" + leg, 0.2));
    tree.links.push_back(bar("shank_" + leg, 0.25));
    const Eigen::Matrix3d around =
        Eigen::AngleAxisd(2.0 * i * M_PI / 3.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    JointSpec hip =
        joint("hip_" + leg, JointType::Revolute, "base", "thigh_" + leg, -Eigen::Vector3d::UnitY());
    hip.placement.linear() = around;
    hip.placement.translation() = around * Eigen::Vector3d(0.2, 0.0, 0.0);
    JointSpec knee = joint("knee_" + leg, JointType::Revolute, "thigh_" + leg, "shank_" + leg,
                           -Eigen::Vector3d::UnitY());
    knee.placement.translation() = Eigen::Vector3d(0.2, 0.0, 0.0);
    tree.joints.push_back(hip);
    tree.joints.push_back(knee);
    LoopSpec loop;
    loop.name = "ball_" + leg;
    loop.first_link = "shank_" + leg;
    loop.second_link = "plate";
    loop.first.translation().x() = 0.25;
    loop.second.translation() = around * Eigen::Vector3d(0.1, 0.0, 0.0);
    if (turned)
      loop.first.linear() =
          Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
    tree.loops.push_back(loop);
  }
  return tree;
}

}  // namespace burnish::testing
