#include "mpc/holding.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/integration.hpp"

namespace burnish {

Holding::Holding(const MpcSpec& spec, std::vector<int> actuated)
    : fallback_(spec.fallback),
      tick_period_(spec.tick_period),
      bridged_(std::min(0.01, spec.limits.bad) + 0.01 * spec.tick_period),
      actuated_(std::move(actuated)),
      effort_(spec.problem.model.effort_limit),
      tree_(spec.problem.model),
      free_(spec.problem.model),
      zero_(Eigen::VectorXd::Zero(spec.problem.model.nv)),
      q_hold_(spec.problem.initial_state.head(spec.problem.model.nq)),
      error_(zero_),
      stretch_(zero_),
      pull_(zero_) {}

void Holding::reset() noexcept {
  blind_for_ = 0.0;
  holding_ = false;
}

const ContactDynamics* Holding::at_rest(const Eigen::VectorXd& q) noexcept {
  return free_.forward(q, zero_, zero_) > Status::NotConverged ? nullptr : &free_;
}

void Holding::torque(const Eigen::VectorXd& q, const Eigen::VectorXd& v, bool fresh,
                     Eigen::VectorXd& tau) noexcept {
  blind_for_ = fresh ? 0.0 : blind_for_ + tick_period_;
  tau.setZero();
  if (at_rest(q) == nullptr) return;
  const auto mass = free_.mass_matrix();
  const bool held = stretch(q, fresh);
  for (const int k : actuated_) {
    tau[k] = free_.bias()[k];
    for (const int j : actuated_) tau[k] -= fallback_.damping * mass(k, j) * v[j];
    if (held) tau[k] -= pull_[k];
  }
}

/// The spring's torque in pull_, slipped to what it may use; false where there is no spring.
bool Holding::stretch(const Eigen::VectorXd& q, bool fresh) noexcept {
  if (blind_for_ > bridged_) holding_ = false;
  if (!holding_ && fresh) {
    q_hold_ = q;
    holding_ = true;
  }
  if (!holding_ || fallback_.stiffness == 0.0) return false;
  const auto mass = free_.mass_matrix();
  difference_configuration(tree_, q_hold_.data(), q.data(), error_.data());
  stretch_.setZero();
  for (const int k : actuated_) stretch_[k] = error_[k];
  double share = 1.0;  // of the stretch, what stays
  for (const int k : actuated_) {
    pull_[k] = 0.0;
    for (const int j : actuated_) pull_[k] += fallback_.stiffness * mass(k, j) * stretch_[j];
    const double most = fallback_.give * effort_[k];
    // A joint without torque has no part in it.
    if (effort_[k] > 0.0 && std::abs(pull_[k]) > most)
      share = std::min(share, most / std::abs(pull_[k]));
  }
  pull_ *= share;
  if (share < 1.0) {
    // All joints slip by the same share: that can only take energy out of the spring.
    stretch_ *= -share;
    integrate_configuration(tree_, q.data(), stretch_.data(), q_hold_.data());
  }
  holding_ = pull_.allFinite() && q_hold_.allFinite();
  return holding_;
}

}  // namespace burnish
