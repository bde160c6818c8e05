#include "burnish/sim/disturbances.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "base/sentence.hpp"
#include "burnish/contact/reference.hpp"

namespace burnish {
namespace {

struct Entry {
  const char* name;
  double value;
};

[[noreturn]] void refuse_entry(const std::string& name, double value, const char* wanted) {
  throw Error("the disturbance '" + name + "' is " + number(value) + "; wanted " + wanted);
}

void check_size(const char* name, const Eigen::VectorXd& entries, int nv) {
  if (entries.size() == 0) return;
  if (entries.size() != nv)
    throw Error("the disturbance '" + std::string(name) + "' has " +
                std::to_string(entries.size()) + " entries; wanted none or " + std::to_string(nv));
  if (!entries.allFinite())
    throw Error("the disturbance '" + std::string(name) + "' holds a NaN or an infinity");
}

/// Entries of v that have a motor and an encoder.
void set_friction(Model& model, double coulomb, double viscous) {
  for (const Joint& joint : model.joints) {
    const bool motor = joint.kind != JointKind::FreeFlyer;
    model.friction.segment(joint.v_index, joint.nv).setConstant(motor ? coulomb : 0.0);
    model.damping.segment(joint.v_index, joint.nv).setConstant(motor ? viscous : 0.0);
  }
}

}  // namespace

void check_disturbances(const Model& model, const Disturbances& d) {
  const std::array<Entry, 14> not_negative{{{"command_delay", d.command_delay},
                                            {"torque_cutoff", d.torque_cutoff},
                                            {"torque_scale_range", d.torque_scale_range},
                                            {"torque_bias_range", d.torque_bias_range},
                                            {"torque_noise", d.torque_noise},
                                            {"torque_sensor_noise", d.torque_sensor_noise},
                                            {"joint_coulomb", d.joint_coulomb},
                                            {"joint_viscous", d.joint_viscous},
                                            {"position_noise", d.position_noise},
                                            {"velocity_noise", d.velocity_noise},
                                            {"velocity_cutoff", d.velocity_cutoff},
                                            {"force_noise", d.force_noise},
                                            {"force_cutoff", d.force_cutoff},
                                            {"surface_friction", d.surface_friction.value_or(0)}}};
  for (const Entry& entry : not_negative)
    if (!(std::isfinite(entry.value) && entry.value >= 0.0))
      refuse_entry(entry.name, entry.value, "a number that is not negative");
  if (!(std::isfinite(d.mass_scale) && d.mass_scale > 0.0))
    refuse_entry("mass_scale", d.mass_scale, "a positive number");
  if (!std::isfinite(d.surface_height))
    refuse_entry("surface_height", d.surface_height, "a number of metres");
  if (!(d.surface_tilt_deg.cwiseAbs().maxCoeff() < 90.0))
    refuse_entry("surface_tilt_deg", d.surface_tilt_deg.cwiseAbs().maxCoeff(),
                 "angles below 90 degrees");
  if (d.encoder_bits < 0 || d.encoder_bits > 40)
    refuse_entry("encoder_bits", d.encoder_bits, "a number from 0 to 40");
  check_size("torque_scale", d.torque_scale, model.nv);
  check_size("torque_bias", d.torque_bias, model.nv);
  for (const Push& push : d.pushes)
    if (!std::isfinite(push.start) || !std::isfinite(push.duration) || push.duration < 0.0 ||
        !push.force_world.allFinite())
      throw Error("a push holds a NaN, an infinity or a negative duration; wanted seconds and N");
}

Model plant_model(const Model& nominal, const Disturbances& disturbances) {
  check_disturbances(nominal, disturbances);
  Model result = nominal;
  for (Joint& joint : result.joints) {
    joint.mass *= disturbances.mass_scale;
    joint.inertia_at_com *= disturbances.mass_scale;
  }
  const bool felt = !disturbances.torque_loop;
  set_friction(result, felt ? disturbances.joint_coulomb : 0.0,
               felt ? disturbances.joint_viscous : 0.0);
  return result;
}

SceneSpec plant_scene(const SceneSpec& nominal, const Disturbances& disturbances) {
  constexpr double degree = std::numbers::pi / 180.0;
  SceneSpec result = nominal;
  SurfaceSpec& surface = result.surface;
  const Eigen::Matrix3d axes = Reference::surface_with_normal(surface.normal).rotation;
  const Eigen::Vector2d tilt = degree * disturbances.surface_tilt_deg;
  surface.point += disturbances.surface_height * axes.col(2);
  if (!tilt.isZero(0.0))
    surface.normal = Eigen::AngleAxisd(tilt[0], axes.col(0)) *
                     (Eigen::AngleAxisd(tilt[1], axes.col(1)) * axes.col(2));
  surface.friction = disturbances.surface_friction.value_or(surface.friction);
  return result;
}

Eigen::Vector3d push_at(const std::vector<Push>& pushes, double time) noexcept {
  constexpr double rounding = 1e-9;  // s: a plant's time is a number of steps times its step
  const double now = time + rounding;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Push& push : pushes)
    if (now >= push.start && now < push.start + push.duration) sum += push.force_world;
  return sum;
}

}  // namespace burnish
