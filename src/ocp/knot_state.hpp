// Quantities of a knot that all its residuals share: kinematics and contact solution.
#pragma once

#include "burnish/ocp/node_view.hpp"
#include "contact/constrained_dynamics.hpp"
#include "derivatives/momentum.hpp"
#include "dynamics/frame_kinematics.hpp"

namespace burnish::ocp {

/// Returns the rotation in nine target entries, stored by columns.
template <class S>
Mat3<S> rotation_of(const S* entries) {
  return {{entries[0], entries[1], entries[2]},
          {entries[3], entries[4], entries[5]},
          {entries[6], entries[7], entries[8]}};
}

/// Number of target entries of a surface: xx, xy, xz, yy, yz and zz of Q, then b (3) and c.
constexpr int surface_size = 10;
/// Returns a surface from its target entries `n`. Omits c, which CurvedSurface does not contain.
template <class S>
CurvedSurface<S> surface_of(const S* n) {
  return {{{n[0], n[1], n[2]}, {n[1], n[3], n[4]}, {n[2], n[4], n[5]}}, {n[6], n[7], n[8]}};
}

/// State, forces and derivatives at one knot, filled by StageDynamics. Pointers that the stage does
/// not need are null.
template <class S>
struct KnotState {
  const StateLayout* layout = nullptr;
  const S* q = nullptr;             ///< Configuration, nq entries
  const S* v = nullptr;             ///< Velocity, nv entries
  const S* torque_state = nullptr;  ///< Torques in the state, `filtered` entries
  const S* force_before = nullptr;  ///< Force states: contact forces of the previous step
  const S* u = nullptr;             ///< Control, nu entries
  const S* tau = nullptr;           ///< Torques of the actuators, nv entries
  const ConstrainedDynamics<S>* dynamics = nullptr;
  bool solved = false;                    ///< Whether a and lambda of `dynamics` are valid
  const FrameState<S>* frames = nullptr;  ///< States of the stage's frames, in their order
  const CompiledFrame* compiled_frames = nullptr;
  const Momentum<S>* momentum = nullptr;
  const S* targets = nullptr;  ///< Target entries of the stage
  S per_second{0.0};           ///< KnotTime::per_second
  S step_ratio{1.0};           ///< KnotTime::step_ratio
  S decaying{0.0};             ///< KnotTime::decaying
  S* scratch = nullptr;        ///< Memory for residuals, 6 x nz

  // Valid only after StageDynamics::derivatives():
  const S* da_dz = nullptr;       ///< Derivative of a, nv x nz, row-major
  const S* dlambda_dz = nullptr;  ///< Derivative of lambda, active rows x nz, row-major
  const MomentumDerivatives<S>* momentum_derivatives = nullptr;
};

}  // namespace burnish::ocp
