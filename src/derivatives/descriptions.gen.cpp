// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "derivatives/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Description& description_of(const CheckGains* /*of*/) {
  using S = CheckGains;
  static const Description all =
      Describe<S>("derivatives", "CheckGains",
                  "Contact gains to check, and the kind of pose error that kp multiplies.")
          .field("kp", &S::kp,
                 "Gains on the pose error, one per direction [{1/s^2}]")
          .field("kd", &S::kd,
                 "Gains on the velocity, one per direction [{1/s}]")
          .field("error", &S::error);
  return all;
}

const Description& description_of(const CheckEntry* /*of*/) {
  using S = CheckEntry;
  static const Description all =
      Describe<S>("derivatives", "CheckEntry",
                  "Entry of a derivative block, computed analytically and by finite differences.")
          .field("block", &S::block,
                 "Name of the block, such as \"da_dq\"")
          .field("row", &S::row,
                 "Name of the row: an entry of v, or a contact row such as \"tool/z\"")
          .field("column", &S::column,
                 "Name of the column: the variable, an entry of v or of lambda")
          .field("value", &S::value,
                 "Analytic derivative")
          .field("expected", &S::expected,
                 "Derivative from finite differences")
          .field("state", &S::state,
                 "Index of the random state, from 0");
  return all;
}

const Description& description_of(const CheckRow* /*of*/) {
  using S = CheckRow;
  static const Description all =
      Describe<S>("derivatives", "CheckRow",
                  "Result of the check for one set of contacts, over all random states. If the "
                  "contacts differ in a text member, the member lists the texts of all contacts, "
                  "joined by \" + \".")
          .field("reference", &S::reference)
          .field("directions", &S::directions)
          .field("bodies", &S::bodies,
                 "Tool frame and base frame, as \"tool on base\"")
          .field("acceleration", &S::acceleration)
          .field("error", &S::error,
                 "Kind of pose error, \"split\" or \"log6\" (\"-\": no proportional gain)")
          .field("gains", &S::gains,
                 "Range of gains in constrained directions, such as \"kp 7..12, kd 2..7\", or "
                 "\"none\"")
          .field("states", &S::states)
          .field("mu", &S::mu,
                 "Compliance of the contacts (zero: rigid), m/s^2 per N")
          .more("The compliance is positive if the contacts cannot be rigid in the majority of "
                "postures. In that case the robot has too few joints, or rows are redundant.")
          .field("worst_error", &S::worst_error,
                 "Largest error, as a fraction of the largest entry of the derivative block")
          .more("The error is infinite if a value is NaN. The largest entry counts as at least "
                "1e6 times the rounding error of the finite differences.")
          .field("worst", &S::worst)
          .field("pass_", &S::pass,
                 "Whether worst_error <= tolerance");
  return all;
}

const Description& description_of(const CheckReport* /*of*/) {
  using S = CheckReport;
  static const Description all =
      Describe<S>("derivatives", "CheckReport",
                  "Result of check_derivatives().")
          .field("robot", &S::robot)
          .field("rows", &S::rows)
          .field("tolerance", &S::tolerance)
          .field("singular_mass", &S::singular_mass,
                 "Sentence that names the joints that move no mass; empty: all joints move mass")
          .more("A joint that moves no mass makes the mass matrix singular. The check then covers"
                " inverse dynamics and contact accelerations only.")
          .field("pass_", &S::pass,
                 "True if all rows pass and the mass matrix is not singular");
  return all;
}

const Description& description_of(const WrenchDerivatives* /*of*/) {
  using S = WrenchDerivatives;
  static const Description all =
      Describe<S>("derivatives", "WrenchDerivatives",
                  "Derivatives of a contact wrench, written in a chosen Reference. Each matrix is"
                  " 6 x nv, with the force rows first.")
          .result()
          .field("dq", &S::dq,
                 "Derivative with respect to a right tangent increment of q")
          .more("Units are N/rad and Nm/rad for revolute joints, N/m and Nm/m for prismatic "
                "joints.")
          .field("dv", &S::dv)
          .field("dtau", &S::dtau,
                 "Derivative with respect to joint torques")
          .more("For revolute joints, force rows are in 1/m and moment rows have no unit.");
  return all;
}

const Description& description_of(const RedundantRow* /*of*/) {
  using S = RedundantRow;
  static const Description all =
      Describe<S>("derivatives", "RedundantRow",
                  "Row of the contact Jacobian that depends linearly on the rows before it, or "
                  "that is zero.")
          .result()
          .field("contact", &S::contact,
                 "Name of the contact")
          .field("direction", &S::direction,
                 "Direction in the contact's reference, \"x\" ... \"rz\"")
          .field("row", &S::row,
                 "Index among all rows of the contact set")
          .field("immovable", &S::immovable,
                 "True if no joint moves the contact in this direction, up to rounding")
          .field("implied_by", &S::implied_by,
                 "Rows that already imply this row, as \"contact/direction\"");
  return all;
}

const Description& description_of(const ContactDiagnosis* /*of*/) {
  using S = ContactDiagnosis;
  static const Description all =
      Describe<S>("derivatives", "ContactDiagnosis",
                  "Contact rows that diagnose() found to depend on other rows. If there are none,"
                  " the contacts are independent.")
          .result()
          .field("redundant", &S::redundant)
          .field("condition", &S::condition,
                 "Condition number of J M^-1 J^T, scaled to a unit diagonal; infinite if a row is"
                 " redundant");
  return all;
}

const Description& description_of(const FrameDerivatives* /*of*/) {
  using S = FrameDerivatives;
  static const Description all =
      Describe<S>("derivatives", "FrameDerivatives",
                  "Derivatives of a frame's velocity and acceleration, in the axes of the "
                  "requested reference. Each matrix is 6 x nv, with the linear rows first.")
          .result()
          .field("jacobian", &S::jacobian,
                 "d(velocity)/dv, which equals d(acceleration)/da")
          .field("velocity_dq", &S::velocity_dq,
                 "d(velocity)/dq")
          .field("acceleration_dq", &S::acceleration_dq,
                 "d(acceleration)/dq at constant v and a")
          .field("acceleration_dv", &S::acceleration_dv,
                 "d(acceleration)/dv at constant q and a");
  return all;
}

const Description& description_of(const PlacementDerivatives* /*of*/) {
  using S = PlacementDerivatives;
  static const Description all =
      Describe<S>("derivatives", "PlacementDerivatives",
                  "Derivatives of a frame's placement with respect to q. Each matrix has nv "
                  "columns.")
          .result()
          .field("position", &S::position,
                 "Derivative of the position in world axes: 3 x nv, m/rad or m/m")
          .field("rotation", &S::rotation,
                 "Derivative of the rotation R, in the frame's own axes: 3 x nv")
          .more("Column k is the vector w with R^T dR/dq_k = [w x].")
          .field("rotation_error", &S::rotation_error,
                 "Derivative of log(R_target^T R), with the target R_target: 3 x nv")
          .field("placement_error", &S::placement_error,
                 "Derivative of the pose error relative to a target: 6 x nv")
          .more("The pose error is the SE(3) logarithm of the frame's placement relative to the "
                "target.");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
