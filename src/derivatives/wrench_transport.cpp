#include "derivatives/wrench_transport.hpp"

namespace burnish {

void wrench_entries(const Tree& tree, const CompiledContact& contact,
                    const CompiledReference& asked, std::vector<WrenchEntry>& out) {
  out.clear();
  auto next = contact.influences.begin();
  for (int v = 0; v < tree.nv; ++v) {
    const bool known = next != contact.influences.end() && next->v == v;
    const ContactSupport none{v, -1, -1};
    const ContactSupport& by = known ? *next++ : none;
    WrenchEntry entry{
        v,
        by.reference,
        {moving_axis(tree, asked.origin_body, v), moving_axis(tree, asked.axes_body, v)}};
    if (contact.reference.is_curved || contact.rubs) {
      entry.tool_axis = by.tool_axis;
      entry.base_axis = by.base_axis;
    }
    if (known || entry.asked.origin >= 0 || entry.asked.axes >= 0) out.push_back(entry);
  }
}

}  // namespace burnish
