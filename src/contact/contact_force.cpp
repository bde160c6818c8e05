#include "burnish/contact/contact_force.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>

namespace burnish {
namespace {

std::string rounded(double value) {
  char text[32];
  const bool readable = std::abs(value) < 1e9;
  std::snprintf(text, sizeof text, readable ? "%.*f" : "%.*e", std::abs(value) < 9.95 ? 2 : 1,
                value);
  return text;
}

std::string axes_name(const Reference& reference) {
  switch (reference.axes) {
    case Reference::Axes::Tool:
      return "the tool's axes";
    case Reference::Axes::Base:
      return "the surface";
    case Reference::Axes::World:
      return "the world";
  }
  return "unknown axes";
}

/// "30.0 N along +z" for a vector along one axis, "(1.0, 2.0, 30.0) N" otherwise.
std::string vector_text(const Eigen::Vector3d& value, const char* unit, const char* along) {
  int largest = 0;
  const double length = value.cwiseAbs().maxCoeff(&largest);
  Eigen::Vector3d rest = value;
  rest[largest] = 0.0;
  if (rest.cwiseAbs().maxCoeff() < 5e-3 && length >= 5e-3) {
    const char sign = value[largest] < 0.0 ? '-' : '+';
    const char axis = "xyz"[largest];
    return rounded(length) + " " + unit + " " + along + " " + sign + axis;
  }
  return "(" + rounded(value.x()) + ", " + rounded(value.y()) + ", " + rounded(value.z()) + ") " +
         unit;
}

}  // namespace

Eigen::Matrix3d ContactForce::axes() const {
  switch (reference.axes) {
    case Reference::Axes::Tool:
      return tool_rotation * reference.rotation;
    case Reference::Axes::Base:
      return base_rotation * reference.rotation;
    case Reference::Axes::World:
      return reference.rotation;
  }
  return reference.rotation;
}

Eigen::Vector3d ContactForce::origin() const {
  return reference.origin == Reference::Origin::World ? Eigen::Vector3d::Zero() : tool_position;
}

ContactForce ContactForce::in(const Reference& other) const {
  const Eigen::Vector3d force_world = axes() * value.head<3>();
  const Eigen::Vector3d moment_world = axes() * value.tail<3>();
  ContactForce result = *this;
  result.reference = other;
  const Eigen::Vector3d arm = origin() - result.origin();
  result.value << result.axes().transpose() * force_world,
      result.axes().transpose() * (moment_world + arm.cross(force_world));
  return result;
}

std::string ContactForce::text() const {
  const Eigen::Vector3d force = value.head<3>(), moment = value.tail<3>();
  std::string sentence = vector_text(force, "N", "along");
  const bool has_moment = moment.cwiseAbs().maxCoeff() >= 5e-3;
  if (has_moment) sentence += " and " + vector_text(moment, "Nm", "about");
  sentence += " of " + axes_name(reference);
  sentence += ", on " + on + ", by " + (by == "world" ? std::string("the world") : by);
  sentence += reference.origin == Reference::Origin::World ? ", about the world's origin"
                                                           : ", at the tool's origin";
  return sentence;
}

}  // namespace burnish
