#include "burnish/contact/contact_set.hpp"

#include <algorithm>
#include <set>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "contact/compiled_contact.hpp"
#include "contact/descriptions.gen.hpp"
#include "contact/row_size.hpp"
#include "dynamics/reference.hpp"

namespace burnish {
namespace {

/// Returns the result of make(). Puts the contact's name and `what` before an error message.
auto compiled(const ContactSpec& spec, const char* what, const auto& make) {
  try {
    return make();
  } catch (const Error& error) {
    throw Error("contact '" + spec.name + "': " + what + ": " + error.what());
  }
}

void check(const ContactSpec& spec) {
  const std::string who = "contact '" + spec.name + "': ";
  if (spec.directions.bits == 0 || spec.directions.bits > 63)
    throw Error(who + "the set of directions is empty; wanted at least one of x,y,z,rx,ry,rz");
  const Reference& reference = spec.reference;
  reference.check("contact '" + spec.name + "'");
  if (reference.quadric && (reference.origin != Anchor::Tool || reference.axes != Anchor::Base))
    throw Error(who + "the reference with a curved surface is '" + reference.name() +
                "'; wanted a reference at the tool with axes of the base, such as from "
                "Reference::on");
  const Eigen::Matrix3d T = spec.target.linear();
  if (!spec.target.matrix().allFinite() ||
      (T.transpose() * T - Eigen::Matrix3d::Identity()).norm() > 1e-6 || T.determinant() < 0.0)
    throw Error(who + "the target is not a pose; wanted finite numbers and a rotation matrix");
  if (!spec.kp.allFinite() || !spec.kd.allFinite() || spec.kp.minCoeff() < 0.0 ||
      spec.kd.minCoeff() < 0.0)
    throw Error(who + "a gain is negative or not finite; wanted kp, kd >= 0");
  if (!spec.friction) return;
  check_ranges(description_of(&*spec.friction), &*spec.friction,
               [&](const std::string& entry) { return who + "friction: " + entry; });
  const Directions held{
      static_cast<std::uint8_t>(spec.directions.bits & Directions::linear().bits)};
  if (held.count() != 1)
    throw Error(who + "the contact has friction, " +
                (held.bits == 0 ? std::string("but none of its directions is a translation")
                                : "and its directions of translation are " + held.text()) +
                "; wanted exactly one of x, y and z (the direction in which the contact presses)");
}

std::vector<ContactSupport> influences(const Model& model, const CompiledContact& contact) {
  std::vector<ContactSupport> result;
  const std::vector<MovingAxis> tool = moving_axes(model, contact.tool_body);
  const std::vector<MovingAxis> base = moving_axes(model, contact.base_body);
  const std::vector<MovingAxis> origin = moving_axes(model, contact.reference.origin_body);
  const std::vector<MovingAxis> axes = moving_axes(model, contact.reference.axes_body);
  const auto axis_of = [](const std::vector<MovingAxis>& entries, int k) {
    const auto same = [k](const MovingAxis& entry) { return entry.v == k; };
    const auto found = std::find_if(entries.begin(), entries.end(), same);
    return found == entries.end() ? -1 : found->axis;
  };
  for (int k = 0; k < model.nv; ++k) {
    const ReferenceAxes reference{axis_of(origin, k), axis_of(axes, k)};
    const ContactSupport entry{k, axis_of(tool, k), axis_of(base, k), reference};
    if (entry.moves_tool() || entry.moves_base() || reference.origin >= 0 || reference.axes >= 0)
      result.push_back(entry);
  }
  return result;
}

std::vector<int> with_ancestors(const Model& model, const std::vector<ContactSupport>& support) {
  std::set<int> entries;
  for (const ContactSupport& entry : support) {
    for (int k = entry.v; k >= 0 && entries.insert(k).second;) k = model.parent_of_v[to_size(k)];
  }
  return {entries.begin(), entries.end()};
}

CompiledContact compile(const Model& model, const ContactSpec& spec) {
  check(spec);
  CompiledContact c;
  c.spec = spec;
  const auto frame = [&](const std::string& name) {
    return [&] { return compile_frame(model, name); };
  };
  const CompiledFrame tool = compiled(spec, "tool frame", frame(spec.tool));
  const CompiledFrame base = compiled(spec, "base frame", frame(spec.base));
  if (tool.body == base.body)
    throw Error("contact '" + spec.name + "': tool '" + spec.tool + "' and base '" + spec.base +
                "' are on the same body; wanted frames that a joint moves relative to each other");
  c.tool_body = tool.body;
  c.base_body = base.body;
  c.tool_R = tool.R;
  c.tool_p = tool.p;
  c.base_R = base.R;
  c.base_p = base.p;
  c.reference = compiled(spec, "reference",
                         [&] { return compile_reference(model, spec.reference, tool, base); });
  c.target_R = from_eigen(Eigen::Matrix3d(spec.target.linear()));
  c.target_p = from_eigen(Eigen::Vector3d(spec.target.translation()));
  c.has_friction = spec.friction.has_value();
  c.proportional = c.damped = c.holds_rotation = false;
  for (int d = 0; d < 6; ++d) {
    if (!spec.directions.has(d)) continue;
    c.directions.push_back(d);
    c.proportional = c.proportional || spec.kp[d] > 0.0;
    c.damped = c.damped || spec.kd[d] > 0.0;
    c.holds_rotation = c.holds_rotation || d >= 3;
  }
  c.influences = influences(model, c);
  const auto moves_contact = [](const ContactSupport& k) {
    return k.moves_tool() || k.moves_base();
  };
  std::copy_if(c.influences.begin(), c.influences.end(), std::back_inserter(c.support),
               moves_contact);
  c.coupled = with_ancestors(model, c.support);
  c.influenced = with_ancestors(model, c.influences);
  set_reaches(model, c);
  return c;
}

}  // namespace

void ContactSolver::check() const {
  check_ranges(description_of(this), this,
               [](const std::string& entry) { return "contact solver: " + entry; });
}

void check_has_friction(const std::string& call, const CompiledContact& contact) {
  if (!contact.has_friction)
    throw Error(call + ": contact '" + contact.spec.name +
                "' has no friction; wanted a contact with ContactSpec::friction");
}

CompiledFrame tool_of(const CompiledContact& contact) {
  return {contact.tool_body, contact.tool_R, contact.tool_p, {}};
}
CompiledFrame base_of(const CompiledContact& contact) {
  return {contact.base_body, contact.base_R, contact.base_p, {}};
}

CompiledReference compile_reference(const Model& model, const Reference& reference,
                                    const CompiledContact& contact) {
  return compile_reference(model, reference, tool_of(contact), base_of(contact));
}

std::vector<ContactSpec> contacts_at(std::vector<ContactSpec> contacts, double time) {
  for (ContactSpec& contact : contacts) {
    const std::string who =
        "contact '" + (contact.name.empty() ? contact.tool : contact.name) + "'";
    contact.reference.check(who);
    try {
      contact.reference = contact.reference.at(time);
    } catch (const Error& error) {
      throw Error(who + ": reference: " + error.what());
    }
  }
  return contacts;
}

ContactSet::ContactSet() : contacts_(std::make_shared<const std::vector<CompiledContact>>()) {}

ContactSet::ContactSet(const Model& model, const std::vector<ContactSpec>& specs) {
  if (specs.size() > max_contacts)
    throw Error("there are " + std::to_string(specs.size()) + " contacts; wanted at most " +
                std::to_string(max_contacts));
  std::vector<CompiledContact> compiled;
  for (ContactSpec spec : specs) {
    if (spec.name.empty()) spec.name = spec.tool;
    for (const CompiledContact& other : compiled)
      if (other.spec.name == spec.name)
        throw Error("contact '" + spec.name +
                    "': another contact has this name; wanted a unique name for each contact");
    compiled.push_back(compile(model, spec));
    rows_ += static_cast<int>(compiled.back().directions.size());
  }
  size_ = static_cast<int>(compiled.size());
  contacts_ = std::make_shared<const std::vector<CompiledContact>>(std::move(compiled));
}

std::vector<ContactSpec> ContactSet::specs() const {
  std::vector<ContactSpec> specs;
  for (const CompiledContact& contact : *contacts_) specs.push_back(contact.spec);
  return specs;
}

int ContactSet::index(const std::string& name) const {
  std::vector<std::string> existing;
  for (const CompiledContact& contact : *contacts_) {
    if (contact.spec.name == name) return static_cast<int>(existing.size());
    existing.push_back(contact.spec.name);
  }
  throw Error("unknown contact '" + name + "'" + did_you_mean(name, existing));
}

std::vector<std::string> ContactSet::row_names() const {
  std::vector<std::string> names;
  for (const CompiledContact& contact : *contacts_)
    for (const int d : contact.directions)
      names.push_back(contact.spec.name + "/" + std::string(direction_names[d]));
  return names;
}

}  // namespace burnish
