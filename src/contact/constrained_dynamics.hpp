// Forward and inverse dynamics of a robot in contact, eqs. (1) to (5) of the paper, for any scalar.
// This is the kernel; contact_dynamics.hpp wraps it for Eigen vectors and for batches of states.
#pragma once

#include <vector>

#include "burnish/base/status.hpp"
#include "contact/contradiction.hpp"
#include "contact/delassus.hpp"
#include "contact/friction_coupling.hpp"
#include "dynamics/inverse_dynamics.hpp"

namespace burnish {

/// Dynamics of a robot in contact, with the workspace of one thread. Only the constructor
/// allocates. S holds one state per lane.
template <class S>
class ConstrainedDynamics {
 public:
  static constexpr int lanes = Lanes<S>::count;

  ConstrainedDynamics(const Model& model, const ContactSet& set, const ContactSolver& solver);

  /// Activates or deactivates a contact. All contacts are active at first. Does not allocate.
  void set_active(int contact, bool active);

  /// Replaces the rotation of a contact's reference in each lane, from the next set_state() on. The
  /// columns of `rotation` are the axes of the reference, in the frame to which they are fixed.
  void set_reference_rotation(int contact, const Mat3<S>& rotation);

  /// Replaces the surface that a contact's reference follows, from the next set_state() on.
  void set_surface(int contact, const CurvedSurface<S>& surface) { surfaces_[contact] = surface; }

  /// Replaces the friction coefficient of a contact, from the next set_state() on.
  void set_friction(int contact, const S& coefficient) { coefficients_[contact] = coefficient; }

  /// Sets ContactState::step_ratio of all contacts, for the next set_state().
  void set_step_ratio(const S& step_ratio) {
    for (ContactState<S>& state : contact_states) state.step_ratio = step_ratio;
  }

  /// Replaces the inertia of a body in all lanes, from the next set_state() on.
  void set_body_inertia(int body, const BodyInertia& inertia) {
    burnish::set_body_inertia(tree_, body, inertia);
  }

  /// Loads one state per lane: q (nq) and v (nv). A lane with non-finite numbers or rotations that
  /// are not normalised gets an error status and is computed at the neutral posture.
  void set_state(const S* q, const S* v);
  /// Like set_state(q, v), but copies `known`, the kinematics of the same tree at (q, v).
  void set_state(const S* q, const S* v, const Kinematics<S>& known);

  /// Recomputes the active contacts at the loaded state, after contacts, references, surfaces or
  /// friction have changed. Does not recompute kinematics and mass matrix. Requires set_state().
  void update_contacts();

  /// Computes a and lambda at joint torques tau (nv), eq. (3). With friction, J^T lambda includes
  /// the torques of friction (friction_coupling.hpp). If a tool jams, the status is
  /// SingularContacts. Requires set_state().
  void forward(const S* tau);

  /// Computes tau = M a + b - J^T lambda minus the torques of friction, eq. (5). a has nv entries,
  /// lambda one entry for each row of the active contacts.
  void inverse(const S* a, const S* lambda);

  /// Computes alpha + kd nu + kp e in the active rows: contact acceleration alpha, plus gains times
  /// velocity nu and pose error e. `a`: joint accelerations (nv).
  void acceleration(const S* a);

  /// Computes the inelastic impact of the active contacts at q (nq), from the velocity v_before
  /// (nv):
  ///   M (v+ - v-) = J^T Lambda, J v+ = 0.
  /// Lambda is the impulse of the environment on the robot. This is eq. (3) with velocities in
  /// place of accelerations. mu and the proximal iterations act as in forward(), but tolerance and
  /// residual are in m/s. Gravity, bias, gains and pose errors have no effect.
  ///
  /// Fills velocity_after, lambda (the impulse [N s] or [N m s]) and a (the change v+ - v-).
  /// Statuses are those of forward(). Loads the state (q, 0) and leaves it loaded.
  void impact(const S* q, const S* v_before);

  Status status(int lane) const { return status_[lane]; }
  /// Returns the most severe status of all lanes.
  Status status() const;

  /// Returns true if entry k of v moves no mass of its own. The status is then SingularMass.
  bool moves_no_mass(int k, int lane) const {
    return has_mass_factor_ && Lanes<S>::get(mass_.inverse_diagonal[k], lane) == 0.0;
  }
  /// Returns true if the tool of a contact jams. The status is then SingularContacts.
  bool jams(int contact, int lane) const;
  /// Returns true if an active row depends on earlier rows. The status is then SingularContacts.
  bool is_dependent(int row, int lane) const {
    return has_delassus_ && Lanes<S>::get(delassus_.inverse_diagonal[row], lane) == 0.0;
  }

  int nv() const { return tree_.nv; }
  int rows() const { return active_.rows; }

