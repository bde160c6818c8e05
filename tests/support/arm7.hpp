// Robot arm7 in code, for builds that read no files; built_robots_test.cpp compares it with
// robots/arm7.
#pragma once

#include <string>

#include "burnish/model/model.hpp"

namespace burnish::test {

namespace arm7 {

inline Eigen::Matrix3d rotation(const Eigen::Vector3d& rpy) {
  return (Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}
inline Eigen::Isometry3d placement(const Eigen::Vector3d& xyz, const Eigen::Vector3d& rpy) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = rotation(rpy);
  result.translation() = xyz;
  return result;
}

/// An <inertial> of the file: mass, origin, and ixx, iyy, izz, ixy, ixz, iyz in its own axes.
struct Inertial {
  double mass;
  Eigen::Vector3d xyz, rpy;
  double xx, yy, zz, xy, xz, yz;

  LinkSpec link(const std::string& name) const {
    Eigen::Matrix3d own;
    own << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    const Eigen::Matrix3d R = rotation(rpy);
    return {name, {mass, xyz, R * own * R.transpose()}, {}};
  }
};

/// A <joint> of the file: origin, axis, limits and dynamics.
struct Hinge {
  Eigen::Vector3d xyz, rpy, axis;
  double lower, upper, effort, velocity, damping, friction, armature;
};

inline TreeSpec tree() {
  const double quarter = 1.570796326794897;
  const Inertial base{
      4.0,    {0.0005, -0.006, 0.0689}, {0, 0, 0}, 0.01276, 0.01339, 0.01332, 0.00023, -0.00045,
      0.00051};
  const Inertial flange{0.7,       {0.0017, -0.0011, 0.0348},
                        {0, 0, 0}, 0.000833,
                        0.000836,  0.000181,
                        0.000003,  0.000006,
                        -0.000004};
  const Hinge hinges[7] = {
      {{0, 0, 0.142}, {0, 0, 0}, {0, 0, 1}, -2.9, 2.9, 180, 2.2, 1.2, 1.5, 0.42},
      {{0.04, 0.06, 0.17}, {-quarter, 0, 0}, {0, 0, 1}, -1.9, 1.9, 180, 2.2, 1.2, 1.5, 0.42},
      {{0, -0.23, 0.02}, {quarter, 0, 0.2}, {0, 0, 1}, -2.9, 2.9, 95, 2.8, 0.8, 0.9, 0.18},
      {{0.06, 0, 0.19}, {0, 0, 0}, {0, -1, 0}, -2.4, 0.6, 95, 2.8, 0.8, 0.9, 0.18},
      {{-0.05, 0.01, 0.21}, {0, -0.25, 0}, {0.6, 0, 0.8}, -2.9, 2.9, 45, 3.6, 0.4, 0.5, 0.06},
      {{0.05, 0, 0.12}, {0, 0.25, 0}, {0, 1, 0}, -1.8, 2.0, 45, 3.6, 0.4, 0.5, 0.06},
      {{0.065, 0, 0}, {0, quarter, 0}, {0, 0, 1}, -3.05, 3.05, 20, 4.5, 0.2, 0.3, 0.015}};
  const Inertial solids[7] = {{3.8,
                               {0.0291, 0.0126, 0.1363},
                               {0, 0.4, 0},
                               0.01682,
                               0.01580,
                               0.00696,
                               0.00015,
                               0.00074,
                               -0.00169},
                              {3.6,
                               {0.0023, -0.1632, 0.0326},
                               {0.1, -0.2, 0.3},
                               0.02802,
                               0.00598,
                               0.03032,
                               -0.00709,
                               0.00093,
                               0.00281},
                              {2.6,
                               {0.0483, -0.0127, 0.1577},
                               {0, 0.43, 0.25},
                               0.010220,
                               0.009094,
                               0.003552,
                               -0.000303,
                               0.000454,
                               0.001510},
                              {2.1,
                               {-0.0286, 0.0362, 0.1125},
                               {-0.35, 0.2, 0},
                               0.007382,
                               0.006665,
                               0.004635,
                               -0.001690,
                               0.002261,
                               0.003035},
                              {1.5,
                               {0.0364, 0.008, 0.0831},
                               {0.2, 0.65, -0.1},
                               0.004871,
                               0.004503,
                               0.001723,
                               0.000359,
                               0.000952,
                               -0.001171},
                              {1.2,
                               {0.02, -0.005, 0.0025},
                               {0, 0, 0.5},
                               0.000811,
                               0.000703,
                               0.001062,
                               0.000027,
                               -0.000016,
                               0.000033},
                              {0.5,
                               {0.0024, 0.003, 0.015},
                               {0.3, 0, 0.7},
                               0.000114,
                               0.000135,
                               0.000179,
                               -0.000003,
                               0.000001,
                               0.000015}};
  TreeSpec tree;
  tree.name = "arm7";
  tree.links.push_back(base.link("base"));
  for (int i = 0; i < 7; ++i) {
    const std::string number = std::to_string(i + 1);
    const Hinge& hinge = hinges[i];
    JointSpec joint;
    joint.name = "joint_" + number;
    joint.type = JointType::Revolute;
    joint.parent_link = tree.links.back().name;
    joint.child_link = "link_" + number;
    joint.placement = placement(hinge.xyz, hinge.rpy);
    joint.axis = hinge.axis;
    joint.lower = hinge.lower;
    joint.upper = hinge.upper;
    joint.effort_limit = hinge.effort;
    joint.velocity_limit = hinge.velocity;
    joint.damping = hinge.damping;
    joint.friction = hinge.friction;
    joint.armature = hinge.armature;
    tree.joints.push_back(joint);
    tree.links.push_back(solids[i].link(joint.child_link));
  }
  JointSpec bolts;
  bolts.name = "flange_joint";
  bolts.parent_link = "link_7";
  bolts.child_link = "flange";
  bolts.placement.translation().z() = 0.03;
  tree.joints.push_back(bolts);
  tree.links.push_back(flange.link("flange"));
  return tree;
}

/// Options with a fixed base, or a floating base 0.5 m up, and the frame of the tool.
inline ModelOptions options(Base base) {
  ModelOptions options;
  options.base = base;
  if (base == Base::FreeFlyer) options.base_placement.translation().z() = 0.5;
  options.frames = {{"tool", "flange", placement({0, 0, 0.12}, {0, 0, 0.785398})}};
  return options;
}
inline Model model(Base base) { return build_model(tree(), options(base)); }

/// Posture "ready" on a fixed base: the probe points down.
inline Eigen::VectorXd ready() {
  return Eigen::Vector<double, 7>(0.07, 0.23, -0.19, -1.94, 0.23, -0.67, 0.3);
}

}  // namespace arm7

}  // namespace burnish::test
