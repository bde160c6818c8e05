// Bodies: links, joints between them, masses and sites.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/sentence.hpp"
#include "mjcf/reading.hpp"
#include "mjcf/solid.hpp"
#include "model/tree_check.hpp"

namespace burnish::mjcf {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr int max_nesting = 1000;  // Largest depth of nested elements; chosen by hand

/// Element of a body, with its default class and the placement of its enclosing <frame>.
struct Within {
  Item item;
  Isometry3d around;
};
struct Child {
  const XMLElement* xml;
  Isometry3d around;
  const DefaultClass* defaults;
};

/// Content of a body, with <frame> elements resolved.
struct Contents {
  std::vector<Within> joints, geoms, sites;
  std::vector<Child> bodies;
  const XMLElement* inertial = nullptr;
};

/// Records an element that is ignored: unnecessary for the dynamics, or unknown.
void ignore(const XMLElement& element, Reading& reading) {
  const std::string_view kind = element.Name();
  if (kind == "light" || kind == "camera")
    ++reading.ignored_elements[std::string(kind)];
  else if (kind == "plugin")
    reading.warning_notes.note("forces of plugins are ignored", example_of(element));
  else
    reading.warning_notes.note("elements with unknown names are ignored", example_of(element));
}

void collect(const XMLElement& element, const Isometry3d& around, const DefaultClass* defaults,
             int depth, Reading& reading, Contents& contents) {
  if (depth > max_nesting)
    refuse_at(element, "elements are nested more than " + std::to_string(max_nesting) + " deep");
  for (const XMLElement* child : reading.source.children(element)) {
    const std::string_view kind = child->Name();
    const auto add = [&](std::vector<Within>& to) {
      reading.findings.attempt([&] { to.push_back({reading.item(*child, defaults), around}); });
    };
    if (kind == "body") {
      contents.bodies.push_back({child, around, reading.class_inside(*child, defaults)});
    } else if (kind == "frame") {
      const Isometry3d inside =
          around * placement_of(Item(*child, nullptr), reading.compiler_of(*child));
      collect(*child, inside, reading.class_inside(*child, defaults), depth + 1, reading, contents);
    } else if (kind == "joint") {
      add(contents.joints);
    } else if (kind == "freejoint") {
      // A freejoint does not have defaults
      contents.joints.push_back({Item(*child, nullptr), around});
    } else if (kind == "geom") {
      add(contents.geoms);
    } else if (kind == "site") {
      add(contents.sites);
    } else if (kind == "inertial") {
      contents.inertial = child;
    } else if (kind == "composite" || kind == "flexcomp") {
      reading.has_composed = true;
      reading.warning_notes.note(
          "soft and composed bodies (<composite>, <flexcomp>, <flex>) are ignored",
          example_of(*child));
    } else {
      ignore(*child, reading);
    }
  }
}

// ---- Masses

InertiaSpec read_inertial(const XMLElement& element, const Compiler& compiler) {
  const Item item(element, nullptr);
  const XmlPlace place = place_of(element);
  const Isometry3d at = placement_of(item, compiler);
  InertiaSpec body;
  body.mass = needed_number(element, "mass", place);
  body.com = at.translation();
  if (const auto full = item.numbers("fullinertia", 6)) {
    if (item.stating("diaginertia") != nullptr)
      refuse_at(element, "diaginertia and fullinertia are both stated; wanted one of them");
    const std::vector<double>& i = *full;
    body.inertia_at_com << i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2];
  } else if (const auto diagonal = item.numbers("diaginertia", 3)) {
    const Vector3d moments((*diagonal)[0], (*diagonal)[1], (*diagonal)[2]);
    const Eigen::Matrix3d turned = at.linear() * moments.asDiagonal() * at.linear().transpose();
    body.inertia_at_com = 0.5 * (turned + turned.transpose());
  }
  return body;
}