  // Results. The comment of a result names the functions that set it.
  std::vector<S> a;                             ///< nv entries, set by forward, inverse, impact
  std::vector<S> lambda;                        ///< Active rows, set by forward, inverse, impact
  std::vector<S> tau;                           ///< nv entries, set by inverse
  std::vector<S> alpha;                         ///< Active rows, set by acceleration
  std::vector<S> velocity_after;                ///< nv entries, set by impact
  std::vector<ContactState<S>> contact_states;  ///< One state per contact of the set
  int proximal_iterations = 0;                  ///< Largest of all lanes, set by forward, impact
  std::vector<S> lane_iterations;               ///< One entry: proximal iterations of each lane
  /// One entry: largest |mu (lambda - previous lambda)| of each lane [m/s^2; in impact(): m/s]
  std::vector<S> proximal_residual;

  // Intermediate results, for the derivatives.
  const Tree& tree() const { return tree_; }
  const ContactSet& set() const { return set_; }
  const ActiveContacts& active() const { return active_; }
  /// Returns a counter that every set_active() increments.
  int active_version() const { return active_version_; }
  const ContactSolver& solver() const { return solver_; }
  const Kinematics<S>& kinematics() const { return kinematics_; }
  const MassMatrix<S>& mass() const { return mass_; }
  const Delassus<S>& delassus() const { return delassus_; }
  /// Returns the friction of the last forward().
  FrictionCoupling<S>& friction() { return friction_; }
  const FrictionCoupling<S>& friction() const { return friction_; }
  /// Returns the rows that contradict each other in the last forward() or impact().
  const Contradiction<S>& contradiction() const { return contradiction_; }
  InverseDynamics<S>& inverse_dynamics() { return id_; }
  /// Loads `a` into the inverse dynamics. Applies the contact forces lambda and their friction to
  /// the bodies. If `more` (one force per row) is given, also applies `more`, without friction.
  void apply_forces(const S* more = nullptr);
  /// Zeroes the meaningless results of lanes with a status more severe than NotConverged.
  void clear_failed(std::vector<S>& results) const;

 private:
  void load_lanes(const S* q, const S* v);
  void mark(const auto& bad, Status status, std::vector<Status>& of_lanes);
  /// Copies `count` values. A lane with a value that is not finite gets zeros and status NotFinite.
  void load_finite(const S* in, int count, S* out);
  void factorize_once();
  void drift(S* out);
  /// Calls visit(k, r) for every entry k of v that is coupled to the contact of an active row r.
  void for_each_coupled(const auto& visit) const;
  /// Solves for lambda (column 0 of rho_) and for the responses to friction (other columns).
  void solve_lambda();
  /// Calls visit(i, c) for every entry of rho_ in the columns `columns_`: i is its index in rho_, c
  /// its column.
  void for_each_solved(const auto& visit);
  /// Runs proximal iterations for the lanes in `open`. Returns the lanes that did not converge.
  auto refine(auto open);
  /// Solves again in those lanes of `open` whose rows contradict each other, after the null-space
  /// component of the right-hand side has been removed. Returns the lanes of `open` that did not
  /// converge.
  auto settle_contradiction(const auto& open);
  void update_friction();
  void add_friction();

  Tree tree_;
  ContactSet set_;
  ContactSolver solver_;
  ActiveContacts active_;
  int active_version_ = 0;
  std::vector<char> is_active_;
  std::vector<Mat3<S>> reference_axes_;     ///< Axes of each contact's reference, in its body
  std::vector<CurvedSurface<S>> surfaces_;  ///< Surface of each contact with a curved reference
  std::vector<S> coefficients_;             ///< Friction coefficient of each contact
  std::vector<S> q_neutral_;
  std::vector<S> q_, v_, drift_;
  /// Right-hand sides and solutions of the contact-space system, rows x stride_. Column 0 belongs
  /// to the contact forces, the other columns to friction.
  std::vector<S> rho_, solved_, solved_before_;
  int stride_;
  std::vector<int> columns_;           ///< Columns of rho_ to solve for
  std::vector<S> at_rest_;             ///< Zero velocity (nv), for impact()
  std::vector<Status> motion_status_;  ///< Status of state and mass matrix, per lane
  std::vector<Status> state_status_;   ///< Status of state, mass matrix and contacts, per lane
  std::vector<Status> status_;         ///< Status of the last evaluation, per lane
  bool has_mass_factor_ = false;       ///< Whether mass_ is factorized at the loaded state
  bool has_delassus_ = false;          ///< Whether delassus_ belongs to the active contacts
  Kinematics<S> kinematics_;
  MassMatrix<S> mass_;
  Delassus<S> delassus_;
  FrictionCoupling<S> friction_;
  Contradiction<S> contradiction_;
  InverseDynamics<S> id_;
};

}  // namespace burnish
