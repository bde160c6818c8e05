#include "specs_derivatives.hpp"

namespace burnish::python {

template <>
const SpecTable& AsDataclass<WrenchDerivatives>::table() {
  static const SpecTable fields = SpecTable("burnish.derivatives", "WrenchDerivatives")
                                      .field("dq", &WrenchDerivatives::dq)
                                      .field("dv", &WrenchDerivatives::dv)
                                      .field("dtau", &WrenchDerivatives::dtau);
  return fields;
}
template <>
const SpecTable& AsDataclass<FrameDerivatives>::table() {
  static const SpecTable fields = SpecTable("burnish.derivatives", "FrameDerivatives")
                                      .field("jacobian", &FrameDerivatives::jacobian)
                                      .field("velocity_dq", &FrameDerivatives::velocity_dq)
                                      .field("acceleration_dq", &FrameDerivatives::acceleration_dq)
                                      .field("acceleration_dv", &FrameDerivatives::acceleration_dv);
  return fields;
}
template <>
const SpecTable& AsDataclass<PlacementDerivatives>::table() {
  static const SpecTable fields =
      SpecTable("burnish.derivatives", "PlacementDerivatives")
          .field("position", &PlacementDerivatives::position)
          .field("rotation", &PlacementDerivatives::rotation)
          .field("rotation_error", &PlacementDerivatives::rotation_error)
          .field("placement_error", &PlacementDerivatives::placement_error);
  return fields;
}
template <>
const SpecTable& AsDataclass<CheckGains>::table() {
  static const SpecTable fields = SpecTable("burnish.derivatives", "CheckGains")
                                      .field("kp", &CheckGains::kp)
                                      .field("kd", &CheckGains::kd)
                                      .field("error", &CheckGains::error);
  return fields;
}
template <>
const SpecTable& AsDataclass<CheckOptions>::table() {
  static const SpecTable fields = SpecTable("burnish.derivatives", "CheckOptions")
                                      .field("tool", &CheckOptions::tool)
                                      .field("base", &CheckOptions::base)
                                      .field("references", &CheckOptions::references)
                                      .field("directions", &CheckOptions::directions)
                                      .field("accelerations", &CheckOptions::accelerations)
                                      .field("gains", &CheckOptions::gains)
                                      .field("contacts", &CheckOptions::contacts)
                                      .field("states", &CheckOptions::states)
                                      .field("seed", &CheckOptions::seed)
                                      .field("tolerance", &CheckOptions::tolerance)
                                      .field("progress", &CheckOptions::progress);
  return fields;
}
template <>
const SpecTable& AsDataclass<CheckEntry>::table() {
  static const SpecTable fields = SpecTable("burnish.derivatives", "CheckEntry")
                                      .field("block", &CheckEntry::block)
                                      .field("row", &CheckEntry::row)
                                      .field("column", &CheckEntry::column)
                                      .field("value", &CheckEntry::value)
                                      .field("expected", &CheckEntry::expected)
                                      .field("state", &CheckEntry::state);
  return fields;
}
template <>
const SpecTable& AsDataclass<CheckRow>::table() {
  static const SpecTable fields = SpecTable("burnish.derivatives", "CheckRow")
                                      .field("reference", &CheckRow::reference)
                                      .field("directions", &CheckRow::directions)
                                      .field("bodies", &CheckRow::bodies)
                                      .field("acceleration", &CheckRow::acceleration)
                                      .field("error", &CheckRow::error)
                                      .field("gains", &CheckRow::gains)
                                      .field("states", &CheckRow::states)
                                      .field("mu", &CheckRow::mu)
                                      .field("worst_error", &CheckRow::worst_error)
                                      .field("worst", &CheckRow::worst)
                                      .field("pass_", &CheckRow::pass);
  return fields;
}
template <>
const SpecTable& AsDataclass<CheckReport>::table() {
  static const SpecTable fields = SpecTable("burnish.derivatives", "CheckReport")
                                      .field("robot", &CheckReport::robot)
                                      .field("rows", &CheckReport::rows)
                                      .field("tolerance", &CheckReport::tolerance)
                                      .field("singular_mass", &CheckReport::singular_mass)
                                      .field("pass_", &CheckReport::pass);
  return fields;
}
template <>
const SpecTable& AsDataclass<RedundantRow>::table() {
  static const SpecTable fields = SpecTable("burnish.derivatives", "RedundantRow")
                                      .field("contact", &RedundantRow::contact)
                                      .field("direction", &RedundantRow::direction)
                                      .field("row", &RedundantRow::row)
                                      .field("immovable", &RedundantRow::immovable)
                                      .field("implied_by", &RedundantRow::implied_by);
  return fields;
}
template <>
const SpecTable& AsDataclass<ContactDiagnosis>::table() {
  static const SpecTable fields = SpecTable("burnish.derivatives", "ContactDiagnosis")
                                      .field("redundant", &ContactDiagnosis::redundant)
                                      .field("condition", &ContactDiagnosis::condition);
  return fields;
}

}  // namespace burnish::python
