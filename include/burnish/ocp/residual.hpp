// Residuals: the quantities that cost terms and constraints measure. The comment of each residual
// states its rows, their units and their axes. docs/costs.md adds typical weights.
//
// Unless stated otherwise, a target has one entry per row of the residual. A target may be empty
// only if the comment of the residual says so.
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

/// Difference of the state from the target, x (-) target, ndx rows: dq (rad, m), dv (rad/s, m/s),
/// dtau (Nm, N).
/// @described residual
/// Differences of the force states (N, Nm) are the last rows. An empty target is the initial
/// state of the problem.
struct State {
  Signal target = {};  ///< Target state, nx entries; None: the initial state of the problem
};

/// Control minus the target, nu rows, Nm (N).
/// @described residual
/// An empty target means zero.
struct Control {
  Signal target = {};  ///< Target control; None: zero
};

/// Position of revolute and prismatic joints minus the target, one row per joint, rad or m. If no
/// joints are named, there is a row for every joint with a position limit.
/// @described residual
/// An empty target means zero.
struct JointPosition {
  std::vector<std::string> joints = {};  ///< @name_of joint
  Signal target = {};  ///< Target positions; None: zero, so the residual equals the positions
};

/// Velocity of joints minus the target, one row per entry of v, rad/s or m/s. If no joints are
/// named, there are rows for all joints except the free-flying base.
/// @described residual
/// An empty target means zero.
struct JointVelocity {
  std::vector<std::string> joints = {};  ///< @name_of joint
  Signal target = {};                    ///< Target velocities; None: zero
};

/// Actuator torque of joints minus the target, Nm or N. Usually, the torque is the control. With a
/// torque model that has a cut-off, it is the torque in the state. If no joints are named, there
/// are rows for all actuated joints.
/// @described residual
/// An empty target means zero.
struct JointTorque {
  std::vector<std::string> joints = {};  ///< @name_of joint
  Signal target = {};                    ///< Target torques; None: zero
};

/// Rate of actuator torques of joints minus the target, Nm/s or N/s. The rate needs a torque model
/// and a control u. With a cut-off, the rate is cutoff (u - tau) at the start of the step, where
/// tau is the torque in the state. The rate decays over the step. With held torques, the rate is
/// (u - tau) / step, where tau is the control of the previous step. If no joints are named, there
/// are rows for all actuated joints.
/// @described residual
/// An empty target means zero.
struct JointTorqueRate {
  std::vector<std::string> joints = {};  ///< @name_of joint
  Signal target = {};                    ///< Target rates; None: zero
};

/// Position of a frame's origin minus the target, 3 rows, m, in the axes of the reference frame.
/// The base of the reference must be the world, and the origin must not be the frame itself.
/// With Reference.on, the axes of the reference follow a surface at the frame. The position is then
/// measured from the origin of the frame in which the surface is fixed. The first two rows are
/// along the surface's tangents.
/// @described residual
struct FramePosition {
  std::string frame = {};  ///< @name_of frame @stated

  /// Target position from the reference's origin, 3 entries [m]
  /// @more Written in the axes of the frame Reference.axes, without Reference.rotation. With
  /// Reference::world(...), the target is a point of the world
  Signal target = {};
  Reference reference = Reference::world();
};

/// Distance of a frame's origin from the target, along one or more axes of the reference; 1 row
/// [m]. With three axes it is the distance from a point, with two axes from a line, with one axis
/// from a plane. The base of the reference must be the world, and the reference's origin must not
/// be the frame itself. For a distance d the row is sqrt(d^2 + (1e-6 m)^2), which is differentiable
/// everywhere. At d = 0 the derivative of the row is zero.
/// @described residual
struct FrameDistance {
  std::string frame = {};  ///< @name_of frame @stated

  /// Target position from the reference's origin (None: the origin itself), 3 entries [m]
  /// @more Written in the axes of the frame Reference.axes, without Reference.rotation. If the
  /// reference's origin is the world's origin, a target is required
  Signal target = {};
  Directions directions = Directions::linear();  ///< Axes that count: one or more of x, y and z
  Reference reference = Reference::world();
};

