// Placements, twists, inertias and bias forces of all bodies, in world coordinates about the
// world's origin. They are computed in one forward pass, on which all other kernels build.
#pragma once

#include <vector>

#include "base/to_size.hpp"
#include "dynamics/tree.hpp"

namespace burnish {

/// State of one body, filled by update_kinematics. Vectors are in world axes; motions and forces
/// are about the world's origin.
template <class S>
struct BodyState {
  Mat3<S> R;            ///< Rotation from the body to the world
  Vec3<S> p;            ///< Origin of the body [m]
  Motion<S> v;          ///< Twist
  Motion<S> a_bias;     ///< Spatial acceleration at zero joint acceleration, minus gravity
  Inertia<S> inertia;   ///< Inertia of this body only
  Force<S> momentum;    ///< inertia * v
  Force<S> force_bias;  ///< inertia * a_bias + v x* momentum
};

/// Joint axis as a motion, and its rates. The axis of a follower is scaled by its multiplier.
template <class S>
struct AxisState {
  Motion<S> axis;         ///< S_k
  Motion<S> parent_rate;  ///< psi'_k = v_parent x S_k
  Motion<S> rate_sum;     ///< psi'_k + dS_k/dt
};

/// State of all bodies and axes: first the axes of the tree, then its sums of axes (Tree::sums).
template <class S>
struct Kinematics {
  explicit Kinematics(const Tree& tree)
      : bodies(tree.joints.size()), axes(to_size(tree.axes) + tree.sums.size()) {}
  std::vector<BodyState<S>> bodies;
  std::vector<AxisState<S>> axes;
};

/// Computes `kinematics` at (q, v), where q has nq entries and v has nv.
template <class S>
void update_kinematics(const Tree& tree, const S* q, const S* v, Kinematics<S>& kinematics);

}  // namespace burnish
