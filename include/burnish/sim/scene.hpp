// Scene of a simulation: a surface with its shape, position and orientation, the round tip of a
// tool, and the planes that the robot stands on.
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <string>
#include <vector>

#include "burnish/dynamics/surface_shape.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Motion of the plant's surface along its normal. The displacement is amplitude sin(2 pi frequency
/// s) + drift s, where s is the time since `start`. Before `start` the surface rests.
/// @described sim
struct SurfaceMotion {
  double amplitude = 0.0;  ///< Amplitude of the oscillation [m], >= 0
  double frequency = 1.0;  ///< Frequency of the oscillation [Hz], > 0
  /// Constant velocity of the surface along its normal, positive out of the material [m/s]
  double drift = 0.0;
  double start = 0.0;  ///< Plant time at which the motion starts [s], >= 0

  bool is_at_rest() const { return amplitude == 0.0 && drift == 0.0; }
  /// Returns the displacement at `time` [s], positive out of the material [m].
  double displacement(double time) const noexcept;
};

/// Surface that the tool touches: a plane, a curved surface, or a square part of a plane or curved
/// surface. Points are relative to the origin of `frame`; points and vectors are in the axes of
/// `frame`. Without a frame, world coordinates are used.
/// @described sim
struct SurfaceSpec {
  /// Frame of the robot that carries the surface (empty: the surface is fixed in the world)
  /// @more Example: the frame of a plate in a hand
  std::string frame = {};
  /// A point of the surface [m]
  /// @more If `extent` is finite, the point is the centre of the square
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  /// Normal of the surface at `point` (out of the material, towards the robot), not zero
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  /// Shape of the surface around `point`
  SurfaceShape shape = {};
  /// Coulomb friction coefficient mu, >= 0
  double friction = 0.0;
  /// Contact stiffness (not used by rigid plants) [N/m], > 0
  double stiffness = 1e5;
  /// Contact damping (not used by rigid plants) [Ns/m], >= 0
  /// @more MuJoCo's own contact (MujocoContact.ENGINE) lifts a sliding tip with a force of mu *
  /// damping * speed.
  double damping = 500.0;
  /// Motion of the surface along its normal
  SurfaceMotion motion = {};
  /// Half side length of the square that can be touched [m], > 0 or infinite
  /// @more If the value is infinite, the whole surface can be touched. The square is centred at
  /// `point`, and its sides are along the columns of Reference::surface_with_normal()
  double extent = std::numeric_limits<double>::infinity();
  /// Half side length of the square that is drawn if `extent` is infinite [m], > 0
  double half_size = 0.4;
};

/// Round tip of a tool: a sphere centred at the origin of a frame. The sphere touches a plane at
/// one point, and the normal force passes through the frame's origin.
/// @described sim
struct ToolTipSpec {
  std::string frame = "tool";  ///< Frame at the sphere's centre (empty: the robot has no tool)
  double radius = 0.02;        ///< Radius of the sphere [m], > 0

  bool exists() const { return !frame.empty(); }
};

/// A part of the robot that stands on a plane or leans against it, such as a foot. Each support has
/// its own plane. The plane can push on the support, but not pull. A support is either a sole
/// (planar foot) or a ball (point foot).
///
/// A sole is a rectangle centred at the origin of `frame`, with sides along the frame's x and y
/// axes. The frame's z axis points away from the plane. A ball is a sphere centred at the origin of
/// `frame`.
/// @described sim
struct SupportSpec {
  /// Frame at the centre of the sole or ball
  std::string frame = {};
  /// Half length of a sole along x (0: a ball) [m], >= 0
  double half_x = 0.0;
  /// Half length of a sole along y (0: a ball) [m], >= 0
  double half_y = 0.0;
  /// Radius of a ball [m], > 0
  double radius = 0.02;
  /// A point of the plane, in world coordinates [m]
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  /// Normal of the plane in world axes (out of the material, towards the robot), not zero
  /// @more The normal may have any length
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double friction = 0.7;   ///< Coulomb friction coefficient, >= 0
  double stiffness = 2e6;  ///< Contact stiffness of the whole sole or ball [N/m], > 0
  double damping = 1e5;    ///< Contact damping of the whole sole or ball [Ns/m], > 0

  bool is_sole() const { return half_x > 0.0 && half_y > 0.0; }
};

/// Ground that is slippery for a limited time, under one support of the robot or under all
/// supports.
/// @described sim
struct SlipperyGround {
  /// Time at which the ground becomes slippery [s]
  double start = 0.0;
  /// Duration of the slippery ground [s], >= 0 or infinite @word forever
  double duration = std::numeric_limits<double>::infinity();
  /// Frame of the support that stands on slippery ground (all, or empty: every support)
  /// @word all
  std::string frame = {};
  /// Coulomb friction coefficient of the slippery ground, >= 0
  /// @more This coefficient replaces the friction coefficient of the support
  double friction = 0.05;
};

