#include "derivatives/wrench_transport.hpp"

namespace burnish {

void wrench_entries(const Tree& tree, const CompiledContact& contact,
                    const CompiledReference& asked, std::vector<WrenchEntry>& out) {
  out.clear();
  auto next = contact.influences.begin();
  for (int v = 0; v < tree.nv; ++v) {
    const bool known = next != contact.influences.end() && next->v == v;
    const ContactSupport none{v, -1, -1};
    const ContactSupport& own = known ? *next++ : none;
    WrenchEntry entry{
        v,
        own.reference,
        {moving_axis(tree, asked.origin_body, v), moving_axis(tree, asked.axes_body, v)}};
    if (asked.is_curved) entry.asked.tool = moving_axis(tree, asked.tool_body, v);
    if (contact.reference.is_curved || contact.rubs) {
      entry.tool_axis = own.tool_axis;
      entry.base_axis = own.base_axis;
    }
    const ReferenceAxes& by = entry.asked;
    if (known || by.origin >= 0 || by.axes >= 0 || by.tool >= 0) out.push_back(entry);
  }
}

}  // namespace burnish
