#include "mpc/holding.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/integration.hpp"
#include "mpc/closed_dynamics.hpp"

namespace burnish {
Holding::Holding(const MpcSpec& spec, std::vector<int> actuated)
    : fallback_(spec.fallback),
      tick_period_(spec.tick_period),
      bridged_(std::min(0.01, spec.limits.bad) + 0.01 * spec.tick_period),
      actuated_(std::move(actuated)),
      effort_(spec.problem.model.effort_limit),
      tree_(spec.problem.model),
      is_closed_(!spec.problem.model.loops.empty() || !supports_of(spec).empty()),
      free_(closed_dynamics(spec.problem.model, supports_of(spec))),
      weight_(Eigen::VectorXd::Zero(spec.problem.model.nv)),
      mass_(Eigen::MatrixXd::Zero(spec.problem.model.nv, spec.problem.model.nv)),
      zero_(Eigen::VectorXd::Zero(spec.problem.model.nv)),
      q_hold_(spec.problem.initial_state.head(spec.problem.model.nq)),
      error_(zero_),
      stretch_(zero_),
      pull_(zero_) {
  const auto count = static_cast<Eigen::Index>(actuated_.size());
  mobility_ = inertia_ = square_ = Eigen::MatrixXd::Zero(count, count);
  scale_ = Eigen::VectorXd::Zero(count);
  fall_ = Eigen::VectorXd::Zero(count);
  factor_ = Eigen::LLT<Eigen::MatrixXd>(count);
}

void Holding::reset() noexcept {
  blind_for_ = 0.0;
  holding_ = false;
  lost_ = -1;
}

const Eigen::VectorXd* Holding::at_rest(const Eigen::VectorXd& q) noexcept {
  const bool known = is_closed_ ? weigh_what_is_carried(q) : weigh_freely(q);
  return known ? &weight_ : nullptr;
}

bool Holding::weigh_freely(const Eigen::VectorXd& q) noexcept {
  if (free_.forward(q, zero_, zero_) > Status::NotConverged) return false;
  for (const int k : actuated_) {
    weight_[k] = free_.bias()[k];
    for (const int j : actuated_) mass_(k, j) = free_.mass_matrix()(k, j);
  }
  return true;
}

/// With a = a_0 + A tau of the closed mechanism, which a robot on its feet is too, the actuated
/// entries move as a body of the inertia A_aa^-1 does, and -A_aa^-1 a_0 holds them. Where motors
/// are more than the degrees of freedom, what they would do against each other is left out: with D
/// of the diagonal and B = D^-1/2 A_aa D^-1/2 the inverse is D^-1/2 B (B B + e^2)^-1 D^-1/2.
bool Holding::weigh_what_is_carried(const Eigen::VectorXd& q) noexcept {
  if (free_.forward(q, zero_, zero_) > Status::NotConverged) return false;
  if (free_.forward_derivatives() > Status::NotConverged) return false;
  const auto count = static_cast<Eigen::Index>(actuated_.size());
  for (Eigen::Index i = 0; i < count; ++i) {
    const int k = actuated_[static_cast<std::size_t>(i)];
    fall_[i] = -free_.a()[k];
    for (Eigen::Index j = 0; j < count; ++j)
      mobility_(i, j) = free_.da_dtau()(k, actuated_[static_cast<std::size_t>(j)]);
    scale_[i] = 1.0 / std::sqrt(std::max(mobility_(i, i), 1e-12));
  }
  leave_out_lost();
  constexpr double least = 1e-3;  // of B: below it nothing moves
  mobility_ = scale_.asDiagonal() * mobility_ * scale_.asDiagonal();
  square_.noalias() = mobility_ * mobility_;
  square_.diagonal().array() += least * least;
  factor_.compute(square_);
  if (factor_.info() != Eigen::Success) return false;
  inertia_ = mobility_;
  factor_.solveInPlace(inertia_);
  inertia_ = scale_.asDiagonal() * inertia_ * scale_.asDiagonal();
  scale_.noalias() = inertia_ * fall_;
  fall_ = scale_;
  for (Eigen::Index i = 0; i < count; ++i) {
    const int k = actuated_[static_cast<std::size_t>(i)];
    weight_[k] = fall_[i];
    for (Eigen::Index j = 0; j < count; ++j)
      mass_(k, actuated_[static_cast<std::size_t>(j)]) = inertia_(i, j);
  }
  return weight_.allFinite() && mass_.allFinite();
}

/// What moves freely there is no entry of the inertia, and takes no torque.
void Holding::leave_out_lost() noexcept {
  for (std::size_t i = 0; i < actuated_.size(); ++i) {
    if (actuated_[i] != lost_) continue;
    const auto at = static_cast<Eigen::Index>(i);
    mobility_.row(at).setZero();
    mobility_.col(at).setZero();
    fall_[at] = 0.0;
  }
}

void Holding::torque(const Eigen::VectorXd& q, const Eigen::VectorXd& v, bool fresh,
                     Eigen::VectorXd& tau) noexcept {
  blind_for_ = fresh ? 0.0 : blind_for_ + tick_period_;
  tau.setZero();
  if (at_rest(q) == nullptr) return;
  const bool held = stretch(q, fresh);
  for (const int k : actuated_) {
    tau[k] = weight_[k];
    for (const int j : actuated_) tau[k] -= fallback_.damping * mass_(k, j) * v[j];
    if (held) tau[k] -= pull_[k];
  }
  if (lost_ >= 0) tau[lost_] = 0.0;
}

/// The spring's torque in pull_, slipped to what it may use; false where there is no spring.
bool Holding::stretch(const Eigen::VectorXd& q, bool fresh) noexcept {
  if (blind_for_ > bridged_) holding_ = false;
  if (!holding_ && fresh) {
    q_hold_ = q;
    holding_ = true;
  }
  if (!holding_ || fallback_.stiffness == 0.0) return false;
  difference_configuration(tree_, q_hold_.data(), q.data(), error_.data());
  stretch_.setZero();
  for (const int k : actuated_) stretch_[k] = error_[k];
  double share = 1.0;  // of the stretch, what stays
  for (const int k : actuated_) {
    pull_[k] = 0.0;
    for (const int j : actuated_) pull_[k] += fallback_.stiffness * mass_(k, j) * stretch_[j];
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