/// Rotation of a frame relative to its target rotation, log(R_target^T A^T R), 3 rows, rad, in the
/// axes of the target. R is the rotation of the frame in the world, and A that of the reference.
/// The target R_target is relative to A. The base of the reference must be the world, and the
/// origin of the reference has no effect.
/// @described residual
struct FrameRotation {
  std::string frame = {};  ///< @name_of frame @stated
  Signal target = {};      ///< Target rotation: quaternion x, y, z, w, of unit length
  Reference reference = Reference::world();
};

/// Lead and tilt of an axis e of a frame minus the target, 2 rows, rad. Here e is written in the
/// reference frame. Lead is the inclination from the reference's z axis towards its x axis,
/// atan2(e_x, e_z). Tilt is the inclination from the z axis towards the y axis, atan2(e_y, e_z).
/// The base of the reference must be the world. Rotation about the axis e has no effect. With
/// Reference.on, z is the normal of a surface.
/// @described residual
struct FrameInclination {
  std::string frame = {};  ///< @name_of frame @stated
  Reference reference = Reference::world();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< Axis in the frame, 3 entries, of any length
  Signal target = {};                               ///< Target lead and tilt [rad]; None: zero
};

/// Height of a frame's origin above a surface minus the target, 1 row, m. The reference follows the
/// surface (Reference.on). The height is the distance to the surface along the normal at the frame,
/// negative inside the material. It is exact for planes, spheres and cylinders, and correct to
/// first order for other surfaces. If the normal at the frame does not meet the surface, the height
/// is no distance, but still increases with the distance.
/// @described residual
struct FrameHeight {
  std::string frame = {};                    ///< @name_of frame @stated
  Reference reference = Reference::world();  ///< @stated
  Signal target = {};                        ///< Target height [m]; None: zero
};

/// Pose of a frame relative to the target, as an SE(3) logarithm in the target's axes: 3 rows in m,
/// 3 rows in rad.
/// @described residual
struct FramePlacement {
  std::string frame = {};  ///< @name_of frame @stated
  Signal target = {};      ///< Target pose: position (m), quaternion x, y, z, w
};

/// Velocity of a frame in the world minus the target, 6 rows: 3 in m/s, 3 in rad/s. The velocity is
/// written in a reference frame, whose tool is the frame and whose base is the world.
/// @described residual
/// An empty target means zero.
struct FrameVelocity {
  std::string frame = {};  ///< @name_of frame @stated
  Reference reference = Reference::centered();
  Signal target = {};  ///< Target velocity; None: zero
};

/// Force of an active contact minus the target, N and Nm. In the contact's own reference frame,
/// there is one row per constrained direction. In another reference frame, there are six rows.
/// @described residual
/// An empty target means zero.
struct ContactForce {
  std::string contact = {};  ///< @name_of contact @stated
  std::optional<Reference> reference = {};
  Signal target = {};  ///< Target force; None: zero
};

/// Rate of change of an active contact's force f, (f - f_before) / step, minus the target, N/s and
/// Nm/s. f_before is the force of the previous step. There is one row per constrained direction, in
/// the contact's own reference frame. The contact must be in the problem's list force_states.
/// @described residual
/// An empty target means zero.
struct ContactForceRate {
  std::string contact = {};  ///< @name_of contact @stated
  Signal target = {};        ///< Target rates; None: zero
};

/// Margins of a contact force within its friction cone, 2 rows, N: friction * f_n - |f_t| and f_n.
/// Here f_n is the force along the axis `normal` of the reference (0, 1, 2: x, y, z). f_t is the
/// tangential force, and |f_t| is smoothed over 1e-3 N. With `sides` = n > 0, a pyramid inside the
/// cone replaces the cone. There are then n rows, N: friction * cos(pi / n) * f_n - d_i . f_t. The
/// tangents d_i are 360 / n degrees apart. The first tangent is the reference's axis that follows
/// the normal (x follows z). Default penalty: a barrier at 0.
/// @described residual
/// The tangents turn from the axis after the normal (y after x, x after z) towards the next axis.
/// If all n rows of the pyramid are at least zero, both rows of the cone are at least zero. The
/// contact must constrain the normal, but may leave one tangent free. The force along a free
/// tangent is zero. In Problem::set_target(), the target is the friction coefficient, since the
/// ground under a foot may change.
struct FrictionCone {
  std::string contact = {};                 ///< @name_of contact @stated
  double friction = 0.5;                    ///< Friction coefficient, > 0
  int normal = 2;                           ///< Axis of the reference along the normal @words x y z
  std::optional<Reference> reference = {};  ///< Reference; by default the contact's own

