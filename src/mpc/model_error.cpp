#include "burnish/mpc/model_error.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "mpc/closed_dynamics.hpp"
#include "mpc/tool_motion.hpp"

namespace burnish {

namespace {

/// Detector of changes in the torque error. It distinguishes changes from noise, and scales the
/// bandwidth of the observer.
class ChangeDetector {
 public:
  ChangeDetector(const Model& model, const ModelErrorOptions& options)
      : transient_scale_(std::max(options.usual_transient_scale(), 1.0)),
        quiescent_scale_(options.quiescent_scale),
        rate_(Eigen::VectorXd::Zero(model.nv)),
        usual_(rate_),
        floor_(rate_),
        slow_(rate_),
        slow_square_(rate_),
        square_(rate_) {
    // Largest rate of the torque error that never counts as a transient, as a fraction of effort
    // limit times bandwidth; chosen by hand. Joints without an effort limit count as 100 Nm.
    constexpr double small = 2e-3;
    for (int k = 0; k < model.nv; ++k) {
      const double effort = model.effort_limit[k];
      const double rate = small * options.usual_bandwidth() *
                          (std::isfinite(effort) && effort > 0.0 ? effort : 100.0);
      floor_[k] = rate * rate;
    }
  }
  void reset() noexcept {
    rate_.setZero();
    usual_.setZero();
    slow_.setZero();
    slow_square_.setZero();
    square_.setZero();
    level_ = seen_ = 0.0;
    busy_ = 1.0;
  }
  /// Processes the change of the torque error over the last `dt` [s], during which the bandwidth
  /// was scaled by factor(). Noise of constant size causes changes proportional to the square of
  /// this factor. The rates are therefore divided by the square.
  void see(const Eigen::VectorXd& change, double dt) noexcept {
    constexpr double memory = 1.0;  // averaging time of noise [s]
    seen_ += dt;
    const double weight = std::min(1.0, dt / std::min(seen_, memory));
    const double rate = 1.0 / (factor() * factor() * dt);
    detect_jumps(change, rate, dt, weight);
    detect_drift(change, rate, dt, weight);
  }
  /// Returns the factor on the observer's bandwidth.
  double factor() const {
    return quiescent_scale_ + (1.0 - quiescent_scale_) * std::max(busy_, level_) +
           (transient_scale_ - 1.0) * level_;
  }

 private:
  /// Detects jumps: rates far beyond the usual rates, for some milliseconds.
  void detect_jumps(const Eigen::VectorXd& change, double rate, double dt, double weight) noexcept {
    // Smoothing time of rates, time until detection starts, decay time of a detected jump [s].
    constexpr double smoothing = 4e-3, first = 0.1, decay_time = 0.15;
    // Thresholds for the squared rate relative to its usual mean, averaged over the joints. Below
    // `noise` the rate is noise, above `certain` it is a jump; chosen by hand. The thresholds are
    // high for two reasons. Averaging does not reduce the noise of a force along a fixed direction,
    // because this noise changes all joints by the same ratio. With hundreds of samples per second,
    // false alarms must be rare.
    constexpr double noise = 8.0, certain = 14.0;
    rate_ += std::min(1.0, dt / smoothing) * (change * rate - rate_);
    double ratio = 0.0;
    for (Eigen::Index k = 0; k < rate_.size(); ++k) {
      const double square = rate_[k] * rate_[k];
      ratio += square / std::max(usual_[k], floor_[k]);
      // The usual rate grows slowly, because the square of an outlier counts as at most 9 times the
      // usual square.
      const double max_square = 9.0 * std::max(usual_[k], floor_[k]);
      usual_[k] += weight * (std::min(square, max_square) - usual_[k]);
    }
    ratio /= static_cast<double>(std::max<Eigen::Index>(rate_.size(), 1));
    const double level =
        seen_ < first ? 0.0 : std::clamp((ratio - noise) / (certain - noise), 0.0, 1.0);
    level_ = std::max(level, level_ * std::exp(-dt / decay_time));
  }
  /// Detects a drift: the rate of some joint keeps its sign for longer than noise does. A low-pass
  /// filter keeps most of a drift. It reduces encoder steps, whose signs alternate, by a factor of
  /// about dt divided by the filter's time constant.
  void detect_drift(const Eigen::VectorXd& change, double rate, double dt, double weight) noexcept {
    // Smoothing time, and time until detection starts [s].
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
    if (seen_ >= first)
      busy_ = std::clamp((std::sqrt(drift) - noise) / (certain - noise), 0.0, 1.0);
  }

