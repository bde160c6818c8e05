// MuJoCo loaded with a robot, a tip and a surface.
#pragma once

#include "burnish/mujoco/mujoco_plant.hpp"
#include "mujoco/mujoco_coordinates.hpp"
#include "mujoco/mujoco_description.hpp"

namespace burnish::mujoco {

/// A part of the robot that stands on a plane: what MuJoCo calls them both, and where forces are
/// taken at.
struct Support {
  int geom, plane, site;
};

/// Everything that make_mujoco_plant() compiles, open to be looked into.
struct Engine {
  Engine(const Model& robot, const SceneSpec& wanted, const MujocoPlantOptions& options);

  Model model;
  SceneSpec scene;
  ModelPointer m;
  DataPointer d;
  Coordinates coordinates;
  int tip_geom, surface_geom, tip_site, tip_body;
  int surface_site;               ///< of the frame that carries the surface; -1: none does
  std::vector<Support> supports;  ///< of the scene, in its order
  bool own_contact;               ///< MujocoContact::Engine

  /// Between mj_fwdPosition() and mj_fwdConstraint(): followers keep to their leaders,
  /// and loops together, to 1e-8 of the acceleration.
  void stiffen_equalities() const;

  /// Lets tip and surface collide at the configuration in `d` where there is surface under the tip,
  /// and only there; `in_contact`: whether they touched in the step before. To be called before
  /// mj_fwdPosition().
  void meet_where_there_is_surface(bool in_contact) const;

  /// Gives every support the friction of what it stands on at a time, s, where that changes. To be
  /// called before mj_fwdPosition().
  void slip(double time) const noexcept;

  /// Force of the surface on the tip, N, world axes, at the last mj_fwdConstraint(). MuJoCo orders
  /// the two geoms by their types, so the ids say which way it points.
  Eigen::Vector3d contact_force_world() const;

  /// Force and moment of its plane on a support, N and Nm, at the origin of its frame and in the
  /// frame's axes, at the last mj_fwdConstraint().
  Eigen::Matrix<double, 6, 1> support_wrench(const Support& support) const;
};

}  // namespace burnish::mujoco
