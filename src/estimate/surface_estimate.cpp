#include "burnish/estimate/surface_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "estimate/descriptions.gen.hpp"

namespace burnish {
namespace {

// Tuning constants, chosen by hand.

// Time over which positions are averaged into one measurement [s].
constexpr double window_time = 5e-3;
constexpr double noise_time = 0.1;  // averaging time of position noise [s]
constexpr double max_tilts = 5.0;   // largest plausible slope [initial standard deviations]

/// Returns the axes, turned by the smallest rotation that aligns their third axis with n (parallel
/// transport).
Eigen::Matrix3d carried(const Eigen::Matrix3d& axes, const Eigen::Vector3d& n) {
  const Eigen::Vector3d c = axes.col(2).cross(n);
  const double factor = 1.0 / std::max(1.0 + axes.col(2).dot(n), 1e-6);
  Eigen::Matrix3d result;
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector3d once = c.cross(axes.col(i));
    result.col(i) = (axes.col(i) + once + factor * c.cross(once)).normalized();
  }
  result.col(2) = n;
  return result;
}

}  // namespace

SurfaceEstimator::SurfaceEstimator(Surface nominal, double tip_radius,
                                   const SurfaceEstimateOptions& options, double tick_period)
    : nominal_(std::move(nominal)),
      radius_(tip_radius),
      options_(options),
      window_(std::max(1, static_cast<int>(std::lround(window_time / tick_period)))),
      tick_period_(tick_period),
      noise_share_(std::min(1.0, tick_period / noise_time)) {
  check_ranges(description_of(&options), &options,
               [](const std::string& entry) { return "surface estimate: " + entry; });
  reset();
}

void SurfaceEstimator::reset() noexcept {
  x_.setZero();
  P_.setZero();
  const auto square = [](double deviation) { return deviation * deviation; };
  P_(h_, h_) = square(options_.height);
  P_(s_, s_) = P_(s_ + 1, s_ + 1) = square(options_.tilt);
  P_(c_, c_) = square(options_.compliance);
  P_(r_, r_) = square(options_.rate);
  placed_ = false;
  trust_ = 1.0;
  seen_ = 0;
  white_ = spread_ = 0.0;
  ticks_ = 0;
  time_ = 0.0;
  sum_p_.setZero();
  sum_f_ = 0.0;
  surface_ = Quadric{};
  normal_ = surface_.b;
}

void SurfaceEstimator::update(const Eigen::Vector3d& p, double force, bool touches) noexcept {
  if (!p.allFinite() || !std::isfinite(force)) return;
  follow_noise(p);
  time_ += tick_period_;
  if (!options_.enabled || !touches) {
    ticks_ = 0;
    sum_p_.setZero();
    sum_f_ = 0.0;
  } else {
    sum_p_ += p;
    sum_f_ += force;
    if (++ticks_ >= window_) learn();
  }
  update_estimate(p);
}

/// Processes the mean position of a window. Joint noise moves the measured tip along the surface
/// and the normal at the same time, which would look like a slope. The state is therefore moved
/// along the surface only if the displacement clearly exceeds the noise.
void SurfaceEstimator::learn() noexcept {
  // Smallest displacement that is clearly not noise [standard deviations of a mean position].
  constexpr double clear = 6.0;
  const Eigen::Vector3d mean = sum_p_ / ticks_;
  const SurfaceDistance nominal = nominal_.at(mean);
  if (!placed_) {
    start(mean, nominal);
  } else {
    wait(time_);
    const Eigen::Vector2d d = tangents_.leftCols<2>().transpose() * (mean - place_);
    if (d.squaredNorm() * ticks_ >= clear * clear * spread_) move_to(mean, d, nominal);
  }
  measure(nominal.distance - radius_, sum_f_ / ticks_, (mean - last_).norm());
  last_ = mean;
  ticks_ = 0;
  time_ = 0.0;
  sum_p_.setZero();
  sum_f_ = 0.0;
}

/// Updates the variance of the position noise between ticks from second differences of the
/// position. The second difference of white noise of standard deviation s has the variance 6 s^2.
/// The motion of the tip hardly contributes.
void SurfaceEstimator::follow_noise(const Eigen::Vector3d& p) noexcept {
  if (seen_ >= 2) {
    const Eigen::Vector3d second = p - 2.0 * before_ + before_that_;
    const double weight = std::max(noise_share_, 1.0 / (seen_ - 1)), along = normal_.dot(second);
    white_ += weight * (along * along / 6.0 - white_);
    spread_ += weight * (second.squaredNorm() / 6.0 - spread_);
  }
  before_that_ = before_;
  before_ = p;
  seen_ = std::min(seen_ + 1, 1 << 20);
}

void SurfaceEstimator::start(const Eigen::Vector3d& p, const SurfaceDistance& nominal) noexcept {
  const Eigen::Vector3d seed =
      std::abs(nominal.normal.x()) > 0.9 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX();
  const Eigen::Vector3d t = seed.cross(nominal.normal).normalized();
  tangents_ << t, nominal.normal.cross(t), nominal.normal;
  place_ = last_ = p;
  placed_ = true;
  curvature_ = options_.curvature + 0.25 * nominal.hessian.norm();
  for (int i = 0; i < 3; ++i) P_(k_ + i, k_ + i) = curvature_ * curvature_;
}

