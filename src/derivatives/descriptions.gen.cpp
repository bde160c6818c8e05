// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "derivatives/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Description& description_of(const CheckGains* /*of*/) {
  using S = CheckGains;
  static const Description all =
      Describe<S>("derivatives", "CheckGains",
                  "Gains that a check tries, and the error that they act on.")
          .field("kp", &S::kp,
                 "{1/s^2}")
          .field("kd", &S::kd,
                 "{1/s}")
          .field("error", &S::error);
  return all;
}

const Description& description_of(const CheckEntry* /*of*/) {
  using S = CheckEntry;
  static const Description all =
      Describe<S>("derivatives", "CheckEntry",
                  "One entry of one block: a derivative, and what differences say.")
          .field("block", &S::block,
                 "such as \"da_dq\"")
          .field("row", &S::row,
                 "entry of v, or contact and direction such as \"tool/z\"")
          .field("column", &S::column,
                 "what it is differentiated by: an entry of v, or of lambda")
          .field("value", &S::value,
                 "computed analytically")
          .field("expected", &S::expected,
                 "from differences")
          .field("state", &S::state,
                 "which of the random states, from 0");
  return all;
}

const Description& description_of(const CheckRow* /*of*/) {
  using S = CheckRow;
  static const Description all =
      Describe<S>("derivatives", "CheckRow",
                  "One set of contacts at all states. Words that differ between contacts are "
                  "joined by \" + \".")
          .field("reference", &S::reference)
          .field("directions", &S::directions)
          .field("bodies", &S::bodies,
                 "\"tool on base\"")
          .field("acceleration", &S::acceleration)
          .field("error", &S::error,
                 "\"split\" or \"log6\"; \"-\" without a proportional gain")
          .field("gains", &S::gains,
                 "\"none\", or such as \"kp 7..12, kd 2..7\"")
          .field("states", &S::states)
          .field("mu", &S::mu,
                 "Compliance that the row was checked with, m/s^2 per N: zero, or positive where "
                 "the joints cannot hold the contact rigidly at most postures (too few joints, "
                 "redundant rows).")
          .field("worst_error", &S::worst_error,
                 "Relative to the block's largest entry, or to what makes its rounding 1e-6 where"
                 " that is more; infinite after a NaN.")
          .field("worst", &S::worst)
          .field("pass_", &S::pass,
                 "worst_error <= tolerance");
  return all;
}

const Description& description_of(const CheckReport* /*of*/) {
  using S = CheckReport;
  static const Description all =
      Describe<S>("derivatives", "CheckReport",
                  "What check_derivatives() found.")
          .field("robot", &S::robot)
          .field("rows", &S::rows)
          .field("tolerance", &S::tolerance)
          .field("singular_mass", &S::singular_mass,
                 "Why there is no forward dynamics to check, naming the joints that move no mass:"
                 " rows then are of inverse dynamics and contact accelerations alone. Empty: "
                 "there is.")
          .field("pass_", &S::pass,
                 "there are rows, all of them pass, and the mass matrix is not singular");
  return all;
}

const Description& description_of(const WrenchDerivatives* /*of*/) {
  using S = WrenchDerivatives;
  static const Description all =
      Describe<S>("derivatives", "WrenchDerivatives",
                  "Derivatives of a wrench in a reference: (6, nv) each, force rows first.")
          .result()
          .field("dq", &S::dq,
                 "N/rad (N/m), Nm/rad (Nm/m), by the right tangent increment of q")
          .field("dv", &S::dv)
          .field("dtau", &S::dtau,
                 "{1/m} (force per torque), dimensionless (moment per torque)");
  return all;
}

const Description& description_of(const RedundantRow* /*of*/) {
  using S = RedundantRow;
  static const Description all =
      Describe<S>("derivatives", "RedundantRow",
                  "A row of the contact Jacobian that depends on rows before it.")
          .result()
          .field("contact", &S::contact,
                 "name of the contact")
          .field("direction", &S::direction,
                 "\"x\" ... \"rz\" in its reference")
          .field("row", &S::row,
                 "index among all rows of the set")
          .field("immovable", &S::immovable,
                 "no joint moves it at this posture, but for rounding")
          .field("implied_by", &S::implied_by,
                 "\"contact/direction\" of the rows that already hold it");
  return all;
}

const Description& description_of(const ContactDiagnosis* /*of*/) {
  using S = ContactDiagnosis;
  static const Description all =
      Describe<S>("derivatives", "ContactDiagnosis",
                  "What diagnose() found: no redundant rows means that the contacts are "
                  "independent.")
          .result()
          .field("redundant", &S::redundant)
          .field("condition", &S::condition,
                 "of J M^-1 J^T scaled to a unit diagonal; infinite when redundant");
  return all;
}

const Description& description_of(const FrameDerivatives* /*of*/) {
  using S = FrameDerivatives;
  static const Description all =
      Describe<S>("derivatives", "FrameDerivatives",
                  "Derivatives of a frame's motion, (6, nv) each, linear rows first, in the axes "
                  "that were asked for.")
          .result()
          .field("jacobian", &S::jacobian,
                 "d(velocity)/dv, and d(acceleration)/da")
          .field("velocity_dq", &S::velocity_dq,
                 "d(velocity)/dq")
          .field("acceleration_dq", &S::acceleration_dq,
                 "d(acceleration)/dq, v and a held")
          .field("acceleration_dv", &S::acceleration_dv,
                 "d(acceleration)/dv, q and a held");
  return all;
}

const Description& description_of(const PlacementDerivatives* /*of*/) {
  using S = PlacementDerivatives;
  static const Description all =
      Describe<S>("derivatives", "PlacementDerivatives",
                  "Derivatives of a frame's placement, nv columns each.")
          .result()
          .field("position", &S::position,
                 "3 x nv, world axes, m/rad (m/m)")
          .field("rotation", &S::rotation,
                 "3 x nv, R^T dR/dq_k = [column k x], the frame's own axes")
          .field("rotation_error", &S::rotation_error,
                 "3 x nv, of log(R_target^T R)")
          .field("placement_error", &S::placement_error,
                 "6 x nv, of the SE(3) logarithm of the frame in the target");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
