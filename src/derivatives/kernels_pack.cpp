// Kernels for packs: one state per lane.
#include "derivatives/constrained_derivatives.tpp"
#include "math/pack.hpp"

namespace burnish {
template class ConstrainedDynamics<NativePack>;
template class ConstrainedDerivatives<NativePack>;
}  // namespace burnish