  double transient_scale_, quiescent_scale_;
  Eigen::VectorXd rate_;                  ///< Smoothed rate of the torque error [Nm/s].
  Eigen::VectorXd usual_, floor_;         ///< Usual squared rate, and lower bound of it [Nm^2/s^2].
  Eigen::VectorXd slow_;                  ///< Low-pass filtered rate, for detect_drift() [Nm/s].
  Eigen::VectorXd slow_square_, square_;  ///< Mean squares of slow_ and of the rate [Nm^2/s^2].
  double level_ = 0.0;                    ///< Strength of a transient, 0 to 1.
  double seen_ = 0.0;                     ///< Time for which rates have been observed [s].
  double busy_ = 1.0;                     ///< Strength of a drift, 0 to 1.
};

}  // namespace

struct TorqueErrorObserver::Impl {
  Impl(const Model& model, const std::string& tool, const ModelErrorOptions& given,
       const std::vector<ContactSpec>& supports, const std::vector<std::string>& measured,
       const std::string& base)
      : options(given),
        is_closed(!model.loops.empty() || !supports.empty()),
        has_loops(!model.loops.empty()),
        dynamics(closed_dynamics(model, supports)),
        free(closed_dynamics(model)),
        body(model),
        pressed(body, tool, base),
        velocity(Eigen::VectorXd::Zero(model.nv)),
        error(Eigen::VectorXd::Zero(model.nv)),
        total(Eigen::VectorXd::Zero(model.nv)),
        innovation(Eigen::VectorXd::Zero(model.nv)),
        change(Eigen::VectorXd::Zero(model.nv)),
        late(Eigen::VectorXd::Zero(model.nv)),
        limit(Eigen::VectorXd::Constant(model.nv, given.limit)),
        change_detector(model, given),
        bandwidth(given.usual_bandwidth()) {
    if (!(bandwidth > 0.0) || !std::isfinite(bandwidth))
      throw Error("model error: bandwidth is " + number(bandwidth) +
                  " rad/s; wanted a positive number");
    if (!(given.quiescent_scale >= 0.01 && given.quiescent_scale <= 1.0))
      throw Error("model error: quiescent_scale is " + number(given.quiescent_scale) +
                  "; wanted 0.01 to 1");
    if (!(given.usual_lag() >= 0.0) || !std::isfinite(given.usual_lag()))
      throw Error("model error: lag is " + number(given.usual_lag()) + " s; wanted at least 0");
    if (!(given.limit > 0.0))
      throw Error("model error: limit is " + number(given.limit) + "; wanted a positive number");
    for (const std::string& at : measured) sensors.push_back(body.frame(at));
    // Smallest limit of the force and moment errors at the base, as a fraction of the robot's
    // weight, which the base carries; chosen by hand.
    constexpr double weight_fraction = 0.06;
    const Joint& first = model.joints.front();
    if (first.kind == JointKind::FreeFlyer)
      limit.segment(first.v_index, first.nv) =
          limit.segment(first.v_index, first.nv)
              .cwiseMax(weight_fraction * model.total_mass() * model.gravity.norm());
  }

  ModelErrorOptions options;
  /// Removes the part of `change` that forces of supports and loops balance. This part causes no
  /// motion, so that no measurement would ever correct it. Multiplication by M da/dtau removes the
  /// part; M is the mass matrix and a the acceleration of the closed mechanism. Returns false if
  /// da/dtau cannot be computed.
  bool remove_balanced_part(ContactDynamics& closed) noexcept {
    if (!is_usable(closed.forward_derivatives())) return false;
    innovation.noalias() = closed.da_dtau() * change;
    change.noalias() = closed.mass_matrix() * innovation;
    return true;
  }

  /// Sets `total` to the torque that corresponds to the delayed velocities. It is the sum of the
  /// torque without gravity, delayed by the lag, and of the gravity torque. The gravity torque is
  /// not delayed, because positions have no delay.
  void act(const ConstVectorRef& tau, double dt) noexcept {
    total = tau;
    if (!(options.usual_lag() > 0.0)) return;
    late += -std::expm1(-dt / options.usual_lag()) * (tau - body.gravity_torque() - late);
    total = body.gravity_torque() + late;
  }

