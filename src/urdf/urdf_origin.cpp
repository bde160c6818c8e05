#include <array>
#include <cmath>

#include "base/sentence.hpp"
#include "urdf/urdf_element.hpp"

namespace burnish {
namespace {

using tinyxml2::XMLElement;

/// Rotation by roll, pitch and yaw about the fixed axes x, y and z, in this order.
Eigen::Quaterniond from_roll_pitch_yaw(const std::vector<double>& rpy) {
  const double sr = std::sin(0.5 * rpy[0]), cr = std::cos(0.5 * rpy[0]);
  const double sp = std::sin(0.5 * rpy[1]), cp = std::cos(0.5 * rpy[1]);
  const double sy = std::sin(0.5 * rpy[2]), cy = std::cos(0.5 * rpy[2]);
  return {cr * cp * cy + sr * sp * sy, sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
          cr * cp * sy - sr * sp * cy};
}

}  // namespace

Eigen::Isometry3d read_origin(const XMLElement& parent, const XmlPlace& place, Findings& findings) {
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
  const XMLElement* origin = first_child(parent, "origin", place, findings);
  if (origin == nullptr) return placement;
  for (const tinyxml2::XMLAttribute* attribute = origin->FirstAttribute(); attribute != nullptr;
       attribute = attribute->Next()) {
    const std::string_view name = attribute->Name();
    if (name == "xyz" || name == "rpy") continue;
    refuse(place, *origin,
           "<origin> has the attribute " + in_quotes(name) + "; wanted only 'xyz' and 'rpy'");
  }
  if (const auto xyz = numbers(*origin, "xyz", 3, place)) {
    placement.translation() = Eigen::Vector3d((*xyz)[0], (*xyz)[1], (*xyz)[2]);
  }
  if (const auto rpy = numbers(*origin, "rpy", 3, place)) {
    placement.linear() = from_roll_pitch_yaw(*rpy).normalized().toRotationMatrix();
  }
  return placement;
}

void warn_of_macros(const XMLElement& element, const XmlPlace& place, Findings& findings) {
  for (const XMLElement* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    if (!std::string_view(child->Name()).starts_with("xacro:")) continue;
    findings.warn(line_text(*child) + place.element + ": <" + child->Name() +
                  "> is a macro that was not expanded; its content is missing");
  }
}

}  // namespace burnish
