#include "burnish/contact/contact_force.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>

#include "burnish/base/error.hpp"

namespace burnish {
namespace {

std::string rounded(double value) {
  char text[32];
  const bool readable = std::abs(value) < 1e9;
  std::snprintf(text, sizeof text, readable ? "%.*f" : "%.*e", std::abs(value) < 9.95 ? 2 : 1,
                value);
  return text;
}

std::string name_of_axes(const Anchor& axes) {
  const char* const names[] = {"the tool's axes", "the surface", "the world"};
  return axes.of == Anchor::Frame ? axes.frame : names[axes.of];
}

std::string name_of_origin(const Anchor& origin) {
  const char* const names[] = {", at the tool's origin", ", at the base's origin",
                               ", about the world's origin"};
  return origin.of == Anchor::Frame ? ", at the origin of " + origin.frame : names[origin.of];
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
  const Eigen::Matrix3d world = Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d* const fixed_in[] = {&tool_rotation, &base_rotation, &world,
                                             &frame_rotation};
  return *fixed_in[reference.axes.of] * reference.rotation;
}

Eigen::Vector3d ContactForce::origin() const {
  const Eigen::Vector3d world = Eigen::Vector3d::Zero();
  const Eigen::Vector3d* const fixed_in[] = {&tool_position, &base_position, &world,
                                             &frame_position};
  return *fixed_in[reference.origin.of];
}

ContactForce ContactForce::in(const Reference& other) const {
  const auto is_known = [](const Anchor& anchor, const Anchor& own) {
    return anchor.of != Anchor::Frame || anchor == own;
  };
  if (!is_known(other.axes, reference.axes) || !is_known(other.origin, reference.origin))
    throw Error("contact force of '" + contact + "': it does not know where the frames of the " +
                other.name() + " are; wanted tool, base or world, or ask the dynamics");
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
  sentence += " of " + name_of_axes(reference.axes);
  sentence += ", on " + on + ", by " + (by == "world" ? std::string("the world") : by);
  sentence += name_of_origin(reference.origin);
  return sentence;
}

}  // namespace burnish
