// What the tool meets: a surface of some shape, position and orientation, and a round tip.
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <string>
#include <vector>

#include "burnish/dynamics/surface_shape.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// How a surface moves along its normal, as a plant has it: by amplitude sin(2 pi frequency s) +
/// drift s, s being the time since its start; before, it rests.
/// @described sim
struct SurfaceMotion {
  double amplitude = 0.0;  ///< [m], >= 0
  double frequency = 1.0;  ///< [Hz], > 0
  double drift = 0.0;      ///< [m/s], out of the material
  double start = 0.0;      ///< [s], of the plant's time, >= 0

  bool is_at_rest() const { return amplitude == 0.0 && drift == 0.0; }
  /// m that it has moved out of the material at a time, s.
  double way(double time) const noexcept;
};

/// A plane or a curved surface, or what of it stands over a square. All vectors in the axes of
/// `frame`, points from its origin: in the world where there is none.
/// @described sim
struct SurfaceSpec {
  /// of the robot, that the surface moves with, such as a plate in a hand; empty: it stands still
  std::string frame = {};
  /// any point on it, {m}; of a square, its middle
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  /// out of the material, towards the robot; of a curved surface at its point, not zero
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  SurfaceShape shape = {};  ///< plane, or what it is about that point
  double friction = 0.0;    ///< Coulomb coefficient mu, >= 0
  double stiffness = 1e5;   ///< [N/m]; rigid plants pass it over, > 0
  /// {Ns/m}; rigid plants pass it over, >= 0 @more MuJoCo's own contact (MujocoContact.ENGINE)
  /// lifts a sliding tip by mu * damping * speed.
  double damping = 500.0;
  SurfaceMotion motion = {};  ///< along the normal at its point
  /// [m], half the side of the square about `point` that is there to be touched, its sides along
  /// the columns of Reference::surface_with_normal(); infinite: the plane has no end, > 0 or
  /// infinite
  double extent = std::numeric_limits<double>::infinity();
  double half_size = 0.4;  ///< [m], of the square that is drawn where the plane has no end, > 0
};

/// A sphere about the origin of a frame. It touches a plane at one point, and the normal force
/// passes through the frame's origin.
/// @described sim
struct ToolTipSpec {
  std::string frame = "tool";
  double radius = 0.02;  ///< [m], > 0
};

/// A part of the robot that stands on a plane of its own, or leans against it, with nothing to hold
/// it there but what it presses with: a sole, which is a rectangle about the origin of a frame in
/// that frame's x and y, with z away from the plane, or without sides a ball about the origin.
/// @described sim
struct SupportSpec {
  std::string frame = {};
  double half_x = 0.0;   ///< [m], half the side of a sole along x; 0: a ball, >= 0
  double half_y = 0.0;   ///< [m], along y, >= 0
  double radius = 0.02;  ///< [m], of a ball, > 0
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< of the plane, {m}, world
  /// of the plane, out of the material, towards the robot; any length, world, not zero
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double friction = 0.7;   ///< Coulomb coefficient, >= 0
  double stiffness = 2e6;  ///< [N/m], of the whole part, > 0
  double damping = 1e5;    ///< {Ns/m}, of the whole part, > 0

  bool is_sole() const { return half_x > 0.0 && half_y > 0.0; }
};

/// Ground that is slippery for a while, under one of the things that the robot stands on.
/// @described sim
struct SlipperyGround {
  double start = 0.0;  ///< [s]
  /// [s], >= 0 or infinite @word forever
  double duration = std::numeric_limits<double>::infinity();
  /// of the support that stands on it; all: of all @code of the support that stands on it; empty:
  /// of all @word all
  std::string frame = {};
  double friction = 0.05;  ///< Coulomb coefficient in place of the support's, >= 0
};

/// What holds the robot by a frame at first, as a crane does, and lets it go: its weight, upwards
/// at that frame, and a stiff spring and damper about where that was, in place and rotation. It has
/// all of it for the first half of `duration` and gives it to what the robot stands on in the
/// second.
/// @described sim
struct HoistSpec {
  std::string frame = {};  ///< empty: nothing holds it
  double duration = 0.0;   ///< [s], until it has let go, >= 0

  bool holds() const { return !frame.empty() && duration > 0.0; }
  /// Of its force, that it has at a time, s: 1 at first, 0 at the end.
  double share(double time) const noexcept;
};

/// What the tool meets, a surface and a round tip, and what the robot stands on.
/// @described sim
struct SceneSpec {
  SurfaceSpec surface = {};
  ToolTipSpec tip = {};
  std::vector<SupportSpec> supports = {};            ///< such as the feet, on the ground
  std::vector<SlipperyGround> slippery_ground = {};  ///< under those
  HoistSpec hoist = {};                              ///< of a ClosedLoop, not the plant's
};

/// Whether something that begins at `start` and lasts `duration` acts at a time; all in s.
bool acts_at(double start, double duration, double time) noexcept;
template <class Spell>
bool acts_at(const Spell& spell, double time) noexcept {
  return acts_at(spell.start, spell.duration, time);
}
/// Coulomb coefficient of what a support of the scene stands on, at a time, s. No allocation.
double friction_under(const SceneSpec& scene, const SupportSpec& support, double time) noexcept;

/// The scene with a normal of length one. Throws Error for numbers that are not finite, a zero
/// normal, negative friction or damping, stiffness, radius, extent or size that are not positive,
/// a shape that is none or that the tip does not fit into, an unknown frame of the tip, the surface
/// or a support, one that does not move, a surface on the body of the tip, and a sole with one
/// side.
SceneSpec checked_scene(const Model& model, const SceneSpec& scene);

/// The scene with its surface put under the tip at the configuration q (nq): `clearance` m between
/// tip and surface along `normal` (in the axes of the surface, any length). Throws Error as
/// checked_scene() does.
SceneSpec scene_under_tip(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                          const Eigen::Vector3d& normal, SceneSpec scene = {},
                          double clearance = 0.0);

/// The surface in its place, in the axes of its frame.
Surface surface_of(const SurfaceSpec& surface);

/// Of the surface's frame in the world at the configuration q (nq); the identity where it has none.
/// What follows takes the tip as that frame sees it.
Eigen::Isometry3d surface_placement(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                                    const SurfaceSpec& surface);

/// A surface that the robot carries as it stands in the world while its frame is there.
SurfaceSpec in_world(SurfaceSpec surface, const Eigen::Isometry3d& placement);

/// Distance from the tip to the surface, m; negative inside. The position of the tip's frame is in
/// the axes of the surface's, the scene's normal of length one.
double gap(const SceneSpec& scene, const Eigen::Vector3d& p_tip);
/// The surface's normal at the tip, of length one, in the same axes. No allocation.
Eigen::Vector3d normal_at(const SceneSpec& scene, const Eigen::Vector3d& p_tip);

/// Where a point is, seen from the surface, m: along the two sides of its square from its middle,
/// and above it. The scene's normal has length one. No allocation.
Eigen::Vector3d seen_from_surface(const SurfaceSpec& surface, const Eigen::Vector3d& p);

/// Whether a tip there can touch the surface: its centre is above the square, or was while it
/// touched and has sunk since (`in_contact`), however deep into what is soft. Always, where the
/// plane has no end. No allocation.
bool is_over(const SceneSpec& scene, const Eigen::Vector3d& p_tip, bool in_contact);

}  // namespace burnish
