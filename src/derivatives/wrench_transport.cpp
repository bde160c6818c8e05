#include "derivatives/wrench_transport.hpp"

namespace burnish {

void wrench_entries(const Tree& tree, const CompiledContact& contact,
                    const CompiledReference& requested, std::vector<WrenchEntry>& out) {
  out.clear();
  auto next = contact.influences.begin();
  for (int v = 0; v < tree.nv; ++v) {
    const bool has_influence = next != contact.influences.end() && next->v == v;
    const ContactSupport none{v, -1, -1};
    const ContactSupport& own = has_influence ? *next++ : none;
    WrenchEntry entry{
        v,
        own.reference,
        {moving_axis(tree, requested.origin_body, v), moving_axis(tree, requested.axes_body, v)}};
    if (requested.is_curved) entry.requested.tool = moving_axis(tree, requested.tool_body, v);
    if (contact.reference.is_curved || contact.has_friction) {
      entry.tool_axis = own.tool_axis;
      entry.base_axis = own.base_axis;
    }
    const ReferenceAxes& by = entry.requested;
    if (has_influence || by.origin >= 0 || by.axes >= 0 || by.tool >= 0) out.push_back(entry);
  }
}

}  // namespace burnish
