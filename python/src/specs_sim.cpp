#include "specs_sim.hpp"

namespace burnish::python {

template <>
const SpecTable& AsDataclass<TaskPoint>::table() {
  static const SpecTable fields = SpecTable("burnish.sim", "TaskPoint")
                                      .field("p_world", &TaskPoint::p_world)
                                      .field("v_world", &TaskPoint::v_world)
                                      .field("a_world", &TaskPoint::a_world)
                                      .field("force", &TaskPoint::force);
  return fields;
}
template <>
const SpecTable& AsDataclass<CirclePath>::table() {
  static const SpecTable fields = SpecTable("burnish.sim", "CirclePath")
                                      .field("center_world", &CirclePath::center_world)
                                      .field("normal_world", &CirclePath::normal_world)
                                      .field("radius", &CirclePath::radius)
                                      .field("rate", &CirclePath::rate)
                                      .field("start_up", &CirclePath::start_up)
                                      .field("force", &CirclePath::force);
  return fields;
}
template <>
const SpecTable& AsDataclass<ImpedanceSpec>::table() {
  static const SpecTable fields = SpecTable("burnish.sim", "ImpedanceSpec")
                                      .field("tool", &ImpedanceSpec::tool)
                                      .field("normal_world", &ImpedanceSpec::normal_world)
                                      .field("task", &ImpedanceSpec::task)
                                      .field("posture", &ImpedanceSpec::posture)
                                      .field("period", &ImpedanceSpec::period)
                                      .field("kp", &ImpedanceSpec::kp)
                                      .field("kd", &ImpedanceSpec::kd)
                                      .field("kd_normal", &ImpedanceSpec::kd_normal)
                                      .field("ki", &ImpedanceSpec::ki)
                                      .field("integral_limit", &ImpedanceSpec::integral_limit)
                                      .field("posture_kp", &ImpedanceSpec::posture_kp)
                                      .field("posture_kd", &ImpedanceSpec::posture_kd)
                                      .field("friction", &ImpedanceSpec::friction)
                                      .field("approach_speed", &ImpedanceSpec::approach_speed)
                                      .field("contact_threshold", &ImpedanceSpec::contact_threshold)
                                      .field("ramp", &ImpedanceSpec::ramp);
  return fields;
}
template <>
const SpecTable& AsDataclass<MujocoPlantOptions>::table() {
  static const SpecTable fields = SpecTable("burnish.sim", "MujocoPlantOptions")
                                      .field("dt", &MujocoPlantOptions::dt)
                                      .field("impedance", &MujocoPlantOptions::impedance)
                                      .field("friction_ratio", &MujocoPlantOptions::friction_ratio)
                                      .field("tolerance", &MujocoPlantOptions::tolerance)
                                      .field("max_iterations", &MujocoPlantOptions::max_iterations)
                                      .field("joint_stops", &MujocoPlantOptions::joint_stops);
  return fields;
}

}  // namespace burnish::python
