// Trees for tests, and textbook computation of their link placements.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "burnish/model/model.hpp"
#include "burnish/model/state.hpp"
#include "model/posture.hpp"

namespace burnish::testing {

inline double uniform(std::mt19937_64& generator, double lower, double upper) {
  return lower + (upper - lower) * static_cast<double>(generator() >> 11) * 0x1.0p-53;
}

inline Eigen::Vector3d random_vector(std::mt19937_64& generator) {
  Eigen::Vector3d result;
  for (int i = 0; i < 3; ++i) result[i] = uniform(generator, -1.0, 1.0);
  return result;
}

inline Eigen::Isometry3d random_placement(std::mt19937_64& generator) {
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d turn = 3.0 * random_vector(generator);
  placement.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  placement.translation() = random_vector(generator);
  return placement;
}

/// Solid of four random point masses: physical by construction.
inline InertiaSpec random_inertia(std::mt19937_64& generator) {
  InertiaSpec result;
  const Eigen::Vector3d points[4] = {random_vector(generator), random_vector(generator),
                                     random_vector(generator), random_vector(generator)};
  double mass[4];
  for (int i = 0; i < 4; ++i) {
    mass[i] = uniform(generator, 0.2, 1.0);
    result.mass += mass[i];
    result.com += mass[i] * points[i];
  }
  result.com /= result.mass;
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector3d arm = points[i] - result.com;
    result.inertia_at_com +=
        mass[i] * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
  }
  return result;
}

inline LinkSpec link(const std::string& name, double mass = 1.0) {
  LinkSpec result;
  result.name = name;
  result.inertia.mass = mass;
  result.inertia.inertia_at_com = 0.1 * mass * Eigen::Matrix3d::Identity();
  return result;
}

inline JointSpec joint(const std::string& name, JointType type, const std::string& parent,
                       const std::string& child,
                       const Eigen::Vector3d& axis = Eigen::Vector3d::UnitZ()) {
  JointSpec result;
  result.name = name;
  result.type = type;
  result.parent_link = parent;
  result.child_link = child;
  result.axis = axis;
  result.placement.translation() = Eigen::Vector3d(0.1, 0.2, 0.3);
  return result;
}

/// Tree named after its file, with two branches:
/// base -b-> b, base -a(fixed)-> a, a -d-> d, a -c-> c, b -e-> e
inline TreeSpec branching_tree() {
  TreeSpec tree;
  tree.name = "branches";
  tree.source = "branches.urdf";
  for (const char* name : {"base", "a", "b", "c", "d", "e"}) tree.links.push_back(link(name));
  tree.joints = {
      joint("b", JointType::Revolute, "base", "b"), joint("a", JointType::Fixed, "base", "a"),
      joint("d", JointType::Prismatic, "a", "d"), joint("c", JointType::Revolute, "a", "c"),
      joint("e", JointType::Continuous, "b", "e")};
  return tree;
}

/// Two links of equal length [m] that turn about z; stretched along x at zero.
inline TreeSpec two_links(double length = 1.0) {
  TreeSpec tree;
  tree.name = "two links";
  for (const char* name : {"root", "upper", "lower", "tip"}) tree.links.push_back(link(name));
  tree.joints = {joint("shoulder", JointType::Revolute, "root", "upper"),
                 joint("elbow", JointType::Revolute, "upper", "lower"),
                 joint("wrist", JointType::Fixed, "lower", "tip")};
  for (JointSpec& spec : tree.joints)
    spec.placement.translation() = Eigen::Vector3d(length, 0.0, 0.0);
  return tree;
}

inline const std::vector<JointType>& all_joint_types() {
  static const std::vector<JointType> types = {
      JointType::Fixed,  JointType::Revolute, JointType::Continuous, JointType::Prismatic,
      JointType::Planar, JointType::Floating, JointType::Ball};
  return types;
}

/// `count` joints of all types in turn, each on a random earlier link, with random axes, placements
/// and masses. Names are not in the order of the tree.
inline TreeSpec random_tree(std::mt19937_64& generator, int count) {
  TreeSpec tree;
  tree.name = "random";
  tree.links.push_back({"link_0", random_inertia(generator), {}});
  for (int i = 1; i <= count; ++i) {
    const std::string child = "link_" + std::to_string(i);
    const auto parent = generator() % static_cast<std::uint64_t>(i);
    const auto type = static_cast<std::size_t>(i) % all_joint_types().size();
    JointSpec spec = joint("joint_" + std::to_string((i * 7) % 97) + "_" + std::to_string(i),
                           all_joint_types()[type], "link_" + std::to_string(parent), child,
                           random_vector(generator).normalized());
    spec.placement = random_placement(generator);
    tree.joints.push_back(spec);
    tree.links.push_back({child, random_inertia(generator), {}});
  }
  return tree;
}

