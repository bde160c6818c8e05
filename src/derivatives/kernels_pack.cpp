// The kernels for one state per lane.
#include "burnish/math/pack.hpp"
#include "derivatives/constrained_derivatives.tpp"

namespace burnish {
template class ConstrainedDynamics<NativePack>;
template class ConstrainedDerivatives<NativePack>;
}  // namespace burnish
