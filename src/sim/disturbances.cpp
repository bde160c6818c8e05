#include "burnish/sim/disturbances.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "base/sentence.hpp"
#include "burnish/dynamics/reference.hpp"
#include "sim/descriptions.gen.hpp"
#include "sim/random.hpp"

namespace burnish {
namespace {

void check_size(const char* name, const Eigen::VectorXd& entries, int nv) {
  if (entries.size() == 0) return;
  if (entries.size() != nv)
    throw Error("the disturbance '" + std::string(name) + "' has " +
                std::to_string(entries.size()) + " entries; wanted none or " + std::to_string(nv));
}

/// Sets the joint friction for the entries of v that have a motor.
void set_friction(Model& model, const Disturbances& d) {
  model.friction.setZero();
  model.damping.setZero();
  if (d.torque_loop) return;
  for (const Joint& joint : model.joints) {
    if (joint.kind == JointKind::FreeFlyer) continue;
    for (int k = joint.v_index; k < joint.v_index + joint.nv; ++k) {
      const double max_friction = d.joint_friction_share * model.effort_limit[k];
      const bool is_bounded = d.joint_friction_share > 0.0 && max_friction < d.joint_coulomb;
      model.friction[k] = is_bounded ? max_friction : d.joint_coulomb;
      model.damping[k] = d.joint_viscous * (is_bounded ? max_friction / d.joint_coulomb : 1.0);
    }
  }
}

}  // namespace

void check_disturbances(const Model& model, const Disturbances& d) {
  check_ranges(description_of(&d), &d,
               [](const std::string& entry) { return "the disturbance " + in_quotes(entry); });
  check_size("torque_scale", d.torque_scale, model.nv);
  check_size("torque_bias", d.torque_bias, model.nv);
  if (d.surface_shape) d.surface_shape->check("the disturbance 'surface_shape'");
  std::vector<std::string> joints;
  for (const Joint& joint : model.joints) joints.push_back(joint.name);
  for (const MotorLoss& loss : d.motor_losses)
    if (std::find(joints.begin(), joints.end(), loss.joint) == joints.end())
      throw Error("the disturbance 'motor_losses' names joint " + in_quotes(loss.joint) +
                  ", which robot " + in_quotes(model.name) + " does not have" +
                  did_you_mean(loss.joint, joints));
}

const std::vector<std::string>& disturbance_presets() {
  static const std::vector<std::string> names{"none", "sensors", "mismatch", "joint_friction"};
  return names;
}

Disturbances disturbance_preset(const std::string& name) {
  const std::vector<std::string>& names = disturbance_presets();
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw Error("unknown disturbances " + in_quotes(name) +
                "; wanted none, sensors, mismatch or joint_friction" + did_you_mean(name, names));
  Disturbances result;
  if (name == "none") return result;
  constexpr double cutoff = 100.0 * std::numbers::pi;  // 50 Hz, as an angular frequency [rad/s]
  result.command_delay = 1e-3;
  result.torque_noise = 0.05;
  // Reduces the noise of small motors. The weakest motor of Talos (4 Nm) still has the full noise
  // of 0.05 Nm.
  result.torque_noise_share = 1.0 / 80.0;
  result.encoder_bits = 17;
  result.finite_difference_velocity = true;
  result.velocity_cutoff = cutoff;
  result.force_noise = 0.3;
  result.support_force_noise = 1.0;
  result.support_moment_noise = 0.1;
  result.gyro_noise = 1e-4;
  result.gyro_bias_range = 5e-3;
  result.gyro_bias_walk = 1e-5;
  result.accelerometer_noise = 1e-3;
  result.accelerometer_bias_range = 0.05;
  result.accelerometer_bias_walk = 1e-4;
  result.force_cutoff = cutoff;
  if (name == "sensors") return result;
  result.mass_scale = 1.05;
  result.surface_friction = 0.3;
  if (name == "mismatch") return result;
  result.joint_coulomb = 1.0;
  result.joint_viscous = 1.0;
  // Reduces the friction of small motors, because their gears have less. With 1 Nm of friction, a
  // motor of 3 Nm could hardly move its arm.
  result.joint_friction_share = 1.0 / 20.0;
  return result;
}

Payload carried_payload(const Disturbances& disturbances) {
  const UnknownPayload& given = disturbances.payload;
  RandomStream random(disturbances.seed, streams::payload);
  Payload result;
  result.frame = given.frame;
  InertiaSpec& sphere = result.inertia;
  sphere.mass = std::max(0.0, given.mass + random.uniform(-given.mass_range, given.mass_range));
  if (sphere.mass == 0.0) return result;
  sphere.com = given.com;
  for (double& x : sphere.com) x += random.uniform(-given.com_range, given.com_range);
  sphere.inertia_at_com =
      0.4 * sphere.mass * given.radius * given.radius * Eigen::Matrix3d::Identity();
  return result;
}

Model plant_model(const Model& nominal, const Disturbances& disturbances) {
  check_disturbances(nominal, disturbances);
  Model result = nominal;
  for (Joint& joint : result.joints) {
    joint.mass *= disturbances.mass_scale;
    joint.inertia_at_com *= disturbances.mass_scale;
  }
  set_friction(result, disturbances);
  const Payload payload = carried_payload(disturbances);
  return payload.inertia.mass > 0.0 ? with_payload(std::move(result), payload) : result;
}

SurfaceSpec plant_surface(const SurfaceSpec& nominal, const Disturbances& disturbances) {
  SurfaceSpec surface = nominal;
  constexpr double degree = std::numbers::pi / 180.0;
  const Eigen::Matrix3d axes = Reference::surface_with_normal(surface.normal).rotation;
  const Eigen::Vector2d tilt = degree * disturbances.surface_tilt_deg;
  surface.point += disturbances.surface_height * axes.col(2);
  if (!tilt.isZero(0.0))
    surface.normal = Eigen::AngleAxisd(tilt[0], axes.col(0)) *
                     (Eigen::AngleAxisd(tilt[1], axes.col(1)) * axes.col(2));
  SurfaceShape& shape = surface.shape;
  shape = disturbances.surface_shape.value_or(shape);
  const double curvature_scale = disturbances.surface_curvature;
  shape.radius /= curvature_scale;
  shape.ring /= curvature_scale;
  shape.semi_axes /= curvature_scale;
  shape.curvature *= curvature_scale;
  surface.motion = disturbances.surface_motion;
  surface.friction = disturbances.surface_friction.value_or(surface.friction);
  return surface;
}

SceneSpec plant_scene(const SceneSpec& nominal, const Disturbances& disturbances) {
  SceneSpec result = nominal;
  for (TouchSpec& touch : result.touches)
    if (!touch.is_support) touch.surface = plant_surface(touch.surface, disturbances);
  result.slippery_ground = disturbances.slippery_ground;
  return result;
}

}  // namespace burnish