  bool is_closed, has_loops;
  ContactDynamics dynamics;  ///< Dynamics with supports and loops.
  /// Dynamics with the loops as the only contacts, if the wrenches of supports are measured.
  ContactDynamics free;
  RigidBody body;
  ToolMotion pressed;
  std::vector<int> sensors;  ///< Frames at which wrenches are measured.
  FrameDerivatives derivatives;
  bool started = false;
  Eigen::VectorXd velocity, error, total, innovation, change;
  Eigen::VectorXd late;   ///< Torque without gravity, delayed by the lag, nv [Nm or N].
  Eigen::VectorXd limit;  ///< Largest magnitude of the error, nv [Nm or N].
  ChangeDetector change_detector;
  double bandwidth;  ///< Bandwidth that the last update used [rad/s].
};

TorqueErrorObserver::TorqueErrorObserver(const Model& model, const std::string& tool,
                                         const ModelErrorOptions& options,
                                         const std::vector<ContactSpec>& supports,
                                         const std::vector<std::string>& measured,
                                         const std::string& base)
    : impl_(std::make_unique<Impl>(model, tool, options, supports, measured, base)) {
  // Allocates memory here, because ticks must not allocate.
  for (const int foot : impl_->sensors)
    impl_->body.frame_derivatives(foot, Reference::local(), impl_->derivatives);
}
TorqueErrorObserver::~TorqueErrorObserver() = default;
TorqueErrorObserver::TorqueErrorObserver(TorqueErrorObserver&&) noexcept = default;
TorqueErrorObserver& TorqueErrorObserver::operator=(TorqueErrorObserver&&) noexcept = default;

void TorqueErrorObserver::reset() noexcept {
  impl_->started = false;
  impl_->error.setZero();
  impl_->change_detector.reset();
  impl_->bandwidth = impl_->options.usual_bandwidth();
}

Status TorqueErrorObserver::set_payload(std::string_view frame, const InertiaSpec& payload) {
  (void)impl_->free.set_payload(frame, payload);
  return impl_->dynamics.set_payload(frame, payload);
}

const Eigen::VectorXd& TorqueErrorObserver::torque_error() const { return impl_->error; }
double TorqueErrorObserver::bandwidth() const { return impl_->bandwidth; }

Status TorqueErrorObserver::update(const ConstVectorRef& q, const ConstVectorRef& v,
                                   const ConstVectorRef& tau, const Eigen::Vector3d& force_world,
                                   double dt, const Wrenches& supports) noexcept {
  Impl& d = *impl_;
  const bool is_measured = supports.cols() > 0;
  if (tau.size() != d.total.size()) return Status::WrongSize;
  if (is_measured && supports.cols() != static_cast<Eigen::Index>(d.sensors.size()))
    return Status::WrongSize;
  if (!tau.allFinite() || !force_world.allFinite() || !std::isfinite(dt) || !supports.allFinite())
    return Status::NotFinite;
  ContactDynamics& dynamics = is_measured ? d.free : d.dynamics;
  Status status = d.body.update(q, v);
  if (!is_usable(status)) return status;
  if (!d.started) {
    d.velocity = v;
    d.late = tau - d.body.gravity_torque();
    d.started = true;
    return status;
  }
  if (!(dt > 0.0)) return status;
  d.pressed.update(d.body);
  d.act(tau, dt);
  d.total += d.error;
  d.total.noalias() += d.pressed.jacobian().transpose() * force_world;
  for (Eigen::Index i = 0; i < supports.cols(); ++i) {
    d.body.frame_derivatives(d.sensors[to_size(i)], Reference::local(), d.derivatives);
    d.total.noalias() += d.derivatives.jacobian.transpose() * supports.col(i);
  }
  status = dynamics.forward(q, v, d.total);
  if (!is_usable(status)) return status;
  d.bandwidth = d.change_detector.factor() * d.options.usual_bandwidth();
  const double pole = std::exp(-d.bandwidth * dt);
  d.velocity += dt * dynamics.a();
  d.innovation = v - d.velocity;
  d.velocity += (1.0 - pole * pole) * d.innovation;
  d.innovation *= (1.0 - pole) * (1.0 - pole) / dt;
  d.change.noalias() = dynamics.mass_matrix() * d.innovation;
  if ((is_measured ? d.has_loops : d.is_closed) && !d.remove_balanced_part(dynamics))
    return Status::SingularContacts;
  d.error += d.change;
  d.change_detector.see(d.change, dt);
  d.error = d.error.cwiseMax(-d.limit).cwiseMin(d.limit);
  return status;
}

}  // namespace burnish
