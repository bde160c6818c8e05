// Kernels of frame and momentum derivatives, for one state at a time and for packs.
#include "derivatives/frame_kinematics.tpp"
#include "derivatives/momentum.tpp"
#include "math/pack.hpp"

#define BURNISH_STATE_KERNELS(S)                                                                 \
  template void frame_velocity_derivative(const CompiledFrame&, const FrameReference<S>&,        \
                                          const Kinematics<S>&, const FrameState<S>&, S*, int);  \
  template void frame_acceleration_derivatives(const CompiledFrame&, const FrameReference<S>&,   \
                                               const Kinematics<S>&, const InverseDynamics<S>&,  \
                                               const FrameState<S>&, StateDerivatives<S>);       \
  template void frame_position_derivative(const CompiledFrame&, const Kinematics<S>&,            \
                                          const FrameState<S>&, S*, int);                        \
  template void frame_rotation_derivative(const CompiledFrame&, const Kinematics<S>&,            \
                                          const FrameState<S>&, S*, int);                        \
  template void frame_rotation_error_derivative(const CompiledFrame&, const Kinematics<S>&,      \
                                                const FrameState<S>&, const FrameError<S>&, S*,  \
                                                int);                                            \
  template void frame_placement_error_derivative(const CompiledFrame&, const Kinematics<S>&,     \
                                                 const FrameState<S>&, const FrameError<S>&, S*, \
                                                 int);                                           \
  template struct MomentumDerivatives<S>;                                                        \
  template void momentum_derivatives(const Tree&, const Kinematics<S>&, const Momentum<S>&,      \
                                     const S*, MomentumDerivatives<S>&);                         \
  template void gravity_torque(const Tree&, const Kinematics<S>&, const Momentum<S>&, S*)

namespace burnish {
BURNISH_STATE_KERNELS(double);
BURNISH_STATE_KERNELS(NativePack);
}  // namespace burnish

#undef BURNISH_STATE_KERNELS
