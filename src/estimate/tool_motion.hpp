// Motion of the tool relative to the surface, which a frame of the robot may carry.
#pragma once

#include <string>

#include "burnish/derivatives/rigid_body.hpp"

namespace burnish {

/// Frames of a tool and of its surface.
struct ToolFrames {
  std::string tool;     ///< Frame of the tool.
  std::string surface;  ///< Frame of the robot that carries the surface; empty: the world.
};

/// Jacobian and velocity of the tool's origin relative to the surface. A force between tool and
/// surface does work along this velocity. If the robot frame `base` carries the surface, the motion
/// is relative to the point of that body at the tool's origin; otherwise, it is relative to the
/// world.
class ToolMotion {
 public:
  /// Throws Error for an unknown frame.
  ToolMotion(const RigidBody& body, const ToolFrames& frames)
      : tool_(body.frame(frames.tool)),
        base_(frames.surface.empty() ? -1 : body.frame(frames.surface)),
        centered_(Reference::centered()),
        at_tool_{Anchor(frames.tool), Anchor::World},
        jacobian_(RowMatrix::Zero(6, body.nv())) {
    update(body);  // allocates here, not in a tick
  }

  /// Updates the Jacobian to the state of `body`, which must belong to the same robot. Does not
  /// allocate.
  void update(const RigidBody& body) {
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
    Eigen::Vector3d v = body.velocity(tool_, centered_).head<3>();
    if (base_ >= 0) v -= body.velocity(base_, at_tool_).head<3>();
    return v;
  }

 private:
  int tool_, base_;               ///< Frames of the robot; base_ -1: the world.
  Reference centered_, at_tool_;  ///< Stored, because their construction takes time.
  RowMatrix jacobian_, base_jacobian_;
};

}  // namespace burnish
