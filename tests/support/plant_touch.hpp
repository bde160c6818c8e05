// Touches of plants: scenes with one tip, forces in world axes, and forces as joint torques.
#pragma once

#include <string>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/sim/plant.hpp"

namespace burnish::test {

/// Round tip of a tool on a plane through the world's origin. A sensor measures its force.
inline TouchSpec round_tip(const std::string& frame = "tool") { return {.frame = frame}; }

/// Scene with a tip whose surface is out of reach.
inline SceneSpec out_of_reach(const std::string& frame = "tool", double height = -100.0) {
  TouchSpec tip = round_tip(frame);
  tip.surface.point.z() = height;
  return {.touches = {tip}};
}

/// Scene with a round tip on a plane; `clearance` is the distance of the tip from the plane [m].
inline SceneSpec plane_under_tip(const Model& model, const Eigen::VectorXd& q,
                                 const Eigen::Vector3d& normal, double clearance = 0.0,
                                 double friction = 0.0) {
  TouchSpec tip = round_tip();
  tip.surface.friction = friction;
  return {.touches = {with_surface_at(model, q, normal, tip, clearance)}};
}

/// Whether a touch of the scene was in contact during the plant's last step.
inline bool is_touching(const Plant& plant, Eigen::Index touch = 0) {
  return !plant.wrenches().col(touch).isZero(0.0);
}

/// Returns the force of the surface on a touch during the plant's last step, in world axes [N].
/// `q_before`: configuration at the start of this step.
inline Eigen::Vector3d force_world(const Plant& plant, const Eigen::VectorXd& q_before,
                                   Eigen::Index touch = 0) {
  const TouchSpec& spec = plant.scene().touches.at(static_cast<std::size_t>(touch));
  return frame_placement(plant.model(), q_before, spec.frame).linear() *
         plant.wrenches().col(touch).head<3>();
}

/// Returns the joint torques J^T f of a force on a frame, at the state of `body`.
inline Eigen::VectorXd torque_of_force(const RigidBody& body, const std::string& frame,
                                       const Eigen::Vector3d& f_world) {
  FrameDerivatives motion;
  body.frame_derivatives(body.frame(frame), Reference::centered(), motion);
  return motion.jacobian.topRows(3).transpose() * f_world;
}

}  // namespace burnish::test
