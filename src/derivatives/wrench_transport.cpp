#include "derivatives/wrench_transport.hpp"

namespace burnish {
namespace {

/// Which entries of v move a body that one of a contact's may be: their axes are looked up there.
class AxesOfBody {
 public:
  AxesOfBody(const Model& model, const CompiledContact& contact, int body)
      : is_tool_(body == contact.tool_body), is_base_(body == contact.base_body) {
    if (body >= 0 && !is_tool_ && !is_base_) others_ = moving_axes(model, body);
  }
  /// `entry` is that of v in the contact, null for none.
  int of(int v, const ContactSupport* entry) const {
    if (is_tool_) return entry == nullptr ? -1 : entry->tool_axis;
    if (is_base_) return entry == nullptr ? -1 : entry->base_axis;
    for (const MovingAxis& k : others_)
      if (k.v == v) return k.axis;
    return -1;
  }

 private:
  bool is_tool_, is_base_;
  std::vector<MovingAxis> others_;
};

}  // namespace

void wrench_entries(const Model& model, const CompiledContact& contact,
                    const CompiledReference& asked, std::vector<WrenchEntry>& out) {
  const AxesOfBody origin(model, contact, asked.origin_body), axes(model, contact, asked.axes_body);
  out.clear();
  auto next = contact.influences.begin();
  for (int v = 0; v < model.nv; ++v) {
    const bool known = next != contact.influences.end() && next->v == v;
    const ContactSupport* const entry = known ? &*next++ : nullptr;
    const WrenchEntry candidate{
        v, known ? entry->reference : ReferenceAxes{}, {origin.of(v, entry), axes.of(v, entry)}};
    if (known || candidate.asked.origin >= 0 || candidate.asked.axes >= 0) out.push_back(candidate);
  }
}

}  // namespace burnish
