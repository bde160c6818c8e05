#include "mpc/holding.hpp"

#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "dynamics/integration.hpp"
#include "mpc/closed_dynamics.hpp"

namespace burnish {

Holding::Holding(const HoldingSpec& spec, std::vector<int> actuated)
    : fallback_(spec.fallback),
      tick_period_(spec.tick_period),
      bridged_(std::min(0.01, spec.bad) + 0.01 * spec.tick_period),
      actuated_(std::move(actuated)),
      effort_(spec.model.effort_limit),
      tree_(spec.model),
      is_closed_(!spec.model.loops.empty() || !spec.supports.empty()),
      free_(closed_dynamics(spec.model, spec.supports)),
      soles_(spec.model, spec.q_start, spec.soles, spec.fallback.stiffness),
      open_(spec.model),
      load_fraction_(Eigen::VectorXd::Ones(spec.model.nv)),
      gravity_(spec.model.gravity.norm()),
      weight_per_foot_(0.0),
      weight_(Eigen::VectorXd::Zero(spec.model.nv)),
      mass_(Eigen::MatrixXd::Zero(spec.model.nv, spec.model.nv)),
      zero_(Eigen::VectorXd::Zero(spec.model.nv)),
      q_hold_(spec.q_start),
      error_(zero_),
      stretch_(zero_),
      pull_(zero_) {
  const auto count = static_cast<Eigen::Index>(actuated_.size());
  mobility_ = inertia_ = square_ = Eigen::MatrixXd::Zero(count, count);
  scale_ = Eigen::VectorXd::Zero(count);
  fall_ = Eigen::VectorXd::Zero(count);
  factor_ = Eigen::LLT<Eigen::MatrixXd>(count);
  const double weight = spec.model.total_mass() * gravity_;
  if (!spec.model.loops.empty() || !(weight > 0.0)) return;
  RigidBody body(spec.model);
  if (!is_usable(body.update(q_hold_, zero_))) return;
  FrameDerivatives by;
  for (std::size_t i = 0; i < spec.supports.size(); ++i) {
    if (spec.sensors[i] < 0) continue;
    Foot& foot = feet_.emplace_back();
    foot.sensor = spec.sensors[i];
    body.frame_derivatives(body.frame(spec.supports[i].tool), Reference::centered(), by);
    for (Eigen::Index k = 0; k < zero_.size(); ++k)
      foot.carries.push_back(by.jacobian.col(k).isZero(0.0) ? 0 : 1);
  }
  if (!feet_.empty()) weight_per_foot_ = weight / static_cast<double>(feet_.size());
}

void Holding::set_payload(std::string_view frame, const InertiaSpec& payload,
                          const LoadedBody& loaded) {
  (void)free_.set_payload(frame, payload);
  (void)open_.set_payload(frame, payload);
  const double before = tree_.joints[to_size(loaded.body)].mass;
  set_body_inertia(tree_, loaded.body, body_inertia(loaded.inertia));
  if (!feet_.empty())
    weight_per_foot_ +=
        (loaded.inertia.mass - before) * gravity_ / static_cast<double>(feet_.size());
}

void Holding::reset() noexcept {
  blind_for_ = 0.0;
  holding_ = false;
  failed_ = -1;
}

const Eigen::VectorXd* Holding::at_rest(const Eigen::VectorXd& q) noexcept {
  const bool found = is_closed_ ? compute_closed_inertia(q) : compute_free_inertia(q);
  return found ? &weight_ : nullptr;
}

bool Holding::compute_free_inertia(const Eigen::VectorXd& q) noexcept {
  if (!is_usable(free_.forward(q, zero_, zero_))) return false;
  for (const int k : actuated_) {
    weight_[k] = free_.bias()[k];
    for (const int j : actuated_) mass_(k, j) = free_.mass_matrix()(k, j);
  }
  return true;
}

/// Computes holding torques and inertia of a closed mechanism, such as a robot on its feet. The
/// acceleration of the mechanism is a = a_0 + A tau. The block A_aa of A belongs to the actuated
/// entries of v. Their effective inertia is A_aa^-1, and the torque -A_aa^-1 a_0 holds them.
/// With more motors than degrees of freedom, A_aa is singular. A regularized inverse then leaves
/// out torques that balance each other: D^-1/2 B (B B + e^2)^-1 D^-1/2, with the diagonal D of
/// A_aa, B = D^-1/2 A_aa D^-1/2 and a small number e.
bool Holding::compute_closed_inertia(const Eigen::VectorXd& q) noexcept {
  if (!is_usable(free_.forward(q, zero_, zero_))) return false;
  if (!is_usable(free_.forward_derivatives())) return false;
  const auto count = static_cast<Eigen::Index>(actuated_.size());
  for (Eigen::Index i = 0; i < count; ++i) {
    const int k = actuated_[to_size(i)];
    fall_[i] = -free_.a()[k];
    for (Eigen::Index j = 0; j < count; ++j)
      mobility_(i, j) = free_.da_dtau()(k, actuated_[to_size(j)]);
    scale_[i] = 1.0 / std::sqrt(std::max(mobility_(i, i), 1e-12));
  }
  remove_failed_motor();
  constexpr double e = 1e-3;  // eigenvalues of B that are below e count as zero
  mobility_ = scale_.asDiagonal() * mobility_ * scale_.asDiagonal();
  square_.noalias() = mobility_ * mobility_;
  square_.diagonal().array() += e * e;
  factor_.compute(square_);
  if (factor_.info() != Eigen::Success) return false;
  inertia_ = mobility_;
  factor_.solveInPlace(inertia_);
  inertia_ = scale_.asDiagonal() * inertia_ * scale_.asDiagonal();
  scale_.noalias() = inertia_ * fall_;
  fall_ = scale_;
  for (Eigen::Index i = 0; i < count; ++i) {
    const int k = actuated_[to_size(i)];
    weight_[k] = fall_[i];
    for (Eigen::Index j = 0; j < count; ++j) mass_(k, actuated_[to_size(j)]) = inertia_(i, j);
  }
  return weight_.allFinite() && mass_.allFinite();
}

/// Removes the failed motor. Its joint then moves freely, adds no inertia, and gets no torque.
void Holding::remove_failed_motor() noexcept {
  for (std::size_t i = 0; i < actuated_.size(); ++i) {
    if (actuated_[i] != failed_) continue;
    const auto at = static_cast<Eigen::Index>(i);
    mobility_.row(at).setZero();
    mobility_.col(at).setZero();
    fall_[at] = 0.0;
  }
}

/// Blends the dynamics of standing and hanging legs. An unloaded foot does not support the robot,
/// and its leg hangs; torques for a standing leg would make this leg kick. S is the diagonal matrix
/// of load fractions s: 1 for a joint whose foot has load, 0 for a joint whose foot has none.
/// Joints that do not lie between a foot and the base have the load fraction of all feet together.
/// With the inertias M_closed of standing and M_open of hanging legs, the blended inertia is
/// S^1/2 M_closed S^1/2 + (1 - S)^1/2 M_open (1 - S)^1/2.
void Holding::blend_with_hanging(const Eigen::VectorXd& q, const Wrenches& wrenches) noexcept {
  if (feet_.empty()) return;
  double total_load = 0.0;
  for (const Foot& foot : feet_) {
    if (foot.sensor >= wrenches.cols()) return;
    total_load += wrenches.col(foot.sensor).head<3>().norm();
  }
  // Load from which s is 1, as a fraction of an equal share of the weight; chosen by hand.
  constexpr double full_load = 0.3;
  const auto fraction = [&](double load, double nominal) {
    return std::isfinite(load) ? std::clamp(load / (full_load * nominal), 0.0, 1.0) : 1.0;
  };
  load_fraction_.setConstant(
      fraction(total_load, weight_per_foot_ * static_cast<double>(feet_.size())));
  const auto each_carried = [&](const Foot& foot, const auto& see) {
    for (const int k : actuated_)
      if (foot.carries[to_size(k)] != 0) see(load_fraction_[k]);
  };
  for (const Foot& foot : feet_) each_carried(foot, [](double& entry) { entry = 0.0; });
  // A joint above several feet, for example in the spine, gets the largest of their load fractions.
  for (const Foot& foot : feet_) {
    const double own = fraction(wrenches.col(foot.sensor).head<3>().norm(), weight_per_foot_);
    each_carried(foot, [own](double& entry) { entry = std::max(entry, own); });
  }
  if (load_fraction_.minCoeff() == 1.0 || !is_usable(open_.forward(q, zero_, zero_))) return;
  for (const int k : actuated_) {
    const double s = load_fraction_[k];
    weight_[k] = s * weight_[k] + (1.0 - s) * open_.bias()[k];
    for (const int j : actuated_)
      mass_(k, j) = std::sqrt(s * load_fraction_[j]) * mass_(k, j) +
                    std::sqrt((1.0 - s) * (1.0 - load_fraction_[j])) * open_.mass_matrix()(k, j);
  }
}

void Holding::torque(const Eigen::VectorXd& q, const Eigen::VectorXd& v, bool fresh,
                     const Wrenches& wrenches, Eigen::VectorXd& tau) noexcept {
  blind_for_ = fresh ? 0.0 : blind_for_ + tick_period_;
  tau.setZero();
  if (at_rest(q) == nullptr) return;
  blend_with_hanging(q, wrenches);
  const bool held = update_spring(q, fresh);
  for (const int k : actuated_) {
    tau[k] = weight_[k];
    for (const int j : actuated_) tau[k] -= fallback_.damping * mass_(k, j) * v[j];
    if (held) tau[k] -= pull_[k];
  }
  soles_.keep(wrenches, tau);
  if (failed_ >= 0) tau[failed_] = 0.0;
}

/// Sets pull_ to the spring torque. If the torque would exceed its limit, the rest position of the
/// spring slips towards q. Returns false if the spring is off.
bool Holding::update_spring(const Eigen::VectorXd& q, bool fresh) noexcept {
  if (blind_for_ > bridged_) holding_ = false;
  if (!holding_ && fresh) {
    q_hold_ = q;
    holding_ = true;
  }
  if (!holding_ || fallback_.stiffness == 0.0) return false;
  difference_configuration(tree_, q_hold_.data(), q.data(), error_.data());
  stretch_.setZero();
  for (const int k : actuated_) stretch_[k] = error_[k];
  double kept = 1.0;  // fraction of the deflection that remains after slipping
  for (const int k : actuated_) {
    pull_[k] = 0.0;
    for (const int j : actuated_) pull_[k] += fallback_.stiffness * mass_(k, j) * stretch_[j];
    const double max_torque = fallback_.saturation_fraction * effort_[k];
    // Joints with an effort limit of 0 are ignored.
    if (effort_[k] > 0.0 && std::abs(pull_[k]) > max_torque)
      kept = std::min(kept, max_torque / std::abs(pull_[k]));
  }
  pull_ *= kept;
  if (kept < 1.0) {
    // All deflections are reduced by the same factor, which can only take energy out of the spring.
    stretch_ *= -kept;
    integrate_configuration(tree_, q.data(), stretch_.data(), q_hold_.data());
  }
  holding_ = pull_.allFinite() && q_hold_.allFinite();
  return holding_;
}

}  // namespace burnish