  /// Number of sides of a pyramid inside the cone, 3 to 32 (0: the cone itself), >= 0
  int sides = 0;
};

/// Margins of the centre of pressure within a rectangle in the tool's axes, times the normal force
/// f_z. There are 4 rows, Nm: half_x f_z + m_y, half_x f_z - m_y, half_y f_z + m_x and half_y f_z -
/// m_x. The centre of pressure is c = (-m_y, m_x) / f_z. These rows are zero if c is at the edge
/// with the largest x, smallest x, smallest y and largest y, respectively. With friction, there
/// are 8 more rows, Nm: the distances of the moment about the normal from the moments at which the
/// corners slip. The first 4 of the 8 rows limit negative moments, the last 4 positive moments.
/// Each corner has the coefficient `friction`. Default penalty: a barrier at 0.
/// @described residual
/// The largest moment that friction can hold about the normal decreases as the centre of pressure
/// approaches an edge. At a corner this moment is zero, and the foot can pivot about the corner.
/// Source: S. Caron, Q.-C. Pham, Y. Nakamura, "Stability of surface contacts for humanoid robots:
/// closed-form formulae of the contact wrench cone for rectangular support areas", ICRA 2015,
/// equations 21 and 22. The equations assume a friction pyramid: |f_x| and |f_y| are each at most
/// the coefficient times f_z. For a pyramid inside a friction cone, use the cone's coefficient
/// divided by sqrt(2). In Problem::set_target(), the target is the friction coefficient. The
/// contact must constrain the normal, but may leave one other direction free. The force or moment
/// along a free direction is zero.
struct CenterOfPressure {
  std::string contact = {};  ///< @name_of contact @stated
  double half_x = 0.1;       ///< Half length of the rectangle along the tool's x [m], > 0 @stated
  double half_y = 0.05;      ///< Half length of the rectangle along the tool's y [m], > 0 @stated

  /// Friction coefficient at each corner, which limits the moment about the normal (0: no limit),
  /// >= 0
  double friction = 0.0;
};

/// Position of the centre of mass minus the target, 3 rows, m, world axes.
/// @described residual
struct CenterOfMass {
  Signal target = {};
};

/// Distance of the centre of mass from each edge of a support polygon, seen from above, one row per
/// edge, m. The distance is positive inside. Row i belongs to the edge from point i to the next
/// point; the last edge returns to the first point. Default penalty: a barrier at 0.
/// @described residual
struct SupportMargin {
  /// Corners of a convex polygon, 3 or more, x and y in the world [m], counter-clockwise from
  /// above. Other polygons are rejected. @stated
  std::vector<Eigen::Vector2d> points = {};
};

/// Linear momentum (3 rows, kg m/s) and angular momentum about the centre of mass (3 rows, kg
/// m^2/s) minus the target, world axes.
/// @described residual
/// An empty target means zero.
struct CentroidalMomentum {
  Signal target = {};  ///< Target momentum; None: zero
};

/// A user-defined residual. The function custom() makes a Custom from a plain struct; see
/// examples/06.
struct Custom {
  std::string name = {};
  int rows = 0;  ///< Number of rows

  /// Names of the frames that `value` and `jacobian` use, in the order of their indices in
  /// NodeView.
  std::vector<std::string> frames = {};
  /// Names of the contacts that `value` and `jacobian` use, in the order of their indices in
  /// NodeView.
  std::vector<std::string> contacts = {};
  /// Function that writes the residual, `rows` entries.
  std::function<void(const NodeView&, Eigen::Ref<Eigen::VectorXd>)> value = {};
  /// Function that writes d(value)/dz, rows x nz, into a zeroed matrix. Empty: central differences.
  std::function<void(const NodeView&, Eigen::Ref<RowMatrix>)> jacobian = {};
};

/// Converts a user's struct into a residual. The struct needs a member `int rows` and a function
/// `value(const NodeView&, Eigen::Ref<Eigen::VectorXd>) const`. Optional are members `name`,
/// `frames` and `contacts`, and a function `jacobian(const NodeView&, Eigen::Ref<RowMatrix>)
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

/// Returns the kind of a residual as words for messages, such as "frame position".
std::string name_of(const Residual& residual);

}  // namespace burnish
