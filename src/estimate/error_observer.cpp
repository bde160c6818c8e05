#include "estimate/error_observer.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"

namespace burnish {

namespace {

/// Returns the supports whose frames are not in `measured`.
std::vector<ContactSpec> without_sensor(std::vector<ContactSpec> supports,
                                        const std::vector<std::string>& measured) {
  std::erase_if(supports, [&](const ContactSpec& support) {
    return std::find(measured.begin(), measured.end(), support.tool) != measured.end();
  });
  return supports;
}

}  // namespace

ChangeDetector::ChangeDetector(const Model& model, const ModelErrorOptions& options)
    : transient_scale_(std::max(options.usual_transient_scale(), 1.0)),
      quiescent_scale_(options.quiescent_scale),
      rate_(Eigen::VectorXd::Zero(model.nv)),
      usual_(rate_),
      floor_(rate_),
      slow_(rate_),
      slow_square_(rate_),
      square_(rate_) {
  // Largest rate of the torque error that never counts as a transient, as a fraction of effort
  // limit times bandwidth; chosen by hand. A missing effort limit counts as 100 Nm.
  constexpr double small = 2e-3;
  for (int k = 0; k < model.nv; ++k) {
    const double effort = model.effort_limit[k];
    const double rate = small * options.usual_bandwidth() *
                        (std::isfinite(effort) && effort > 0.0 ? effort : 100.0);
    floor_[k] = rate * rate;
  }
}

void ChangeDetector::reset() noexcept {
  rate_.setZero();
  usual_.setZero();
  slow_.setZero();
  slow_square_.setZero();
  square_.setZero();
  level_ = seen_ = 0.0;
  busy_ = 1.0;
}

void ChangeDetector::see(const Eigen::VectorXd& change, double dt) noexcept {
  constexpr double memory = 1.0;  // averaging time of noise [s]
  seen_ += dt;
  const double weight = std::min(1.0, dt / std::min(seen_, memory));
  const double rate = 1.0 / (factor() * factor() * dt);
  detect_jumps(change, rate, dt, weight);
  detect_drift(change, rate, dt, weight);
}

/// Detects jumps: rates of the torque error far beyond the usual rates, for some milliseconds.
void ChangeDetector::detect_jumps(const Eigen::VectorXd& change, double rate, double dt,
                                  double weight) noexcept {
  // Smoothing time of rates, time until detection starts, decay time of a detected jump [s].
  constexpr double smoothing = 4e-3, first = 0.1, decay_time = 0.15;
  // Thresholds for the squared rate relative to its usual mean, averaged over the joints. Below
  // `noise` the rate is noise, above `certain` it is a jump; chosen by hand. The thresholds are
  // high for two reasons. Averaging over the joints does not reduce the noise of a force sensor,
  // which disturbs all joints at once. At hundreds of samples per second, false alarms must be
  // rare.
  constexpr double noise = 8.0, certain = 14.0;
  rate_ += std::min(1.0, dt / smoothing) * (change * rate - rate_);
  double ratio = 0.0;
  for (Eigen::Index k = 0; k < rate_.size(); ++k) {
    const double square = rate_[k] * rate_[k];
    ratio += square / std::max(usual_[k], floor_[k]);
    // Limits the squared rate of an outlier to 9 times the usual squared rate, so that `usual_`
    // grows slowly.
    const double max_square = 9.0 * std::max(usual_[k], floor_[k]);
    usual_[k] += weight * (std::min(square, max_square) - usual_[k]);
  }
  ratio /= static_cast<double>(std::max<Eigen::Index>(rate_.size(), 1));
  const double level =
      seen_ < first ? 0.0 : std::clamp((ratio - noise) / (certain - noise), 0.0, 1.0);
  level_ = std::max(level, level_ * std::exp(-dt / decay_time));
}

/// Detects a drift: the rate of a joint's torque error keeps its sign for longer than noise does. A
/// low-pass filter with the time constant T keeps most of a drift. The filter reduces encoder
/// steps, whose signs alternate, to about the fraction dt / T.
void ChangeDetector::detect_drift(const Eigen::VectorXd& change, double rate, double dt,
                                  double weight) noexcept {
  // Smoothing time of rates, and time until detection starts [s].
  constexpr double smoothing = 0.02, first = 0.5;
  // Thresholds for the ratio of filtered to unfiltered rate (root mean squares). Below `noise`
  // the rate is noise, above `certain` it is a drift; chosen by hand.
  const double noise = 2.4 * dt / smoothing, certain = 4.0 * dt / smoothing;
  slow_ += std::min(1.0, dt / smoothing) * (change * rate - slow_);
  double drift = 0.0;
  for (Eigen::Index k = 0; k < slow_.size(); ++k) {
    const double square = change[k] * rate * (change[k] * rate);
    slow_square_[k] += weight * (slow_[k] * slow_[k] - slow_square_[k]);
    square_[k] += weight * (square - square_[k]);
    if (square_[k] > 0.0) drift = std::max(drift, slow_square_[k] / square_[k]);
  }
  if (seen_ >= first) busy_ = std::clamp((std::sqrt(drift) - noise) / (certain - noise), 0.0, 1.0);
}

ErrorObserver::ErrorObserver(const Model& model, const ModelErrorOptions& options,
                             const RobotState& state, const std::vector<ContactSpec>& supports,
                             const std::vector<std::string>& measured)
    : options_(options),
      closed_(state.active_in(supports)),
      unmeasured_(state.active_in(without_sensor(supports, measured))),
      velocity_(Eigen::VectorXd::Zero(model.nv)),
      error_(velocity_),
      total_(velocity_),
      innovation_(velocity_),
      change_(velocity_),
      late_(velocity_),
      limit_(Eigen::VectorXd::Constant(model.nv, options.limit)),
      change_detector_(model, options),
      bandwidth_(options.usual_bandwidth()) {
  if (!(bandwidth_ > 0.0) || !std::isfinite(bandwidth_))
    throw Error("model error: bandwidth is " + number(bandwidth_) +
                " rad/s; wanted a positive number");
  if (!(options.quiescent_scale >= 0.01 && options.quiescent_scale <= 1.0))
    throw Error("model error: quiescent_scale is " + number(options.quiescent_scale) +
                "; wanted 0.01 to 1");
  if (!(options.usual_lag() >= 0.0) || !std::isfinite(options.usual_lag()))
    throw Error("model error: lag is " + number(options.usual_lag()) + " s; wanted at least 0");
  if (!(options.limit > 0.0))
    throw Error("model error: limit is " + number(options.limit) + "; wanted a positive number");
  for (const std::string& at : measured) sensors_.push_back(state.body().frame(at));
  if (!sensors_.empty())  // allocates memory here, because ticks must not allocate
    state.body().frame_jacobian(sensors_.front(), local_, jacobian_);
  // Lower bound of the error limits of a floating base [N, Nm], as a fraction of the robot's weight
  // [N]; chosen by hand.
  constexpr double weight_fraction = 0.06;
  const Joint& first = model.joints.front();
  if (first.kind == JointKind::FreeFlyer)
    limit_.segment(first.v_index, first.nv) =
        limit_.segment(first.v_index, first.nv)
            .cwiseMax(weight_fraction * model.total_mass() * model.gravity.norm());
}

void ErrorObserver::reset() noexcept {
  started_ = false;
  error_.setZero();
  change_detector_.reset();
  bandwidth_ = options_.usual_bandwidth();
}

/// Removes the part of `change_` that forces of supports and loops balance. This part causes no
/// motion, so that no measurement would ever correct it. The acceleration of the closed mechanism
/// is a = a_0 + A tau. Multiplication by A and by the mass matrix removes the part. Returns false
/// if A cannot be computed.
bool ErrorObserver::remove_balanced_part(ContactDynamics& closed) noexcept {
  if (!is_usable(closed.forward_derivatives())) return false;
  innovation_.noalias() = closed.da_dtau() * change_;
  change_.noalias() = closed.mass_matrix() * innovation_;
  return true;
}

/// Sets `total_` to the torque that corresponds to the delayed velocities. It is the sum of the
/// torque without gravity, delayed by the lag, and of the gravity torque. The gravity torque is
/// not delayed, because positions have no delay.
void ErrorObserver::delay(const RigidBody& body, const ConstVectorRef& tau, double dt) noexcept {
  total_ = tau;
  if (!(options_.usual_lag() > 0.0)) return;
  late_ += -std::expm1(-dt / options_.usual_lag()) * (tau - body.gravity_torque() - late_);
  total_ = body.gravity_torque() + late_;
}

Status ErrorObserver::update(RobotState& state, const ConstVectorRef& tau,
                             const Eigen::Matrix3Xd& forces_world, double dt,
                             const Wrenches& supports) noexcept {
  const bool is_measured = supports.cols() > 0;
  if (tau.size() != total_.size()) return Status::WrongSize;
  const std::vector<ToolMotion>& tools = state.tools();
  if (forces_world.cols() != static_cast<Eigen::Index>(tools.size())) return Status::WrongSize;
  if (is_measured && supports.cols() != static_cast<Eigen::Index>(sensors_.size()))
    return Status::WrongSize;
  if (!tau.allFinite() || !forces_world.allFinite() || !std::isfinite(dt) || !supports.allFinite())
    return Status::NotFinite;
  const RigidBody& body = state.body();
  if (!started_) {
    velocity_ = state.v();
    late_ = tau - body.gravity_torque();
    started_ = true;
    return Status::Ok;
  }
  if (!(dt > 0.0)) return Status::Ok;
  delay(body, tau, dt);
  total_ += error_;
  for (std::size_t i = 0; i < tools.size(); ++i)
    total_.noalias() +=
        tools[i].jacobian().transpose() * forces_world.col(static_cast<Eigen::Index>(i));
  for (Eigen::Index i = 0; i < supports.cols(); ++i) {
    body.frame_jacobian(sensors_[to_size(i)], local_, jacobian_);
    total_.noalias() += jacobian_.transpose() * supports.col(i);
  }
  const RobotState::ActiveContacts& closed = is_measured ? unmeasured_ : closed_;
  const Status status = state.forward(closed, total_);
  if (!is_usable(status)) return status;
  ContactDynamics& dynamics = state.dynamics();
  bandwidth_ = change_detector_.factor() * options_.usual_bandwidth();
  const double pole = std::exp(-bandwidth_ * dt);
  velocity_ += dt * dynamics.a();
  innovation_ = state.v() - velocity_;
  velocity_ += (1.0 - pole * pole) * innovation_;
  innovation_ *= (1.0 - pole) * (1.0 - pole) / dt;
  change_.noalias() = dynamics.mass_matrix() * innovation_;
  if (dynamics.rows() > 0 && !remove_balanced_part(dynamics)) return Status::SingularContacts;
  error_ += change_;
  change_detector_.see(change_, dt);
  error_ = error_.cwiseMax(-limit_).cwiseMin(limit_);
  return status;
}

}  // namespace burnish
