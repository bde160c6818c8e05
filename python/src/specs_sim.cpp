#include "specs_sim.hpp"

namespace burnish::python {

template <>
const SpecTable& AsDataclass<Push>::table() {
  static const SpecTable fields = SpecTable("burnish.sim", "Push")
                                      .field("start", &Push::start)
                                      .field("duration", &Push::duration)
                                      .field("force_world", &Push::force_world);
  return fields;
}
template <>
const SpecTable& AsDataclass<Disturbances>::table() {
  static const SpecTable fields =
      SpecTable("burnish.sim", "Disturbances")
          .field("seed", &Disturbances::seed)
          .field("command_delay", &Disturbances::command_delay)
          .field("torque_cutoff", &Disturbances::torque_cutoff)
          .field("torque_scale_range", &Disturbances::torque_scale_range)
          .field("torque_scale", &Disturbances::torque_scale)
          .field("torque_bias_range", &Disturbances::torque_bias_range)
          .field("torque_bias", &Disturbances::torque_bias)
          .field("torque_noise", &Disturbances::torque_noise)
          .field("torque_limits", &Disturbances::torque_limits)
          .field("torque_loop", &Disturbances::torque_loop)
          .field("torque_sensor_noise", &Disturbances::torque_sensor_noise)
          .field("joint_coulomb", &Disturbances::joint_coulomb)
          .field("joint_viscous", &Disturbances::joint_viscous)
          .field("encoder_bits", &Disturbances::encoder_bits)
          .field("position_noise", &Disturbances::position_noise)
          .field("velocity_noise", &Disturbances::velocity_noise)
          .field("finite_difference_velocity", &Disturbances::finite_difference_velocity)
          .field("velocity_cutoff", &Disturbances::velocity_cutoff)
          .field("force_noise", &Disturbances::force_noise)
          .field("force_cutoff", &Disturbances::force_cutoff)
          .field("mass_scale", &Disturbances::mass_scale)
          .field("surface_tilt_deg", &Disturbances::surface_tilt_deg)
          .field("surface_height", &Disturbances::surface_height)
          .field("surface_friction", &Disturbances::surface_friction)
          .field("pushes", &Disturbances::pushes);
  return fields;
}
template <>
const SpecTable& AsDataclass<SurfaceSpec>::table() {
  static const SpecTable fields = SpecTable("burnish.sim", "SurfaceSpec")
                                      .field("point", &SurfaceSpec::point)
                                      .field("normal", &SurfaceSpec::normal)
                                      .field("friction", &SurfaceSpec::friction)
                                      .field("stiffness", &SurfaceSpec::stiffness)
                                      .field("damping", &SurfaceSpec::damping)
                                      .field("extent", &SurfaceSpec::extent)
                                      .field("half_size", &SurfaceSpec::half_size);
  return fields;
}
template <>
const SpecTable& AsDataclass<ToolTipSpec>::table() {
  static const SpecTable fields = SpecTable("burnish.sim", "ToolTipSpec")
                                      .field("frame", &ToolTipSpec::frame)
                                      .field("radius", &ToolTipSpec::radius);
  return fields;
}
template <>
const SpecTable& AsDataclass<SceneSpec>::table() {
  static const SpecTable fields = SpecTable("burnish.sim", "SceneSpec")
                                      .field("surface", &SceneSpec::surface)
                                      .field("tip", &SceneSpec::tip);
  return fields;
}
template <>
const SpecTable& AsDataclass<PlantSnapshot>::table() {
  static const SpecTable fields =
      SpecTable("burnish.sim", "PlantSnapshot").field("numbers", &PlantSnapshot::numbers);
  return fields;
}
template <>
const SpecTable& AsDataclass<ActuationStep>::table() {
  static const SpecTable fields = SpecTable("burnish.sim", "ActuationStep")
                                      .field("command", &ActuationStep::command)
                                      .field("delayed", &ActuationStep::delayed)
                                      .field("tracked", &ActuationStep::tracked)
                                      .field("noise", &ActuationStep::noise)
                                      .field("applied", &ActuationStep::applied)
                                      .field("limited", &ActuationStep::limited)
                                      .field("held", &ActuationStep::held);
  return fields;
}
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
const SpecTable& AsDataclass<IdealPlantOptions>::table() {
  static const SpecTable fields = SpecTable("burnish.sim", "IdealPlantOptions")
                                      .field("dt", &IdealPlantOptions::dt)
                                      .field("tip_viscous", &IdealPlantOptions::tip_viscous)
                                      .field("stabilize_kp", &IdealPlantOptions::stabilize_kp)
                                      .field("stabilize_kd", &IdealPlantOptions::stabilize_kd);
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
template <>
const SpecTable& AsDataclass<ClosedLoopOptions>::table() {
  static const SpecTable fields = SpecTable("burnish.sim", "ClosedLoopOptions")
                                      .field("control_period", &ClosedLoopOptions::control_period)
                                      .field("max_duration", &ClosedLoopOptions::max_duration)
                                      .field("record_every", &ClosedLoopOptions::record_every);
  return fields;
}

}  // namespace burnish::python
