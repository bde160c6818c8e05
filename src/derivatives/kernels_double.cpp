// Kernels for one state at a time.
#include "derivatives/constrained_derivatives.tpp"

namespace burnish {
template class ConstrainedDynamics<double>;
template class ConstrainedDerivatives<double>;
}  // namespace burnish
