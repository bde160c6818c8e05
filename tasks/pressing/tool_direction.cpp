#include "pressing/tool_direction.hpp"

#include <array>
#include <cmath>

#include "base/sentence.hpp"

namespace burnish::pressing {
namespace {

/// Offsets along an axis that are shorter decide nothing [m].
constexpr double decisive = 1e-3;
/// A tool lies beside the axis that carries it where it is further off [m]; mounts are off by less.
constexpr double beside_axis = 0.02;

/// 1 or -1: the side of `axis` that points away from the robot, in the frame of the last joint;
/// nothing where nothing tells.
std::optional<double> outward_side(const Joint& last, const Eigen::Vector3d& offset,
                                   const Eigen::Vector3d& axis) {
  // Across the last axis, the joint before is elsewhere whenever the last joint turns.
  const Eigen::Vector3d from_joint_before(0.0, 0.0, -last.placement.inverse().translation().z());
  for (const Eigen::Vector3d& outward : {offset, from_joint_before, last.com}) {
    const double along = outward.dot(axis);
    if (std::abs(along) >= decisive) return along > 0.0 ? 1.0 : -1.0;
  }
  return std::nullopt;
}

}  // namespace

ToolDirection tool_direction(const std::string& frame, const std::optional<Eigen::Vector3d>& axis,
                             const Model& model) {
  if (axis) return {axis->normalized()};
  const Frame& tool = model.frames[static_cast<std::size_t>(model.frame_index(frame))];
  if (tool.body < 0) return {-Eigen::Vector3d::UnitZ()};
  // In the frame of the joint that carries it, which turns about its z.
  const Joint& joint = model.joints[static_cast<std::size_t>(tool.body)];
  const Eigen::Vector3d offset = tool.placement.translation();
  const Eigen::Matrix3d R = tool.placement.linear();
  if (tool.kind == FrameKind::User) {
    const auto side = outward_side(joint, offset, R.col(2));
    return {{0.0, 0.0, side.value_or(-1.0)}, side.has_value()};
  }
  if (offset.head<2>().norm() > beside_axis && std::abs(offset.z()) < 0.5 * offset.norm())
    return {R.transpose() * offset.normalized()};
  const auto side = outward_side(joint, offset, Eigen::Vector3d::UnitZ());
  // Last resort: flanges are drawn with z, if any axis, out of them.
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
  notes.push_back("nothing tells which way the tool " + in_quotes(frame) +
                  " looks: along its axis neither the tool, nor the joint before, nor the mass of "
                  "the link is off the last joint; " +
                  axis_text(direction.axis) + " is assumed, and " + axis_text(-direction.axis) +
                  " is the other way");
}

}  // namespace burnish::pressing
