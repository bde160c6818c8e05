// Definitions of constrained_dynamics.hpp, for any scalar.
#pragma once

#include <algorithm>

#include "base/to_size.hpp"
#include "contact/constrained_dynamics.hpp"
#include "contact/contact_kinematics.tpp"
#include "contact/delassus.tpp"
#include "dynamics/inverse_dynamics.tpp"
#include "dynamics/kinematics.tpp"
#include "dynamics/mass_matrix.tpp"
#include "model/joint_entries.hpp"

namespace burnish {

template <class S>
ConstrainedDynamics<S>::ConstrainedDynamics(const Model& model, const ContactSet& set,
                                            const ContactSolver& solver)
    : a(to_size(model.nv), S(0.0)),
      lambda(to_size(set.rows()), S(0.0)),
      tau(to_size(model.nv), S(0.0)),
      alpha(to_size(set.rows()), S(0.0)),
      velocity_after(to_size(model.nv), S(0.0)),
      contact_states(to_size(set.size())),
      lane_iterations(1, S(0.0)),
      proximal_residual(1, S(0.0)),
      tree_(model),
      set_(set),
      solver_(solver),
      is_active_(to_size(set.size()), 1),
      q_(to_size(model.nq), S(0.0)),
      v_(to_size(model.nv), S(0.0)),
      drift_(to_size(set.rows()), S(0.0)),
      at_rest_(to_size(model.nv), S(0.0)),
      motion_status_(to_size(lanes), Status::Ok),
      state_status_(motion_status_),
      status_(to_size(lanes), Status::Ok),
      kinematics_(tree_),
      mass_(tree_),
      delassus_(tree_, set_),
      friction_(tree_, set_),
      contradiction_(tree_,
                     solver.mu > 0.0 && solver.max_proximal_iterations > 0 ? set_ : ContactSet()),
      id_(tree_) {
  solver.check();
  for (int i = 0; i < model.nq; ++i) q_neutral_.push_back(S(model.q_neutral[i]));
  active_.contacts.reserve(to_size(set.size()));
  active_.first_row.assign(to_size(set.size()), -1);
  for (int i = 0; i < set.size(); ++i) {
    const CompiledReference& reference = set.contacts()[i].reference;
    reference_axes_.push_back(lift<S>(reference.axes));
    surfaces_.push_back({lift<S>(reference.Q), lift<S>(reference.b)});
    const auto& friction = set.contacts()[i].spec.friction;
    coefficients_.push_back(S(friction ? friction->coefficient : 0.0));
    set_active(i, true);
  }
  stride_ = 1 + friction_.max_contacts;
  for (auto* block : {&rho_, &solved_, &solved_before_})
    block->assign(to_size(set.rows() * stride_), S(0.0));
  columns_.reserve(to_size(stride_));
}

template <class S>
void ConstrainedDynamics<S>::set_active(int contact, bool active) {
  is_active_[contact] = active ? 1 : 0;
  ++active_version_;
  // From now on, rows can belong to other contacts. Entries outside the new support must be zero.
  std::fill(delassus_.T.begin(), delassus_.T.end(), S(0.0));
  std::fill(delassus_.jacobian_by_v.begin(), delassus_.jacobian_by_v.end(), S(0.0));
  active_.contacts.clear();
  active_.rows = 0;
  for (int i = 0; i < set_.size(); ++i) {
    active_.first_row[i] = -1;
    if (is_active_[i] == 0) continue;
    active_.contacts.push_back(i);
    active_.first_row[i] = active_.rows;
    active_.rows += static_cast<int>(set_.contacts()[i].directions.size());
  }
  choose_sliding(set_, active_, friction_);
}

template <class S>
void ConstrainedDynamics<S>::set_reference_rotation(int contact, const Mat3<S>& rotation) {
  reference_axes_[contact] = lift<S>(set_.contacts()[contact].reference.fixed_in) * rotation;
}

template <class S>
Status ConstrainedDynamics<S>::status() const {
  return *std::max_element(status_.begin(), status_.end());
}

template <class S>
void ConstrainedDynamics<S>::mark(const auto& bad, Status status, std::vector<Status>& of_lanes) {
  if (!any(bad)) [[likely]]
    return;
  for (int l = 0; l < lanes; ++l)
    if (lane_of(bad, l)) of_lanes[l] = worst(of_lanes[l], status);
}

template <class S>
void ConstrainedDynamics<S>::load_finite(const S* in, int count, S* out) {
  // 0 * x is zero for finite x and NaN otherwise.
  S zero(0.0);
  for (int i = 0; i < count; ++i) zero += in[i] * S(0.0);
  const auto infinite = mask_not(less(absolute(zero), S(1.0)));
  mark(infinite, Status::NotFinite, status_);
  for (int i = 0; i < count; ++i) out[i] = select(infinite, S(0.0), in[i]);
}

template <class S>
void ConstrainedDynamics<S>::clear_failed(std::vector<S>& results) const {
  if (is_usable(status())) [[likely]]
    return;
  for (int l = 0; l < lanes; ++l)
    if (!is_usable(status_[l]))
      for (S& x : results) Lanes<S>::set(x, l, 0.0);
}

template <class S>
void ConstrainedDynamics<S>::load_lanes(const S* q, const S* v) {
  std::fill(motion_status_.begin(), motion_status_.end(), Status::Ok);
  has_mass_factor_ = false;
  // 0 * x is zero for finite x and NaN otherwise.
  S zero(0.0);
  for (int i = 0; i < tree_.nq; ++i) zero += q[i] * S(0.0);
  for (int i = 0; i < tree_.nv; ++i) zero += v[i] * S(0.0);
  const auto infinite = mask_not(less(absolute(zero), S(1.0)));
  auto unnormalized = less(S(0.0), S(0.0));
  for (const TreeJoint& joint : tree_.joints) {
    const int size = unit_entries(joint.kind);
    if (size == 0) continue;
    const int last = joint.q + joint_nq(joint.kind);
    S square(-1.0);
    for (int i = last - size; i < last; ++i) square += q[i] * q[i];
    unnormalized = mask_or(unnormalized, mask_not(less(absolute(square), S(2e-6))));
  }
  mark(unnormalized, Status::NotNormalized, motion_status_);
  mark(infinite, Status::NotFinite, motion_status_);
  const auto bad = mask_or(unnormalized, infinite);
  for (int i = 0; i < tree_.nq; ++i) q_[i] = select(bad, q_neutral_[i], q[i]);
  for (int i = 0; i < tree_.nv; ++i) v_[i] = select(bad, S(0.0), v[i]);
}

template <class S>
void ConstrainedDynamics<S>::set_state(const S* q, const S* v) {
  load_lanes(q, v);
  update_kinematics(tree_, q_.data(), v_.data(), kinematics_);
  update_mass_and_bias(tree_, kinematics_, mass_);
  update_contacts();
}

template <class S>
void ConstrainedDynamics<S>::set_state(const S* q, const S* v, const Kinematics<S>& known) {
  load_lanes(q, v);
  if (std::count(motion_status_.begin(), motion_status_.end(), Status::Ok) == lanes)
    kinematics_ = known;  // does not allocate, because the sizes are equal
  else
    update_kinematics(tree_, q_.data(), v_.data(), kinematics_);
  update_mass_and_bias(tree_, kinematics_, mass_);
  update_contacts();
}

template <class S>
void ConstrainedDynamics<S>::update_contacts() {
  has_delassus_ = false;
  status_ = state_status_ = motion_status_;
  for (const int c : active_.contacts) {
    const CompiledContact& contact = set_.contacts()[c];
    update_contact(contact, reference_axes_[c], surfaces_[c], coefficients_[c], kinematics_,
                   contact_states[c]);
    contact_jacobian(contact, kinematics_, contact_states[c],
                     delassus_.jacobian_by_v.data() + active_.first_row[c], delassus_.stride);
  }
}

template <class S>
void ConstrainedDynamics<S>::drift(S* out) {
  const Motion<S> gravity{lift<S>(tree_.gravity), Vec3<S>::zero()};
  const auto bias_of = [&](int body) {
    return body < 0 ? Motion<S>::zero() : kinematics_.bodies[body].a_bias + gravity;
  };
  for (const int c : active_.contacts) {
    const CompiledContact& contact = set_.contacts()[c];
    contact_acceleration(contact, contact_states[c], bias_of(contact.tool_body),
                         bias_of(contact.base_body), out + active_.first_row[c]);
  }
}

template <class S>
void ConstrainedDynamics<S>::for_each_coupled(const auto& visit) const {
  for (const int c : active_.contacts) {
    const int first = active_.first_row[c];
    const int end = first + static_cast<int>(set_.contacts()[c].directions.size());
    for (const int k : set_.contacts()[c].coupled)
      for (int r = first; r < end; ++r) visit(k, r);
  }
}

template <class S>
void ConstrainedDynamics<S>::for_each_solved(const auto& visit) {
  for (int r = 0; r < active_.rows; ++r)
    for (const int c : columns_) visit(r * stride_ + c, c);
}

template <class S>
auto ConstrainedDynamics<S>::refine(auto open) {
  const S mu(solver_.mu), tolerance(solver_.proximal_tolerance);
  int iterations = 0;
  // Lanes that have converged are frozen, so that a lane's result does not depend on the others.
  while (any(open) && iterations < solver_.max_proximal_iterations) {
    ++iterations;
    for_each_solved([&](int i, int) {
      solved_before_[i] = solved_[i];
      solved_[i] = rho_[i] + solved_[i] * mu;
    });
    solve_delassus(delassus_, active_.rows, std::span<const int>(columns_), solved_.data(),
                   stride_);
    S largest(0.0);
    for_each_solved([&](int i, int c) {
      S change = absolute(S((solved_[i] - solved_before_[i]) * mu));
      // Multiplies the change of a response to friction by the normal force. All changes are then
      // comparable.
      if (c > 0) change = change * absolute(solved_[friction_.rows[c - 1] * stride_]);
      largest = select(less(largest, change), change, largest);
      solved_[i] = select(open, solved_[i], solved_before_[i]);
    });
    proximal_residual[0] = select(open, largest, proximal_residual[0]);
    lane_iterations[0] += select(open, S(1.0), S(0.0));
    open = mask_and(open, less(tolerance, largest));
  }
  return open;
}

template <class S>
auto ConstrainedDynamics<S>::settle_contradiction(const auto& open) {
  // Rounding error of the null-space component, relative to the right-hand side; chosen by hand.
  constexpr double rounding = 1e-12;
  const int m = active_.rows;
  const std::span<const int> columns(columns_), first = columns.first(1);
  Contradiction<S>& c = contradiction_;
  find_null_space(tree_, {set_, active_, contact_states}, mass_, delassus_, solver_.mu, c);
  S size(0.0), largest(0.0);
  for (int r = 0; r < m; ++r) c.unmet[r] = rho_[r * stride_];
  remove_null_part(c, S(1.0), m, first, c.unmet.data(), 1);
  for (int r = 0; r < m; ++r) {
    c.unmet[r] -= rho_[r * stride_];
    const S whole = absolute(rho_[r * stride_]), unmet = absolute(c.unmet[r]);
    size = select(less(size, whole), whole, size);
    largest = select(less(largest, unmet), unmet, largest);
  }
  const auto contradicts = mask_and(mask_and(open, less(S(solver_.proximal_tolerance), largest)),
                                    less(size * S(rounding), largest));
  c.found = any(contradicts);
  c.present = select(contradicts, S(1.0), S(0.0));
  for (int r = 0; r < m; ++r) c.unmet[r] = select(contradicts, c.unmet[r], S(0.0));
  auto unconverged = open;
  if (!c.found) return unconverged;
  remove_null_part(c, c.present, m, columns, rho_.data(), stride_);
  for_each_solved([&](int i, int) {
    solved_before_[i] = solved_[i];
    solved_[i] = rho_[i];
  });
  solve_delassus(delassus_, m, columns, solved_.data(), stride_);
  for_each_solved(
      [&](int i, int) { solved_[i] = select(contradicts, solved_[i], solved_before_[i]); });
  lane_iterations[0] = select(contradicts, S(0.0), lane_iterations[0]);
  unconverged = mask_or(mask_and(open, mask_not(contradicts)), refine(contradicts));
  // Removes the rounding errors that have accumulated in the null space.
  remove_null_part(c, c.present, m, columns, solved_.data(), stride_);
  const auto more = mask_and(contradicts, less(proximal_residual[0], largest));
  proximal_residual[0] = select(more, largest, proximal_residual[0]);
  mark(contradicts, Status::NotConverged, status_);
  return unconverged;
}

template <class S>
void ConstrainedDynamics<S>::solve_lambda() {
  const int m = active_.rows;
  for_each_solved([&](int i, int) { solved_[i] = rho_[i]; });
  solve_delassus(delassus_, m, std::span<const int>(columns_), solved_.data(), stride_);
  proximal_iterations = 0;
  lane_iterations[0] = proximal_residual[0] = S(0.0);
  if (contradiction_.found) [[unlikely]] {
    contradiction_.found = false;
    std::fill(contradiction_.unmet.begin(), contradiction_.unmet.end(), S(0.0));
  }
  if (solver_.mu > 0.0 && solver_.max_proximal_iterations > 0) {
    auto open = refine(less(S(0.0), S(1.0)));
    if (any(open)) [[unlikely]]
      open = settle_contradiction(open);
    mark(open, Status::NotConverged, status_);
    for (int l = 0; l < lanes; ++l)
      proximal_iterations =
          std::max(proximal_iterations, static_cast<int>(Lanes<S>::get(lane_iterations[0], l)));
  }
  for (int r = 0; r < m; ++r) lambda[r] = solved_[r * stride_];
}

/// Fills the columns of friction in rho_ with J M^-1 F_j. F_j are the joint torques of friction per
/// unit of the normal force of contact j.
template <class S>
void ConstrainedDynamics<S>::update_friction() {
  const S* const T = delassus_.T.data();
  for (int j = 0; j < friction_.size(); ++j) {
    const int c = friction_.contacts[j];
    const CompiledContact& contact = set_.contacts()[c];
    friction_torque(contact, kinematics_, contact_states[c], friction_.torque_of(j));
    S* const w = friction_.transformed_of(j);
    for (const int k : contact.coupled) w[k] = friction_.torque_of(j)[k];
    delassus_detail::transform_coupled(tree_, contact, mass_, w, 1, 1);
    for (int r = 0; r < active_.rows; ++r) rho_[r * stride_ + 1 + j] = S(0.0);
    for_each_coupled(
        [&](int k, int r) { rho_[r * stride_ + 1 + j] += T[k * delassus_.stride + r] * w[k]; });
    columns_.push_back(1 + j);
  }
}

/// Adds the effect of friction to lambda and a, which were computed without friction.
template <class S>
void ConstrainedDynamics<S>::add_friction() {
  const int n = friction_.size();
  if (n == 0) return;
  for (int r = 0; r < active_.rows; ++r)
    for (int j = 0; j < n; ++j)
      friction_.response[r * friction_.max_contacts + j] = solved_[r * stride_ + 1 + j];
  mark(factorize_friction(friction_), Status::SingularContacts, status_);
  for (int j = 0; j < n; ++j) friction_.normal[j] = lambda[friction_.rows[j]];
  solve_friction(friction_);
  for (int j = 0; j < n; ++j) {
    for (int r = 0; r < active_.rows; ++r)
      lambda[r] -= friction_.response[r * friction_.max_contacts + j] * friction_.normal[j];
    const S* const w = friction_.transformed_of(j);
    for (const int k : set_.contacts()[friction_.contacts[j]].coupled)
      a[k] += w[k] * friction_.normal[j];
  }
}

template <class S>
bool ConstrainedDynamics<S>::jams(int contact, int lane) const {
  for (int j = 0; j < friction_.size(); ++j)
    if (friction_.contacts[j] == contact)
      return Lanes<S>::get(friction_.factor[j * (friction_.size() + 1)], lane) == 0.0;
  return false;
}

template <class S>
void ConstrainedDynamics<S>::factorize_once() {
  if (has_delassus_) return;
  if (!has_mass_factor_) {
    const auto singular = factorize(tree_, kinematics_, mass_);
    mark(singular, Status::SingularMass, motion_status_);
    mark(singular, Status::SingularMass, state_status_);
    has_mass_factor_ = true;
  }
  mark(update_delassus(tree_, {set_, active_, contact_states}, mass_, solver_.mu, delassus_),
       Status::SingularContacts, state_status_);
  has_delassus_ = true;
}

template <class S>
void ConstrainedDynamics<S>::forward(const S* tau_in) {
  const int n = tree_.nv, m = active_.rows;
  factorize_once();
  status_ = state_status_;
  load_finite(tau_in, n, a.data());
  // Eq. (3) with T = L^-T J^T:
  // t = L^-T (tau - b); lambda = G^-1 (-alpha_0 - T^T t); a = L^-1 (t + T lambda).
  for (int i = 0; i < n; ++i) a[i] -= mass_.bias[i];
  solve_transposed(tree_, mass_, a.data());
  if (m > 0) {
    drift(drift_.data());
    for (int r = 0; r < m; ++r) rho_[r * stride_] = -drift_[r];
    const S* const T = delassus_.T.data();
    const int stride = delassus_.stride;
    for_each_coupled([&](int k, int r) { rho_[r * stride_] -= T[k * stride + r] * a[k]; });
    columns_.assign(1, 0);
    update_friction();
    solve_lambda();
    add_friction();
    for_each_coupled([&](int k, int r) { a[k] += T[k * stride + r] * lambda[r]; });
  }
  solve_factor(tree_, mass_, a.data());
  // Results can overflow although the inputs are finite.
  load_finite(a.data(), n, a.data());
  load_finite(lambda.data(), m, lambda.data());
  clear_failed(a);
  clear_failed(lambda);
}

template <class S>
void ConstrainedDynamics<S>::impact(const S* q, const S* v_before) {
  const int n = tree_.nv, m = active_.rows;
  set_state(q, at_rest_.data());
  factorize_once();
  status_ = state_status_;
  load_finite(v_before, n, velocity_after.data());
  // With T = L^-T J^T: Lambda = G^-1 (-J v-); v+ - v- = L^-1 T Lambda.
  std::fill(a.begin(), a.end(), S(0.0));
  std::fill(rho_.begin(), rho_.end(), S(0.0));
  const S* const J = delassus_.jacobian_by_v.data();
  const S* const T = delassus_.T.data();
  const int stride = delassus_.stride;
  for_each_coupled(
      [&](int k, int r) { rho_[r * stride_] -= J[k * stride + r] * velocity_after[k]; });
  columns_.assign(1, 0);
  solve_lambda();
  for_each_coupled([&](int k, int r) { a[k] += T[k * stride + r] * lambda[r]; });
  solve_factor(tree_, mass_, a.data());
  for (int k = 0; k < n; ++k) velocity_after[k] += a[k];
  load_finite(a.data(), n, a.data());
  load_finite(lambda.data(), m, lambda.data());
  load_finite(velocity_after.data(), n, velocity_after.data());
  clear_failed(a);
  clear_failed(lambda);
  clear_failed(velocity_after);
}

template <class S>
void ConstrainedDynamics<S>::apply_forces(const S* more) {
  accelerate(tree_, kinematics_, a.data(), id_);
  for (const int c : active_.contacts) {
    const CompiledContact& contact = set_.contacts()[c];
    set_contact_force(contact, lambda.data() + active_.first_row[c], contact_states[c]);
    if (more != nullptr) [[unlikely]]
      contact_states[c].force_world +=
          wrench_of_rows(contact, more + active_.first_row[c], contact_states[c]);
    const Force<S>& force = contact_states[c].force_world;
    if (contact.tool_body >= 0) id_.force[contact.tool_body] -= force;
    if (contact.base_body >= 0) id_.force[contact.base_body] += force;
  }
}

template <class S>
void ConstrainedDynamics<S>::inverse(const S* a_in, const S* lambda_in) {
  status_ = state_status_;
  load_finite(a_in, tree_.nv, a.data());
  load_finite(lambda_in, active_.rows, lambda.data());
  apply_forces();
  inverse_dynamics_sweep(tree_, kinematics_, mass_, a.data(), id_);
  load_finite(id_.tau.data(), tree_.nv, tau.data());
  clear_failed(tau);
}

template <class S>
void ConstrainedDynamics<S>::acceleration(const S* a_in) {
  status_ = state_status_;
  load_finite(a_in, tree_.nv, a.data());
  drift(alpha.data());
  const S* const J = delassus_.jacobian_by_v.data();
  for_each_coupled([&](int k, int r) { alpha[r] += J[k * delassus_.stride + r] * a[k]; });
  load_finite(alpha.data(), active_.rows, alpha.data());
  clear_failed(alpha);
}

}  // namespace burnish
