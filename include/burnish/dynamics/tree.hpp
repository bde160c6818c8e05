// The model as the kernels read it: constants in plain structs, ancestor lists.
#pragma once

#include <utility>
#include <vector>

#include "burnish/math/spatial.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Constants of one joint and its body. The joint's axis is z of its frame.
struct TreeJoint {
  JointKind kind;
  int parent;            ///< joint index, -1 for the world
  int q, v, nv;          ///< first entry in q and v, number of entries in v
  Mat3<double> R;        ///< joint frame at zero in the parent body
  Vec3<double> p;        ///< m
  double mass;           ///< kg
  Vec3<double> com;      ///< in the body, m
  Sym3<double> inertia;  ///< about com, body axes, kg m^2
};

struct Tree {
  explicit Tree(const Model& model);

  std::vector<TreeJoint> joints;
  std::vector<int> parent_of_v;  ///< previous entry of v on the way to the root, -1 at the root
  std::vector<int> joint_of_v;
  std::vector<double> armature;  ///< per entry of v
  Vec3<double> gravity;          ///< m/s^2, world axes
  int nq = 0, nv = 0;

  /// Whether entries of v have so many relatives on the ways to the root and to the tips that
  /// articulated bodies are cheaper than sparse matrices (articulated.hpp).
  bool deep = false;

  int bodies() const { return static_cast<int>(joints.size()); }
  /// Maximal chains [first, end) of entries of v in which each but the first hangs on the one
  /// before it and each but the last carries that one alone; ascending.
  std::vector<std::pair<int, int>> chains() const;
};

}  // namespace burnish
