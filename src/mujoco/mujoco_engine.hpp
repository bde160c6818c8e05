// MuJoCo's model and data for a robot and a scene: tools and feet with the surfaces they touch.
#pragma once

#include "burnish/base/views.hpp"
#include "burnish/mujoco/mujoco_plant.hpp"
#include "mujoco/mujoco_coordinates.hpp"
#include "mujoco/mujoco_description.hpp"

namespace burnish::mujoco {

/// MuJoCo's ids of a touch: geom and body of the robot's part (tool or foot), geom of the surface,
/// site of the touch's frame, and site of the frame that carries the surface (-1: the surface is in
/// the world).
struct TouchIds {
  int geom, body, surface_geom, site, surface_site;
};

/// MuJoCo model of make_mujoco_plant(), with public members for tests.
struct Engine {
  Engine(const Model& robot, const SceneSpec& wanted, const MujocoPlantOptions& options);

  Model model;
  SceneSpec scene;
  ModelPointer m;
  DataPointer d;
  Coordinates coordinates;
  std::vector<TouchIds> touches;  ///< Touches of the scene, in its order
  bool own_contact;               ///< Whether MuJoCo computes contacts of tools, not only supports

  /// Returns whether MuJoCo computes the contact of a touch.
  bool computes(const TouchSpec& touch) const { return own_contact || touch.is_support; }

  /// Stiffens the equality constraints of followers and loops, so that their error is 1e-8 of the
  /// acceleration. Must be called between mj_fwdPosition() and mj_fwdConstraint().
  void stiffen_equalities() const;

  /// Lets tools and their surfaces collide only if there is surface under the tool, at the
  /// configuration in `d`. `wrenches` (6 x touches) are the contact wrenches of the previous step.
  /// Must be called before mj_fwdPosition().
  void update_surface_extents(const Wrenches& wrenches) const;

  /// Sets the friction of every support at a time [s], if the scene has slippery ground. Must be
  /// called before mj_fwdPosition().
  void update_ground_friction(double time) const noexcept;

  using AxesMap = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;
  /// Returns the axes of the touch's frame in world axes, at the last mj_fwdPosition().
  AxesMap axes_of(const TouchIds& touch) const { return AxesMap(d->site_xmat + 9 * touch.site); }

  /// Returns the wrench that MuJoCo's contacts exert on a touch at the last mj_fwdConstraint():
  /// force [N] and moment [Nm] about the origin of the touch's frame, in the axes of this frame.
  Vector6 contact_wrench(const TouchIds& touch) const;
};

}  // namespace burnish::mujoco
