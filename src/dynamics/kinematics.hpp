// Placements, twists, inertias and bias forces of all bodies, in world coordinates about the
// world's origin. One forward pass; everything after it reads from here.
#pragma once

#include <vector>

#include "dynamics/tree.hpp"

namespace burnish {

/// Filled by update_kinematics. World axes; motions and forces about the world's origin.
template <class S>
struct BodyState {
  Mat3<S> R;            ///< rotation body -> world
  Vec3<S> p;            ///< origin of the body, m
  Motion<S> v;          ///< twist
  Motion<S> a_bias;     ///< spatial acceleration at zero joint acceleration, minus gravity
  Inertia<S> inertia;   ///< of this body alone
  Force<S> momentum;    ///< inertia * v
  Force<S> force_bias;  ///< inertia * a_bias + v x* momentum
};

/// Per axis k of the tree, and per sum of axes behind them: the joint axis as a motion (a
/// follower's times its multiplier), and its rates.
template <class S>
struct AxisState {
  Motion<S> axis;         ///< S_k
  Motion<S> parent_rate;  ///< psi'_k = v_parent x S_k
  Motion<S> rate_sum;     ///< psi'_k + dS_k/dt
};

template <class S>
struct Kinematics {
  explicit Kinematics(const Tree& tree)
      : bodies(tree.joints.size()), axes(static_cast<std::size_t>(tree.axes) + tree.sums.size()) {}
  std::vector<BodyState<S>> bodies;
  std::vector<AxisState<S>> axes;
};

/// Fills `kinematics` at (q, v): q has nq entries, v nv.
template <class S>
void update_kinematics(const Tree& tree, const S* q, const S* v, Kinematics<S>& kinematics);

}  // namespace burnish
