// Definitions of constrained_derivatives.hpp, for any scalar.
#pragma once

#include <algorithm>

#include "base/to_size.hpp"
#include "contact/constrained_dynamics.tpp"
#include "derivatives/constrained_derivatives.hpp"
#include "derivatives/contact_acceleration.tpp"
#include "derivatives/inverse_dynamics.tpp"
#include "dynamics/articulated.tpp"
#include "math/gram.hpp"

namespace burnish {
namespace derivatives_detail {

inline std::vector<int> ancestors(const Tree& tree, int last) {
  std::vector<int> result;
  for (int k = last; k >= 0; k = tree.parent_of_v[k]) result.push_back(k);
  std::reverse(result.begin(), result.end());
  return result;
}

inline bool contains(const std::vector<int>& sorted, int k) {
  return std::binary_search(sorted.begin(), sorted.end(), k);
}

inline bool is_influenced(const CompiledContact& contact, int k) {
  return contains(contact.influenced, k);
}

/// Returns the entries of v related to a chain: entries above, in and below the chain, and entries
/// that are coupled to the chain by a contact in which more than the tool moves.
inline std::vector<int> related_rows(const Tree& tree, const ContactSet& set,
                                     const std::vector<int>& above, int first) {
  std::vector<int> result;
  for (int k = 0; k < tree.nv; ++k) {
    bool is_related = contains(above, k) || contains(ancestors(tree, k), first);
    for (const CompiledContact& contact : set.contacts())
      is_related = is_related || (transport_couples_branches(contact) &&
                                  contains(contact.coupled, k) && is_influenced(contact, first));
    if (is_related) result.push_back(k);
  }
  return result;
}

}  // namespace derivatives_detail

template <class S>
ConstrainedDerivatives<S>::ConstrainedDerivatives(const ConstrainedDynamics<S>& dynamics)
    : n_(dynamics.nv()),
      contacts_without_gains_(dynamics.set().contacts()),
      articulated_(dynamics.tree()) {
  using namespace derivatives_detail;
  const Tree& tree = dynamics.tree();
  const ContactSet& set = dynamics.set();
  for (CompiledContact& contact : contacts_without_gains_)
    contact.proportional = contact.damped = false;
  const int all_rows = n_ + set.rows();
  const auto entries = to_size(all_rows * n_);
  for (auto* matrix : {&rhs_q, &rhs_v, &d_dq, &d_dv, &d_dtau}) matrix->assign(entries, S(0.0));
  if (!tree.deep) factor_inverse_.assign(to_size(n_ * n_), S(0.0));
  by_friction_.assign(to_size(dynamics.friction().max_contacts * n_), S(0.0));
  const auto contact_entries = to_size(set.rows() * n_);
  for (auto* matrix : {&Z_, &lambda_by_tau_, &solved_, &before_, &frozen_})
    matrix->assign(contact_entries, S(0.0));
  if (!dynamics.contradiction().basis.empty()) {
    shifted_.assign(entries, S(0.0));
    a_.assign(to_size(n_), S(0.0));
  }
  for (int k = 0; k < n_; ++k) all_columns_.push_back(k);
  for (const auto& [first, end] : tree.chains()) {
    const std::vector<int> above = ancestors(tree, end - 1);
    segments_.push_back({first, end, related_rows(tree, set, above, first), above});
  }
  for (const Segment& a : segments_)
    for (const Segment& b : segments_) {
      std::vector<int> shared;
      std::set_intersection(a.ancestors.begin(), a.ancestors.end(), b.ancestors.begin(),
                            b.ancestors.end(), std::back_inserter(shared));
      shared_ancestors_.push_back(shared);
    }
  segment_rows_.resize(segments_.size());
  for (auto& rows : segment_rows_) rows.reserve(to_size(all_rows));
  contact_rows_.reserve(to_size(set.rows()));
  supported_columns_.reserve(to_size(n_));
  supported_.assign(to_size(n_), 0);
}

template <class S>
void ConstrainedDerivatives<S>::adapt_to_active(const ConstrainedDynamics<S>& dynamics) {
  if (version_ == dynamics.active_version()) return;
  version_ = dynamics.active_version();
  std::fill(rhs_q.begin(), rhs_q.end(), S(0.0));
  std::fill(rhs_v.begin(), rhs_v.end(), S(0.0));
  const ActiveContacts& active = dynamics.active();
  std::fill(supported_.begin(), supported_.end(), 0);
  contact_rows_.clear();
  for (int r = 0; r < active.rows; ++r) contact_rows_.push_back(r);
  for (std::size_t s = 0; s < segments_.size(); ++s) {
    segment_rows_[s] = segments_[s].related;
    for (const int c : active.contacts) {
      const CompiledContact& contact = dynamics.set().contacts()[c];
      for (const ContactSupport& entry : contact.influences) supported_[entry.v] = 1;
      if (!derivatives_detail::is_influenced(contact, segments_[s].first)) continue;
      for (std::size_t r = 0; r < contact.directions.size(); ++r)
        segment_rows_[s].push_back(n_ + active.first_row[c] + static_cast<int>(r));
    }
  }
  supported_columns_.clear();
  for (int k = 0; k < n_; ++k)
    if (supported_[k] != 0) supported_columns_.push_back(k);
}

template <class S>
void ConstrainedDerivatives<S>::fill_contact_rows(ConstrainedDynamics<S>& dynamics,
                                                  const std::vector<CompiledContact>& contacts) {
  const ActiveContacts& active = dynamics.active();
  for (const int c : active.contacts) {
    const CompiledContact& contact = contacts[c];
    const ContactState<S>& state = dynamics.contact_states[c];
    const auto at = contact_accelerations(dynamics.tree(), contact, dynamics.kinematics(),
                                          dynamics.inverse_dynamics(), state);
    const int offset = (n_ + active.first_row[c]) * n_;
    contact_acceleration_derivatives(contact, dynamics.kinematics(), dynamics.inverse_dynamics(),
                                     state, at, {rhs_q.data() + offset, rhs_v.data() + offset, n_});
  }
}

template <class S>
void ConstrainedDerivatives<S>::fill_joint_rows(ConstrainedDynamics<S>& dynamics) {
  const ActiveContacts& active = dynamics.active();
  for (const int c : active.contacts) {
    const CompiledContact& contact = dynamics.set().contacts()[c];
    if (!transport_couples_branches(contact)) continue;
    for (const ContactSupport& row : contact.support)
      for (const ContactSupport& column : contact.influences) {
        rhs_q[row.v * n_ + column.v] = S(0.0);
        if (contact.has_friction) rhs_v[row.v * n_ + column.v] = S(0.0);
      }
  }
  inverse_dynamics_derivatives(dynamics.tree(), dynamics.kinematics(), dynamics.mass(),
                               dynamics.inverse_dynamics(), rhs_q.data(), rhs_v.data());
  for (const int c : active.contacts)
    subtract_force_transport(dynamics.set().contacts()[c], dynamics.kinematics(),
                             dynamics.contact_states[c], rhs_q.data(), n_);
}

template <class S>
void ConstrainedDerivatives<S>::subtract_friction(ConstrainedDynamics<S>& dynamics) {
  for (const int c : dynamics.friction().contacts)
    subtract_friction_by_v(dynamics.set().contacts()[c], dynamics.kinematics(),
                           dynamics.contact_states[c], rhs_v.data(), n_);
}

template <class S>
void ConstrainedDerivatives<S>::add_friction(ConstrainedDynamics<S>& dynamics) {
  // The columns hold da and dlambda without friction. A unit of the normal force of contact j adds
  // P F_j to da and subtracts R_j from dlambda, with P = da/dtau (friction_coupling.hpp).
  FrictionCoupling<S>& f = dynamics.friction();
  const int m = dynamics.rows();
  for (int j = 0; j < f.size(); ++j) {
    S* const da = by_friction_.data() + j * n_;
    for (int k = 0; k < n_; ++k) da[k] = S(0.0);
    const S* const F = f.torque_of(j);
    for (const ContactSupport& entry : dynamics.set().contacts()[f.contacts[j]].support)
      for (int k = 0; k < n_; ++k) da[k] += d_dtau[k * n_ + entry.v] * F[entry.v];
  }
  for (auto* matrix : {&d_dq, &d_dv, &d_dtau}) {
    S* const X = matrix->data();
    for (int column = 0; column < n_; ++column) {
      for (int j = 0; j < f.size(); ++j) f.normal[j] = X[(n_ + f.rows[j]) * n_ + column];
      solve_friction(f);
      for (int j = 0; j < f.size(); ++j) {
        for (int k = 0; k < n_; ++k) X[k * n_ + column] += by_friction_[j * n_ + k] * f.normal[j];
        for (int r = 0; r < m; ++r)
          X[(n_ + r) * n_ + column] -= f.response[r * f.max_contacts + j] * f.normal[j];
      }
    }
  }
}

template <class S>
void ConstrainedDerivatives<S>::inverse(ConstrainedDynamics<S>& dynamics) {
  adapt_to_active(dynamics);
  dynamics.apply_forces();
  fill_joint_rows(dynamics);
  subtract_friction(dynamics);
  for (auto* matrix : {&rhs_q, &rhs_v}) dynamics.clear_failed(*matrix);
}

template <class S>
void ConstrainedDerivatives<S>::acceleration(ConstrainedDynamics<S>& dynamics) {
  adapt_to_active(dynamics);
  dynamics.apply_forces();
  fill_contact_rows(dynamics, dynamics.set().contacts());
  for (auto* matrix : {&rhs_q, &rhs_v}) dynamics.clear_failed(*matrix);
}

template <class S>
void ConstrainedDerivatives<S>::fill_impact_rows(ConstrainedDynamics<S>& dynamics) {
  // At zero velocity, joint accelerations v+ cause the contact acceleration J v+, for all kinds of
  // acceleration and references. Its derivative by q is d(J v+)/dq, without gravity.
  InverseDynamics<S>& id = dynamics.inverse_dynamics();
  accelerate(dynamics.tree(), dynamics.kinematics(), dynamics.velocity_after.data(), id);
  fill_contact_rows(dynamics, contacts_without_gains_);
  const Delassus<S>& d = dynamics.delassus();
  for (const int c : dynamics.active().contacts) {
    const int first = dynamics.active().first_row[c];
    const int end = first + static_cast<int>(dynamics.set().contacts()[c].directions.size());
    for (const ContactSupport& entry : dynamics.set().contacts()[c].support)
      for (int r = first; r < end; ++r)
        rhs_v[(n_ + r) * n_ + entry.v] = -d.jacobian_by_v[entry.v * d.stride + r];
  }
  // At zero velocity, M a + b is M a plus the gravity torques. Subtracting gravity from the
  // accelerations of axes and bodies leaves M a. `a` holds the velocity change dv, so the rows are
  // the derivatives of M dv - J^T Lambda.
  dynamics.apply_forces();
  const Motion<S> gravity{lift<S>(dynamics.tree().gravity), Vec3<S>::zero()};
  for (std::size_t k = 0; k < id.axis_acc.size(); ++k)
    id.axis_acc[k] += cross(gravity, dynamics.kinematics().axes[k].axis);
  for (int i = 0; i < dynamics.tree().bodies(); ++i)
    id.force[i] += dynamics.kinematics().bodies[i].inertia * gravity;
  fill_joint_rows(dynamics);
}

template <class S>
void ConstrainedDerivatives<S>::impact(ConstrainedDynamics<S>& dynamics) {
  adapt_to_active(dynamics);
  fill_impact_rows(dynamics);
  by_torque(dynamics);
  by_state(dynamics, rhs_q, d_dq);
  by_state(dynamics, rhs_v, d_dv);
  // The first n_ rows hold d(v+ - v-)/dv-. Adding the identity gives dv+/dv-.
  for (int k = 0; k < n_; ++k) d_dv[k * n_ + k] += S(1.0);
  for (auto* matrix : {&d_dq, &d_dv, &d_dtau}) dynamics.clear_failed(*matrix);
}

template <class S>
void ConstrainedDerivatives<S>::invert_factor(const ConstrainedDynamics<S>& dynamics) {
  // Row i of W = L^-1: W_ii = 1/L_ii, W_ij = -1/L_ii sum of L_ik W_kj over j <= k < i. Row i of W
  // is stored as column i of W^T.
  const MassMatrix<S>& mass = dynamics.mass();
  const auto& parent = dynamics.tree().parent_of_v;
  S* const W = factor_inverse_.data();
  for (int i = 0; i < n_; ++i) {
    for (int j = parent[i]; j >= 0; j = parent[j]) W[j * n_ + i] = S(0.0);
    for (int k = parent[i]; k >= 0; k = parent[k]) {
      const S l = mass.factor[i * n_ + k];
      for (int j = k; j >= 0; j = parent[j]) W[j * n_ + i] -= l * W[j * n_ + k];
    }
    const S reciprocal = mass.inverse_diagonal[i];
    for (int j = parent[i]; j >= 0; j = parent[j]) W[j * n_ + i] *= reciprocal;
    W[i * n_ + i] = reciprocal;
  }
}

template <class S>
void ConstrainedDerivatives<S>::solve_contacts(const ConstrainedDynamics<S>& dynamics,
                                               const std::vector<int>& columns, S* x) {
  const int m = dynamics.rows();
  const Contradiction<S>& contradiction = dynamics.contradiction();
  if (contradiction.found) [[unlikely]]
    remove_null_part(contradiction, contradiction.present, m, std::span<const int>(columns), x, n_);
  if (dynamics.proximal_iterations > 0)
    for (int i = 0; i < m * n_; ++i) before_[i] = x[i];
  solve_delassus(dynamics.delassus(), m, std::span<const int>(columns), x, n_);
  const S mu(dynamics.solver().mu);
  for (int iteration = 0; iteration < dynamics.proximal_iterations; ++iteration) {
    // Each lane runs as many iterations as in forward(), whatever the other lanes do.
    const auto closed =
        mask_not(less(S(static_cast<double>(iteration)), dynamics.lane_iterations[0]));
    const bool some_closed = any(closed);
    for (int r = 0; r < m; ++r)
      for (const int j : columns) {
        S& entry = x[r * n_ + j];
        frozen_[r * n_ + j] = entry;
        entry = before_[r * n_ + j] + entry * mu;
      }
    solve_delassus(dynamics.delassus(), m, std::span<const int>(columns), x, n_);
    if (!some_closed) continue;
    for (int r = 0; r < m; ++r)
      for (const int j : columns)
        x[r * n_ + j] = select(closed, frozen_[r * n_ + j], x[r * n_ + j]);
  }
}

template <class S>
void ConstrainedDerivatives<S>::by_torque(const ConstrainedDynamics<S>& dynamics) {
  // With Z = J M^-1, dlambda/dtau = -G^-1 Z and da/dtau = M^-1 + Z^T dlambda/dtau.
  if (dynamics.tree().deep) {
    by_torque_deep(dynamics);
    return;
  }
  invert_factor(dynamics);
  const int m = dynamics.rows();
  const Delassus<S>& d = dynamics.delassus();
  const StridedView<const S> W{factor_inverse_.data(), n_};
  const StridedView<S> P{d_dtau.data(), n_};
  S* const lambda_rows = d_dtau.data() + n_ * n_;
  for (const Segment& s : segments_)
    gram<Gram::Set>(StridedView<const S>{d.T.data(), d.stride}, W,
                    std::span<const int>(s.ancestors), 0, m, s.first, s.end,
                    StridedView<S>{Z_.data(), n_});
  lambda_by_torque(dynamics);
  const std::span<const int> contact_rows(contact_rows_);
  for (std::size_t a = 0; a < segments_.size(); ++a)
    for (std::size_t b = 0; b <= a; ++b) {
      const Segment &x = segments_[a], &y = segments_[b];
      gram<Gram::Set>(W, W, std::span<const int>(shared_ancestors_[a * segments_.size() + b]),
                      x.first, x.end, y.first, y.end, P);
      if (m > 0)
        gram<Gram::Add>(StridedView<const S>{Z_.data(), n_}, StridedView<const S>{lambda_rows, n_},
                        contact_rows, x.first, x.end, y.first, y.end, P);
      if (a == b) continue;
      for (int i = x.first; i < x.end; ++i)
        for (int j = y.first; j < y.end; ++j) d_dtau[j * n_ + i] = d_dtau[i * n_ + j];
    }
}

/// Computes dlambda/dtau and its transpose from Z = J M^-1.
template <class S>
void ConstrainedDerivatives<S>::lambda_by_torque(const ConstrainedDynamics<S>& dynamics) {
  const int m = dynamics.rows();
  S* const lambda_rows = d_dtau.data() + n_ * n_;
  for (int i = 0; i < m * n_; ++i) lambda_rows[i] = -Z_[i];
  solve_contacts(dynamics, all_columns_, lambda_rows);
  for (int r = 0; r < m; ++r)
    for (int k = 0; k < n_; ++k) lambda_by_tau_[k * m + r] = lambda_rows[r * n_ + k];
}

template <class S>
void ConstrainedDerivatives<S>::by_torque_deep(const ConstrainedDynamics<S>& dynamics) {
  const int m = dynamics.rows();
  const Delassus<S>& d = dynamics.delassus();
  articulated_.invert(dynamics.kinematics(), dynamics.mass(), d_dtau.data());
  gram<Gram::Set>(StridedView<const S>{d.jacobian_by_v.data(), d.stride},
                  StridedView<const S>{d_dtau.data(), n_}, std::span<const int>(supported_columns_),
                  0, m, 0, n_, StridedView<S>{Z_.data(), n_});
  lambda_by_torque(dynamics);
  gram<Gram::Add>(
      StridedView<const S>{Z_.data(), n_}, StridedView<const S>{d_dtau.data() + n_ * n_, n_},
      std::span<const int>(contact_rows_), 0, n_, 0, n_, StridedView<S>{d_dtau.data(), n_});
}

template <class S>
void ConstrainedDerivatives<S>::by_state(const ConstrainedDynamics<S>& dynamics,
                                         const std::vector<S>& rhs, std::vector<S>& out) {
  // For z = q and z = v:
  // da/dz = -da/dtau dtau/dz - (dlambda/dtau)^T (minus dalpha/dz),
  // dlambda/dz = -dlambda/dtau dtau/dz + G^-1 (minus dalpha/dz).
  const int m = dynamics.rows();
  const bool deep = dynamics.tree().deep;
  for (std::size_t s = 0; s < segments_.size(); ++s) {
    const Segment& segment = segments_[s];
    const StridedView<const S> right{rhs.data(), n_};
    if (!deep)
      gram<Gram::SetNegative>(StridedView<const S>{d_dtau.data(), n_}, right,
                              std::span<const int>(segment_rows_[s]), 0, n_, segment.first,
                              segment.end, StridedView<S>{out.data(), n_});
    gram<Gram::SetNegative>(StridedView<const S>{lambda_by_tau_.data(), m}, right,
                            std::span<const int>(segment.related), 0, m, segment.first, segment.end,
                            StridedView<S>{out.data() + n_ * n_, n_});
  }
  if (deep)
    articulated_.solve_negative(dynamics.kinematics(), dynamics.mass(), rhs.data(), out.data(), n_,
                                n_);
  if (m == 0) return;
  for (int r = 0; r < m; ++r)
    for (const int j : supported_columns_) solved_[r * n_ + j] = rhs[(n_ + r) * n_ + j];
  solve_contacts(dynamics, supported_columns_, solved_.data());
  for (int r = 0; r < m; ++r)
    for (const int j : supported_columns_) out[(n_ + r) * n_ + j] += solved_[r * n_ + j];
  if (!deep) return;
  // Deep trees use an equivalent formula: da/dz = Z^T dlambda/dz - M^-1 dtau/dz.
  gram<Gram::Add>(
      StridedView<const S>{Z_.data(), n_}, StridedView<const S>{out.data() + n_ * n_, n_},
      std::span<const int>(contact_rows_), 0, n_, 0, n_, StridedView<S>{out.data(), n_});
}

// Let rho be the right-hand side of G lambda = rho with G = J M^-1 J^T, and n its component in the
// null space of G. J^T n is zero. With the pseudoinverse G^+, lambda = G^+ (rho - n). With
// Z = J M^-1, dlambda/dq is the derivative at constant n and null space, plus two terms:
//   G^+ G^+ Z d(J^T n)/dq, and the null-space component of d(J y)/dq with y = Z^T G^+ lambda.
// The rows of rhs_q are affine in lambda and a. Both terms are therefore computed from the
// difference between shifted_ and rhs_q; shifted_ is rhs_q at changed lambda and a.
template <class S>
void ConstrainedDerivatives<S>::fill_shifted_rows(ConstrainedDynamics<S>& dynamics) {
  const int m = dynamics.rows();
  by_torque(dynamics);
  for (int r = 0; r < m; ++r)
    for (const int j : all_columns_) solved_[r * n_ + j] = dynamics.lambda[r];
  solve_contacts(dynamics, all_columns_, solved_.data());
  a_ = dynamics.a;
  for (int r = 0; r < m; ++r)
    for (int k = 0; k < n_; ++k) dynamics.a[k] += Z_[r * n_ + k] * solved_[r * n_ + k];
  dynamics.apply_forces();
  fill_contact_rows(dynamics, dynamics.set().contacts());
  dynamics.a = a_;
  // `unmet` is -n, with n the null-space component of rho.
  dynamics.apply_forces(dynamics.contradiction().unmet.data());
  fill_joint_rows(dynamics);
  shifted_ = rhs_q;
}

template <class S>
void ConstrainedDerivatives<S>::add_contradiction(const ConstrainedDynamics<S>& dynamics) {
  const int m = dynamics.rows();
  for (std::size_t i = 0; i < shifted_.size(); ++i) shifted_[i] -= rhs_q[i];
  const std::span<const int> columns(all_columns_);
  for (int r = 0; r < m; ++r)
    for (int j = 0; j < n_; ++j) {
      S sum(0.0);
      for (int k = 0; k < n_; ++k) sum += Z_[r * n_ + k] * shifted_[k * n_ + j];
      solved_[r * n_ + j] = sum;
    }
  for (int pass = 0; pass < 2; ++pass) solve_contacts(dynamics, all_columns_, solved_.data());
  for (int r = 0; r < m; ++r)
    for (int k = 0; k < n_; ++k)
      for (int j = 0; j < n_; ++j) d_dq[k * n_ + j] += Z_[r * n_ + k] * solved_[r * n_ + j];
  // Subtracts the null-space component of the rows of lambda in shifted_, which are -d(J y)/dq.
  S* const by_y = shifted_.data() + n_ * n_;
  const Contradiction<S>& c = dynamics.contradiction();
  for (int i = 0; i < m * n_; ++i) d_dq[n_ * n_ + i] += solved_[i] - by_y[i];
  remove_null_part(c, c.present, m, columns, by_y, n_);
  for (int i = 0; i < m * n_; ++i) d_dq[n_ * n_ + i] += by_y[i];
}

template <class S>
void ConstrainedDerivatives<S>::forward(ConstrainedDynamics<S>& dynamics) {
  adapt_to_active(dynamics);
  const bool contradicts = dynamics.contradiction().found;
  if (contradicts) [[unlikely]]
    fill_shifted_rows(dynamics);
  dynamics.apply_forces();
  fill_contact_rows(dynamics, dynamics.set().contacts());
  fill_joint_rows(dynamics);
  subtract_friction(dynamics);
  by_torque(dynamics);
  by_state(dynamics, rhs_q, d_dq);
  by_state(dynamics, rhs_v, d_dv);
  if (contradicts) [[unlikely]]
    add_contradiction(dynamics);
  if (dynamics.friction().size() > 0) add_friction(dynamics);
  for (auto* matrix : {&d_dq, &d_dv, &d_dtau}) dynamics.clear_failed(*matrix);
}

}  // namespace burnish
