// Contact as a user specifies it: a tool frame and a base frame whose relative motion is
// constrained.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/base/error.hpp"
#include "burnish/base/views.hpp"
#include "burnish/dynamics/reference.hpp"
#include "burnish/model/directions.hpp"

namespace burnish {

/// Kind of tool acceleration that a contact prescribes.
/// @described contact
/// The kinds differ by cross products of angular and linear velocity. They agree where the contact
/// velocity is zero. See docs/frames.md.
enum class Acceleration {
  TimeDerivative,  ///< True time derivative of the contact velocity @note d(nu)/dt

  /// Spatial acceleration of the tool in tool axes, transformed to contact axes @note Proposition 3
  /// of Kleff et al. (docs/frames.md).
  Spatial,
  Classical,  ///< Acceleration of the tool's material point, in contact axes
};

/// Kind of pose error that the proportional gain of a contact multiplies.
/// @described contact
enum class PoseError {
  Split,  ///< Position error and logarithm of the rotation error
  Log6,   ///< SE(3) logarithm of the pose error, transformed from tool axes to contact axes
};

std::string name_of(Acceleration acceleration);
std::string name_of(PoseError error);
/// Returns the enumerator whose name_of() is `name`. For an unknown name, throws Error with the
/// nearest known name.
Acceleration parse_acceleration(const std::string& name);
PoseError parse_pose_error(const std::string& name);

/// Smoothed Coulomb friction on a sliding tool. The friction force on the tool is -coefficient
/// lambda v_t / sqrt(|v_t|^2 + speed^2). Here lambda is the normal force, and v_t is the tangential
/// velocity of the tool relative to the base. The velocity is taken at the point where friction
/// acts.
/// @described contact
/// The contact must constrain exactly one direction of translation: the normal. Impacts ignore
/// friction.
struct SlidingFriction {
  /// Coefficient of friction, >= 0 @more With 0, there is no friction until another coefficient is
  /// set.
  double coefficient = 0.3;
  /// Speed below which friction fades out (none: chosen from a problem's time steps) [m/s], > 0
  /// @word none @more The fade-out makes friction differentiable at rest. The speed chosen from the
  /// time steps is at least 0.01 m/s. For a contact without a problem, none means 0.01 m/s.
  std::optional<double> speed = {};
  /// Radius of a round tool tip [m], >= 0 @more Friction acts at the tool's origin shifted by this
  /// distance, opposite to the normal.
  double radius = 0.0;
  /// Name of the scalar input of an optimal control problem whose values, at least 0, replace
  /// `coefficient` (empty: no input) @more See InputSpec.
  std::string coefficient_input = {};

  /// Returns `speed`, or 0.01 m/s if `speed` is empty.
  double fade_speed() const { return speed.value_or(0.01); }
};

/// Contact that constrains a tool frame relative to a base frame in some directions: alpha + kd nu
/// + kp e = 0. Here e, nu and alpha are the pose error, velocity and acceleration of the tool
/// relative to the base, written in the axes of the contact's Reference.
/// @described contact
struct ContactSpec {
  std::string name = {};       ///< Unique name (empty: the name of the tool frame)
  std::string tool = {};       ///< Name of the tool frame C2
  std::string base = "world";  ///< Name of the base frame C1; "world" always exists
  Reference reference = Reference::centered();
  /// Constrained directions: "all", "linear", "angular", "pad_x", "pad_y", "pad_z" (a flat pad with
  /// normal x, y or z), or a list ("z,rx,ry")
  Directions directions = Directions::all();
  Acceleration acceleration = Acceleration::TimeDerivative;
  PoseError error = PoseError::Split;
  /// Gains on the pose error, one per direction [1/s^2] @more Gains of free directions have no
  /// effect.
  Vector6 kp = Vector6::Zero();
  Vector6 kd = Vector6::Zero();  ///< Gains on the velocity, one per direction [1/s]

  /// Desired pose of the tool frame C2 in the base frame C1 @more At this pose, the pose error is
  /// zero.
  Eigen::Isometry3d target = Eigen::Isometry3d::Identity();
  std::optional<SlidingFriction> friction = {};  ///< Friction on the tool (none: frictionless)
  /// Name of the input of an optimal control problem whose surface replaces the surface of
  /// `reference` (empty: no input) @more The reference must follow a surface. See InputSpec.
  std::string surface_input = {};

  /// Sets kp to `kp_all` [1/s^2] and kd to `kd_all` [1/s] in all directions. Returns this contact.
  ContactSpec& with_gains(double kp_all, double kd_all);
};

/// Returns `contacts` with each time-varying Reference replaced by its value at `time` [s]. Throws
/// Error if the rotation of a Reference at `time` is not a unit quaternion.
std::vector<ContactSpec> contacts_at(std::vector<ContactSpec> contacts, double time);

}  // namespace burnish
