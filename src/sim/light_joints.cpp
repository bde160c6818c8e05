#include "sim/light_joints.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "base/sentence.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/sim/actuation.hpp"

namespace burnish {
namespace {

/// Ratio of the largest speed during a run to the standard deviation of the speed before control
/// reacts. A normal variable exceeds four deviations once in 16 000 draws, about the number of
/// draws in a run. The factor 1.6 is the further growth of the speed because MPC reacts late
/// (measured: 1.4 for xArm7, 1.4 to 1.6 for SO-101).
constexpr double deviations = 4.0 * 1.6;
/// Time in which a typical motor accelerates its own rotor from rest to its speed limit [s]; chosen
/// by hand.
constexpr double rotor_time = 2e-3;

/// Returns the diagonal of the inverse mass matrix with armatures; empty if the mass matrix is
/// singular.
Eigen::VectorXd mobility(const Model& model, const ConstVectorRef& q) {
  RigidBody body(model);
  Eigen::MatrixXd M(model.nv, model.nv);
  for (int k = 0; k < model.nv; ++k) {
    if (!is_usable(body.update(q, Eigen::VectorXd::Unit(model.nv, k)))) return {};
    body.update_derivatives();
    M.col(k) = body.kinetic_energy_dv();
  }
  const Eigen::LLT<Eigen::MatrixXd> factor(M);
  if (factor.info() != Eigen::Success) return {};
  return factor.solve(Eigen::MatrixXd::Identity(model.nv, model.nv)).diagonal();
}

/// Returns the time until a command can react to a velocity [s].
double reaction_time(const Disturbances& d, double control_period) {
  const bool filtered = d.finite_difference_velocity && d.velocity_cutoff > 0.0;
  return d.command_delay + control_period + (filtered ? 1.0 / d.velocity_cutoff : 0.0);
}

}  // namespace

std::vector<LightJoint> light_joints(const Model& model, const ConstVectorRef& q,
                                     const Disturbances& disturbances,
                                     const LightJointOptions& options) {
  const Eigen::VectorXd noise = torque_noise(model, disturbances);
  if (noise.isZero(0.0)) return {};
  const Eigen::VectorXd speed_per_torque = mobility(model, q);
  if (speed_per_torque.size() == 0) return {};
  const double walk =
      std::sqrt(options.plant_step * reaction_time(disturbances, options.control_period));
  std::vector<LightJoint> light;
  for (int k = 0; k < model.nv; ++k) {
    const double limit = options.joint_speed_ratio * model.velocity_limit[k];
    const double speed = deviations * noise[k] * speed_per_torque[k] * walk;
    if (!(speed > limit)) continue;
    light.push_back({model.v_name(k), k, 1.0 / speed_per_torque[k], noise[k], speed, limit,
                     rotor_time * model.effort_limit[k] / model.velocity_limit[k]});
  }
  return light;
}

std::string light_joints_text(const std::vector<LightJoint>& joints) {
  std::string text, lines;
  for (const LightJoint& each : joints) {
    text += (text.empty() ? "joint " : ", joint ") + in_quotes(each.joint) + " (" +
            number(each.inertia) + " kg m^2, reaches " + number(each.speed) + " rad/s, limit " +
            number(each.limit) + " rad/s)";
    if (std::isfinite(each.armature))
      lines +=
          (lines.empty() ? "" : ", ") + each.joint + ": {armature: " + number(each.armature) + "}";
  }
  text += ": torque noise alone drives " + std::string(joints.size() > 1 ? "them" : "it") +
          " past the speed limit before control reacts; the description probably lacks the inertia "
          "of the motors' rotors";
  if (!lines.empty())
    text +=
        "; wanted typical rotor inertias (2 ms x effort limit / velocity limit) in robot.yaml, "
        "such as joints: {" +
        lines + "}";
  return text;
}

}  // namespace burnish