/// Propagates the state over the time `dt` of a moving surface: the height error h changes by r dt,
/// and its rate r is a random walk.
void SurfaceEstimator::wait(double dt) noexcept {
  // Growth of the rate's variance per time, relative to its initial variance [1/s].
  constexpr double wander = 0.1;
  x_[h_] += dt * x_[r_];
  P_.row(h_) += dt * P_.row(r_);
  P_.col(h_) += dt * P_.col(r_);
  P_(r_, r_) += wander * options_.rate * options_.rate * dt;
}

/// Moves the state by the step d along the tangents. The height error h changes by
/// s . d + d . K d / 2, and the slope error s by K d, with the curvature error K.
void SurfaceEstimator::move_to(const Eigen::Vector3d& p, const Eigen::Vector2d& d,
                               const SurfaceDistance& nominal) noexcept {
  Covariance F = Covariance::Identity();
  F(h_, s_) = d[0];
  F(h_, s_ + 1) = d[1];
  F(h_, k_) = 0.5 * d[0] * d[0];
  F(h_, k_ + 1) = d[0] * d[1];
  F(h_, k_ + 2) = 0.5 * d[1] * d[1];
  F(s_, k_) = F(s_ + 1, k_ + 1) = d[0];
  F(s_, k_ + 1) = F(s_ + 1, k_ + 2) = d[1];
  x_ = F * x_;
  P_ = F * P_ * F.transpose();
  recover(d.norm());
  const double change = trust_ * options_.curvature_change, wander = change * change * d.norm();
  for (int i = 0; i < 3; ++i) P_(k_ + i, k_ + i) += wander;
  tangents_ = carried(tangents_, nominal.normal);
  place_ = p;
}

void SurfaceEstimator::measure(double distance, double force, double travel) noexcept {
  State H = State::Zero();
  H[h_] = 1.0;
  H[c_] = -force;
  // Encoder noise is constant at one position. The measurements within a travel of noise_length
  // therefore count as one measurement.
  const double repeats = std::max(1.0, options_.noise_length / std::max(travel, 1e-9));
  const double yield = x_[c_] * options_.force_noise;
  const double R = options_.position_noise * options_.position_noise * std::min(repeats, 1e6) +
                   yield * yield + white_ / ticks_;
  const State PH = P_ * H;
  const double S = H.dot(PH) + R;
  const State gain = PH / S;
  const double innovation = distance - H.dot(x_);
  x_ += gain * innovation;
  // Joseph's form of the update keeps the covariance symmetric and positive.
  const Covariance keep = Covariance::Identity() - gain * H.transpose();
  P_ = keep * P_ * keep.transpose() + R * gain * gain.transpose();
  if (!(x_.segment<2>(s_).norm() <= max_tilts * trust_ * options_.tilt)) begin_anew();
}

/// Raises `trust_`, a factor on the initial deviations, towards 1 while the tip travels. The cause
/// of an implausible slope may be temporary, such as a tip that sinks in at first.
void SurfaceEstimator::recover(double travel) noexcept {
  constexpr double length = 0.15;  // travel after which trust_ has recovered [m]
  const double before = trust_;
  trust_ += std::min(1.0, travel / length) * (1.0 - trust_);
  const double added = (trust_ * trust_ - before * before) * options_.tilt * options_.tilt;
  P_(s_, s_) += added;
  P_(s_ + 1, s_ + 1) += added;
}

/// Restarts the estimates of slope and curvature after an implausible slope. Such a slope indicates
/// an effect that the model lacks, such as a surface that moves or creeps. The initial deviations
/// are halved, so that the effect has less influence.
void SurfaceEstimator::begin_anew() noexcept {
  constexpr double min_trust = 1e-3;
  trust_ = std::max(0.5 * trust_, min_trust);
  x_.segment<5>(s_).setZero();
  for (int i = s_; i < s_ + 5; ++i) {
    P_.row(i).setZero();
    P_.col(i).setZero();
  }
  const double tilt = trust_ * options_.tilt;
  P_(s_, s_) = P_(s_ + 1, s_ + 1) = tilt * tilt;
  for (int i = 0; i < 3; ++i) P_(k_ + i, k_ + i) = trust_ * trust_ * curvature_ * curvature_;
}

void SurfaceEstimator::update_estimate(const Eigen::Vector3d& p) noexcept {
  const SurfaceDistance here = nominal_.at(p);
  surface_ = here.quadric(p, radius_);
  if (placed_ && options_.enabled) {
    const auto T = tangents_.leftCols<2>();
    Eigen::Matrix2d K;
    K << x_[k_], x_[k_ + 1], x_[k_ + 1], x_[k_ + 2];
    const Eigen::Vector2d d = T.transpose() * (p - place_);
    const Eigen::Vector2d s = x_.segment<2>(s_) + K * d;
    surface_.Q -= T * K * T.transpose();
    const Eigen::Vector3d gradient = here.normal - T * s;
    surface_.b = gradient - surface_.Q * p;
    const double height = x_[h_] + x_.segment<2>(s_).dot(d) + 0.5 * d.dot(K * d);
    surface_.c = here.distance - radius_ - height - gradient.dot(p) + 0.5 * p.dot(surface_.Q * p);
    normal_ = gradient.normalized();
  } else {
    normal_ = here.normal;
  }
}

double SurfaceEstimator::normal_deviation() const {
  const auto slopes = P_.block<2, 2>(s_, s_);
  const double mean = 0.5 * slopes.trace();
  const double off = std::hypot(0.5 * (slopes(0, 0) - slopes(1, 1)), slopes(0, 1));
  return std::sqrt(std::max(0.0, mean + off));
}

}  // namespace burnish