/// Applies the compiler's corrections: minimum mass and moments, and balanced moments for inertias
/// that violate the triangle inequality.
void correct(InertiaSpec& body, const Compiler& compiler) {
  body.mass = std::max(body.mass, compiler.min_mass);
  if (compiler.min_inertia <= 0.0 && !compiler.balance_inertia) return;
  if (!body.inertia_at_com.allFinite()) return;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(body.inertia_at_com);
  Vector3d moments = principal.eigenvalues().cwiseMax(compiler.min_inertia);
  if (compiler.balance_inertia && 2.0 * moments.maxCoeff() > moments.sum())
    moments.setConstant(moments.mean());
  if (moments == principal.eigenvalues()) return;
  const Eigen::Matrix3d& axes = principal.eigenvectors();
  const Eigen::Matrix3d turned = axes * moments.asDiagonal() * axes.transpose();
  body.inertia_at_com = 0.5 * (turned + turned.transpose());
}

InertiaSpec mass_of(const Contents& contents, const XMLElement& element, std::size_t link,
                    bool moves, Reading& reading) {
  const Compiler& compiler = reading.compiler_of(element);
  const InertiaFromGeom from_geom = compiler.inertia_from_geom;
  const bool infers = from_geom == InertiaFromGeom::Yes ||
                      (from_geom == InertiaFromGeom::Auto && contents.inertial == nullptr);
  std::vector<Geom> geoms;
  for (const Within& geom : contents.geoms) geoms.push_back({&geom.item, geom.around});
  const Weigh how = !infers ? Weigh::No : moves ? Weigh::Yes : Weigh::Silently;
  InertiaSpec body = read_geoms(geoms, link, how, reading);
  const bool keeps_inertial = !infers || body.mass <= 0.0;
  if (keeps_inertial && contents.inertial != nullptr) {
    reading.findings.attempt([&] { body = read_inertial(*contents.inertial, compiler); });
  }
  correct(body, compiler);
  return body;
}

// ---- Joints

JointType joint_type(const Item& item) {
  if (std::string_view(item.xml().Name()) == "freejoint") return JointType::Floating;
  const std::string type = item.text("type").value_or("hinge");
  if (type == "hinge") return JointType::Revolute;
  if (type == "slide") return JointType::Prismatic;
  if (type == "ball") return JointType::Ball;
  if (type == "free") return JointType::Floating;
  refuse_at(item.xml(), "type " + in_quotes(type) + " is unknown" +
                            did_you_mean(type, {"hinge", "slide", "ball", "free"}));
}

/// Returns the linear coefficient of an attribute that newer files may state as a polynomial.
double first_of(const Item& item, const char* attribute, Reading& reading) {
  const XMLElement* at = item.stating(attribute);
  if (at == nullptr) return 0.0;
  const std::vector<double> stated = all_numbers(*at, attribute, place_of(*at));
  if (stated.empty()) return 0.0;
  if (std::any_of(stated.begin() + 1, stated.end(), [](double x) { return x != 0.0; }))
    reading.warning_notes.note(
        "polynomial " + std::string(attribute) + " is reduced to its linear coefficient",
        example_of(item.xml()));
  return stated.front();
}

void read_range(const Item& item, JointSpec& joint, Reading& reading) {
  const auto stated = item.numbers("range", 2);
  const bool has_range = stated && ((*stated)[0] != 0.0 || (*stated)[1] != 0.0);
  const auto limited = item.choice("limited");
  if (!limited.value_or(has_range && reading.compiler_of(item.xml()).autolimits)) return;
  if (joint.type == JointType::Ball) {
    reading.warning_notes.note("ranges of ball joints are ignored", example_of(item.xml()));
    return;
  }
  if (!has_range) refuse_at(item.xml(), "it is limited but has no range; wanted a range");
  const bool turns = joint.type == JointType::Revolute;
  joint.lower = turns ? reading.compiler_of(item.xml()).angle((*stated)[0]) : (*stated)[0];
  joint.upper = turns ? reading.compiler_of(item.xml()).angle((*stated)[1]) : (*stated)[1];
}

