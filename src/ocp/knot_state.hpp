// What the residuals of a knot share: one kinematics, one contact solve.
#pragma once

#include "burnish/ocp/node_view.hpp"
#include "contact/constrained_dynamics.hpp"
#include "derivatives/momentum.hpp"
#include "dynamics/frame_kinematics.hpp"

namespace burnish::ocp {

/// Nine entries by columns, as targets hold a rotation.
template <class S>
Mat3<S> rotation_of(const S* entries) {
  return {{entries[0], entries[1], entries[2]},
          {entries[3], entries[4], entries[5]},
          {entries[6], entries[7], entries[8]}};
}

/// Ten entries, as targets hold a surface: Q, of which xx, xy, xz, yy, yz and zz, b and c.
constexpr int surface_size = 10;
template <class S>
CurvedSurface<S> surface_of(const S* n) {
  return {{{n[0], n[1], n[2]}, {n[1], n[3], n[4]}, {n[2], n[4], n[5]}}, {n[6], n[7], n[8]}};
}

/// Filled by StageDynamics. Pointers that a stage has no use for are null.
template <class S>
struct KnotState {
  const StateLayout* layout = nullptr;
  const S* q = nullptr;             ///< nq
  const S* v = nullptr;             ///< nv
  const S* torque_state = nullptr;  ///< filtered
  const S* force_before = nullptr;  ///< remembered
  const S* u = nullptr;             ///< nu
  const S* tau = nullptr;           ///< nv, of the actuators
  const ConstrainedDynamics<S>* dynamics = nullptr;
  bool solved = false;                    ///< a and lambda of `dynamics` are those of this knot
  const FrameState<S>* frames = nullptr;  ///< of the stage, in its order
  const CompiledFrame* compiled_frames = nullptr;
  const Momentum<S>* momentum = nullptr;
  const S* targets = nullptr;  ///< of the stage
  S per_second{0.0};           ///< one over the step; 0 where no time passes
  S pace{1.0};                 ///< KnotTime::pace
  S passing{0.0};              ///< KnotTime::passing
  S* scratch = nullptr;        ///< 12 x nv, for a residual that needs room

  // While derivatives are asked for:
  const S* da_dz = nullptr;       ///< nv x nz, row-major
  const S* dlambda_dz = nullptr;  ///< active rows x nz, row-major
  const MomentumDerivatives<S>* momentum_derivatives = nullptr;
};

}  // namespace burnish::ocp
