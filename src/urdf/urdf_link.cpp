#include <array>
#include <cmath>

#include "base/sentence.hpp"
#include "urdf/urdf_element.hpp"

namespace burnish {
namespace {

using tinyxml2::XMLElement;

Eigen::Vector3d vector_of(const std::vector<double>& values) {
  return {values[0], values[1], values[2]};
}

InertiaSpec read_inertia(const XMLElement& inertial, const XmlPlace& place, Findings& findings) {
  Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
  InertiaSpec result;
  findings.attempt([&] { origin = read_origin(inertial, place, findings); });
  findings.attempt(
      [&] { result.mass = needed_number(needed_child(inertial, "mass", place), "value", place); });
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  findings.attempt([&] {
    const XMLElement& stated = needed_child(inertial, "inertia", place);
    constexpr std::array<const char*, 6> names = {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"};
    constexpr std::array<int, 6> rows = {0, 0, 0, 1, 1, 2}, columns = {0, 1, 2, 1, 2, 2};
    for (std::size_t i = 0; i < names.size(); ++i) {
      findings.attempt([&] {
        const double value = needed_number(stated, names[i], place);
        inertia(rows[i], columns[i]) = inertia(columns[i], rows[i]) = value;
      });
    }
  });
  const Eigen::Matrix3d turned = origin.linear() * inertia * origin.linear().transpose();
  result.com = origin.translation();
  // Rounding makes the product slightly asymmetric.
  result.inertia_at_com = 0.5 * (turned + turned.transpose());
  return result;
}

/// Reads a length or a radius [m].
double size_of(const XMLElement& shape, const char* attribute, const XmlPlace& place) {
  const double size = needed_number(shape, attribute, place);
  if (size >= 0.0) return size;
  refuse(place, shape,
         std::string("<") + shape.Name() + "> has " + attribute + " = " + number(size) +
             "; wanted zero or more");
}

Shape read_shape(const XMLElement& shape, const XmlPlace& place) {
  const std::string_view kind = shape.Name();
  if (kind == "box") {
    needed_attribute(shape, "size", place);
    const Eigen::Vector3d size = vector_of(*numbers(shape, "size", 3, place));
    if (size.minCoeff() >= 0.0) return BoxShape{size};
    refuse(place, shape, "<box> has the size " + number(size.minCoeff()) + "; wanted zero or more");
  }
  if (kind == "cylinder") {
    return CylinderShape{size_of(shape, "radius", place), size_of(shape, "length", place)};
  }
  if (kind == "sphere") return SphereShape{size_of(shape, "radius", place)};
  if (kind == "mesh") {
    const auto scale = numbers(shape, "scale", 3, place);
    return MeshShape{needed_attribute(shape, "filename", place),
                     scale ? vector_of(*scale) : Eigen::Vector3d(1.0, 1.0, 1.0)};
  }
  refuse(place, shape,
         "<geometry> holds <" + std::string(kind) + ">; wanted box, cylinder, sphere or mesh");
}

/// Returns the <color> of a material. Returns nothing if it is missing or invalid; an invalid
/// colour is not an error, since only drawings use it.
std::optional<Eigen::Vector4d> own_colour(const XMLElement& material) {
  const XMLElement* colour = material.FirstChildElement("color");
  if (colour == nullptr) return std::nullopt;
  try {
    const auto rgba = numbers(*colour, "rgba", 4, {});
    if (!rgba) return std::nullopt;
    const Eigen::Vector4d values((*rgba)[0], (*rgba)[1], (*rgba)[2], (*rgba)[3]);
    if (values.minCoeff() >= 0.0 && values.maxCoeff() <= 1.0) return values;
  } catch (const Error&) {
    // Visuals without a colour are drawn in grey.
  }
  return std::nullopt;
}

void add_colours(const XMLElement& parent, Colours& colours) {
  for (const XMLElement* material = parent.FirstChildElement("material"); material != nullptr;
       material = material->NextSiblingElement("material")) {
    const char* name = material->Attribute("name");
    if (name == nullptr || colours.contains(name)) continue;
    if (const auto colour = own_colour(*material)) colours.emplace(name, *colour);
  }
}

/// Returns the colour of the first material with a <color> or with a name in `colours`.
std::optional<Eigen::Vector4d> colour_of(const XMLElement& visual, const Colours& colours) {
  for (const XMLElement* material = visual.FirstChildElement("material"); material != nullptr;
       material = material->NextSiblingElement("material")) {
    if (const auto own = own_colour(*material)) return own;
    const char* name = material->Attribute("name");
    const auto found = colours.find(name == nullptr ? "" : name);
    if (found != colours.end()) return found->second;
  }
  return std::nullopt;
}

void add_visual(const XMLElement& element, const Colours& colours, const XmlPlace& place,
                std::vector<VisualSpec>& visuals, Findings& findings) {
  const XMLElement* geometry = element.FirstChildElement("geometry");
  const XMLElement* shape = geometry == nullptr ? nullptr : geometry->FirstChildElement();
  if (shape == nullptr) return;  // a visual without geometry
  VisualSpec visual;
  visual.shape = read_shape(*shape, place);
  visual.placement = read_origin(element, place, findings);
  visual.rgba = colour_of(element, colours).value_or(visual.rgba);
  visuals.push_back(std::move(visual));
}

void add_collision(const XMLElement& element, const XmlPlace& place, std::vector<LinkSolid>& solids,
                   Findings& findings) {
  const XMLElement* geometry = element.FirstChildElement("geometry");
  const XMLElement* shape = geometry == nullptr ? nullptr : geometry->FirstChildElement();
  if (shape == nullptr) return;
  const Eigen::Isometry3d placement = read_origin(element, place, findings);
  if (std::string_view(shape->Name()) != "capsule") {
    solids.push_back({place.element, read_shape(*shape, place), placement});
    return;
  }
  const double radius = size_of(*shape, "radius", place), length = size_of(*shape, "length", place);
  solids.push_back({place.element, CylinderShape{radius, length}, placement});
  for (const double end : {-0.5 * length, 0.5 * length})
    solids.push_back(
        {place.element, SphereShape{radius}, placement * Eigen::Translation3d(0.0, 0.0, end)});
}

}  // namespace

void read_collisions(const XMLElement& element, std::vector<LinkSolid>& solids) {
  const char* name = element.Attribute("name");
  if (name == nullptr) return;
  Findings ignored("");  // computations do not use collision geometry
  for (const XMLElement* collision = element.FirstChildElement("collision"); collision != nullptr;
       collision = collision->NextSiblingElement("collision")) {
    try {
      add_collision(*collision, {"", name}, solids, ignored);
    } catch (const Error&) {
      // A shape that cannot be read is left out.
    }
  }
}

Colours read_colours(const XMLElement& robot) {
  Colours colours;
  add_colours(robot, colours);
  for (const XMLElement* link = robot.FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link")) {
    for (const XMLElement* visual = link->FirstChildElement("visual"); visual != nullptr;
         visual = visual->NextSiblingElement("visual")) {
      add_colours(*visual, colours);
    }
  }
  return colours;
}

LinkSpec read_link(const XMLElement& element, const Colours& colours, Findings& findings) {
  LinkSpec link;
  link.name = name_of(element, findings.origin());
  link.line = element.GetLineNum();
  const XmlPlace place{findings.origin(), "link " + in_quotes(link.name)};
  findings.attempt([&] {
    if (const XMLElement* inertial = first_child(element, "inertial", place, findings)) {
      link.inertia = read_inertia(*inertial, place, findings);
    }
  });
  for (const XMLElement* visual = element.FirstChildElement("visual"); visual != nullptr;
       visual = visual->NextSiblingElement("visual")) {
    findings.attempt_or_warn([&] { add_visual(*visual, colours, place, link.visuals, findings); },
                             "; this visual is not drawn");
  }
  warn_of_macros(element, place, findings);
  return link;
}

}  // namespace burnish
