// Centre of mass, momentum and energy of the whole robot. Links that are fixed to the world are
// left out. Rotors (armature) contribute only to the kinetic energy, as in the mass matrix.
#pragma once

#include <vector>

#include "dynamics/kinematics.hpp"

namespace burnish {

/// Momentum and energy, filled by update_momentum. Vectors are in world axes; motions and forces
/// are about the world's origin.
template <class S>
struct Momentum {
  explicit Momentum(const Tree& tree);
  /// Updates `mass` and `inverse_mass`; call it after a change of the mass of a body.
  void set_mass(const Tree& tree);

  std::vector<Inertia<S>> composite;         ///< Inertia I^C of the subtree of each body
  std::vector<Force<S>> composite_momentum;  ///< Momentum h^C of the subtree of each body
  Vec3<S> first_moment;                      ///< Mass times centre of mass [kg m]
  Vec3<S> com;                               ///< Centre of mass; zero for a massless robot [m]
  Vec3<S> com_velocity;                      ///< Velocity of the centre of mass [m/s]
  Force<S> total;       ///< Momentum about the world's origin [kg m/s, kg m^2/s]
  Force<S> centroidal;  ///< Momentum about the centre of mass [kg m/s, kg m^2/s]
  S kinetic;            ///< Kinetic energy v^T M v / 2, armature included [J]
  S potential;          ///< Potential energy -mass gravity . com, zero at the world's origin [J]
  double mass = 0.0;    ///< Total mass, set by the constructor and set_mass [kg]
  double inverse_mass = 0.0;  ///< 1 / mass; zero for a massless robot [1/kg]
};

/// Computes `momentum` from the kinematics and v (nv).
template <class S>
void update_momentum(const Tree& tree, const Kinematics<S>& kinematics, const S* v,
                     Momentum<S>& momentum);

}  // namespace burnish
