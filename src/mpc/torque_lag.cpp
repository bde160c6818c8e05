#include "mpc/torque_lag.hpp"

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr double resolution = 1e-3;  // difference between successive lags [s]
constexpr double window = 0.03;      // averaging time of torque differences [s]
constexpr double usual = 100.0;      // assumed effort limit of unlimited joints [Nm (N)]

}  // namespace

TorqueLag::TorqueLag(const Model& model, double tick_period, std::vector<int> actuated)
    : actuated_(std::move(actuated)),
      weight_(Eigen::VectorXd::Zero(model.nv)),
      tick_period_(tick_period),
      step_(std::max(1, static_cast<int>(std::lround(resolution / tick_period)))),
      sent_(model.nv, step_ * (lags - 1)),
      gaps_(Eigen::MatrixXd::Zero(model.nv, lags)) {
  for (const int k : actuated_) {
    const double effort = model.effort_limit[k];
    const double size = std::isfinite(effort) && effort > 0.0 ? effort : usual;
    weight_[k] = 1.0 / (size * size);
  }
}

void TorqueLag::reset() noexcept {
  gaps_.setZero();
  errors_.setZero();
  started_ = false;
  best_ = 0;
}

void TorqueLag::look(const ConstVectorRef& sent, const Eigen::VectorXd& measured,
                     double dt) noexcept {
  if (started_)
    sent_.add(sent);
  else
    sent_.fill(sent);
  started_ = true;
  const double weight = -std::expm1(-dt / window);
  for (int lag = 0; lag < lags; ++lag) {
    const auto then = sent_.ago(lag * step_);
    now_[lag] = 0.0;
    for (const int k : actuated_) {
      const double gap = then[k] - measured[k];
      gaps_(k, lag) += weight * (gap - gaps_(k, lag));
      now_[lag] += weight_[k] * gap * gap;
    }
  }
  errors_ += weight * (now_ - errors_);
  // A lag is visible under two conditions. The torque difference without a delay must exceed
  // `noise`, a fraction of the effort limit. The best delay must reduce the mean square of the
  // torque difference to less than the fraction `explained`.
  constexpr double noise = 0.01, explained = 0.25;
  Eigen::Index best = 0;
  const double error = errors_.minCoeff(&best);
  const bool is_visible = errors_[0] > noise * noise && error < explained * errors_[0];
  best_ = is_visible ? static_cast<int>(best) : 0;
}

}  // namespace burnish
