// Tendons and equalities: couplings of joints and loops.
#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "mjcf/reading.hpp"
#include "model/posture.hpp"

namespace burnish::mjcf {
namespace {

using Eigen::Isometry3d;

double reference_of(const std::string& joint, const XMLElement& asking, Reading& reading) {
  return reading.coordinate(joint, asking).start.front();
}

JointSpec& joint_of(const std::string& name, const XMLElement& asking, Reading& reading) {
  return reading.tree.joints[reading.coordinate(name, asking).joint];
}

/// Returns a hinge or slide joint by name; other joints cannot be in tendons and couplings.
JointSpec& single_joint(const std::string& name, const XMLElement& asking, Reading& reading) {
  JointSpec& joint = joint_of(name, asking, reading);
  if (posture_size(joint.type) > 1)
    refuse_at(asking, "joint " + in_quotes(name) +
                          " is neither a hinge nor a slide; wanted a hinge or a slide");
  return joint;
}

// ---- Tendons

/// Reads the spring of a tendon. Without a stated rest length, the spring rests at the length
/// `at_rest`, which the tendon has at the rest positions of the joints' springs.
void read_spring(const Item& item, double at_rest, TendonSpec& tendon, Reading& reading) {
  const std::vector<double> stiffness = item.overlaid("stiffness", {0.0});
  tendon.stiffness = stiffness[0];
  tendon.damping = item.overlaid("damping", {0.0})[0];
  tendon.rest = at_rest;
  const XMLElement* at = item.stating("springlength");
  if (at == nullptr) return;
  const std::vector<double> stated = all_numbers(*at, "springlength", place_of(*at));
  if (stated.empty() || stated[0] < 0.0) return;  // -1: rests at `at_rest`
  tendon.rest = stated[0];
  if (stated.size() < 2 || stated[1] == stated[0]) return;
  tendon.stiffness = 0.0;
  reading.warning_notes.note(
      "springs of tendons with two different rest lengths (springlength) are ignored",
      example_of(item.xml()));
}

void note_tendon_omissions(const Item& item, Reading& reading) {
  const auto range = item.numbers("range", 2);
  const bool has_range = range && ((*range)[0] != 0.0 || (*range)[1] != 0.0);
  if (item.choice("limited").value_or(has_range && reading.compiler_of(item.xml()).autolimits))
    reading.warning_notes.note("limits of tendons are ignored", example_of(item.xml()));
  if (item.number("frictionloss", 0.0) != 0.0 || item.number("armature", 0.0) != 0.0)
    reading.warning_notes.note("friction and inertia of tendons are ignored",
                               example_of(item.xml()));
}

void read_fixed(const Item& item, Reading& reading) {
  TendonSpec tendon;
  tendon.name = item.name();
  tendon.line = line_of(item.xml());
  double at_rest = 0.0;
  for (const XMLElement* child : reading.source.children(item.xml())) {
    if (std::string_view(child->Name()) != "joint") continue;
    const std::string name = needed_attribute(*child, "joint", place_of(*child));
    const double coefficient = needed_number(*child, "coef", place_of(*child));
    JointSpec& joint = single_joint(name, *child, reading);
    const double rest = joint.stiffness != 0.0 ? joint.rest : 0.0;
    at_rest += coefficient * rest;
    tendon.parts.push_back({name, coefficient});
  }
  if (tendon.parts.empty()) refuse_at(item.xml(), "it has no joint; wanted at least 1");
  read_spring(item, at_rest, tendon, reading);
  note_tendon_omissions(item, reading);
  reading.tree.tendons.push_back(std::move(tendon));
}

/// Spatial tendons, which a tree cannot represent because their length depends on points of bodies.
/// Warnings name the tendons that affect the motion. A note counts the other tendons.
class SpatialTendons {
 public:
  void look_at(const Item& item, Reading& reading) {
    const bool pulls =
        item.overlaid("stiffness", {0.0})[0] != 0.0 || item.overlaid("damping", {0.0})[0] != 0.0;
    const bool resists =
        item.number("frictionloss", 0.0) != 0.0 || item.number("armature", 0.0) != 0.0;
    const auto range = item.numbers("range", 2);
    const bool has_range = range && ((*range)[0] != 0.0 || (*range)[1] != 0.0);
    const bool stops =
        item.choice("limited").value_or(has_range && reading.compiler_of(item.xml()).autolimits);
    const std::string name = example_of(item.xml());
    if (pulls) pulling_.push_back(name);
    if (stops) stopping_.push_back(name);
    if (resists) resisting_.push_back(name);
    if (!pulls && !stops && !resists)
      reading.info_notes.note("spatial tendons without a spring, a damper or limits are ignored",
                              name);
  }

