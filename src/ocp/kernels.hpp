// Declares the explicit instantiations of contact dynamics, to avoid compiling them again.
#pragma once

#include "math/pack.hpp"
#include "ocp/node_kernel.hpp"

namespace burnish {
extern template class ConstrainedDynamics<double>;
extern template class ConstrainedDynamics<NativePack>;
extern template class ConstrainedDerivatives<double>;
extern template class ConstrainedDerivatives<NativePack>;
}  // namespace burnish