/// Reads the limit of the sum of all actuator efforts on the joint.
void read_effort(const Item& item, JointSpec& joint, Reading& reading) {
  const auto stated = item.numbers("actuatorfrcrange", 2);
  const bool has_range = stated && ((*stated)[0] != 0.0 || (*stated)[1] != 0.0);
  const auto limited = item.choice("actuatorfrclimited");
  if (!limited.value_or(has_range && reading.compiler_of(item.xml()).autolimits) || !has_range)
    return;
  joint.effort_limit = std::max(std::abs((*stated)[0]), std::abs((*stated)[1]));
  if ((*stated)[0] != -(*stated)[1])
    reading.warning_notes.note(uneven_forces, example_of(item.xml()));
}

void read_passive(const Item& item, JointSpec& joint, double ref_unit, Reading& reading) {
  joint.armature = item.number("armature", 0.0);
  joint.friction = item.number("frictionloss", 0.0);
  joint.damping = first_of(item, "damping", reading);
  const double stiffness = first_of(item, "stiffness", reading);
  if (joint.type == JointType::Floating) {
    if (stiffness != 0.0)
      reading.warning_notes.note("springs of free joints are ignored", example_of(item.xml()));
    return;
  }
  joint.stiffness = stiffness;
  if (stiffness != 0.0 && joint.type != JointType::Ball)
    joint.rest = ref_unit * item.number("springref", 0.0);
  const std::vector<double> springdamper = item.overlaid("springdamper", {0.0, 0.0});
  if (springdamper[0] != 0.0 || springdamper[1] != 0.0)
    reading.warning_notes.note("springdamper, from which MuJoCo computes a spring, is ignored",
                               example_of(item.xml()));
}

/// A joint with its reference position (`ref`), and its anchor, a point of the body.
struct ReadJoint {
  JointSpec spec;
  double reference = 0.0;
  Vector3d anchor = Vector3d::Zero();
};

ReadJoint read_joint(const Within& within, const std::string& body, Reading& reading) {
  const Item& item = within.item;
  ReadJoint read;
  JointSpec& joint = read.spec;
  joint.type = joint_type(item);
  joint.line = line_of(item.xml());
  joint.name = item.name();
  if (joint.name.empty()) {
    // A floating base without a name gets its usual name, root_joint.
    const bool is_base =
        joint.type == JointType::Floating && !reading.joints.is_taken("root_joint");
    joint.name = reading.joints.unique(is_base ? "root_joint" : body + "_joint");
  }
  reading.findings.attempt([&] {
    const bool turns = joint.type == JointType::Revolute;
    const double unit = turns ? reading.compiler_of(item.xml()).angle(1.0) : 1.0;
    const bool is_single = turns || joint.type == JointType::Prismatic;
    if (is_single) {
      const std::vector<double> axis = item.overlaid("axis", {0.0, 0.0, 1.0});
      joint.axis = within.around.linear() * Vector3d(axis[0], axis[1], axis[2]);
      if (joint.axis.norm() > 0.0) joint.axis.normalize();  // A zero axis is rejected later
      read.reference = unit * item.number("ref", 0.0);
    }
    if (joint.type != JointType::Floating) read_range(item, joint, reading);
    if (is_single) read_effort(item, joint, reading);
    if (turns || joint.type == JointType::Ball) {
      const std::vector<double> pos = item.overlaid("pos", {0.0, 0.0, 0.0});
      read.anchor = within.around * Vector3d(pos[0], pos[1], pos[2]);
    }
    read_passive(item, joint, unit, reading);
    if (item.text("align").value_or("auto") == "true")
      reading.warning_notes.note(
          "'align' is ignored: free joints stay at the frames of their bodies",
          example_of(item.xml()));
  });
  return read;
}

/// Returns the motion of a joint from its reference position to position zero.
Isometry3d back_from_reference(const ReadJoint& joint) {
  Isometry3d back = Isometry3d::Identity();
  if (joint.spec.type == JointType::Revolute)
    back.linear() = Eigen::AngleAxisd(-joint.reference, joint.spec.axis).toRotationMatrix();
  if (joint.spec.type == JointType::Prismatic)
    back.translation() = -joint.reference * joint.spec.axis;
  return back;
}

