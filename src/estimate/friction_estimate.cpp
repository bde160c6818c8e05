#include "burnish/estimate/friction_estimate.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "burnish/base/error.hpp"
#include "estimate/descriptions.gen.hpp"

namespace burnish {

Eigen::Vector3d sliding_direction(const Eigen::Vector3d& v_across, double speed) noexcept {
  return v_across / std::sqrt(v_across.squaredNorm() + speed * speed);
}

FrictionEstimator::FrictionEstimator(const FrictionEstimateOptions& options) : options_(options) {
  check_ranges(description_of(&options_), &options_,
               [](const std::string& entry) { return "the friction estimate's " + entry; });
  reset();
}

void FrictionEstimator::reset() noexcept {
  mu_ = options_.coefficient;
  variance_ = options_.deviation * options_.deviation;
}

double FrictionEstimator::deviation() const { return std::sqrt(variance_); }

void FrictionEstimator::update(double normal_force, const Eigen::Vector3d& force_across,
                               const Eigen::Vector3d& v_across, double dt) noexcept {
  if (!options_.enabled || !(normal_force > 0.0) || !(dt > 0.0)) return;
  const Eigen::Vector3d s = sliding_direction(v_across, options_.speed);
  // Friction acts opposite to the sliding direction s, so the measurement -force_across . s is
  // mu normal_force |s|. Its noise is constant, so a slow tool (small |s|) has little influence.
  const double sensitivity = normal_force * s.norm();
  const double noise =
      options_.force_noise * options_.force_noise * std::max(1.0, options_.noise_time / dt);
  const double innovation = -force_across.dot(s) - sensitivity * mu_;
  if (!std::isfinite(innovation)) return;
  variance_ += options_.wander * options_.wander * v_across.norm() * dt;
  const double gain = variance_ * sensitivity / (sensitivity * sensitivity * variance_ + noise);
  mu_ = std::max(0.0, mu_ + gain * innovation);
  variance_ *= 1.0 - gain * sensitivity;
}

}  // namespace burnish
