// MuJoCo's model and data for a robot, a tip, a surface and supports.
#pragma once

#include "burnish/mujoco/mujoco_plant.hpp"
#include "mujoco/mujoco_coordinates.hpp"
#include "mujoco/mujoco_description.hpp"

namespace burnish::mujoco {

/// MuJoCo's ids of a support: the geom of the foot, the geom of the plane below it, and the site at
/// which wrenches are computed.
struct Support {
  int geom, plane, site;
};

/// MuJoCo model of make_mujoco_plant(), with public members for tests.
struct Engine {
  Engine(const Model& robot, const SceneSpec& wanted, const MujocoPlantOptions& options);

  Model model;
  SceneSpec scene;
  ModelPointer m;
  DataPointer d;
  Coordinates coordinates;
  int tip_geom, surface_geom, tip_site, tip_body;  ///< -1 if the robot has no tool
  int surface_site;               ///< Site of the frame that carries the surface; -1: none
  std::vector<Support> supports;  ///< Supports of the scene, in its order
  bool own_contact;               ///< Whether the contact is MujocoContact::Engine

  bool has_tip() const { return tip_geom >= 0; }

  /// Stiffens the equality constraints of followers and loops, so that their error is 1e-8 of the
  /// acceleration. Must be called between mj_fwdPosition() and mj_fwdConstraint().
  void stiffen_equalities() const;

  /// Lets tip and surface collide only if there is surface under the tip, at the configuration in
  /// `d`. `in_contact` tells whether they touched in the previous step. Must be called before
  /// mj_fwdPosition().
  void update_surface_extent(bool in_contact) const;

  /// Sets the friction of every support at a time [s], if the scene has slippery ground. Must be
  /// called before mj_fwdPosition().
  void update_ground_friction(double time) const noexcept;

  /// Returns the force of the surface on the tip at the last mj_fwdConstraint(), in world axes [N].
  Eigen::Vector3d contact_force_world() const;

  /// Returns the wrench of the plane on a support at the last mj_fwdConstraint(): force [N] and
  /// moment [Nm] at the origin of the support's frame, in the frame's axes.
  Eigen::Matrix<double, 6, 1> support_wrench(const Support& support) const;
};

}  // namespace burnish::mujoco
