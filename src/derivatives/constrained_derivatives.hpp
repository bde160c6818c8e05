// Derivatives of a and lambda by q, v and tau (Proposition 1 in docs/theory.md), for any scalar.
#pragma once

#include <vector>

#include "contact/constrained_dynamics.hpp"
#include "dynamics/articulated.hpp"

namespace burnish {

/// Derivatives of the results of one ConstrainedDynamics, with workspace. Only the constructor
/// allocates.
///
/// All matrices are row-major with nv columns. The first nv rows belong to a, the next rows() to
/// lambda.
template <class S>
class ConstrainedDerivatives {
 public:
  explicit ConstrainedDerivatives(const ConstrainedDynamics<S>& dynamics);

  /// Computes the derivatives of the last forward() of `dynamics`.
  void forward(ConstrainedDynamics<S>& dynamics);
  /// Computes the derivatives of the last inverse(). The first nv rows of rhs_q and rhs_v then hold
  /// dtau/dq and dtau/dv (dtau/da is M, dtau/dlambda is -J^T).
  void inverse(ConstrainedDynamics<S>& dynamics);
  /// Computes the derivatives of the last acceleration(). The rows of rhs_q and rhs_v after the
  /// first nv then hold the negated derivatives of alpha + kd nu + kp e by q and v. (The derivative
  /// by a is J.)
  void acceleration(ConstrainedDynamics<S>& dynamics);
  /// Computes the derivatives of the last impact(). The first nv rows of d_dq, d_dv and d_dtau
  /// belong to velocity_after, the other rows to the impulse lambda. The derivatives are by q, by
  /// the velocity before the impact, and by an impulse on the joints during the impact (nv) [N m s,
  /// N s].
  void impact(ConstrainedDynamics<S>& dynamics);

  /// Right-hand sides. The first nv rows hold dtau/dq and dtau/dv at constant a and lambda. The
  /// other rows hold minus the derivatives of the contact acceleration at constant a.
  std::vector<S> rhs_q, rhs_v;
  /// Results of forward() and impact().
  std::vector<S> d_dq, d_dv, d_dtau;

 private:
  /// Unbranched chain of entries of v.
  struct Segment {
    int first, end;              ///< Entries of v in the chain
    std::vector<int> related;    ///< Joint rows of rhs that are nonzero in these columns, ascending
    std::vector<int> ancestors;  ///< Entries of v in the chain and above it
  };
  /// Fill the contact rows (after the first nv rows) and the joint rows of rhs_q and rhs_v.
  void fill_contact_rows(ConstrainedDynamics<S>& dynamics,
                         const std::vector<CompiledContact>& contacts);
  void fill_joint_rows(ConstrainedDynamics<S>& dynamics);
  /// Subtracts the derivative of friction by v from the first nv rows of rhs_v.
  void subtract_friction(ConstrainedDynamics<S>& dynamics);
  /// Adds the effect of friction to results that were computed without friction.
  void add_friction(ConstrainedDynamics<S>& dynamics);
  /// Correct d_dq if rows contradict each other (contradiction.hpp). Before rhs_q is filled,
  /// fill_shifted_rows() computes shifted_: the rows of rhs_q at changed forces and accelerations.
  /// add_contradiction() corrects d_dq after its computation.
  void fill_shifted_rows(ConstrainedDynamics<S>& dynamics);
  void add_contradiction(const ConstrainedDynamics<S>& dynamics);
  /// Fills rhs_q and rhs_v for an impact.
  void fill_impact_rows(ConstrainedDynamics<S>& dynamics);
  void adapt_to_active(const ConstrainedDynamics<S>& dynamics);
  void invert_factor(const ConstrainedDynamics<S>& dynamics);
  void by_torque(const ConstrainedDynamics<S>& dynamics);
  void by_torque_deep(const ConstrainedDynamics<S>& dynamics);
  void lambda_by_torque(const ConstrainedDynamics<S>& dynamics);
  void solve_contacts(const ConstrainedDynamics<S>& dynamics, const std::vector<int>& columns,
                      S* x);
  void by_state(const ConstrainedDynamics<S>& dynamics, const std::vector<S>& rhs,
                std::vector<S>& out);

  int n_;
  std::vector<CompiledContact> contacts_without_gains_;
  int version_ = -1;  ///< active_version() for which the lists of rows are valid
  std::vector<Segment> segments_;
  std::vector<std::vector<int>> shared_ancestors_;  ///< Common ancestors of each pair of segments
  std::vector<std::vector<int>> segment_rows_;      ///< Joint and contact rows of each segment
  std::vector<int> all_columns_, contact_rows_, supported_columns_;
  std::vector<char> supported_;
  ArticulatedSolver<S> articulated_;
  std::vector<S> factor_inverse_;  ///< L^-T, row-major: entry (k, i) for ancestors k of i
  std::vector<S> Z_;               ///< J M^-1, rows x nv
  std::vector<S> lambda_by_tau_;   ///< (dlambda/dtau)^T, nv x rows
  std::vector<S> by_friction_;     ///< da per unit of normal force, nv entries per sliding contact
  std::vector<S> solved_, before_, frozen_;
  /// Change of rhs_q due to contradictory rows, and a copy of a; empty without proximal iterations
  std::vector<S> shifted_, a_;
};

}  // namespace burnish