std::vector<double> values_at_start(const ReadJoint& joint, const Isometry3d& body_in_world) {
  if (joint.spec.type == JointType::Ball) return {0.0, 0.0, 0.0, 1.0};
  if (joint.spec.type != JointType::Floating) return {joint.reference};
  const Vector3d p = body_in_world.translation();
  const Eigen::Quaterniond r(body_in_world.linear());
  return {p.x(), p.y(), p.z(), r.x(), r.y(), r.z(), r.w()};
}

void check_free(const Within& within, const std::string& parent, std::size_t joints) {
  if (parent != world_name)
    refuse_at(within.item.xml(), "a free joint must belong to a body directly in the world");
  if (joints != 1)
    refuse_at(within.item.xml(), "a free joint must be the only joint of its body; this body has " +
                                     std::to_string(joints) + " joints");
}

/// Adds the chain of joints between two bodies. MuJoCo moves a body by each joint in turn. A joint
/// with anchor p, axis a and reference position r has the transform
/// T(p) R(a, q - r) T(-p) = T(p) R(a, -r) R(a, q) T(-p).
void join(const std::vector<Within>& joints, const std::string& parent, const std::string& body,
          const Isometry3d& placement, int line, Reading& reading) {
  TreeSpec& tree = reading.tree;
  std::string from = parent;
  Isometry3d at = placement;
  const auto add = [&](JointSpec joint, const std::string& to) {
    joint.parent_link = from;
    joint.child_link = to;
    joint.placement = at;
    tree.joints.push_back(std::move(joint));
    from = to;
    at.setIdentity();
  };
  for (std::size_t i = 0; i < joints.size(); ++i) {
    ReadJoint joint = read_joint(joints[i], body, reading);
    if (joint.spec.type == JointType::Floating)
      reading.findings.attempt([&] { check_free(joints[i], parent, joints.size()); });
    reading.coordinates.push_back({tree.joints.size(), values_at_start(joint, placement)});
    reading.joint_by_name.emplace(joint.spec.name, reading.coordinates.size() - 1);
    const bool floats = joint.spec.type == JointType::Floating;
    at = floats ? Isometry3d::Identity()
                : at * Eigen::Translation3d(joint.anchor) * back_from_reference(joint);
    const bool is_last = i + 1 == joints.size() && joint.anchor.isZero(0.0);
    std::string to = body;
    if (!is_last) {
      to = reading.links.unique(body + "_" + joint.spec.name);
      tree.links.push_back({to, {}, {}, joint.spec.line});
    }
    add(joint.spec, to);
    at.translation() = -joint.anchor;
  }
  if (from == body) return;
  JointSpec fixed;
  fixed.name = reading.joints.unique(body + "_fixed");
  fixed.line = line;
  add(fixed, body);
}

// ---- Bodies

void read_sites(const std::vector<Within>& sites, const std::string& link, Reading& reading) {
  for (const Within& within : sites) {
    reading.findings.attempt([&] {
      Isometry3d placement = Isometry3d::Identity();
      if (const auto ends = within.item.numbers("fromto", 6)) {
        const Vector3d from((*ends)[0], (*ends)[1], (*ends)[2]),
            to((*ends)[3], (*ends)[4], (*ends)[5]);
        placement.translation() = 0.5 * (from + to);
        if ((from - to).norm() > 0.0) placement.linear() = rotation_to(from - to);
      } else {
        placement = placement_of(within.item, reading.compiler_of(within.item.xml()));
      }
      const std::string name = within.item.name();
      if (name.empty()) return;  // A site without a name cannot be referenced
      placement = within.around * placement;
      reading.sites.emplace(name, LinkPlacement{link, placement});
      std::string frame = name;
      if (reading.links.is_taken(name) || reading.joints.is_taken(name)) {
        frame = reading.frames.unique(name + "_site");
        reading.info_notes.note("sites with the name of a body or a joint get the suffix '_site'",
                                example_of(within.item.xml()));
      }
      reading.frames.take(frame);
      reading.tree.frames.push_back({frame, link, placement});
    });
  }
}

