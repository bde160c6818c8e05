// What a cost term measures. Each residual is a plain value; its rows, their units and axes are
// said here, and docs/costs.md has the same with typical weights.
//
// A target may be left empty where that is said; its size is the residual's unless said otherwise.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "burnish/base/signal.hpp"
#include "burnish/contact/contact.hpp"
#include "burnish/dynamics/reference.hpp"
#include "burnish/ocp/node_view.hpp"

namespace burnish::residual {

/// x (-) target, ndx rows: dq (rad, m), dv (rad/s, m/s), dtau (Nm, N).
/// @described residual
/// The target is a state of nx entries; empty: the initial state of the problem.
struct State {
  Signal target = {};  ///< a state of nx entries; None: the initial state of the problem
};

/// u - target, nu rows, Nm (N).
/// @described residual
/// Empty target: zero.
struct Control {
  Signal target = {};  ///< None: zero
};

/// q_j - target for revolute and prismatic joints, one row each, rad or m. No joints: all of them
/// that have a limit.
/// @described residual
/// Empty target: zero, as limits want it.
struct JointPosition {
  std::vector<std::string> joints = {};  ///< @name_of joint
  Signal target = {};                    ///< None: zero, as limits want it
};

/// v - target for the entries of the named joints, rad/s or m/s; no joints: all but the free-flying
/// base.
/// @described residual
/// Empty target: zero.
struct JointVelocity {
  std::vector<std::string> joints = {};  ///< @name_of joint
  Signal target = {};                    ///< None: zero
};

/// What the actuators apply to the named joints minus the target, Nm or N: the control, or with a
/// cut-off of the torque model the torque state. No joints: all actuated ones.
/// @described residual
/// Empty target: zero.
struct JointTorque {
  std::vector<std::string> joints = {};  ///< @name_of joint
  Signal target = {};                    ///< None: zero
};

/// How fast the torques of the named joints follow the control, minus the target: cutoff (u - tau),
/// Nm/s or N/s, at the begin of the step, over which it decays; (u - tau) / step where torques are
/// held and tau is the control of the step before. With a torque model alone, where there is a
/// control. No joints: all actuated ones.
/// @described residual
/// Empty target: zero.
struct JointTorqueRate {
  std::vector<std::string> joints = {};  ///< @name_of joint
  Signal target = {};                    ///< None: zero
};

/// Origin of a frame minus the target, 3 rows, m, written in the axes of the reference, whose base
/// is the world. Its origin must not be the frame itself; where its axes follow a surface at the
/// frame (Reference.on) it is that of what the surface is fixed in, and the first two rows are how
/// far the target is along the tangents at the frame.
/// @described residual
struct FramePosition {
  std::string frame = {};  ///< @name_of frame @stated
  /// 3, {m}: from the reference's origin, in the axes that its rotation is fixed in; of
  /// Reference::world(...) a point of the world
  Signal target = {};
  Reference reference = Reference::world();
};

/// Distance of a frame's origin from the target, 1 row, m, measured along `directions` of the
/// reference, whose base is the world and whose origin must not be the frame itself: along all
/// three from a point, along two from a line, along one from a plane. It is sqrt(d^2 + (1e-6 m)^2),
/// so that it has a derivative everywhere; at d = 0 that is zero, as no direction leads away.
/// @described residual
struct FrameDistance {
  std::string frame = {};  ///< @name_of frame @stated
  /// 3, {m}, as of FramePosition. None: the reference's origin, unless that is the world's
  Signal target = {};
  Directions directions = Directions::linear();  ///< one or more of x, y and z
  Reference reference = Reference::world();
};

/// log(R_target^T A^T R), 3 rows, rad, target axes: how far the frame is from the target, which is
/// a rotation from the axes A of the reference, whose base is the world; its origin does not
/// matter.
/// @described residual
struct FrameRotation {
  std::string frame = {};  ///< @name_of frame @stated
  Signal target = {};      ///< quaternion x, y, z, w, of unit length
  Reference reference = Reference::world();
};

/// Lead and tilt of an axis of a frame minus the target, 2 rows, rad: the angles by which it leans
/// from the third axis of the reference, whose base is the world, towards the first and towards the
/// second: atan2(e_x, e_z) and atan2(e_y, e_z), with e the axis in the reference. How it is turned
/// about itself does not matter. With Reference.on the third axis is a surface's normal.
/// @described residual
struct FrameInclination {
  std::string frame = {};  ///< @name_of frame @stated
  Reference reference = Reference::world();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< 3, of any length, in the frame
  Signal target = {};                               ///< lead and tilt, {rad}; None: zero
};

/// Height of a frame's origin above the surface that the reference follows (Reference.on), minus
/// the target, 1 row, m: how far away the surface is along its normal at the frame, below zero in
/// the material. Exact for planes, spheres and cylinders, to first order for others; far outside of
/// a surface that the normal there misses it only grows.
/// @described residual
struct FrameHeight {
  std::string frame = {};                    ///< @name_of frame @stated
  Reference reference = Reference::world();  ///< @stated
  Signal target = {};                        ///< [m]; None: zero
};

/// SE(3) logarithm of the frame in the target: 3 rows m, 3 rows rad, target axes.
/// @described residual
struct FramePlacement {
  std::string frame = {};  ///< @name_of frame @stated
  Signal target = {};      ///< position (m), quaternion x, y, z, w
};

/// Velocity of a frame in the world minus the target, 6 rows: m/s, rad/s, written in the reference,
/// whose tool is the frame and whose base is the world.
/// @described residual
/// Empty target: zero.
struct FrameVelocity {
  std::string frame = {};  ///< @name_of frame @stated
  Reference reference = Reference::centered();
  Signal target = {};  ///< None: zero
};

/// Force of an active contact minus the target, N and Nm: the held rows in the contact's own
/// reference, or six rows in another one.
/// @described residual
/// Empty target: zero.
struct ContactForce {
  std::string contact = {};  ///< @name_of contact @stated
  std::optional<Reference> reference = {};
  Signal target = {};  ///< None: zero
};

/// How fast the force of an active contact changes from the step before to this one, minus the
/// target: (f - f_before) / step, N/s and Nm/s, the held rows in the contact's own reference. For
/// contacts that the problem remembers the force of.
/// @described residual
/// Empty target: zero.
struct ContactForceRate {
  std::string contact = {};  ///< @name_of contact @stated
  Signal target = {};        ///< None: zero
};

/// Two rows, N: friction * f_n - |f_t| (smoothed over 1e-3 N) and f_n, both to be kept above a
/// limit: the default penalty is a barrier at 0. f_n is the force along the axis `normal` of the
/// reference (0, 1, 2: x, y, z), f_t what stands at a right angle to it. With `sides` n a pyramid
/// inside the cone: n rows, N, friction * cos(pi / n) * f_n - d_i . f_t, where d_0 is the next axis
/// of the reference after the normal and the others follow every 360 / n degrees.
/// @described residual
/// `sides`: 3 to 32; d_i turn from the next axis (y after x, x after z) towards the one after that.
/// What keeps them at zero or above keeps the cone and f_n. One of the two directions along the
/// ground need not be held by the contact: its force is zero. To Problem::set_target its
/// coefficient is its target: what is under a foot may change.
struct FrictionCone {
  std::string contact = {};                 ///< @name_of contact @stated
  double friction = 0.5;                    ///< > 0
  int normal = 2;                           ///< @words x y z
  std::optional<Reference> reference = {};  ///< default: the contact's own
  int sides = 0;  ///< 3 to 32, of a pyramid inside the cone; 0: the cone itself, >= 0
};

/// Four rows, Nm: how far the centre of pressure is inside a rectangle of the tool's axes, times
/// the normal force f_z: half_x f_z +- m_y, half_y f_z +- m_x, both halves in m; zero where the
/// centre, which is (-m_y, m_x) / f_z, is at the edge above in x, below in x, below in y, above in
/// y. With friction eight rows more, Nm, four to the right and four to the left: how far the moment
/// about the normal is within what the corners bear with that coefficient each. Default penalty: a
/// barrier at 0.
/// @described residual
/// That is the less the nearer the centre is to an edge, and nothing at a corner, about which a
/// foot turns as on a nail (S. Caron, Q.-C. Pham, Y. Nakamura, "Stability of surface contacts for
/// humanoid robots: closed-form formulae of the contact wrench cone for rectangular support areas",
/// ICRA 2015, equations 21 and 22). Friction there is a pyramid, |f_x| and |f_y| each within the
/// coefficient times f_z: one inside the cone has that of the cone over sqrt(2). To
/// Problem::set_target the coefficient is its target. One direction beside the normal need not be
/// held by the contact: its force or moment is zero.
struct CenterOfPressure {
  std::string contact = {};  ///< @name_of contact @stated
  double half_x = 0.1;       ///< [m], > 0 @stated
  double half_y = 0.05;      ///< [m], > 0 @stated
  double friction = 0.0;     ///< 0: the moment about the normal is free, >= 0
};

/// Centre of mass minus the target, 3 rows, m, world.
/// @described residual
struct CenterOfMass {
  Signal target = {};
};

/// How far the centre of mass, seen from above, is inside of each edge of a support polygon: a row
/// per edge, m, all to be kept above a limit: the default penalty is a barrier at 0. Row i is of
/// the edge from point i to the next one, the last back to the first.
/// @described residual
struct SupportMargin {
  /// 3 or more, x and y in the world, {m}: the corners of a convex polygon, counter-clockwise as
  /// seen from above. Others are refused. @stated
  std::vector<Eigen::Vector2d> points = {};
};

/// Momentum about the centre of mass minus the target, 6 rows: kg m/s, kg m^2/s, world axes.
/// @described residual
/// Empty target: zero.
struct CentroidalMomentum {
  Signal target = {};  ///< None: zero
};

/// A residual of the user's own. Made by custom() from a plain struct; see examples/06.
struct Custom {
  std::string name = {};
  int rows = 0;
  std::vector<std::string> frames = {};  ///< that value and jacobian ask for, by place
  std::vector<std::string> contacts = {};
  std::function<void(const NodeView&, Eigen::Ref<Eigen::VectorXd>)> value = {};
  /// d(value)/dz, rows x nz, handed over zeroed; empty: central differences.
  std::function<void(const NodeView&, Eigen::Ref<RowMatrix>)> jacobian = {};
};

/// Any struct with `int rows` and `value(const NodeView&, Eigen::Ref<Eigen::VectorXd>) const`, and
/// if wanted `name`, `frames`, `contacts` and `jacobian(const NodeView&, Eigen::Ref<RowMatrix>)
/// const`.
template <class User>
Custom custom(User user) {
  Custom result;
  result.rows = user.rows;
  if constexpr (requires { user.name; }) result.name = user.name;
  if constexpr (requires { user.frames; }) result.frames = user.frames;
  if constexpr (requires { user.contacts; }) result.contacts = user.contacts;
  if constexpr (requires(const NodeView& at, Eigen::Ref<RowMatrix> out) { user.jacobian(at, out); })
    result.jacobian = [user](const NodeView& at, Eigen::Ref<RowMatrix> out) {
      user.jacobian(at, out);
    };
  result.value = [user = std::move(user)](const NodeView& at, Eigen::Ref<Eigen::VectorXd> out) {
    user.value(at, out);
  };
  return result;
}

}  // namespace burnish::residual

namespace burnish {

using Residual =
    std::variant<residual::State, residual::Control, residual::JointPosition,
                 residual::JointVelocity, residual::JointTorque, residual::JointTorqueRate,
                 residual::FramePosition, residual::FrameDistance, residual::FrameRotation,
                 residual::FrameInclination, residual::FrameHeight, residual::FramePlacement,
                 residual::FrameVelocity, residual::ContactForce, residual::ContactForceRate,
                 residual::FrictionCone, residual::CenterOfPressure, residual::CenterOfMass,
                 residual::SupportMargin, residual::CentroidalMomentum, residual::Custom>;

/// Such as "frame position", for messages.
std::string name_of(const Residual& residual);

}  // namespace burnish
