#include "derivatives/descriptions.hpp"

namespace burnish {

const Description& description_of(const WrenchDerivatives* /*of*/) {
  using W = WrenchDerivatives;
  static const Description all =
      Describe<W>("derivatives", "WrenchDerivatives",
                  "Derivatives of a wrench in a reference: (6, nv) each, force rows first.")
          .result()
          .field("dq", &W::dq, "N/rad (N/m), Nm/rad (Nm/m), by the right tangent increment of q")
          .field("dv", &W::dv)
          .field("dtau", &W::dtau, "{1/m} (force per torque), dimensionless (moment per torque)");
  return all;
}

const Description& description_of(const FrameDerivatives* /*of*/) {
  using F = FrameDerivatives;
  static const Description all =
      Describe<F>("derivatives", "FrameDerivatives",
                  "Derivatives of a frame's motion, (6, nv) each, linear rows first, in the axes "
                  "that were asked for.")
          .result()
          .field("jacobian", &F::jacobian, "d(velocity)/dv, and d(acceleration)/da")
          .field("velocity_dq", &F::velocity_dq, "d(velocity)/dq")
          .field("acceleration_dq", &F::acceleration_dq, "d(acceleration)/dq, v and a held")
          .field("acceleration_dv", &F::acceleration_dv, "d(acceleration)/dv, q and a held");
  return all;
}

const Description& description_of(const PlacementDerivatives* /*of*/) {
  using P = PlacementDerivatives;
  static const Description all =
      Describe<P>("derivatives", "PlacementDerivatives",
                  "Derivatives of a frame's placement, nv columns each.")
          .result()
          .field("position", &P::position, "3 x nv, world axes, m/rad (m/m)")
          .field("rotation", &P::rotation,
                 "3 x nv, R^T dR/dq_k = [column k x], the frame's own axes")
          .field("rotation_error", &P::rotation_error, "3 x nv, of log(R_target^T R)")
          .field("placement_error", &P::placement_error,
                 "6 x nv, of the SE(3) logarithm of the frame in the target");
  return all;
}

const Description& description_of(const CheckGains* /*of*/) {
  using C = CheckGains;
  static const Description all =
      Describe<C>("derivatives", "CheckGains",
                  "Gains that a check tries, and the error that they act on.")
          .field("kp", &C::kp, "{1/s^2}")
          .field("kd", &C::kd, "{1/s}")
          .field("error", &C::error);
  return all;
}

const Description& description_of(const CheckEntry* /*of*/) {
  using C = CheckEntry;
  static const Description all =
      Describe<C>("derivatives", "CheckEntry",
                  "One entry of one block: a derivative, and what differences say.")
          .field("block", &C::block, "such as \"da_dq\"")
          .field("row", &C::row, "entry of v, or contact and direction such as \"tool/z\"")
          .field("column", &C::column, "what it is differentiated by: an entry of v, or of lambda")
          .field("value", &C::value, "computed analytically")
          .field("expected", &C::expected, "from differences")
          .field("state", &C::state, "which of the random states, from 0");
  return all;
}

const Description& description_of(const CheckRow* /*of*/) {
  using C = CheckRow;
  static const Description all =
      Describe<C>("derivatives", "CheckRow",
                  "One set of contacts at all states. Words that differ between contacts are "
                  "joined by \" + \".")
          .field("reference", &C::reference)
          .field("directions", &C::directions)
          .field("bodies", &C::bodies, "\"tool on base\"")
          .field("acceleration", &C::acceleration)
          .field("error", &C::error, R"("split" or "log6"; "-" without a proportional gain)")
          .field("gains", &C::gains, R"("none", or such as "kp 7..12, kd 2..7")")
          .field("states", &C::states)
          .field("mu", &C::mu,
                 "Compliance that the row was checked with, m/s^2 per N: zero, or positive where "
                 "the joints cannot hold the contact rigidly at most postures (too few joints, "
                 "redundant rows).")
          .field("worst_error", &C::worst_error,
                 "Relative to the block's largest entry, or to what makes its rounding 1e-6 where "
                 "that is more; infinite after a NaN.")
          .field("worst", &C::worst)
          .field("pass_", &C::pass, "worst_error <= tolerance");
  return all;
}

const Description& description_of(const CheckReport* /*of*/) {
  using C = CheckReport;
  static const Description all =
      Describe<C>("derivatives", "CheckReport", "What check_derivatives() found.")
          .field("robot", &C::robot)
          .field("rows", &C::rows)
          .field("tolerance", &C::tolerance)
          .field(
              "singular_mass", &C::singular_mass,
              "Why there is no forward dynamics to check, naming the joints that move no mass: "
              "rows then are of inverse dynamics and contact accelerations alone. Empty: there is.")
          .field("pass_", &C::pass,
                 "there are rows, all of them pass, and the mass matrix is not singular");
  return all;
}

const Description& description_of(const RedundantRow* /*of*/) {
  using R = RedundantRow;
  static const Description all =
      Describe<R>("derivatives", "RedundantRow",
                  "A row of the contact Jacobian that depends on rows before it.")
          .result()
          .field("contact", &R::contact, "name of the contact")
          .field("direction", &R::direction, R"("x" ... "rz" in its reference)")
          .field("row", &R::row, "index among all rows of the set")
          .field("immovable", &R::immovable, "no joint moves it at this posture, but for rounding")
          .field("implied_by", &R::implied_by,
                 "\"contact/direction\" of the rows that already hold it");
  return all;
}

const Description& description_of(const ContactDiagnosis* /*of*/) {
  using C = ContactDiagnosis;
  static const Description all =
      Describe<C>(
          "derivatives", "ContactDiagnosis",
          "What diagnose() found: no redundant rows means that the contacts are independent.")
          .result()
          .field("redundant", &C::redundant)
          .field("condition", &C::condition,
                 "of J M^-1 J^T scaled to a unit diagonal; infinite when redundant");
  return all;
}

}  // namespace burnish
