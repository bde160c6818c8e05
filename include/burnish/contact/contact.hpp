// A contact as a user states it: a tool frame tied to a base frame along some directions.
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

/// Which acceleration of the tool a contact prescribes.
/// @described contact
/// They differ by w x v; all agree where the contact velocity is zero. See docs/frames.md.
enum class Acceleration {
  TimeDerivative,  ///< the true derivative of the constraint velocity @note d(nu)/dt
  Spatial,         ///< the tool's local spatial acceleration carried into the axes (Proposition 3)
  Classical,       ///< of the material point, written in the axes
};

/// Position-level error that the proportional gain acts on.
/// @described contact
enum class PoseError {
  Split,  ///< position error, and the logarithm of the rotation error
  Log6,   ///< the SE(3) logarithm in tool axes, carried into the contact's axes
};

std::string name_of(Acceleration acceleration);
std::string name_of(PoseError error);
/// Read the names that name_of writes. Throw Error with the nearest known name.
Acceleration parse_acceleration(const std::string& name);
PoseError parse_pose_error(const std::string& name);

/// Coulomb's, of a tool that slides: beside lambda along the held normal, on the tool acts
/// -coefficient lambda v_t / sqrt(|v_t|^2 + speed^2), v_t being the velocity across the normal,
/// seen from the base, of the tool's point where it acts.
/// @described contact
/// Contacts that hold one direction of translation, their normal. Impacts are without friction.
struct SlidingFriction {
  double coefficient = 0.3;  ///< 0: none, until it is set, >= 0
  /// [m/s], below which it fades, so that it has a derivative at rest; none: in a problem what its
  /// steps tolerate, elsewhere 0.01, > 0 @word none
  std::optional<double> speed = {};
  /// [m] from the tool's origin against the normal to where it acts: of a round tip, >= 0
  double radius = 0.0;

  /// Returns `speed`, or 0.01 where none is stated [m/s].
  double fade_speed() const { return speed.value_or(0.01); }
};

/// A tool frame tied to a base frame along some directions: alpha + kd nu + kp e = 0, nu and alpha
/// being velocity and acceleration of the tool relative to the base, in the reference.
/// @described contact
struct ContactSpec {
  std::string name = {};       ///< unique; the tool's name if left empty
  std::string tool = {};       ///< frame C2
  std::string base = "world";  ///< frame C1; "world" is always known
  Reference reference = Reference::centered();
  /// "all", "linear", "angular", "pad_x|y|z", or names separated by commas such as "z,rx,ry"
  Directions directions = Directions::all();
  Acceleration acceleration = Acceleration::TimeDerivative;
  PoseError error = PoseError::Split;
  /// [1/s^2], by direction; only entries of held directions are used
  Vector6 kp = Vector6::Zero();
  Vector6 kd = Vector6::Zero();  ///< [1/s]
  /// Placement of C2 in C1 that the error is measured from.
  Eigen::Isometry3d target = Eigen::Isometry3d::Identity();
  std::optional<SlidingFriction> friction = {};  ///< none: the tool slides freely

  /// The same gains in every direction. `kp` in 1/s^2, `kd` in 1/s.
  ContactSpec& with_gains(double kp_all, double kd_all);
};

/// The contacts with their references as they are at a time, s. Throws Error where one has no
/// rotation there.
std::vector<ContactSpec> contacts_at(std::vector<ContactSpec> contacts, double time);

}  // namespace burnish
