// Motion of a tool and of the surface that it touches, for the trace of a simulation.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "base/to_size.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/estimate/measurement.hpp"
#include "burnish/sim/scene.hpp"

namespace burnish {

/// Returns the rotation vector of a rotation matrix [rad].
inline Eigen::Vector3d vector_of(const Eigen::Matrix3d& R) {
  const Eigen::AngleAxisd turn(R);
  return turn.angle() * turn.axis();
}

/// Motion of a tool and of the surface that it touches.
struct TracedTool {
  TracedTool(const SceneSpec& scene, Eigen::Index index, const RigidBody& body,
             const std::vector<std::string>& measured)
      : touch(index), surface(scene.touches[to_size(index)].surface) {
    const std::string& name = scene.touches[to_size(index)].frame;
    frame = body.frame(name);
    if (!surface.frame.empty()) carrier = body.frame(surface.frame);
    const auto at = std::find(measured.begin(), measured.end(), name);
    if (at != measured.end()) column = at - measured.begin();
  }

  void place(const RigidBody& body) noexcept {
    if (carrier >= 0) surface_world = body.placement(carrier);
    const Eigen::Isometry3d placement = body.placement(frame);
    p_world = placement.translation();
    R_world = placement.linear();
    turned =
        vector_of(start_R.transpose() * (surface_world.linear().transpose() * placement.linear()));
  }
  void start(const RigidBody& body) noexcept {
    if (carrier >= 0) surface_world = body.placement(carrier);
    start_R = surface_world.linear().transpose() * body.placement(frame).linear();
  }
  void measure(const Measurement& m) noexcept {
    if (column >= 0) measured_force_world = R_world * m.wrenches.col(column).head<3>();
  }
  /// Returns the true normal of the surface at the tool, in world axes.
  Eigen::Vector3d normal_world(double time) const noexcept {
    const double moved = surface.motion.displacement(time);
    const Eigen::Vector3d p_tool = surface_world.inverse() * p_world;
    return surface_world.linear() * normal_at(surface, p_tool - moved * surface.normal);
  }

  Eigen::Index touch;        ///< Index of the tool in SceneSpec::touches.
  Eigen::Index column = -1;  ///< Column of Measurement::wrenches for the tool; -1: not measured.
  SurfaceSpec surface;
  int frame = -1;
  int carrier = -1;  ///< Frame that carries the surface; -1: the world.
  /// Rotation of the tool at the start, in the axes of the surface.
  Eigen::Matrix3d start_R = Eigen::Matrix3d::Identity();
  /// Placement of the frame that carries the surface.
  Eigen::Isometry3d surface_world = Eigen::Isometry3d::Identity();
  Eigen::Vector3d p_world = Eigen::Vector3d::Zero();
  Eigen::Matrix3d R_world = Eigen::Matrix3d::Identity();
  /// Force reading at the last tick [N]; NaN if the controller does not read the force.
  Eigen::Vector3d measured_force_world =
      Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  /// Rotation vector of the tool since the start, in the axes of the surface [rad].
  Eigen::Vector3d turned = Eigen::Vector3d::Zero();
};

}  // namespace burnish