/// Lets about half of the one-coordinate joints follow another joint anywhere in the tree, directly
/// or through others.
inline TreeSpec with_random_followers(TreeSpec tree, std::mt19937_64& generator) {
  std::vector<JointSpec*> single;
  for (JointSpec& spec : tree.joints)
    if (posture_size(spec.type) == 1) single.push_back(&spec);
  std::shuffle(single.begin(), single.end(), generator);
  for (std::size_t i = 1; i < single.size(); ++i) {
    if (generator() % 2 == 0) continue;
    const JointSpec& leader = *single[generator() % i];
    const bool whole = single[i]->type == JointType::Continuous ||
                       leader.type == JointType::Continuous || leader.mimic.has_value();
    const double multiplier = uniform(generator, -2.5, 2.5);
    if (single[i]->type == JointType::Prismatic && whole) continue;
    single[i]->mimic = MimicSpec{leader.name, whole ? std::round(multiplier) : multiplier,
                                 uniform(generator, -1.0, 1.0)};
  }
  return tree;
}

/// Random values for every moving joint, and the base.
inline Posture random_posture(const TreeSpec& tree, std::mt19937_64& generator) {
  Posture posture;
  const auto fill = [&](const std::string& name, std::size_t size) {
    std::vector<double>& values = posture[name];
    for (std::size_t i = 0; i < size; ++i) values.push_back(uniform(generator, -2.0, 2.0));
    if (size == 7 || size == 4) Eigen::Map<Eigen::Vector4d>(values.data() + size - 4).normalize();
  };
  for (const JointSpec& spec : tree.joints) {
    if (spec.type != JointType::Fixed) fill(spec.name, posture_size(spec.type));
  }
  return posture;
}

/// Placement of every link in the world, joint by joint as the description format defines it, for
/// any order of the joints.
inline std::map<std::string, Eigen::Isometry3d> link_placements(
    const TreeSpec& tree, const Posture& posture, const std::string& root,
    const Eigen::Isometry3d& base = Eigen::Isometry3d::Identity()) {
  std::map<std::string, Eigen::Isometry3d> placed = {{root, base}};
  while (placed.size() < tree.links.size()) {
    for (const JointSpec& spec : tree.joints) {
      const auto parent = placed.find(spec.parent_link);
      if (parent == placed.end() || placed.contains(spec.child_link)) continue;
      Eigen::Isometry3d moved = spec.placement;
      const auto values = posture.find(spec.name);
      if (values != posture.end()) moved = moved * displacement(spec, values->second);
      placed.emplace(spec.child_link, parent->second * moved);
    }
  }
  return placed;
}

/// Placement of every body in the world.
inline std::vector<Eigen::Isometry3d> body_placements(const Model& model,
                                                      const Eigen::VectorXd& q) {
  std::vector<Eigen::Isometry3d> placed;
  for (const Joint& spec : model.joints) {
    const auto values = q.segment(spec.q_index, spec.nq);
    Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    if (spec.kind == JointKind::Revolute) {
      turn = Eigen::AngleAxisd(values[0], Eigen::Vector3d::UnitZ()).toRotationMatrix();
    } else if (spec.kind == JointKind::Continuous || spec.kind == JointKind::Planar) {
      const double c = values[spec.nq - 2], s = values[spec.nq - 1];
      turn << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
      if (spec.kind == JointKind::Planar) moved.translation().head<2>() = values.head<2>();
    } else if (spec.kind == JointKind::Prismatic) {
      moved.translation().z() = values[0];
    } else {
      if (spec.kind == JointKind::FreeFlyer) moved.translation() = values.head<3>();
      turn = Eigen::Quaterniond(Eigen::Vector4d(values.tail<4>())).toRotationMatrix();
    }
    moved.linear() = turn;
    const Eigen::Isometry3d at_zero =
        spec.parent < 0 ? spec.placement
                        : placed[static_cast<std::size_t>(spec.parent)] * spec.placement;
    placed.push_back(at_zero * moved);
  }
  return placed;
}

inline Eigen::Isometry3d frame_placement(const Model& model, const Eigen::VectorXd& q,
                                         const std::string& name) {
  const Frame& frame = model.frames[static_cast<std::size_t>(model.frame_index(name))];
  if (frame.body < 0) return frame.placement;
  return body_placements(model, q)[static_cast<std::size_t>(frame.body)] * frame.placement;
}

}  // namespace burnish::testing
