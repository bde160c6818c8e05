#include "burnish/sim/actuation.hpp"

#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "sim/random.hpp"

namespace burnish {
namespace {

std::vector<char> motors(const Model& model) {
  std::vector<char> result(to_size(model.nv), 1);
  for (const Joint& joint : model.joints)
    if (joint.kind == JointKind::FreeFlyer)
      std::fill_n(result.begin() + joint.v_index, joint.nv, static_cast<char>(0));
  return result;
}

/// Returns the standard deviation of the noise due to Disturbances::torque_noise, for each entry of
/// v [Nm or N].
Eigen::VectorXd added_noise(const Model& model, const std::vector<char>& motor,
                            const Disturbances& d) {
  Eigen::VectorXd noise = Eigen::VectorXd::Zero(model.nv);
  for (int k = 0; k < model.nv; ++k) {
    if (motor[to_size(k)] == 0) continue;
    noise[k] = d.torque_noise;
    if (d.torque_noise_share > 0.0)
      noise[k] = std::min(noise[k], d.torque_noise_share * model.effort_limit[k]);
  }
  return noise;
}

/// Returns `given` or, if `given` is empty, random values between centre - range and centre +
/// range.
Eigen::VectorXd drawn(const std::vector<char>& motor, const Eigen::VectorXd& given, double centre,
                      double range, RandomStream random) {
  if (given.size() > 0) return given;
  Eigen::VectorXd result =
      Eigen::VectorXd::Constant(static_cast<Eigen::Index>(motor.size()), centre);
  for (std::size_t k = 0; k < motor.size(); ++k)
    if (motor[k] != 0) result[static_cast<Eigen::Index>(k)] += random.uniform(-range, range);
  return result;
}

}  // namespace

Eigen::VectorXd torque_noise(const Model& model, const Disturbances& disturbances) {
  const std::vector<char> motor = motors(model);
  Eigen::VectorXd noise = added_noise(model, motor, disturbances);
  if (!disturbances.torque_loop) return noise;
  for (int k = 0; k < model.nv; ++k)
    if (motor[to_size(k)] != 0) noise[k] = std::hypot(noise[k], disturbances.torque_sensor_noise);
  return noise;
}

struct Actuation::Random {
  explicit Random(std::uint64_t seed)
      : noise(seed, streams::torque_noise), sensor_noise(seed, streams::torque_loop) {}
  RandomStream noise, sensor_noise;
};

Actuation::Actuation(const Model& model, const Disturbances& disturbances, double dt)
    : disturbances_((check_disturbances(model, disturbances), disturbances)),
      motor_(motors(model)),
      limit_(model.effort_limit),
      scale_(drawn(motor_, disturbances.torque_scale, 1.0, disturbances.torque_scale_range,
                   {disturbances.seed, streams::torque_scale})),
      bias_(drawn(motor_, disturbances.torque_bias, 0.0, disturbances.torque_bias_range,
                  {disturbances.seed, streams::torque_bias})),
      at_rest_(Eigen::VectorXd::Zero(model.nv)),
      noise_(added_noise(model, motor_, disturbances)),
      delay_steps_(static_cast<int>(std::lround(disturbances.command_delay / dt))),
      dt_(dt),
      tracking_(disturbances.torque_cutoff > 0.0 ? -std::expm1(-disturbances.torque_cutoff * dt)
                                                 : 1.0),
      random_(std::make_unique<Random>(disturbances.seed)) {
  queue_ = Eigen::MatrixXd::Zero(model.nv, delay_steps_);
  for (Eigen::VectorXd* x :
       {&step_.command, &step_.delayed, &step_.tracked, &step_.noise, &step_.applied})
    *x = at_rest_;
  for (const MotorLoss& loss : disturbances.motor_losses)
    for (const Joint& joint : model.joints)
      if (joint.name == loss.joint) losses_.push_back({loss, joint.v_index, joint.nv});
}

Actuation::~Actuation() = default;
Actuation::Actuation(Actuation&&) noexcept = default;
Actuation& Actuation::operator=(Actuation&&) noexcept = default;

Actuation::Actuation(const Actuation& other)
    : disturbances_(other.disturbances_),
      motor_(other.motor_),
      limit_(other.limit_),
      scale_(other.scale_),
      bias_(other.bias_),
      at_rest_(other.at_rest_),
      noise_(other.noise_),
      queue_(other.queue_),
      delay_steps_(other.delay_steps_),
      next_(other.next_),
      losses_(other.losses_),
      dt_(other.dt_),
      steps_(other.steps_),
      tracking_(other.tracking_),
      random_(std::make_unique<Random>(*other.random_)),
      step_(other.step_) {}

Actuation& Actuation::operator=(const Actuation& other) {
  if (this != &other) *this = Actuation(other);
  return *this;
}

void Actuation::reset() noexcept { reset(at_rest_); }

void Actuation::reset(const ConstVectorRef& tau) noexcept {
  if (tau.size() != at_rest_.size()) return;
  *random_ = Random(disturbances_.seed);
  next_ = 0;
  steps_ = 0;
  queue_.colwise() = tau;
  step_.command = step_.delayed = step_.tracked = step_.applied = tau;
  step_.noise.setZero();
  step_.limited = 0;
  step_.held = false;
}

const Eigen::VectorXd& Actuation::apply(const ConstVectorRef& command) noexcept {
  step_.held = command.size() != at_rest_.size() || !command.allFinite();
  if (!step_.held) step_.command = command;
  delay();
  if (tracking_ < 1.0)
    step_.tracked += tracking_ * (step_.delayed - step_.tracked);
  else
    step_.tracked = step_.delayed;
  distort();
  fail();
  ++steps_;
  return step_.applied;
}

void Actuation::delay() noexcept {
  if (delay_steps_ == 0) {
    step_.delayed = step_.command;
    return;
  }
  step_.delayed = queue_.col(next_);
  queue_.col(next_) = step_.command;
  next_ = (next_ + 1) % delay_steps_;
}

void Actuation::distort() noexcept {
  const bool loop = disturbances_.torque_loop;
  step_.limited = 0;
  for (Eigen::Index k = 0; k < limit_.size(); ++k) {
    double& noise = step_.noise[k];
    noise = 0.0;
    if (motor_[to_size(k)] == 0) {
      step_.applied[k] = step_.tracked[k];
      continue;
    }
    if (disturbances_.torque_noise > 0.0) noise += noise_[k] * random_->noise.normal();
    // The torque loop controls the sensor's reading. The actual torque therefore contains the
    // negative noise of the sensor.
    if (loop && disturbances_.torque_sensor_noise > 0.0)
      noise -= disturbances_.torque_sensor_noise * random_->sensor_noise.normal();
    const double wanted = loop ? step_.tracked[k] : scale_[k] * step_.tracked[k] + bias_[k];
    double& applied = step_.applied[k];
    applied = wanted + noise;
    if (!disturbances_.torque_limits || std::abs(applied) <= limit_[k]) continue;
    applied = std::copysign(limit_[k], applied);
    ++step_.limited;
  }
}

void Actuation::fail() noexcept {
  const double now = static_cast<double>(steps_) * dt_;
  for (const Loss& loss : losses_)
    if (acts_at(loss.when, now)) step_.applied.segment(loss.first, loss.count) *= loss.when.share;
}

}  // namespace burnish
