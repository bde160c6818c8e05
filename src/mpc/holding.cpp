#include "mpc/holding.hpp"

#include <algorithm>
#include <cmath>

#include "burnish/derivatives/rigid_body.hpp"
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
      soles_(spec),
      open_(spec.problem.model),
      share_(Eigen::VectorXd::Ones(spec.problem.model.nv)),
      gravity_(spec.problem.model.gravity.norm()),
      weight_per_foot_(0.0),
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
  const double weight = spec.problem.model.total_mass() * gravity_;
  if (!spec.support_sensors || !spec.problem.model.loops.empty() || !(weight > 0.0)) return;
  RigidBody body(spec.problem.model);
  if (body.update(q_hold_, zero_) > Status::NotConverged) return;
  FrameDerivatives by;
  for (const ContactSpec& contact : supports_of(spec)) {
    const auto at = std::find(spec.supports.begin(), spec.supports.end(), contact.name);
    Foot& foot = feet_.emplace_back();
    foot.sensor = at - spec.supports.begin();
    body.frame_derivatives(body.frame(contact.tool), Reference::centered(), by);
    for (Eigen::Index k = 0; k < zero_.size(); ++k)
      foot.carries.push_back(by.jacobian.col(k).isZero(0.0) ? 0 : 1);
  }
  if (!feet_.empty()) weight_per_foot_ = weight / static_cast<double>(feet_.size());
}

void Holding::set_payload(std::string_view frame, const InertiaSpec& payload,
                          const LoadedBody& loaded) {
  (void)free_.set_payload(frame, payload);
  (void)open_.set_payload(frame, payload);
  const double before = tree_.joints[static_cast<std::size_t>(loaded.body)].mass;
  set_body_inertia(tree_, loaded.body, body_inertia(loaded.inertia));
  if (!feet_.empty())
    weight_per_foot_ +=
        (loaded.inertia.mass - before) * gravity_ / static_cast<double>(feet_.size());
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

/// A foot that bears nothing carries nothing, and its leg hangs. To what moves it as if it stood,
/// legs would kick. With the share s of its part of the weight that each foot bears, and for what
/// is between no foot and the base that of all of them together, the entries move as a body of the
/// inertia S^1/2 M_closed S^1/2 + (1 - S)^1/2 M_open (1 - S)^1/2, which is one again.
void Holding::weigh_by_loads(const Eigen::VectorXd& q,
                             const Eigen::Matrix<double, 6, Eigen::Dynamic>& wrenches) noexcept {
  if (feet_.empty()) return;
  double all = 0.0;
  for (const Foot& foot : feet_) {
    if (foot.sensor >= wrenches.cols()) return;
    all += wrenches.col(foot.sensor).head<3>().norm();
  }
  // What bears some of its part stands: only the rest goes over into hanging.
  constexpr double some = 0.3;
  const auto part = [&](double load, double of) {
    return std::isfinite(load) ? std::clamp(load / (some * of), 0.0, 1.0) : 1.0;
  };
  share_.setConstant(part(all, weight_per_foot_ * static_cast<double>(feet_.size())));
  const auto each_carried = [&](const Foot& foot, const auto& see) {
    for (const int k : actuated_)
      if (foot.carries[static_cast<std::size_t>(k)] != 0) see(share_[k]);
  };
  for (const Foot& foot : feet_) each_carried(foot, [](double& share) { share = 0.0; });
  // Of a joint above several feet, as one of a spine, the one that bears most.
  for (const Foot& foot : feet_) {
    const double own = part(wrenches.col(foot.sensor).head<3>().norm(), weight_per_foot_);
    each_carried(foot, [own](double& share) { share = std::max(share, own); });
  }
  if (share_.minCoeff() == 1.0 || open_.forward(q, zero_, zero_) > Status::NotConverged) return;
  for (const int k : actuated_) {
    const double s = share_[k];
    weight_[k] = s * weight_[k] + (1.0 - s) * open_.bias()[k];
    for (const int j : actuated_)
      mass_(k, j) = std::sqrt(s * share_[j]) * mass_(k, j) +
                    std::sqrt((1.0 - s) * (1.0 - share_[j])) * open_.mass_matrix()(k, j);
  }
}

void Holding::torque(const Eigen::VectorXd& q, const Eigen::VectorXd& v, bool fresh,
                     const Eigen::Matrix<double, 6, Eigen::Dynamic>& wrenches,
                     Eigen::VectorXd& tau) noexcept {
  blind_for_ = fresh ? 0.0 : blind_for_ + tick_period_;
  tau.setZero();
  if (at_rest(q) == nullptr) return;
  weigh_by_loads(q, wrenches);
  const bool held = stretch(q, fresh);
  for (const int k : actuated_) {
    tau[k] = weight_[k];
    for (const int j : actuated_) tau[k] -= fallback_.damping * mass_(k, j) * v[j];
    if (held) tau[k] -= pull_[k];
  }
  soles_.keep(wrenches, tau);
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
