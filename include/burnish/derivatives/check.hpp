// Check of the analytic derivatives for a given robot. It compares every derivative block of
// ContactDynamics with finite differences.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "burnish/contact/contact.hpp"
#include "burnish/dynamics/surface_shape.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Contact gains to check, and the kind of pose error that kp multiplies.
/// @described derivatives
struct CheckGains {
  Vector6 kp = Vector6::Zero();  ///< Gains on the pose error, one per direction [1/s^2]
  Vector6 kd = Vector6::Zero();  ///< Gains on the velocity, one per direction [1/s]
  PoseError error = PoseError::Split;
};

/// Returns "tool" if the model has a moving frame of this name. Otherwise returns the name of the
/// last frame on a body without child bodies. Frames of kinematic loops do not count. Throws Error
/// if there is no such frame.
std::string default_tool(const Model& model);

/// Returns the contact references that a check covers by default: local, centered, a tilted
/// surface, and world.
std::vector<Reference> default_check_references();
/// Returns the sets of constrained directions that a check covers by default: x; y; z; x and y;
/// linear; pad_z; all but rz; all.
std::vector<Directions> default_check_directions();
/// Returns the contact gains that a check covers by default: no gains; gains with PoseError::Split;
/// gains with PoseError::Log6. The gains differ between directions.
std::vector<CheckGains> default_check_gains();
/// Returns the shapes of curved surfaces that a check covers by default: one saddle.
std::vector<SurfaceShape> default_check_surfaces();

/// Options of check_derivatives(). If `contacts` has entries, only these contacts are checked.
/// Otherwise the check sweeps over contacts of one tool. The reference of a contact is an entry of
/// `references`, or belongs to an entry of `surfaces`. Each of these references is combined with
/// each entry of `directions`, `accelerations` and `gains`.
struct CheckOptions {
  /// Name of the tool frame C2. Empty: the result of default_tool().
  std::string tool;
  /// Name of the base frame C1. The base may be on a moving body.
  std::string base = "world";
  std::vector<Reference> references = default_check_references();
  /// Shapes of curved surfaces on the base. For each shape, the check has contacts whose axes
  /// follow a surface of this shape. At each state, the surface is placed at random near the tool.
  /// For a robot of 1 m, the surface is at most 2 cm away from the tool along each axis; the
  /// distance grows with the size of the robot. The surface is also tilted at random: a vector with
  /// entries of at most 0.6 is added to the initial unit normal. The contact uses the quadric that
  /// osculates the surface.
  std::vector<SurfaceShape> surfaces = default_check_surfaces();
  std::vector<Directions> directions = default_check_directions();
  std::vector<Acceleration> accelerations{Acceleration::TimeDerivative};
  std::vector<CheckGains> gains = default_check_gains();

  /// Contacts to check together in one row of the report. Empty: contacts are combined from
  /// references, surfaces, directions, accelerations and gains.
  std::vector<ContactSpec> contacts;

  int states = 20;         ///< Number of random states per row of the report, at least 1
  std::uint64_t seed = 1;  ///< Random seed; the same seed gives the same states on every machine
  /// Largest accepted error, as a fraction of the largest entry of the derivative block
  double tolerance = 1e-6;

  /// Function that is called after each row of the report, with the numbers of finished rows and of
  /// all rows.
  std::function<void(int done, int total)> progress;
};

/// Entry of a derivative block, computed analytically and by finite differences.
/// @described derivatives
struct CheckEntry {
  std::string block;      ///< Name of the block, such as "da_dq"
  std::string row;        ///< Name of the row: an entry of v, or a contact row such as "tool/z"
  std::string column;     ///< Name of the column: the variable, an entry of v or of lambda
  double value = 0.0;     ///< Analytic derivative
  double expected = 0.0;  ///< Derivative from finite differences
  int state = -1;         ///< Index of the random state, from 0
};

/// Result of the check for one set of contacts, over all random states. If the contacts differ in a
/// text member, the member lists the texts of all contacts, joined by " + ".
/// @described derivatives
struct CheckRow {
  std::string reference;
  std::string directions;
  std::string bodies;  ///< Tool frame and base frame, as "tool on base"
  std::string acceleration;
  std::string error;  ///< Kind of pose error, "split" or "log6" ("-": no proportional gain)

  /// Range of gains in constrained directions, such as "kp 7..12, kd 2..7", or "none"
  std::string gains;
  int states = 0;
  /// Compliance of the contacts (zero: rigid), m/s^2 per N @more The compliance is positive if the
  /// contacts cannot be rigid in the majority of postures. In that case the robot has too few
  /// joints, or rows are redundant.
  double mu = 0.0;
  /// Largest error, as a fraction of the largest entry of the derivative block @more The error is
  /// infinite if a value is NaN. The largest entry counts as at least 1e6 times the rounding error
  /// of the finite differences.
  double worst_error = 0.0;
  CheckEntry worst;
  bool pass = false;  ///< Whether worst_error <= tolerance
};

/// Result of check_derivatives().
/// @described derivatives
struct CheckReport {
  std::string robot;
  std::vector<CheckRow> rows;
  double tolerance = 0.0;
  /// Sentence that names the joints that move no mass; empty: all joints move mass @more A joint
  /// that moves no mass makes the mass matrix singular. The check then covers inverse dynamics and
  /// contact accelerations only.
  std::string singular_mass = {};
  bool pass = false;  ///< True if all rows pass and the mass matrix is not singular

  /// Returns a table of all rows, the worst entry of each failed row, and the verdict.
  std::string text() const;
};

/// Compares the analytic derivatives of ContactDynamics with finite differences, at random states
/// within the position limits:
///  - forward_derivatives(): derivatives of a and lambda with respect to q, v and tau,
///  - inverse_derivatives(): derivatives of tau with respect to q, v, a and lambda,
///  - acceleration_derivatives(): derivatives of alpha with respect to q, v and a.
/// Differences with respect to q are central differences in the tangent space. They are taken at
/// three step lengths and extrapolated (Richardson). If the three results disagree, smaller steps
/// follow. The differentiated quantities are quadratic in v and linear in tau, a and lambda. For
/// these variables, one central difference is exact.
///
/// Every row includes the loops of the robot as contacts.
///
/// If an analytic derivative and a finite difference differ by no more than rounding explains, they
/// pass. Rounding errors are large compared with values that are zero, and with small values that
/// remain after large torques cancel.
///
/// The check skips states
///  - with nearly singular contacts: the condition number of J M^-1 J^T exceeds 1e5. The rows of J
///    are first scaled to unit length. Exception: a row along which the joints hardly move the
///    contact is scaled to a smaller length.
///  - with a rotation error within 0.1 rad of half a turn, if a proportional gain acts on
///    rotations. The logarithm of the rotation jumps at half a turn.
///  - where the surface of a contact in `options.contacts` has no normal, or a normal nearly
///    opposite to the initial normal of the contact's axes.
///
/// If `options.contacts` is empty, the target of each contact is the tool's placement at the
/// neutral configuration. Throws Error with one sentence if an option is not valid.
CheckReport check_derivatives(const Model& model, const CheckOptions& options = {});

}  // namespace burnish
