// Contact kernels for automatic differentiation, compiled once for all tests.
#include "derivatives/constrained_derivatives.tpp"
#include "support/autodiff.hpp"

namespace burnish {
template class ConstrainedDynamics<test::Dual>;
}  // namespace burnish
