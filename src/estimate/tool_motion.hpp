// Motion of the tool relative to the surface, which a frame of the robot may carry.
#pragma once

#include <string>

#include "burnish/derivatives/rigid_body.hpp"

namespace burnish {

/// Jacobian and velocity of the tool's origin relative to the surface. A force between tool and
/// surface does work along this velocity. If the robot frame `base` carries the surface, the motion
/// is relative to the point of that body at the tool's origin; otherwise, it is relative to the
/// world. For a robot without a tool, Jacobian and velocity are zero.
class ToolMotion {
 public:
  /// `tool`: frame of the tool; empty if the robot has none. `base`: frame of the robot that
  /// carries the surface; empty if the surface is fixed in the world. Throws Error for an unknown
  /// frame.
  ToolMotion(const RigidBody& body, const std::string& tool, const std::string& base)
      : tool_(tool.empty() ? -1 : body.frame(tool)),
        base_(base.empty() ? -1 : body.frame(base)),
        centered_(Reference::centered()),
        at_tool_{Anchor(tool.empty() ? Anchor::World : Anchor(tool)), Anchor::World},
        jacobian_(RowMatrix::Zero(6, body.nv())) {
    update(body);  // allocates here, not in a tick
  }

  /// Updates the Jacobian to the state of `body`, which must belong to the same robot. Does not
  /// allocate.
  void update(const RigidBody& body) {
    if (tool_ < 0) return;
    body.frame_jacobian(tool_, centered_, jacobian_);
    if (base_ < 0) return;
    body.frame_jacobian(base_, at_tool_, base_jacobian_);
    jacobian_.topRows<3>() -= base_jacobian_.topRows<3>();
  }

  /// Returns the Jacobian of the relative velocity, 3 x nv, in world axes.
  auto jacobian() const { return jacobian_.topRows<3>(); }
  /// Returns the velocity of the tool relative to the surface at the state of `body`, in world axes
  /// [m/s].
  Eigen::Vector3d velocity(const RigidBody& body) const {
    if (tool_ < 0) return Eigen::Vector3d::Zero();
    Eigen::Vector3d v = body.velocity(tool_, centered_).head<3>();
    if (base_ >= 0) v -= body.velocity(base_, at_tool_).head<3>();
    return v;
  }

 private:
  int tool_, base_;               ///< Frames of the robot; tool_ -1: no tool; base_ -1: the world.
  Reference centered_, at_tool_;  ///< Stored, because their construction takes time.
  RowMatrix jacobian_, base_jacobian_;
};

}  // namespace burnish
