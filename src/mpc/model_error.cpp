#include "burnish/mpc/model_error.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "burnish/base/error.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "mpc/closed_dynamics.hpp"
#include "mpc/tool_motion.hpp"

namespace burnish {

namespace {

/// Tells changes of the torque error from its noise, and so how fast it is to be followed.
class Haste {
 public:
  Haste(const Model& model, const ModelErrorOptions& options)
      : boost_(std::max(options.usual_boost(), 1.0)),
        calm_(options.calm),
        rate_(Eigen::VectorXd::Zero(model.nv)),
        usual_(rate_),
        least_(rate_),
        slow_(rate_),
        slow_square_(rate_),
        square_(rate_) {
    constexpr double small = 2e-3;  // of a joint's effort limit: what need not be known at once
    for (int k = 0; k < model.nv; ++k) {
      const double effort = model.effort_limit[k];
      const double rate = small * options.usual_bandwidth() *
                          (std::isfinite(effort) && effort > 0.0 ? effort : 100.0);
      least_[k] = rate * rate;
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
  /// After a change of the torque error, dt s after the last one, that followed at factor() times
  /// the bandwidth. The same noise changes it by the square of that, which is no haste.
  void see(const Eigen::VectorXd& change, double dt) noexcept {
    constexpr double memory = 1.0;  // s
    seen_ += dt;
    const double share = std::min(1.0, dt / std::min(seen_, memory));
    const double rate = 1.0 / (factor() * factor() * dt);
    see_jumps(change, rate, dt, share);
    see_wandering(change, rate, dt, share);
  }
  /// Times the bandwidth.
  double factor() const {
    return calm_ + (1.0 - calm_) * std::max(busy_, level_) + (boost_ - 1.0) * level_;
  }

 private:
  /// Rates far beyond the usual ones, which last milliseconds.
  void see_jumps(const Eigen::VectorXd& change, double rate, double dt, double share) noexcept {
    constexpr double smoothing = 4e-3, first = 0.1, fading = 0.15;  // s
    // Squares of deviations, mean of the joints: noise along one direction of the tool is the same
    // in all of them, and is to be passed over some hundred times a second.
    constexpr double noise = 8.0, certain = 14.0;
    rate_ += std::min(1.0, dt / smoothing) * (change * rate - rate_);
    double haste = 0.0;
    for (Eigen::Index k = 0; k < rate_.size(); ++k) {
      const double square = rate_[k] * rate_[k];
      haste += square / std::max(usual_[k], least_[k]);
      // What is far from usual is not to become so at once.
      const double most = 9.0 * std::max(usual_[k], least_[k]);
      usual_[k] += share * (std::min(square, most) - usual_[k]);
    }
    haste /= static_cast<double>(std::max<Eigen::Index>(rate_.size(), 1));
    const double level =
        seen_ < first ? 0.0 : std::clamp((haste - noise) / (certain - noise), 0.0, 1.0);
    level_ = std::max(level, level_ * std::exp(-dt / fading));
  }
  /// Rates that keep their sign for longer than noise does, in any joint. Of the steps of an
  /// encoder, which come back, next to nothing is left behind a filter, whose share of them is the
  /// tick's of its time; of an error that wanders most is.
  void see_wandering(const Eigen::VectorXd& change, double rate, double dt, double share) noexcept {
    constexpr double smoothing = 0.02, first = 0.5;                             // s
    const double noise = 2.4 * dt / smoothing, certain = 4.0 * dt / smoothing;  // of the rate
    slow_ += std::min(1.0, dt / smoothing) * (change * rate - slow_);
    double wandering = 0.0;
    for (Eigen::Index k = 0; k < slow_.size(); ++k) {
      const double square = change[k] * rate * (change[k] * rate);
      slow_square_[k] += share * (slow_[k] * slow_[k] - slow_square_[k]);
      square_[k] += share * (square - square_[k]);
      if (square_[k] > 0.0) wandering = std::max(wandering, slow_square_[k] / square_[k]);
    }
    if (seen_ >= first)
      busy_ = std::clamp((std::sqrt(wandering) - noise) / (certain - noise), 0.0, 1.0);
  }

  double boost_, calm_;
  Eigen::VectorXd rate_, usual_, least_;  ///< Nm/s, and the squares of what is usual and small
  Eigen::VectorXd slow_, slow_square_, square_;  ///< Nm/s, and means of its and the rate's squares
  double level_ = 0.0, seen_ = 0.0;              ///< 0 to 1; s
  double busy_ = 1.0;                            ///< 0 to 1
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
        most(Eigen::VectorXd::Constant(model.nv, given.limit)),
        haste(model, given),
        bandwidth(given.usual_bandwidth()) {
    if (!(bandwidth > 0.0) || !std::isfinite(bandwidth))
      throw Error("model error: a bandwidth of " + number(bandwidth) +
                  " rad/s; wanted a positive number");
    if (!(given.calm >= 0.01 && given.calm <= 1.0))
      throw Error("model error: calm " + number(given.calm) + "; wanted 0.01 to 1");
    if (!(given.usual_lag() >= 0.0) || !std::isfinite(given.usual_lag()))
      throw Error("model error: a lag of " + number(given.usual_lag()) + " s; wanted at least 0");
    if (!(given.limit > 0.0))
      throw Error("model error: a limit of " + number(given.limit) + "; wanted a positive number");
    for (const std::string& at : measured) sensors.push_back(body.frame(at));
    // What carries all others is wrong by a share of all their weights.
    constexpr double share = 0.06;
    const Joint& first = model.joints.front();
    if (first.kind == JointKind::FreeFlyer)
      most.segment(first.v_index, first.nv) =
          most.segment(first.v_index, first.nv)
              .cwiseMax(share * model.total_mass() * model.gravity.norm());
  }

  ModelErrorOptions options;
  /// Of `change` the part that supports and loops carry moves nothing, so that nothing would ever
  /// correct it: with a = a_0 + A tau of the closed mechanism, M A takes it away. False where A is
  /// unknown.
  bool drop_what_is_carried(ContactDynamics& closed) noexcept {
    if (closed.forward_derivatives() > Status::NotConverged) return false;
    innovation.noalias() = closed.da_dtau() * change;
    change.noalias() = closed.mass_matrix() * innovation;
    return true;
  }

  /// Sets `total` to what has acted where velocities are late by the lag. What holds the robot
  /// against gravity is not behind it: positions are not late.
  void act(const ConstVectorRef& tau, double dt) noexcept {
    total = tau;
    if (!(options.usual_lag() > 0.0)) return;
    late += -std::expm1(-dt / options.usual_lag()) * (tau - body.gravity_torque() - late);
    total = body.gravity_torque() + late;
  }

  bool is_closed, has_loops;
  ContactDynamics dynamics;  ///< with supports and loops
  ContactDynamics free;      ///< with loops alone, where what acts on supports is measured
  RigidBody body;
  ToolMotion pressed;
  std::vector<int> sensors;  ///< frames that wrenches are measured at
  FrameDerivatives derivatives;
  bool started = false;
  Eigen::VectorXd velocity, error, total, innovation, change;
  Eigen::VectorXd late;  ///< Nm (N), nv: what torques were beyond gravity, behind the lag
  Eigen::VectorXd most;  ///< Nm (N), nv: that errors stay within
  Haste haste;
  double bandwidth;  ///< rad/s, at present
};

TorqueErrorObserver::TorqueErrorObserver(const Model& model, const std::string& tool,
                                         const ModelErrorOptions& options,
                                         const std::vector<ContactSpec>& supports,
                                         const std::vector<std::string>& measured,
                                         const std::string& base)
    : impl_(std::make_unique<Impl>(model, tool, options, supports, measured, base)) {
  // Resized on first use: here, rather than in a tick.
  for (const int foot : impl_->sensors)
    impl_->body.frame_derivatives(foot, Reference::local(), impl_->derivatives);
}
TorqueErrorObserver::~TorqueErrorObserver() = default;
TorqueErrorObserver::TorqueErrorObserver(TorqueErrorObserver&&) noexcept = default;
TorqueErrorObserver& TorqueErrorObserver::operator=(TorqueErrorObserver&&) noexcept = default;

void TorqueErrorObserver::reset() noexcept {
  impl_->started = false;
  impl_->error.setZero();
  impl_->haste.reset();
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
  if (status > Status::NotConverged) return status;
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
    d.body.frame_derivatives(d.sensors[static_cast<std::size_t>(i)], Reference::local(),
                             d.derivatives);
    d.total.noalias() += d.derivatives.jacobian.transpose() * supports.col(i);
  }
  status = dynamics.forward(q, v, d.total);
  if (status > Status::NotConverged) return status;
  d.bandwidth = d.haste.factor() * d.options.usual_bandwidth();
  const double pole = std::exp(-d.bandwidth * dt);
  d.velocity += dt * dynamics.a();
  d.innovation = v - d.velocity;
  d.velocity += (1.0 - pole * pole) * d.innovation;
  d.innovation *= (1.0 - pole) * (1.0 - pole) / dt;
  d.change.noalias() = dynamics.mass_matrix() * d.innovation;
  if ((is_measured ? d.has_loops : d.is_closed) && !d.drop_what_is_carried(dynamics))
    return Status::SingularContacts;
  d.error += d.change;
  d.haste.see(d.change, dt);
  d.error = d.error.cwiseMax(-d.most).cwiseMin(d.most);
  return status;
}

}  // namespace burnish