/// A gantry that holds a frame of the robot at the start of a simulation and then releases the
/// robot. The gantry carries the robot's weight at this frame. In addition, a stiff spring and
/// damper hold the frame at its initial position and rotation.
///
/// During the first half of `duration` the full force acts. During the second half the force falls
/// to zero, and the supports take over the load.
/// @described sim
struct HoistSpec {
  std::string frame = {};  ///< Frame that the gantry holds (empty: no gantry)
  double duration = 0.0;   ///< Time at which the gantry has released the robot [s], >= 0

  bool holds() const { return !frame.empty() && duration > 0.0; }
  /// Returns the fraction of the gantry's force that acts at `time` [s]: 1 up to half of
  /// `duration`, then falling to 0 at `duration`.
  double load_fraction(double time) const noexcept;
};

/// Scene of a simulation: the surface, the tool's tip, and what the robot stands on.
/// @described sim
struct SceneSpec {
  /// Surface that the tool touches
  /// @more Nothing touches the surface if the robot has no tool
  SurfaceSpec surface = {};
  ToolTipSpec tip = {};
  /// Parts of the robot that stand on a plane, such as feet
  std::vector<SupportSpec> supports = {};
  /// Slippery ground under supports
  std::vector<SlipperyGround> slippery_ground = {};
  /// Gantry that holds the robot at the start
  /// @more The gantry is simulated by ClosedLoop, not by the plant
  HoistSpec hoist = {};
};

/// Returns whether `time` is between the start of an event and its end, all in s. The event starts
/// at `start` and lasts for `duration`.
bool acts_at(double start, double duration, double time) noexcept;
template <class Spell>
bool acts_at(const Spell& spell, double time) noexcept {
  return acts_at(spell.start, spell.duration, time);
}
/// Returns the Coulomb friction coefficient under a support at `time` [s]. While the ground under
/// the support is slippery, this is the coefficient of the slippery ground, otherwise the
/// coefficient of the support. Allocates nothing.
double friction_under(const SceneSpec& scene, const SupportSpec& support, double time) noexcept;

/// Returns the scene with all normals scaled to length one. Throws Error for
/// - a number that is not finite (unless infinity is permitted) or out of its range,
/// - a zero normal,
/// - an invalid shape, or a hollow shape into which the tip does not fit,
/// - a frame (of tip, surface, support or gantry) that is unknown or fixed to the world,
/// - a surface on the same body as the tip,
/// - a support with only one of half_x and half_y above zero,
/// - slippery ground under a frame that is not a support.
SceneSpec checked_scene(const Model& model, const SceneSpec& scene);

/// Returns `scene` with its surface moved to the tip at the configuration q (nq). The surface's
/// normal is set to `normal`, a vector of any length in the axes of the surface's frame.
/// `clearance` is the distance from tip to surface along the normal [m]. Throws Error if
/// checked_scene() rejects the scene, and for a scene without a tip.
SceneSpec scene_under_tip(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                          const Eigen::Vector3d& normal, SceneSpec scene = {},
                          double clearance = 0.0);

/// Returns a Surface with the shape, point and normal of `surface`, in the axes of the surface's
/// frame.
Surface surface_of(const SurfaceSpec& surface);

/// Returns the world placement of the frame that carries the surface, at the configuration q (nq).
/// If the surface is fixed in the world, returns the identity.
Eigen::Isometry3d surface_placement(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                                    const SurfaceSpec& surface);

/// Converts a surface that the robot carries to a surface that is fixed in the world. `placement`
/// is the world placement of the surface's frame.
SurfaceSpec in_world(SurfaceSpec surface, const Eigen::Isometry3d& placement);

/// Returns the distance from the tip to the surface [m]; negative if the tip is inside the
/// material. `p_tip` is the position of the tip's frame, in the axes of the surface's frame. The
/// surface normal of the scene must have length one.
double gap(const SceneSpec& scene, const Eigen::Vector3d& p_tip);
/// Returns the surface's normal at the tip, of length one. `p_tip` is the position of the tip's
/// frame. Position and normal are in the axes of the surface's frame. Allocates nothing.
Eigen::Vector3d normal_at(const SceneSpec& scene, const Eigen::Vector3d& p_tip);

/// Returns the coordinates of the point `p` relative to the centre of the surface's square [m]: x
/// and y along the sides, z along the normal. `p` is in the axes of the surface's frame. The
/// surface's normal must have length one. Allocates nothing.
Eigen::Vector3d seen_from_surface(const SurfaceSpec& surface, const Eigen::Vector3d& p);

/// Returns whether a tip at `p_tip` can touch the surface. If SurfaceSpec::extent is infinite,
/// returns true. Otherwise, the tip's centre must be over the square. If `in_contact` is false, the
/// tip's centre must also be outside the material. Allocates nothing.
bool is_over(const SceneSpec& scene, const Eigen::Vector3d& p_tip, bool in_contact);

}  // namespace burnish
