// Are the derivatives right on this robot? Every block of ContactDynamics against differences of
// the values alone.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "burnish/contact/contact.hpp"
#include "burnish/dynamics/surface_shape.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Gains that a check tries, and the error that they act on.
/// @described derivatives
struct CheckGains {
  Vector6 kp = Vector6::Zero();  ///< [1/s^2]
  Vector6 kd = Vector6::Zero();  ///< [1/s]
  PoseError error = PoseError::Split;
};

/// The frame named "tool" if it moves, or else the last frame of the model that is fixed to a body
/// without children and is not a loop's. Throws Error if no frame moves.
std::string default_tool(const Model& model);

/// What the sweep tries unless told otherwise.
std::vector<Reference> default_check_references();   ///< all four, the surface tilted
std::vector<Directions> default_check_directions();  ///< x; y; z; x,y; linear; pad_z; five; all
std::vector<CheckGains> default_check_gains();       ///< none; Split; Log6, unequal by direction
std::vector<SurfaceShape> default_check_surfaces();  ///< a saddle

/// What to check: one tool in every combination of references or surfaces, directions,
/// accelerations and gains, or the contacts given.
struct CheckOptions {
  /// Frame C2. Empty: default_tool().
  std::string tool;
  /// Frame C1. On a moving body, every row is a contact between two bodies.
  std::string base = "world";
  std::vector<Reference> references = default_check_references();
  /// Curved surfaces of the base, which the axes of further contacts follow. At each state one of
  /// that shape is within 2 cm of the tool, its normal up to a radian from where the axes start,
  /// and the contact has what osculates it there.
  std::vector<SurfaceShape> surfaces = default_check_surfaces();
  std::vector<Directions> directions = default_check_directions();
  std::vector<Acceleration> accelerations{Acceleration::TimeDerivative};
  std::vector<CheckGains> gains = default_check_gains();

  /// When not empty: these contacts, all at once, in one row instead of the sweep.
  std::vector<ContactSpec> contacts;

  int states = 20;          ///< random states per row, at least 1
  std::uint64_t seed = 1;   ///< the same seed gives the same states on every machine
  double tolerance = 1e-6;  ///< on |derivative - difference| over the block's largest entry
  /// Called after each row with the number of rows done and the number of all rows.
  std::function<void(int done, int total)> progress;
};

/// One entry of one block: a derivative, and what differences say.
/// @described derivatives
struct CheckEntry {
  std::string block;      ///< such as "da_dq"
  std::string row;        ///< entry of v, or contact and direction such as "tool/z"
  std::string column;     ///< what it is differentiated by: an entry of v, or of lambda
  double value = 0.0;     ///< computed analytically
  double expected = 0.0;  ///< from differences
  int state = -1;         ///< which of the random states, from 0
};

/// One set of contacts at all states. Words that differ between contacts are joined by " + ".
/// @described derivatives
struct CheckRow {
  std::string reference;
  std::string directions;
  std::string bodies;  ///< "tool on base"
  std::string acceleration;
  std::string error;  ///< "split" or "log6"; "-" without a proportional gain
  std::string gains;  ///< "none", or such as "kp 7..12, kd 2..7"
  int states = 0;
  /// Compliance that the row was checked with, m/s^2 per N: zero, or positive where the joints
  /// cannot hold the contact rigidly at most postures (too few joints, redundant rows).
  double mu = 0.0;
  /// Relative to the block's largest entry, or to what makes its rounding 1e-6 where that is more;
  /// infinite after a NaN.
  double worst_error = 0.0;
  CheckEntry worst;
  bool pass = false;  ///< worst_error <= tolerance
};

/// What check_derivatives() found.
/// @described derivatives
struct CheckReport {
  std::string robot;
  std::vector<CheckRow> rows;
  double tolerance = 0.0;
  /// Why there is no forward dynamics to check, naming the joints that move no mass: rows then are
  /// of inverse dynamics and contact accelerations alone. Empty: there is.
  std::string singular_mass = {};
  bool pass = false;  ///< there are rows, all of them pass, and the mass matrix is not singular

  /// A table of all rows, the worst entries of those that fail, and the verdict.
  std::string text() const;
};

/// Compares, at random states within the position limits,
///  - forward_derivatives: da and dlambda by q, v and tau,
///  - inverse_derivatives: dtau by q, v, a and lambda,
///  - acceleration_derivatives: dalpha by q, v and a
/// with differences of the values in the tangent space. By q, central differences at three steps
/// are extrapolated (Richardson), again at smaller steps where the three disagree. By v the values
/// are quadratic and by tau, a and lambda linear, so that one central difference is exact.
///
/// The loops of the robot hold in every row.
///
/// What the rounding of large sums can do to a difference of their values is no error: with torques
/// that cancel, or where the values are zero.
///
/// States are passed over where the contact is close to singular (condition of J M^-1 J^T above
/// 1e5, rows that the joints hardly move counting as the short ones that they are) or, with a
/// proportional gain on rotations, within 0.1 rad of half a turn from the target, where the
/// logarithm jumps, or where a surface that a given contact follows has no normal or one about half
/// a turn from where its axes start. Targets of the sweep are at the neutral configuration.
///
/// Throws Error with one sentence for options that cannot be used.
CheckReport check_derivatives(const Model& model, const CheckOptions& options = {});

}  // namespace burnish
