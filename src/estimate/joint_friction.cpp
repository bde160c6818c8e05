#include "estimate/joint_friction.hpp"

#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"

namespace burnish {
namespace {

// Tuning constants, chosen by hand unless the comment states an origin.
constexpr double look_ahead = 0.05;       // time after a plan's first knot at which it is read [s]
constexpr double constant_memory = 0.3;   // correlation time of the offset c [s]
constexpr double friction_memory = 10.0;  // correlation time of friction F and B [s]
constexpr double noise_memory = 0.5;      // averaging time of noise variances [s]
// Innovation above which a sample is an outlier [standard deviations].
constexpr double outlier = 4.0;
// Initial standard deviation of the Coulomb friction F, as a fraction of the effort limit.
constexpr double prior_fraction = 0.03;
constexpr double offset_variance = 100.0;  // (initial variance of c) / (initial variance of F)
// Initial variance of the noise, as a multiple of the initial variance of F.
constexpr double noise_variance = 0.01;
constexpr double reversal_noise = 10.0;  // factor on the noise while a joint reverses
// Time constant of the filters through which measured and planned velocities are compared [s].
// After the filter, the velocity steps of a 16-bit encoder are 5 mrad/s.
constexpr double velocity_smoothing = 0.02;
// Width w of the smoothed sign tanh(v / w), in standard deviations of the velocity error. The value
// 1.25 would match the expected sign of a normally distributed velocity. The value 1.6 was best on
// four arms with 1 Nm of friction in each joint.
constexpr double uncertain = 1.6;

/// Returns, per joint, 1 if the joint moves a body that one of the contacts holds.
std::vector<char> in_closed_chains(const Model& model, const std::vector<ContactSpec>& held) {
  std::vector<char> closed(model.joints.size(), 0);
  for (const ContactSpec& contact : held)
    for (const std::string& frame : {contact.tool, contact.base}) {
      if (!model.has_frame(frame)) continue;  // the world, which no joint moves
      int j = model.frames[to_size(model.frame_index(frame))].body;
      for (; j >= 0; j = model.joints[to_size(j)].parent) closed[to_size(j)] = 1;
    }
  return closed;
}

}  // namespace

JointFriction::JointFriction(const Model& model, const ModelErrorOptions& options,
                             const LoopTimes& times, const std::vector<ContactSpec>& held)
    : enabled_(options.kind == ModelErrorKind::Torque && options.joint_friction),
      options_(options),
      lead_(look_ahead),
      // The smoothing time includes the mean age of a plan, which comes into use after solver_delay
      // and stays in use for update_period.
      smoothing_(look_ahead + times.solver_delay + 0.5 * times.update_period),
      joints_(to_size(model.nv)),
      torque_(Eigen::VectorXd::Zero(model.nv)),
      late_(times.delay_ticks()),
      torques_(model.nv, late_),
      speeds_(torques_),
      speed_(torque_) {
  const std::vector<char> closed = in_closed_chains(model, held);
  // Effort limits above the robot's weight times this lever arm [m] count as unlimited.
  constexpr double max_arm = 100.0;
  const double unlimited = max_arm * model.total_mass() * model.gravity.norm();
  for (std::size_t j = 0; j < closed.size(); ++j) {
    const burnish::Joint& of = model.joints[j];
    if (of.kind == JointKind::FreeFlyer || of.follows || closed[j] != 0) continue;
    for (int k = of.v_index; k < of.v_index + of.nv; ++k) {
      Joint& joint = joints_[to_size(k)];
      joint.driven = true;
      const double effort = model.effort_limit[k];
      if (effort > 0.0 && effort < unlimited) joint.prior = prior_fraction * effort;
    }
  }
  reset();
}

void JointFriction::reset() noexcept {
  torque_.setZero();
  speed_.setZero();
  torques_.fill(torque_);
  speeds_.fill(speed_);
  for (Joint& joint : joints_) {
    joint.ahead = joint.between = joint.v = 0.0;
    joint.sign = joint.speed = joint.given = joint.actual = joint.foreseen = Late{};
    joint.strays = 0.0;
    joint.x.setZero();
    const double variance = joint.prior * joint.prior;
    joint.P = Eigen::Vector3d(offset_variance * variance, variance, variance).asDiagonal();
    joint.noise = noise_variance * variance;
  }
}

void JointFriction::foresee(const double* v) noexcept {
  for (Joint& joint : joints_) joint.ahead = *v++;
}

double JointFriction::sign_of(const Joint& joint, double v) const noexcept {
  const double width = std::hypot(options_.friction_speed, uncertain * std::sqrt(joint.strays));
  return std::tanh(v / width);
}

void JointFriction::advance(double dt) noexcept {
  if (!enabled_) return;
  const double weight = -std::expm1(-2.0 * dt / smoothing_);
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    Joint& joint = joints_[k];
    if (!joint.driven) continue;
    joint.between += weight * (joint.ahead - joint.between);
    joint.v += weight * (joint.between - joint.v);
    // Subtracts one standard deviation from the estimated Coulomb friction, so that an uncertain
    // estimate does not cause overcompensation.
    const double coulomb = std::max(0.0, joint.x[1] - std::sqrt(joint.P(1, 1)));
    const double torque = coulomb * sign_of(joint, joint.v) + joint.x[2] * joint.v;
    torque_[static_cast<Eigen::Index>(k)] = std::clamp(torque, -options_.limit, options_.limit);
    speed_[static_cast<Eigen::Index>(k)] = joint.v;
  }
}