void note_body_omissions(const XMLElement& body, Reading& reading) {
  const Item item(body, nullptr);
  if (item.flag("mocap", false))
    reading.warning_notes.note("motion-capture bodies (mocap) are read as fixed bodies",
                               example_of(body));
  if (item.text("gravcomp").value_or("0") != "0")
    reading.warning_notes.note("gravity compensation of bodies (gravcomp) is ignored",
                               example_of(body));
}

/// Reads a body and its children. `moves` tells whether a joint moves the parent.
void read_body(const Child& child, const std::string& parent, bool moves, int depth,
               Reading& reading) {
  const XMLElement& xml = *child.xml;
  if (depth > max_depth || reading.tree.links.size() > max_links)
    refuse_at(xml,
              (depth > max_depth ? "bodies are nested more than " : "the model has more than ") +
                  std::to_string(depth > max_depth ? max_depth : int{max_links}) +
                  (depth > max_depth ? " deep, the maximum" : " links, the maximum number"));
  LinkSpec link;
  const char* stated = xml.Attribute("name");
  link.name = stated == nullptr || *stated == '\0' ? reading.links.unique("body") : stated;
  link.line = line_of(xml);
  Isometry3d placement = child.around;
  reading.findings.attempt([&] {
    placement = child.around * placement_of(Item(xml, nullptr), reading.compiler_of(xml));
  });
  reading.findings.attempt([&] { note_body_omissions(xml, reading); });
  Contents contents;
  reading.findings.attempt(
      [&] { collect(xml, Isometry3d::Identity(), child.defaults, 0, reading, contents); });
  const std::size_t index = reading.tree.links.size();
  const std::string name = link.name;
  reading.tree.links.push_back(link);
  reading.link_at_start.emplace(name, reading.link_at_start.at(parent) * placement);
  moves = moves || !contents.joints.empty();
  reading.tree.links[index].inertia = mass_of(contents, xml, index, moves, reading);
  join(contents.joints, parent, name, placement, link.line, reading);
  read_sites(contents.sites, name, reading);
  for (const Child& below : contents.bodies) read_body(below, name, moves, depth + 1, reading);
}

/// Reserves all names in the file, so that the reader generates different names.
void take_names(const XMLElement& element, int depth, Reading& reading) {
  if (depth > max_nesting) return;  // The reader rejects the element later
  for (const XMLElement* child : reading.source.children(element)) {
    const std::string_view kind = child->Name();
    const char* name = child->Attribute("name");
    if (name != nullptr && kind == "body") reading.links.take(name);
    if (name != nullptr && (kind == "joint" || kind == "freejoint")) reading.joints.take(name);
    if (name != nullptr && kind == "site") reading.frames.take(name);
    if (kind == "body" || kind == "frame") take_names(*child, depth + 1, reading);
  }
}

}  // namespace

void read_world(const XMLElement& section, Reading& reading) {
  if (reading.tree.links.empty()) {
    reading.tree.links.push_back({world_name, {}, {}, line_of(section)});
    reading.links.take(world_name);
    reading.link_at_start[world_name] = Isometry3d::Identity();
  }
  take_names(section, 0, reading);
  const DefaultClass* defaults = reading.class_inside(section, &reading.classes.main());
  Contents contents;
  collect(section, Isometry3d::Identity(), defaults, 0, reading, contents);
  if (!contents.joints.empty())
    refuse_at(contents.joints.front().item.xml(),
              "the world must have no joints; wanted the joint in a body");
  std::vector<Geom> geoms;
  for (const Within& geom : contents.geoms) geoms.push_back({&geom.item, geom.around});
  read_geoms(geoms, 0, Weigh::No, reading);
  read_sites(contents.sites, world_name, reading);
  for (const Child& child : contents.bodies) read_body(child, world_name, false, 1, reading);
}

}  // namespace burnish::mjcf
