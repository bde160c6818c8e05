// Instantiations of the kernels of this layer for one state (double) and for one state per lane.
#include "dynamics/frame_kinematics.tpp"
#include "dynamics/inverse_dynamics.tpp"
#include "dynamics/kinematics.tpp"
#include "dynamics/mass_matrix.tpp"
#include "dynamics/momentum.tpp"
#include "dynamics/passive.hpp"
#include "math/pack.hpp"

#define BURNISH_DYNAMICS_KERNELS(S)                                                                \
  template void update_kinematics(const Tree&, const S*, const S*, Kinematics<S>&);                \
  template struct MassMatrix<S>;                                                                   \
  template void update_mass_and_bias(const Tree&, const Kinematics<S>&, MassMatrix<S>&);           \
  template struct InverseDynamics<S>;                                                              \
  template void accelerate(const Tree&, const Kinematics<S>&, const S*, InverseDynamics<S>&);      \
  template void inverse_dynamics_sweep(const Tree&, const Kinematics<S>&, const MassMatrix<S>&,    \
                                       const S*, InverseDynamics<S>&);                             \
  template void update_frame(const CompiledFrame&, const Kinematics<S>&, FrameState<S>&);          \
  template void update_frame_acceleration(const Tree&, const CompiledFrame&, const Kinematics<S>&, \
                                          const InverseDynamics<S>&, FrameState<S>&);              \
  template Motion<S> frame_acceleration(const CompiledReference&, const ReferencePose<S>&,         \
                                        const Kinematics<S>&, const FrameState<S>&);               \
  template void frame_jacobian(const CompiledFrame&, const CompiledReference&,                     \
                               const ReferencePose<S>&, const Kinematics<S>&, S*, int);            \
  template FrameError<S> frame_error(const FrameState<S>&, const Mat3<S>&, const Vec3<S>&);        \
  template struct Momentum<S>;                                                                     \
  template void update_momentum(const Tree&, const Kinematics<S>&, const S*, Momentum<S>&)

namespace burnish {
BURNISH_DYNAMICS_KERNELS(double);
BURNISH_DYNAMICS_KERNELS(NativePack);
}  // namespace burnish

#undef BURNISH_DYNAMICS_KERNELS
