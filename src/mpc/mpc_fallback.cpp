// What an MpcController sends after a fault: see Fallback.
#include <algorithm>
#include <cmath>

#include "dynamics/integration.hpp"
#include "mpc/mpc_impl.hpp"

namespace burnish {

void MpcController::Impl::fall_back() noexcept {
  const Fallback& fallback = spec.fallback;
  blind_for_ = fresh_ ? 0.0 : blind_for_ + spec.tick_period;
  if (!fresh_) v_ *= std::exp(-fallback.damping * spec.tick_period);
  command_.tau.setZero();
  bias_.setZero();
  if (gravity_.forward(q_, bias_, bias_) > Status::NotConverged) return;
  const auto mass = gravity_.mass_matrix();
  const std::vector<int>& actuated = problem.layout().actuated;
  const bool held = hold();
  for (const int k : actuated) {
    command_.tau[k] = gravity_.bias()[k];
    for (const int j : actuated) command_.tau[k] -= fallback.damping * mass(k, j) * v_[j];
    if (held) command_.tau[k] -= pull_[k];
  }
}

/// The spring's torque in pull_, slipped to what it may use; false where there is no spring.
bool MpcController::Impl::hold() noexcept {
  constexpr double bridged = 0.01;  // s
  const Fallback& fallback = spec.fallback;
  const double rounding = 0.01 * spec.tick_period;
  if (blind_for_ > std::min(bridged, spec.limits.bad) + rounding) holding_ = false;
  if (!holding_ && fresh_) {
    q_hold_ = q_;
    holding_ = true;
  }
  if (!holding_ || fallback.stiffness == 0.0) return false;
  const auto mass = gravity_.mass_matrix();
  const std::vector<int>& actuated = problem.layout().actuated;
  difference_configuration(tree_, q_hold_.data(), q_.data(), total_.data());
  stretch_.setZero();
  for (const int k : actuated) stretch_[k] = total_[k];
  double share = 1.0;  // of the stretch, what stays
  for (const int k : actuated) {
    pull_[k] = 0.0;
    for (const int j : actuated) pull_[k] += fallback.stiffness * mass(k, j) * stretch_[j];
    const double most = fallback.give * effort_[k];
    // A joint without torque has no part in it.
    if (effort_[k] > 0.0 && std::abs(pull_[k]) > most)
      share = std::min(share, most / std::abs(pull_[k]));
  }
  pull_ *= share;
  if (share < 1.0) {
    // All joints slip by the same share: that can only take energy out of the spring.
    stretch_ *= -share;
    integrate_configuration(tree_, q_.data(), stretch_.data(), q_hold_.data());
  }
  holding_ = pull_.allFinite() && q_hold_.allFinite();
  return holding_;
}

}  // namespace burnish
