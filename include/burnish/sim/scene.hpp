// Scene of a simulation: the parts of the robot that can touch something, such as the round tip of
// a tool or a foot, and the surface that each of them touches.
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/dynamics/surface_shape.hpp"
#include "burnish/estimate/measurement.hpp"
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

/// Surface that a part of the robot touches: a plane, a curved surface, or a square part of a plane
/// or curved surface. Points are relative to the origin of `frame`; points and vectors are in the
/// axes of `frame`. Without a frame, world coordinates are used.
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

/// A touch: a part of the robot that can touch a surface, such as the tip of a tool, a hand or a
/// foot. The frame names the touch. The part is either a sphere or a rectangle, and touches nothing
/// but its own surface. The surface can push on the part, but not pull.
///
/// A sphere is centred at the origin of `frame`. It touches the surface at one point. The normal
/// force passes through the origin, and friction has a moment about the origin. A rectangle (sole)
/// is centred at the origin of `frame`, with sides along the x and y axes of `frame`. Its z axis
/// points away from the surface. The rectangle stands on its four corners.
/// @described sim
struct TouchSpec {
  /// Frame at the centre of the sphere or rectangle; names the touch
  std::string frame = {};
  double half_x = 0.0;       ///< Half length of a rectangle along x (0: a sphere) [m], >= 0
  double half_y = 0.0;       ///< Half length of a rectangle along y (0: a sphere) [m], >= 0
  double radius = 0.02;      ///< Radius of a sphere; not used for a rectangle [m], > 0
  SurfaceSpec surface = {};  ///< Surface that the part touches; by default without friction
  /// Whether the part is a support, on which the robot stands or leans; if false, it is a tool
  /// @more A rectangle must be a support. The surface of a support must be a plane that is fixed in
  /// the world and has an infinite `extent`
  bool is_support = false;
  /// Components that the robot measures (automatic: force of a tool, force and moment of a support)
  WrenchSensor sensor = WrenchSensor::Automatic;

  bool is_rectangle() const { return half_x > 0.0 && half_y > 0.0; }
  /// Returns `sensor`, or the components that Automatic stands for.
  WrenchSensor measured() const;
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

/// Scene of a simulation: what the robot touches, and with which parts.
/// @described sim
struct SceneSpec {
  /// Parts of the robot that can touch a surface, each with its own frame
  std::vector<TouchSpec> touches = {};
  /// Slippery ground under supports
  std::vector<SlipperyGround> slippery_ground = {};
  /// Gantry that holds the robot at the start
  /// @more The gantry is simulated by ClosedLoop, not by the plant
  HoistSpec hoist = {};

  /// Returns the index of the first touch that is not a support; -1 if there is none. This touch is
  /// the tool in traces.
  int tool_index() const noexcept;
  /// Returns the touch at tool_index(). Throws Error if there is none.
  const TouchSpec& tool() const;
  TouchSpec& tool();
  std::vector<TouchSpec> supports() const;  ///< Returns the touches that are supports.
  /// Returns the touch whose frame is `frame`. Throws Error if there is none.
  const TouchSpec& touch(std::string_view frame) const;
};

/// Returns whether `time` is between the start of an event and its end, all in s. The event starts
/// at `start` and lasts for `duration`.
bool acts_at(double start, double duration, double time) noexcept;
template <class Spell>
bool acts_at(const Spell& spell, double time) noexcept {
  return acts_at(spell.start, spell.duration, time);
}
/// Returns the Coulomb friction coefficient under a support at `time` [s]. While the ground under
/// the support is slippery, this is the coefficient of the slippery ground, otherwise that of the
/// support's surface. Allocates nothing.
double friction_under(const SceneSpec& scene, const TouchSpec& support, double time) noexcept;

/// Returns the scene with all normals scaled to length one. Throws Error for
/// - a number that is not finite (unless infinity is permitted) or out of its range,
/// - a zero normal,
/// - an invalid shape, or a hollow shape into which a sphere does not fit,
/// - a frame (of a touch, surface or gantry) that is unknown or fixed to the world,
/// - two touches with the same frame,
/// - a surface on the same body as the part that touches it,
/// - a touch with only one of half_x and half_y above zero, or a rectangle that is not a support,
/// - a support whose surface is curved, moves, has edges or is carried by the robot,
/// - slippery ground under a frame that is not a support.
SceneSpec checked_scene(const Model& model, const SceneSpec& scene);

/// Returns `touch` with its surface moved to the touch at the configuration q (nq). The surface's
/// normal is set to `normal`, a vector of any length in the axes of the surface's frame. The
/// surface's point is on the line through the origin of the touch's frame along `normal`.
/// `clearance` is the distance from the sphere to that point [m]; for a rectangle, the distance
/// from its centre. Throws Error if checked_scene() rejects the touch.
TouchSpec with_surface_at(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                          const Eigen::Vector3d& normal, TouchSpec touch, double clearance = 0.0);

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

/// Returns the distance from the sphere of a touch to its surface [m]; negative if the sphere is
/// inside the material. `p` is the origin of the touch's frame, in coordinates of the surface's
/// frame. The surface normal must have length one.
double gap(const TouchSpec& touch, const Eigen::Vector3d& p);
/// Returns the normal of `surface` at its point nearest to `p`, of length one. `p` and the normal
/// are in the axes of the surface's frame. Allocates nothing.
Eigen::Vector3d normal_at(const SurfaceSpec& surface, const Eigen::Vector3d& p);

/// Returns the coordinates of the point `p` relative to the centre of the surface's square [m]: x
/// and y along the sides, z along the normal. `p` is in the axes of the surface's frame. The
/// surface's normal must have length one. Allocates nothing.
Eigen::Vector3d seen_from_surface(const SurfaceSpec& surface, const Eigen::Vector3d& p);

/// Returns whether the sphere of a touch can touch its surface. `p` is the origin of the touch's
/// frame, in coordinates of the surface's frame. If SurfaceSpec::extent is infinite, returns true.
/// Otherwise, the sphere's centre must be over the square. If `in_contact` is false, the centre
/// must also be outside the material. The surface normal must have length one. Allocates nothing.
bool is_over(const TouchSpec& touch, const Eigen::Vector3d& p, bool in_contact);

}  // namespace burnish
