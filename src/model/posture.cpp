#include "model/posture.hpp"

#include <cmath>

#include "base/sentence.hpp"

namespace burnish {

Eigen::Matrix3d rotation_from_z(const Eigen::Vector3d& axis) {
  // The result is the shortest rotation from z to the axis if axis.z() >= 0. Otherwise, the result
  // is half a turn about x, then the shortest rotation from -z to the axis. Both cases are far from
  // the singularity at opposite vectors, and exact for axes along x, y or z.
  const bool above = axis.z() >= 0.0;
  const Eigen::Vector3d from(0.0, 0.0, above ? 1.0 : -1.0);
  const Eigen::Vector3d cross = from.cross(axis);
  Eigen::Matrix3d skew;
  skew << 0.0, -cross.z(), cross.y(), cross.z(), 0.0, -cross.x(), -cross.y(), cross.x(), 0.0;
  const Eigen::Matrix3d shortest =
      Eigen::Matrix3d::Identity() + skew + skew * skew / (1.0 + from.dot(axis));
  if (above) return shortest;
  return shortest * Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
}

JointKind kind_of(JointType type) {
  switch (type) {
    case JointType::Revolute:
      return JointKind::Revolute;
    case JointType::Continuous:
      return JointKind::Continuous;
    case JointType::Prismatic:
      return JointKind::Prismatic;
    case JointType::Planar:
      return JointKind::Planar;
    case JointType::Ball:
      return JointKind::Ball;
    case JointType::Fixed:
    case JointType::Floating:
      break;
  }
  return JointKind::FreeFlyer;
}

std::size_t posture_size(JointType type) {
  switch (type) {
    case JointType::Fixed:
      return 0;
    case JointType::Revolute:
    case JointType::Continuous:
    case JointType::Prismatic:
      return 1;
    case JointType::Planar:
      return 3;
    case JointType::Floating:
      return 7;
    case JointType::Ball:
      return 4;
  }
  return 0;
}

std::size_t posture_size(JointKind kind) {
  if (kind == JointKind::Planar) return 3;
  if (kind == JointKind::Ball) return 4;
  return kind == JointKind::FreeFlyer ? 7 : 1;
}

void check_posture_values(const std::string& origin, const std::string& joint,
                          std::span<const double> values, std::size_t size) {
  if (values.size() != size) {
    refuse(origin, "posture of joint " + in_quotes(joint) + " has " +
                       std::to_string(values.size()) + " values; wanted " + std::to_string(size) +
                       (size == 7   ? " (x, y, z and a quaternion x, y, z, w)"
                        : size == 4 ? " (a quaternion x, y, z, w)"
                        : size == 3 ? " (x, y and an angle)"
                                    : ""));
  }
  for (const double value : values) {
    if (!std::isfinite(value)) {
      refuse(origin, "posture of joint " + in_quotes(joint) + " contains " + number(value) +
                         "; wanted finite values");
    }
  }
  if (size != 7 && size != 4) return;
  const double length = Eigen::Map<const Eigen::Vector4d>(values.data() + size - 4).norm();
  if (std::abs(length - 1.0) > 1e-3) {
    refuse(origin, "posture of joint " + in_quotes(joint) + ": its quaternion has length " +
                       number(length) + "; wanted 1");
  }
}

Eigen::Isometry3d displacement(const JointSpec& joint, std::span<const double> values) {
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d axis = joint.axis.normalized();
  switch (joint.type) {
    case JointType::Fixed:
      break;
    case JointType::Revolute:
    case JointType::Continuous:
      moved.linear() = Eigen::AngleAxisd(values[0], axis).toRotationMatrix();
      break;
    case JointType::Prismatic:
      moved.translation() = values[0] * axis;
      break;
    case JointType::Planar:
      moved.linear() = Eigen::AngleAxisd(values[2], axis).toRotationMatrix();
      moved.translation() = rotation_from_z(axis) * Eigen::Vector3d(values[0], values[1], 0.0);
      break;
    case JointType::Floating:
      moved.translation() = Eigen::Map<const Eigen::Vector3d>(values.data());
      moved.linear() = Eigen::Quaterniond(Eigen::Map<const Eigen::Vector4d>(values.data() + 3))
                           .normalized()
                           .toRotationMatrix();
      break;
    case JointType::Ball:
      moved.linear() = Eigen::Quaterniond(Eigen::Map<const Eigen::Vector4d>(values.data()))
                           .normalized()
                           .toRotationMatrix();
      break;
  }
  return moved;
}

}  // namespace burnish
