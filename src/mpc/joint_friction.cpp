#include "mpc/joint_friction.hpp"

#include <algorithm>
#include <cmath>

#include "burnish/contact/loops.hpp"
#include "mpc/closed_dynamics.hpp"

namespace burnish {
namespace {

constexpr double look_ahead = 0.05;       // s, of plans
constexpr double constant_memory = 0.3;   // s, in which c may become another
constexpr double friction_memory = 10.0;  // s, in which F and B may
constexpr double noise_memory = 0.5;      // s
constexpr double outlier = 4.0;           // deviations
// s of the filter behind which a joint's velocity is compared with the planned one. The steps of an
// encoder of 16 bits are 5 mrad/s there.
constexpr double velocity_smoothing = 0.02;
// Deviations of a joint's velocity from the planned one within which its sign is uncertain. The
// mean sign of a normal variable has 1.25; 1.6 was best on four arms with 1 Nm of friction in each
// joint.
constexpr double uncertain = 1.6;

/// Of every joint, whether it moves something that a loop or a support holds: there any joint's
/// friction is felt in all of them.
std::vector<char> in_closed_chains(const MpcSpec& spec) {
  const Model& model = spec.problem.model;
  std::vector<char> closed(model.joints.size(), 0);
  for (const ContactSpec& contact : with_loops(model, supports_of(spec)))
    for (const std::string& frame : {contact.tool, contact.base}) {
      if (!model.has_frame(frame)) continue;  // the world
      int j = model.frames[static_cast<std::size_t>(model.frame_index(frame))].body;
      for (; j >= 0; j = model.joints[static_cast<std::size_t>(j)].parent)
        closed[static_cast<std::size_t>(j)] = 1;
    }
  return closed;
}

}  // namespace

JointFriction::JointFriction(const MpcSpec& spec)
    : enabled_(spec.model_error.kind == ModelErrorKind::Torque && spec.model_error.joint_friction),
      options_(spec.model_error),
      lead_(look_ahead),
      // A plan is used so long after it begins, and stands for so long.
      smoothing_(look_ahead + spec.solver_delay + 0.5 * spec.update_period),
      joints_(static_cast<std::size_t>(spec.problem.model.nv)),
      torque_(Eigen::VectorXd::Zero(spec.problem.model.nv)),
      late_(static_cast<int>(std::lround(spec.command_delay / spec.tick_period) +
                             std::lround(spec.measurement_delay / spec.tick_period))),
      torques_(spec.problem.model.nv, late_),
      speeds_(torques_),
      speed_(torque_) {
  const std::vector<char> closed = in_closed_chains(spec);
  // m: an effort that lifts the robot's weight on such an arm, such as 1e9 Nm, stands for none.
  constexpr double longest_arm = 100.0;
  const Model& model = spec.problem.model;
  const double unlimited = longest_arm * model.total_mass() * model.gravity.norm();
  for (std::size_t j = 0; j < closed.size(); ++j) {
    const burnish::Joint& of = spec.problem.model.joints[j];
    if (of.kind == JointKind::FreeFlyer || of.follows || closed[j] != 0) continue;
    for (int k = of.v_index; k < of.v_index + of.nv; ++k) {
      Joint& joint = joints_[static_cast<std::size_t>(k)];
      joint.driven = true;
      const double effort = spec.problem.model.effort_limit[k];
      if (effort > 0.0 && effort < unlimited) joint.prior = 0.03 * effort;
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
    joint.P = Eigen::Vector3d(100.0 * variance, variance, variance).asDiagonal();
    joint.noise = 0.01 * variance;
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
  const double share = -std::expm1(-2.0 * dt / smoothing_);
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    Joint& joint = joints_[k];
    if (!joint.driven) continue;
    joint.between += share * (joint.ahead - joint.between);
    joint.v += share * (joint.between - joint.v);
    const double sure = std::max(0.0, joint.x[1] - std::sqrt(joint.P(1, 1)));
    const double torque = sure * sign_of(joint, joint.v) + joint.x[2] * joint.v;
    torque_[static_cast<Eigen::Index>(k)] = std::clamp(torque, -options_.limit, options_.limit);
    speed_[static_cast<Eigen::Index>(k)] = joint.v;
  }
}

void JointFriction::learn(const Eigen::VectorXd& torque_error, const Eigen::VectorXd& v,
                          double bandwidth, double dt) noexcept {
  if (!enabled_ || !(dt > 0.0)) return;
  const double share = -std::expm1(-bandwidth * dt);
  const double part = -std::expm1(-2.0 * dt / velocity_smoothing);
  const double forgotten = std::min(1.0, dt / noise_memory);
  torques_.add(torque_);
  speeds_.add(speed_);
  const auto torques = torques_.ago(late_), speeds = speeds_.ago(late_);
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    Joint& joint = joints_[k];
    if (!joint.driven) continue;
    const auto i = static_cast<Eigen::Index>(k);
    const double stray = joint.actual.follow(v[i], part) - joint.foreseen.follow(speeds[i], part);
    joint.strays += forgotten * (stray * stray - joint.strays);
    const double given = joint.given.follow(torques[i], share);
    learn(joint, torque_error[i] - given, speeds[i], share, dt);
  }
}

/// speed: rad/s, of the joint when the error was there.
void JointFriction::learn(Joint& joint, double error, double speed, double share,
                          double dt) noexcept {
  const double s = joint.sign.follow(sign_of(joint, speed), share);
  const double v = joint.speed.follow(speed, share);
  const Eigen::Vector3d phi(1.0, -s, -v);
  // What the observer says stays the same for a while: so many ticks are worth one.
  const double repeats = std::max(1.0, 2.0 / share);
  const double turning = 1.0 - s * s;
  const double late = joint.x[1] * turning;  // the joint turns around a little sooner or later
  const double once = joint.noise * (1.0 + 10.0 * turning) + late * late, R = repeats * once;
  const double constant = dt / constant_memory, slow = dt / friction_memory;
  const double wander = repeats * joint.noise;
  joint.P(0, 0) += wander * constant * constant;
  joint.P(1, 1) += wander * slow * slow;
  joint.P(2, 2) += wander * slow * slow;
  const Eigen::Vector3d PH = joint.P * phi;
  const double known = phi.dot(PH), S = known + R, innovation = error - phi.dot(joint.x);
  if (innovation * innovation > outlier * outlier * (known + once)) {
    // A push, an impact: another constant, first of all.
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
