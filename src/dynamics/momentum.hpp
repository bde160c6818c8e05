// Centre of mass, momentum and energy of the whole robot. Links that are fixed to the world do not
// count; rotors (armature) count in the kinetic energy alone, as in the mass matrix.
#pragma once

#include <vector>

#include "dynamics/kinematics.hpp"

namespace burnish {

/// Filled by update_momentum. World axes; motions and forces about the world's origin.
template <class S>
struct Momentum {
  explicit Momentum(const Tree& tree);
  /// When a body's mass has become another.
  void set_mass(const Tree& tree);

  std::vector<Inertia<S>> composite;         ///< per body: I^C of its subtree
  std::vector<Force<S>> composite_momentum;  ///< per body: h^C of its subtree
  Vec3<S> first_moment;                      ///< mass times centre of mass, kg m
  Vec3<S> com;                               ///< centre of mass, m; zero for a massless robot
  Vec3<S> com_velocity;                      ///< m/s
  Force<S> total;                            ///< about the world's origin: kg m/s, kg m^2/s
  Force<S> centroidal;                       ///< about the centre of mass
  S kinetic;                                 ///< v^T M v / 2, armature included, J
  S potential;                               ///< -mass gravity . com, zero at the world's origin, J
  double mass = 0.0;                         ///< kg; by set_mass, and when made
  double inverse_mass = 0.0;                 ///< 1/kg; zero for a massless robot
};

/// From the kinematics and v (nv).
template <class S>
void update_momentum(const Tree& tree, const Kinematics<S>& kinematics, const S* v,
                     Momentum<S>& momentum);

}  // namespace burnish
