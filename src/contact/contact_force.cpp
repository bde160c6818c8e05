#include "burnish/contact/contact_force.hpp"

#include <cmath>
#include <cstdio>

#include "burnish/base/error.hpp"
#include "dynamics/reference.hpp"

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
  return fixed_in<std::string>(axes, "the tool's axes", "the surface", "the world",
                               [](const std::string& frame) { return frame; });
}

std::string name_of_origin(const Anchor& origin) {
  return fixed_in<std::string>(
      origin, ", at the tool's origin", ", at the base's origin", ", about the world's origin",
      [](const std::string& frame) { return ", at the origin of " + frame; });
}

/// Returns the pose of the force's reference in the world.
ReferencePose<double> pose_of(const ContactForce& force) {
  using Pose = ReferencePose<double>;
  const auto pose = [](const Eigen::Matrix3d& R, const Eigen::Vector3d& p) {
    return Pose{from_eigen(R), from_eigen(p)};
  };
  const Pose world{Mat3<double>::identity(), Vec3<double>::zero()};
  const auto place = [&](const Anchor& anchor) {
    return fixed_in(anchor, pose(force.tool_rotation, force.tool_position),
                    pose(force.base_rotation, force.base_position), world, [&](const std::string&) {
                      return pose(force.frame_rotation, force.frame_position);
                    });
  };
  const Reference& reference = force.reference;
  return {place(reference.axes).R * from_eigen(reference.rotation), place(reference.origin).p};
}

/// Returns the force in world axes, about the world's origin.
Force<double> force_in_world(const ContactForce& force) {
  const ReferencePose<double> at = pose_of(force);
  const Vec3<double> f = at.R * from_eigen(Eigen::Vector3d(force.value.head<3>()));
  const Vec3<double> m = at.R * from_eigen(Eigen::Vector3d(force.value.tail<3>()));
  return {f, m + cross(at.p, f)};
}

/// Returns "30.0 N along +z" for a vector along one axis, else "(1.0, 2.0, 30.0) N".
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

Eigen::Matrix3d ContactForce::axes() const { return to_eigen(pose_of(*this).R); }
Eigen::Vector3d ContactForce::origin() const { return to_eigen(pose_of(*this).p); }

ContactForce ContactForce::in(const Reference& other) const {
  const auto is_recorded = [](const Anchor& anchor, const Anchor& own) {
    return fixed_in(anchor, true, true, true, [&](const std::string&) { return anchor == own; });
  };
  if (!is_recorded(other.axes, reference.axes) || !is_recorded(other.origin, reference.origin))
    throw Error("the force of contact '" + contact +
                "' was recorded without the pose of reference '" + other.name() +
                "'; wanted a reference at tool, base or world (ContactDynamics::force computes the "
                "force in any reference)");
  ContactForce result = *this;
  result.reference = other;
  if (other.quadric) {
    // A ContactForce contains no poses of bodies other than the base and the world.
    const bool of_base = other.axes == Anchor::Base;
    if (!of_base && other.axes != Anchor::World)
      throw Error("the force of contact '" + contact +
                  "' was recorded without the pose of the surface fixed to " + other.axes.text() +
                  "; wanted a surface fixed to base or world (ContactDynamics::force computes the "
                  "force in any reference)");
    const Eigen::Vector3d x =
        of_base ? Eigen::Vector3d(base_rotation.transpose() * (tool_position - base_position))
                : tool_position;
    result.reference = other.at(x);
  }
  const Force<double> there = in_reference(pose_of(result), force_in_world(*this));
  result.value << to_eigen(there.linear), to_eigen(there.angular);
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
