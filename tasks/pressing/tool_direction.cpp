#include "pressing/tool_direction.hpp"

#include <array>
#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"

namespace burnish::pressing {
namespace {

/// Smallest offset along an axis from which outward_side() returns a sign [m]. Chosen by hand.
constexpr double min_offset = 1e-3;
/// Distance from the last joint axis beyond which a tool lies beside the axis [m]. Tools mounted on
/// the axis are nearer.
constexpr double beside_axis = 0.02;

/// Returns the sign, 1 or -1, with which `axis` points away from the robot. Returns nothing if all
/// offsets along the axis are too small. All vectors are in the frame of the last joint.
std::optional<double> outward_side(const Joint& last, const Eigen::Vector3d& offset,
                                   const Eigen::Vector3d& axis) {
  // Uses only the offset along the axis of the last joint, because the other components depend on
  // the angle of this joint.
  const Eigen::Vector3d from_joint_before(0.0, 0.0, -last.placement.inverse().translation().z());
  for (const Eigen::Vector3d& outward : {offset, from_joint_before, last.com}) {
    const double along = outward.dot(axis);
    if (std::abs(along) >= min_offset) return along > 0.0 ? 1.0 : -1.0;
  }
  return std::nullopt;
}

}  // namespace

ToolDirection tool_direction(const std::string& frame, const std::optional<Eigen::Vector3d>& axis,
                             const Model& model) {
  if (axis) return {axis->normalized()};
  const Frame& tool = model.frames[to_size(model.frame_index(frame))];
  if (tool.body < 0) return {-Eigen::Vector3d::UnitZ()};
  // Offset and rotation of the tool in the frame of the last joint, whose axis is z.
  const Joint& joint = model.joints[to_size(tool.body)];
  const Eigen::Vector3d offset = tool.placement.translation();
  const Eigen::Matrix3d R = tool.placement.linear();
  if (tool.kind == FrameKind::User) {
    const auto side = outward_side(joint, offset, R.col(2));
    return {{0.0, 0.0, side.value_or(-1.0)}, side.has_value()};
  }
  if (offset.head<2>().norm() > beside_axis && std::abs(offset.z()) < 0.5 * offset.norm())
    return {R.transpose() * offset.normalized()};
  const auto side = outward_side(joint, offset, Eigen::Vector3d::UnitZ());
  // If the offsets are too small, uses the tool's z axis, which points outwards at most flanges.
  const double by_its_axes = R(2, 2) < 0.0 ? -1.0 : 1.0;
  return {R.transpose() * Eigen::Vector3d(0.0, 0.0, side.value_or(by_its_axes)), side.has_value()};
}

std::string axis_text(const Eigen::Vector3d& axis) {
  constexpr double digits = 1e3;
  std::string text = "tool.axis=[";
  for (int i = 0; i < 3; ++i)
    text += (i == 0 ? "" : ", ") + number(std::round(digits * axis[i]) / digits + 0.0);
  return text + "]";
}

void note_tool_direction(const std::string& frame, const std::optional<Eigen::Vector3d>& axis,
                         const Model& model, std::vector<std::string>& notes) {
  const ToolDirection direction = tool_direction(frame, axis, model);
  if (direction.decided) return;
  notes.push_back(
      axis_text(direction.axis) + " is assumed as the direction in which tool " + in_quotes(frame) +
      " presses, because the description does not determine the sign of this axis; set " +
      axis_text(-direction.axis) + " if the tool presses in the opposite direction");
}

}  // namespace burnish::pressing
