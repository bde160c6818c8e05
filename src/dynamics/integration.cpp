// Instantiations of the arithmetic on configurations for one state (double) and for one state per
// lane.
#include "dynamics/integration.tpp"

#include "math/pack.hpp"

#define BURNISH_INTEGRATION_KERNELS(S)                                         \
  template void integrate_configuration(const Tree&, const S*, const S*, S*);  \
  template void difference_configuration(const Tree&, const S*, const S*, S*); \
  template void integrate_jacobians(const TangentBlock&, const S*, S*, S*);    \
  template void difference_jacobians(const TangentBlock&, const S*, S*, S*)

namespace burnish {

std::vector<TangentBlock> tangent_blocks(const Tree& tree) {
  std::vector<TangentBlock> blocks;
  for (const TreeJoint& joint : tree.joints)
    if (joint.nv > 1) blocks.push_back({joint.v, joint.nv, joint.kind, joint.q});
  return blocks;
}

BURNISH_INTEGRATION_KERNELS(double);
BURNISH_INTEGRATION_KERNELS(NativePack);
}  // namespace burnish

#undef BURNISH_INTEGRATION_KERNELS