  void report(Reading& reading) const {
    report("springs and dampers", pulling_, reading);
    report("limits", stopping_, reading);
    report("friction and inertia", resisting_, reading);
  }

 private:
  static void report(const std::string& what, const std::vector<std::string>& names,
                     Reading& reading) {
    constexpr std::size_t max_names = 12;
    std::string list;
    for (std::size_t i = 0; i < std::min(max_names, names.size()); ++i)
      list += (i == 0 ? "" : ", ") + names[i];
    if (names.size() > max_names)
      list += " and " + std::to_string(names.size() - max_names) + " more";
    if (!names.empty()) reading.warning_notes.note(what + " of spatial tendons are ignored", list);
  }

  std::vector<std::string> pulling_, stopping_, resisting_;
};

// ---- Couplings of joints

/// Returns the coupling of a follower's position y to its leader's position x. The reference
/// positions are x0 and y0: y - y0 = a0 + a1 (x - x0).
MimicSpec coupling(const std::string& leader, double a0, double a1, double x0, double y0) {
  return {leader, a1, a0 + y0 - a1 * x0};
}

/// Returns whether joint `name` is `other` or follows it, directly or indirectly.
bool is_led_by(const std::string& name, const std::string& other, const XMLElement& asking,
               Reading& reading) {
  std::string at = name;
  while (at != other) {
    const JointSpec& spec = joint_of(at, asking, reading);
    if (!spec.mimic) return false;
    at = spec.mimic->leader;
  }
  return true;
}

/// Fixes a joint at a value, and its followers at the values that result. Removes the joints from
/// tendons and subtracts their contributions from the tendons' rest lengths.
void fix(JointSpec& joint, double value, Reading& reading) {
  joint.placement = joint.placement * displacement(joint, std::vector<double>{value});
  joint.type = JointType::Fixed;
  joint.mimic.reset();
  joint.held = {value};
  for (TendonSpec& tendon : reading.tree.tendons) {
    for (const TendonSpec::Part& part : tendon.parts)
      if (part.joint == joint.name) tendon.rest -= part.coefficient * value;
    std::erase_if(tendon.parts, [&](const auto& part) { return part.joint == joint.name; });
  }
  std::erase_if(reading.tree.tendons, [](const auto& tendon) { return tendon.parts.empty(); });
  for (JointSpec& other : reading.tree.joints) {
    if (!other.mimic || other.mimic->leader != joint.name) continue;
    fix(other, other.mimic->multiplier * value + other.mimic->offset, reading);
  }
}

void hold(JointSpec& joint, double value, const Item& item, Reading& reading) {
  // A follower is held by holding its leader.
  JointSpec* leader = &joint;
  while (leader->mimic) {
    value = (value - leader->mimic->offset) / leader->mimic->multiplier;
    leader = &joint_of(leader->mimic->leader, item.xml(), reading);
  }
  fix(*leader, value, reading);
  reading.info_notes.note(
      "joints that an equality holds at a constant value are fixed at that value",
      example_of(item.xml()) + " holds joint " + in_quotes(joint.name));
}

/// Fixes the second joint of the coupling second = multiplier * first + offset if the first is
/// held, or the first joint if the second is held.
void couple_to_held(JointSpec& second, JointSpec& first, const MimicSpec& coupling,
                    const Item& item, Reading& reading) {
  if (first.type != JointType::Fixed) {
    const double value = second.held.front();
    return hold(first, (value - coupling.offset) / coupling.multiplier, item, reading);
  }
  if (second.type != JointType::Fixed) {
    const double value = first.held.front();
    return hold(second, coupling.multiplier * value + coupling.offset, item, reading);
  }
  reading.warning_notes.note("equalities of joints that another equality holds already are ignored",
                             example_of(item.xml()));
}

void couple(const Item& item, Reading& reading) {
  const XMLElement& xml = item.xml();
  const std::string follower = needed_attribute(xml, "joint1", place_of(xml));
  const std::vector<double> a = item.overlaid("polycoef", {0.0, 1.0, 0.0, 0.0, 0.0});
  JointSpec& second = single_joint(follower, xml, reading);
  const double y0 = reference_of(follower, xml, reading);
  const auto stated = item.text("joint2");
  const bool is_linear = a[2] == 0.0 && a[3] == 0.0 && a[4] == 0.0;
  if (stated && !is_linear)
    return reading.warning_notes.note("nonlinear couplings of joints are ignored", example_of(xml));
  if (!stated || a[1] == 0.0) {
    if (second.type != JointType::Fixed) return hold(second, y0 + a[0], item, reading);
    return reading.warning_notes.note(
        "equalities of joints that another equality holds already are ignored", example_of(xml));
  }
  const std::string& leader = *stated;
  JointSpec& first = single_joint(leader, xml, reading);
  const double x0 = reference_of(leader, xml, reading);
  const MimicSpec forwards = coupling(leader, a[0], a[1], x0, y0);
  if (first.type == JointType::Fixed || second.type == JointType::Fixed)
    return couple_to_held(second, first, forwards, item, reading);
  if (!second.mimic && !is_led_by(leader, follower, xml, reading)) {
    second.mimic = forwards;
  } else if (!first.mimic && !is_led_by(follower, leader, xml, reading)) {
    // The inverse coupling, with y as leader: x - x0 = (y - y0 - a0) / a1.
    first.mimic = coupling(follower, -a[0] / a[1], 1.0 / a[1], y0, x0);
  } else {
    reading.warning_notes.note("couplings of joints that are coupled already are ignored",
                               example_of(xml));
  }
}

void hold_tendon(const Item& item, Reading& reading) {
  const XMLElement& xml = item.xml();
  const std::string name = needed_attribute(xml, "tendon1", place_of(xml));
  if (item.text("tendon2"))
    return reading.warning_notes.note("equalities of two tendons are ignored", example_of(xml));
  const double a0 = item.overlaid("polycoef", {0.0})[0];
  for (TendonSpec& tendon : reading.tree.tendons) {
    if (tendon.name != name) continue;
    const auto counts = [](const TendonSpec::Part& part) { return part.coefficient != 0.0; };
    if (std::count_if(tendon.parts.begin(), tendon.parts.end(), counts) > 2)
      return reading.warning_notes.note(
          "equalities that hold the length of a tendon along more than two joints are ignored",
          example_of(xml));
    if (tendon.stiffness != 0.0)
      reading.warning_notes.note("springs of tendons whose length is held constant are ignored",
                                 example_of(xml));
    tendon.held = true;
    tendon.stiffness = 0.0;
    tendon.rest = a0;
    for (const TendonSpec::Part& part : tendon.parts)
      tendon.rest += part.coefficient * reference_of(part.joint, xml, reading);
    if (tendon.parts.size() > 1 || tendon.parts[0].coefficient == 0.0) return;
    const TendonSpec::Part only = tendon.parts[0];
    return hold(joint_of(only.joint, xml, reading), tendon.rest / only.coefficient, item, reading);
  }
  reading.warning_notes.note("equalities of ignored tendons are ignored", example_of(xml));
}

// ---- Loops

std::string link_of(const Item& item, const char* attribute, const Reading& reading) {
  const auto stated = item.text(attribute);
  if (!stated || stated->empty()) return world_name;
  if (reading.link_at_start.contains(*stated)) return *stated;
  std::vector<std::string> known;
  for (const auto& [name, pose] : reading.link_at_start) known.push_back(name);
  refuse_at(item.xml(),
            "body " + in_quotes(*stated) + " does not exist" + reading.hint(*stated, known));
}

const LinkPlacement& site_of(const Item& item, const char* attribute, const Reading& reading) {
  const std::string name = needed_attribute(item.xml(), attribute, place_of(item.xml()));
  const auto found = reading.sites.find(name);
  if (found != reading.sites.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& [one, site] : reading.sites) known.push_back(one);
  refuse_at(item.xml(), "site " + in_quotes(name) + " does not exist" + reading.hint(name, known));
}

Isometry3d at_point(const std::vector<double>& p) {
  Isometry3d placement = Isometry3d::Identity();
  placement.translation() = Eigen::Vector3d(p[0], p[1], p[2]);
  return placement;
}

/// Returns the pose `relpose` in the first body's frame; nothing if its quaternion is zero. MuJoCo
/// holds the anchor, a point of the second body, at the position of this pose. The axes of the
/// second body are held at the rotation of this pose.
std::optional<Isometry3d> stated_pose(const Item& item) {
  const auto pose = item.numbers("relpose", 7);
  const bool is_stated =
      pose && std::any_of(pose->begin() + 3, pose->end(), [](double x) { return x != 0.0; });
  if (!is_stated) return std::nullopt;
  Isometry3d held = at_point(*pose);
  held.linear() = quaternion_of({pose->begin() + 3, pose->end()}, item.xml()).toRotationMatrix();
  return held;
}

void close_loop(const Item& item, bool is_weld, Reading& reading) {
  LoopSpec loop;
  loop.line = line_of(item.xml());
  loop.name = item.name().empty() ? reading.loops.unique("loop") : item.name();
  reading.loops.take(loop.name);
  loop.directions = is_weld ? Directions::all() : Directions::linear();
  if (item.stating("site1") != nullptr) {
    const LinkPlacement &first = site_of(item, "site1", reading),
                        &second = site_of(item, "site2", reading);
    loop.first_link = first.link, loop.first = first.in_link;
    loop.second_link = second.link, loop.second = second.in_link;
  } else {
    needed_attribute(item.xml(), "body1", place_of(item.xml()));
    loop.first_link = link_of(item, "body1", reading);
    loop.second_link = link_of(item, "body2", reading);
    const auto anchor = item.numbers("anchor", 3);
    if (!is_weld && !anchor)
      refuse_at(item.xml(), "it has no anchor; wanted an anchor, a point of body1");
    // Pose of the second body in the first body's frame at qpos0.
    const Isometry3d drawn = reading.link_at_start.at(loop.first_link).inverse() *
                             reading.link_at_start.at(loop.second_link);
    const Isometry3d at = at_point(anchor.value_or(std::vector<double>(3, 0.0)));
    // The anchor of a weld is a point of the second body; other anchors belong to the first body.
    loop.first = is_weld ? stated_pose(item).value_or(drawn * at) : at;
    loop.second = is_weld ? at : drawn.inverse() * at;
  }
  if (loop.first_link == loop.second_link)
    refuse_at(item.xml(),
              "it connects " + in_quotes(loop.first_link) + " to itself; wanted two bodies");
  reading.tree.loops.push_back(std::move(loop));
}

void read_equality(const Item& item, Reading& reading) {
  const std::string_view kind = item.xml().Name();
  if (!item.flag("active", true))
    return reading.info_notes.note("equalities that are not active are ignored",
                                   example_of(item.xml()));
  if (kind == "connect") return close_loop(item, false, reading);
  if (kind == "weld") return close_loop(item, true, reading);
  if (kind == "joint") return couple(item, reading);
  if (kind == "tendon") return hold_tendon(item, reading);
  reading.warning_notes.note("equalities of <" + std::string(kind) + "> are ignored",
                             example_of(item.xml()));
}

/// Returns an equality with the defaults of equalities. Element names such as "joint" and "tendon"
/// alone would select the defaults of joints and tendons.
Item equality_item(const XMLElement& element, const Reading& reading) {
  return {element, reading.item(element).defaults(), "equality"};
}

}  // namespace

void read_tendons(const std::vector<const XMLElement*>& elements, Reading& reading) {
  SpatialTendons spatial;
  for (const XMLElement* element : elements) {
    if (std::string_view(element->Name()) == "fixed")
      reading.findings.attempt([&] { read_fixed(reading.item(*element), reading); });
    else
      reading.findings.attempt([&] { spatial.look_at(reading.item(*element), reading); });
  }
  spatial.report(reading);
}

void read_equalities(const std::vector<const XMLElement*>& elements, Reading& reading) {
  // Equalities of tendons come first, because holding a joint removes it from its tendons.
  for (const bool of_tendons : {true, false})
    for (const XMLElement* element : elements)
      if ((std::string_view(element->Name()) == "tendon") == of_tendons)
        reading.findings.attempt([&] { read_equality(equality_item(*element, reading), reading); });
}

}  // namespace burnish::mjcf
