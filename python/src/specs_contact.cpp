#include "specs_contact.hpp"

namespace burnish::python {

template <>
const EnumTable& AsEnum<Acceleration>::table() {
  static const EnumTable words("burnish.contact", "Acceleration",
                               {"time_derivative", "spatial", "classical"});
  return words;
}
template <>
const EnumTable& AsEnum<PoseError>::table() {
  static const EnumTable words("burnish.contact", "PoseError", {"split", "log6"});
  return words;
}
template <>
const SpecTable& AsDataclass<ContactSpec>::table() {
  static const SpecTable fields = SpecTable("burnish.contact", "ContactSpec")
                                      .field("name", &ContactSpec::name)
                                      .field("tool", &ContactSpec::tool)
                                      .field("base", &ContactSpec::base)
                                      .field("reference", &ContactSpec::reference)
                                      .field("directions", &ContactSpec::directions)
                                      .field("acceleration", &ContactSpec::acceleration)
                                      .field("error", &ContactSpec::error)
                                      .field("kp", &ContactSpec::kp)
                                      .field("kd", &ContactSpec::kd)
                                      .field("target", &ContactSpec::target);
  return fields;
}
template <>
const SpecTable& AsDataclass<ContactSolver>::table() {
  static const SpecTable fields =
      SpecTable("burnish.contact", "ContactSolver")
          .field("mu", &ContactSolver::mu)
          .field("max_proximal_iterations", &ContactSolver::max_proximal_iterations)
          .field("proximal_tolerance", &ContactSolver::proximal_tolerance);
  return fields;
}
template <>
const SpecTable& AsDataclass<ContactForce>::table() {
  static const SpecTable fields = SpecTable("burnish.contact", "ContactForce")
                                      .field("contact", &ContactForce::contact)
                                      .field("on", &ContactForce::on)
                                      .field("by", &ContactForce::by)
                                      .field("reference", &ContactForce::reference)
                                      .field("value", &ContactForce::value)
                                      .field("tool_rotation", &ContactForce::tool_rotation)
                                      .field("base_rotation", &ContactForce::base_rotation)
                                      .field("tool_position", &ContactForce::tool_position)
                                      .field("base_position", &ContactForce::base_position)
                                      .field("frame_rotation", &ContactForce::frame_rotation)
                                      .field("frame_position", &ContactForce::frame_position);
  return fields;
}

}  // namespace burnish::python
