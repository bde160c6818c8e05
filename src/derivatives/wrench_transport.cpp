#include "derivatives/wrench_transport.hpp"

namespace burnish {

void wrench_entries(const Tree& tree, const CompiledContact& contact,
                    const CompiledReference& asked, std::vector<WrenchEntry>& out) {
  out.clear();
  auto next = contact.influences.begin();
  for (int v = 0; v < tree.nv; ++v) {
    const bool known = next != contact.influences.end() && next->v == v;
    const ReferenceAxes own = known ? next++->reference : ReferenceAxes{};
    const WrenchEntry entry{
        v, own, {moving_axis(tree, asked.origin_body, v), moving_axis(tree, asked.axes_body, v)}};
    if (known || entry.asked.origin >= 0 || entry.asked.axes >= 0) out.push_back(entry);
  }
}

}  // namespace burnish
