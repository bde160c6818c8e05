#include "burnish/sim/sensing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/to_size.hpp"
#include "dynamics/integration.hpp"
#include "sim/random.hpp"

namespace burnish {
namespace {

/// Returns the gain of a first-order low-pass filter over the time `elapsed`; 1 for a cut-off of 0
/// (no filter).
double low_pass(double cutoff, double elapsed) {
  return cutoff > 0.0 ? -std::expm1(-cutoff * elapsed) : 1.0;
}

/// Rounds the joint's angle to the nearest encoder step.
void quantize(const Joint& joint, double step, double* q) {
  if (joint.kind == JointKind::Revolute) q[0] = step * std::round(q[0] / step);
  if (joint.kind != JointKind::Continuous) return;
  const double angle = step * std::round(std::atan2(q[1], q[0]) / step);
  q[0] = std::cos(angle), q[1] = std::sin(angle);
}

}  // namespace

struct Sensing::Random {
  explicit Random(std::uint64_t seed)
      : torque(seed, streams::torque_sensor),
        position(seed, streams::position),
        velocity(seed, streams::velocity),
        force(seed, streams::force),
        support(seed, streams::support) {}
  RandomStream torque, position, velocity, force, support;
};

Sensing::Sensing(const Model& model, const Disturbances& disturbances, const SceneSpec& scene,
                 const std::vector<std::string>& touches, double period)
    : disturbances_((check_disturbances(model, disturbances), disturbances)),
      joints_(model.joints),
      tree_(std::make_unique<Tree>(model)),
      random_(std::make_unique<Random>(disturbances.seed)),
      q_before_(model.q_neutral),
      differences_(Eigen::VectorXd::Zero(model.nv)),
      work_(differences_) {
  for (const std::string& frame : touches) {
    const TouchSpec& touch = scene.touch(frame);
    sensors_.push_back({&touch - scene.touches.data(), touch.measured()});
  }
  measurement_.q = model.q_neutral;
  measurement_.v = measurement_.tau = differences_;
  measurement_.wrenches.setConstant(6, static_cast<Eigen::Index>(touches.size()),
                                    std::numeric_limits<double>::quiet_NaN());
  const long ticks = std::lround(disturbances.measurement_delay / period);
  // Ring buffer with the current measurement and `ticks` earlier ones.
  if (ticks > 0) late_.assign(to_size(ticks) + 1, measurement_);
}

Sensing::~Sensing() = default;

void Sensing::mount_imu(const Model& model, const std::string& frame) {
  imu_.emplace(model, frame, disturbances_);
}

void Sensing::reset() noexcept {
  *random_ = Random(disturbances_.seed);
  if (imu_) imu_->reset();
  started_ = false;
}

const Measurement& Sensing::measure(const Plant& plant, const ConstVectorRef& applied) noexcept {
  elapsed_ = plant.time() - measurement_.time;
  measurement_.time = plant.time();
  measure_position(plant);
  measure_velocity(plant);
  measurement_.tau = applied + plant.friction_torque();
  if (disturbances_.torque_sensor_noise > 0.0)
    for (double& tau : measurement_.tau)
      tau += disturbances_.torque_sensor_noise * random_->torque.normal();
  measure_wrenches(plant);
  if (imu_) {
    measurement_.imu = imu_->measure(
        plant.q(), plant.v(), started_ && elapsed_ > 0.0 ? elapsed_ : plant.dt(), plant.time());
    if (imu_->is_silent()) measurement_.imu.reset();
  }
  const Measurement& seen = delayed();
  started_ = true;
  return seen;
}

/// Returns the measurement taken `measurement_delay` ago. Only its time stamp is the current time.
const Measurement& Sensing::delayed() noexcept {
  if (late_.empty()) return measurement_;
  if (!started_)
    for (Measurement& entry : late_) entry = measurement_;
  late_[next_] = measurement_;
  next_ = (next_ + 1) % late_.size();
  late_[next_].time = measurement_.time;
  return late_[next_];
}

void Sensing::measure_position(const Plant& plant) noexcept {
  Eigen::VectorXd& q = measurement_.q;
  q = plant.q();
  if (disturbances_.position_noise > 0.0) {
    for (double& entry : work_) entry = disturbances_.position_noise * random_->position.normal();
    integrate_configuration(*tree_, q.data(), work_.data(), q.data());
  }
  if (disturbances_.encoder_bits == 0) return;
  const double step = std::ldexp(2.0 * std::numbers::pi, -disturbances_.encoder_bits);
  for (const Joint& joint : joints_)
    if (!joint.follows) quantize(joint, step, q.data() + joint.q_index);
}

void Sensing::measure_velocity(const Plant& plant) noexcept {
  Eigen::VectorXd& v = measurement_.v;
  v = plant.v();
  if (disturbances_.finite_difference_velocity) {
    if (!started_) differences_ = v;
    if (started_ && elapsed_ > 0.0) {
      difference_configuration(*tree_, q_before_.data(), measurement_.q.data(), work_.data());
      const double gain = low_pass(disturbances_.velocity_cutoff, elapsed_);
      differences_ += gain * (work_ / elapsed_ - differences_);
    }
    for (const Joint& joint : joints_)
      if (joint.kind != JointKind::FreeFlyer)
        v.segment(joint.v_index, joint.nv) = differences_.segment(joint.v_index, joint.nv);
    q_before_ = measurement_.q;
  }
  if (disturbances_.velocity_noise > 0.0)
    for (double& entry : v) entry += disturbances_.velocity_noise * random_->velocity.normal();
}

/// Adds noise to the wrenches, then filters them. The low-pass filter starts at the first reading.
void Sensing::measure_wrenches(const Plant& plant) noexcept {
  const double gain = started_ ? low_pass(disturbances_.force_cutoff, elapsed_) : 1.0;
  const auto noise = [](double deviation, RandomStream& stream) {
    return deviation > 0.0 ? deviation * stream.normal() : 0.0;
  };
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const auto [touch, components] = sensors_[i];
    const auto reading = plant.wrenches().col(touch);
    auto measured = measurement_.wrenches.col(static_cast<Eigen::Index>(i));
    const int count = components == WrenchSensor::None    ? 0
                      : components == WrenchSensor::Force ? 3
                                                          : 6;
    if (!started_) measured.head(count).setZero();  // Clears NaN or a value from before reset()
    for (int k = 0; k < count; ++k) {
      const double error = components == WrenchSensor::Force
                               ? noise(disturbances_.force_noise, random_->force)
                           : k < 3 ? noise(disturbances_.support_force_noise, random_->support)
                                   : noise(disturbances_.support_moment_noise, random_->support);
      measured[k] += gain * (reading[k] + error - measured[k]);
    }
  }
}

}  // namespace burnish
