// d(a, lambda)/d(q, v, tau), Proposition 1 of the paper, for any scalar.
#pragma once

#include <vector>

#include "contact/constrained_dynamics.hpp"
#include "dynamics/articulated.hpp"

namespace burnish {

/// Workspace of the derivatives of one ConstrainedDynamics. Allocates when made, never afterwards.
///
/// All matrices are row-major with nv columns, stacked: the first nv rows belong to a, the
/// following rows() to lambda.
template <class S>
class ConstrainedDerivatives {
 public:
  explicit ConstrainedDerivatives(const ConstrainedDynamics<S>& dynamics);

  /// Of forward(), at the state and torque last given to it.
  void forward(ConstrainedDynamics<S>& dynamics);
  /// Of inverse(), at the state, a and lambda last given to it: fills dtau_dq and dtau_dv
  /// (dtau/da is M, dtau/dlambda is -J^T).
  void inverse(ConstrainedDynamics<S>& dynamics);
  /// Of acceleration(), at the state and a last given to it: the lambda rows of rhs_q and rhs_v
  /// hold minus d(alpha + kd nu + kp e)/dq and /dv (d/da is J).
  void acceleration(ConstrainedDynamics<S>& dynamics);
  /// Of impact(), at the state and velocity last given to it: d_dq, d_dv and d_dtau hold the
  /// derivatives of velocity_after (the first nv rows) and of the impulse lambda by q, by the
  /// velocity before and by an impulse on the joints (nv, Nms or Ns) that acts during the impact.
  void impact(ConstrainedDynamics<S>& dynamics);

  /// Right-hand sides: rows of a hold dtau/dq (dtau/dv) at constant a and lambda, rows of lambda
  /// hold minus the derivative of the contact acceleration at constant a.
  std::vector<S> rhs_q, rhs_v;
  /// Results of forward() and impact().
  std::vector<S> d_dq, d_dv, d_dtau;

 private:
  struct Segment {
    int first, end;  ///< entries of v in one unbranched chain
    std::vector<int>
        related;  ///< rows of rhs that are not zero in these columns; v part, ascending
    std::vector<int> ancestors;  ///< entries of v above and in the segment
  };
  /// The rows of rhs_q and rhs_v that belong to lambda, and those that belong to a.
  void fill_contact_rows(ConstrainedDynamics<S>& dynamics,
                         const std::vector<CompiledContact>& contacts);
  void fill_joint_rows(ConstrainedDynamics<S>& dynamics);
  /// What friction changes in the joints' rows with v.
  void subtract_friction(ConstrainedDynamics<S>& dynamics);
  /// Turns the results of the system without friction into those with it.
  void add_friction(ConstrainedDynamics<S>& dynamics);
  /// What rows that contradict each other add to the derivatives by q (contradiction.hpp): the rows
  /// of rhs_q at other forces and accelerations, before they are filled, and what follows from
  /// them.
  void fill_shifted_rows(ConstrainedDynamics<S>& dynamics);
  void add_contradiction(const ConstrainedDynamics<S>& dynamics);
  /// The same of an impact.
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
  int version_ = -1;  ///< of the active contacts that the lists below were made for
  std::vector<Segment> segments_;
  std::vector<std::vector<int>> shared_ancestors_;  ///< of two segments
  std::vector<std::vector<int>> segment_rows_;      ///< related and the rows of active contacts
  std::vector<int> all_columns_, contact_rows_, supported_columns_;
  std::vector<char> supported_;
  std::vector<Coriolis<S>> coriolis_;
  ArticulatedSolver<S> articulated_;
  std::vector<S> factor_inverse_;  ///< L^-T, row-major: entry (k, i) for ancestors k of i
  std::vector<S> Z_;               ///< J M^-1, rows x nv
  std::vector<S> lambda_by_tau_;   ///< (dlambda/dtau)^T, nv x rows
  std::vector<S> by_friction_;     ///< da by each normal force of friction, nv entries each
  std::vector<S> solved_, before_, frozen_;
  std::vector<S> shifted_, a_;  ///< of contradictions: as rhs_q, and nv; empty where none can be
};

}  // namespace burnish
