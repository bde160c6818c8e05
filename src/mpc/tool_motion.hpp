// How the tool moves against the surface that it presses on, which the robot may carry itself.
#pragma once

#include <string>

#include "burnish/derivatives/rigid_body.hpp"

namespace burnish {

/// Of the tool's origin less that of what the robot carries there: what a force between the two
/// does work along. Without a base the tool's own, in the world.
class ToolMotion {
 public:
  /// base: frame of the robot; empty: the world. Throws Error for an unknown frame.
  ToolMotion(const RigidBody& body, const std::string& tool, const std::string& base)
      : tool_(body.frame(tool)),
        base_(base.empty() ? -1 : body.frame(base)),
        at_tool_{Anchor(tool), Anchor::World} {
    update(body);  // sized here, not in a tick
  }

  /// At the state of `body`, of the same robot. Allocates nothing.
  void update(const RigidBody& body) {
    body.frame_derivatives(tool_, Reference::centered(), motion_);
    if (base_ < 0) return;
    body.frame_derivatives(base_, at_tool_, base_motion_);
    motion_.jacobian.topRows<3>() -= base_motion_.jacobian.topRows<3>();
  }

  /// 3 x nv, world axes.
  auto jacobian() const { return motion_.jacobian.topRows<3>(); }
  /// m/s, world axes, at the state of `body`.
  Eigen::Vector3d velocity(const RigidBody& body) const {
    Eigen::Vector3d v = body.velocity(tool_, Reference::centered()).head<3>();
    if (base_ >= 0) v -= body.velocity(base_, at_tool_).head<3>();
    return v;
  }

 private:
  int tool_, base_;  ///< frames
  Reference at_tool_;
  FrameDerivatives motion_, base_motion_;
};

}  // namespace burnish