void JointFriction::learn(const Eigen::VectorXd& torque_error, const Eigen::VectorXd& v,
                          double bandwidth, double dt) noexcept {
  if (!enabled_ || !(dt > 0.0)) return;
  const double weight = -std::expm1(-bandwidth * dt);
  const double velocity_weight = -std::expm1(-2.0 * dt / velocity_smoothing);
  const double noise_weight = std::min(1.0, dt / noise_memory);
  torques_.add(torque_);
  speeds_.add(speed_);
  const auto torques = torques_.ago(late_), speeds = speeds_.ago(late_);
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    Joint& joint = joints_[k];
    if (!joint.driven) continue;
    const auto i = static_cast<Eigen::Index>(k);
    const double stray = joint.actual.follow(v[i], velocity_weight) -
                         joint.foreseen.follow(speeds[i], velocity_weight);
    joint.strays += noise_weight * (stray * stray - joint.strays);
    const double given = joint.given.follow(torques[i], weight);
    learn(joint, torque_error[i] - given, speeds[i], weight, dt);
  }
}

/// Updates the filter of one joint. `speed`: planned velocity at the time of the error [rad/s].
void JointFriction::learn(Joint& joint, double error, double speed, double weight,
                          double dt) noexcept {
  const double s = joint.sign.follow(sign_of(joint, speed), weight);
  const double v = joint.speed.follow(speed, weight);
  const Eigen::Vector3d phi(1.0, -s, -v);
  // Number of ticks that count as one measurement, because the observer's output is correlated over
  // time.
  const double repeats = std::max(1.0, 2.0 / weight);
  const double turning = 1.0 - s * s;
  // Increases the noise while the joint reverses, because the time of the reversal is uncertain.
  const double late = joint.x[1] * turning;
  const double noise = joint.noise * (1.0 + reversal_noise * turning) + late * late,
               R = repeats * noise;
  const double constant = dt / constant_memory, slow = dt / friction_memory;
  const double wander = repeats * joint.noise;
  joint.P(0, 0) += wander * constant * constant;
  joint.P(1, 1) += wander * slow * slow;
  joint.P(2, 2) += wander * slow * slow;
  const Eigen::Vector3d PH = joint.P * phi;
  const double predicted = phi.dot(PH), S = predicted + R, innovation = error - phi.dot(joint.x);
  if (innovation * innovation > outlier * outlier * (predicted + noise)) {
    // After a push or an impact, the filter assumes that the offset c has changed.
    joint.P(0, 0) += innovation * innovation;
    return;
  }
  const Eigen::Vector3d gain = PH / S;
  joint.x += gain * innovation;
  joint.P -= gain * PH.transpose();
  joint.P = 0.5 * (joint.P + joint.P.transpose()).eval();
  joint.x[1] = std::clamp(joint.x[1], 0.0, options_.limit);
  joint.x[2] = std::max(joint.x[2], 0.0);
  const double left = error - phi.dot(joint.x);
  joint.noise += std::min(1.0, dt / noise_memory) * (left * left - joint.noise);
}

}  // namespace burnish
