// Instantiates the kernels for packs, with one knot per lane.
#include "ocp/kernels.hpp"
#include "ocp/node_kernel.tpp"

namespace burnish::ocp {
extern template class StageDynamics<double>;
extern template class LaneView<double>;
template class StageDynamics<NativePack>;
template class LaneView<NativePack>;
template class CustomLanes<NativePack>;
template class NodeKernel<NativePack>;
}  // namespace burnish::ocp
