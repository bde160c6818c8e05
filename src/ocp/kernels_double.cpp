// Instantiates the kernels for one knot at a time.
#include "ocp/kernels.hpp"
#include "ocp/node_kernel.tpp"

namespace burnish::ocp {
template class StageDynamics<double>;
template class LaneView<double>;
template class CustomLanes<double>;
template class NodeKernel<double>;
}  // namespace burnish::ocp
