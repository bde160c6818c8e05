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

/// Workspace of one thread: allocates when made, never afterwards. S carries one state per lane.
template <class S>
class ConstrainedDynamics {
 public:
  static constexpr int lanes = Lanes<S>::count;

  ConstrainedDynamics(const Model& model, const ContactSet& set, const ContactSolver& solver);

  /// Chooses the active contacts; all are active at first. No allocation.
  void set_active(int contact, bool active);

  /// Another rotation in the place of that of a contact's reference, per lane; of the states loaded
  /// from then on. Its columns are the reference's axes in what they are fixed in.
  void set_reference_rotation(int contact, const Mat3<S>& rotation);

  /// Another surface in the place of the one that a contact's reference follows, likewise.
  void set_surface(int contact, const CurvedSurface<S>& surface) { surfaces_[contact] = surface; }

  /// Another coefficient of a contact's friction, likewise.
  void set_friction(int contact, const S& coefficient) { coefficients_[contact] = coefficient; }

  /// ContactState::pace of all contacts, likewise.
  void set_pace(const S& pace) {
    for (ContactState<S>& state : contact_states) state.pace = pace;
  }

  /// Another mass distribution in the place of that of a body, the same in all lanes; likewise.
  void set_body_inertia(int body, const BodyInertia& inertia) {
    burnish::set_body_inertia(tree_, body, inertia);
  }

  /// Loads a state: lane l of q (nq) and v (nv). Lanes that are not finite or not normalised are
  /// marked and computed at the neutral posture instead.
  void set_state(const S* q, const S* v);

  /// a and lambda at joint torques tau (nv), eq. (3), with what friction adds to J^T lambda
  /// (friction_coupling.hpp); SingularContacts where a tool jams. Needs set_state.
  void forward(const S* tau);

  /// tau = M a + b - J^T lambda less the torques of friction, eq. (5), with a: nv, lambda: rows of
  /// the active contacts.
  void inverse(const S* a, const S* lambda);

  /// alpha + kd nu + kp e of the active rows at joint accelerations a (nv), without solving for a.
  void acceleration(const S* a);

  /// Inelastic impact of the active contacts at q (nq) and the velocity before it, v_before (nv):
  ///   M (v+ - v-) = J^T Lambda, J v+ = 0,
  /// with the impulse Lambda of the environment on the robot; that is eq. (3) with velocities in
  /// the place of accelerations, and mu and the proximal iterations act alike (tolerance and
  /// residual are then in m/s). Gravity, bias, gains and error play no part. Fills velocity_after,
  /// lambda (the impulse, Ns or Nms) and a (the velocity change v+ - v-), with the statuses of
  /// forward. Needs no set_state: loads the state (q, 0) itself and leaves it loaded.
  void impact(const S* q, const S* v_before);

  Status status(int lane) const { return status_[lane]; }
  /// The most severe status of all lanes.
  Status status() const;

  /// What a SingularMass is to blame on in a lane: entry k of v moves no mass of its own.
  bool moves_no_mass(int k, int lane) const {
    return factorized_ && Lanes<S>::get(mass_.inverse_diagonal[k], lane) == 0.0;
  }
  /// What a SingularContacts is to blame on where it is not that: the tool of a contact jams.
  bool jams(int contact, int lane) const;
  /// What a SingularContacts is to blame on: the active row depends on those before it.
  bool is_dependent(int row, int lane) const {
    return factorized_ && Lanes<S>::get(delassus_.inverse_diagonal[row], lane) == 0.0;
  }

  int nv() const { return tree_.nv; }
  int rows() const { return active_.rows; }

  // Results, valid after the call that fills them.
  std::vector<S> a;                             ///< nv, by forward, inverse or impact
  std::vector<S> lambda;                        ///< rows, by forward, inverse or impact
  std::vector<S> tau;                           ///< nv, by inverse
  std::vector<S> alpha;                         ///< rows, by acceleration
  std::vector<S> velocity_after;                ///< nv, by impact
  std::vector<ContactState<S>> contact_states;  ///< per contact of the set
  int proximal_iterations = 0;                  ///< by forward or impact, most of all lanes
  std::vector<S> lane_iterations;    ///< 1 entry: those of each lane, which is frozen after them
  std::vector<S> proximal_residual;  ///< 1 entry: largest |mu (lambda - previous)|, m/s^2

  // Stages, for the derivatives that build on them.
  const Tree& tree() const { return tree_; }
  const ContactSet& set() const { return set_; }
  const ActiveContacts& active() const { return active_; }
  /// Changes with every set_active.
  int active_version() const { return active_version_; }
  const ContactSolver& solver() const { return solver_; }
  const Kinematics<S>& kinematics() const { return kinematics_; }
  const MassMatrix<S>& mass() const { return mass_; }
  const Delassus<S>& delassus() const { return delassus_; }
  /// Of the last forward.
  FrictionCoupling<S>& friction() { return friction_; }
  const FrictionCoupling<S>& friction() const { return friction_; }
  /// Of the last forward or impact: rows that contradict each other, which the forces leave unmet.
  const Contradiction<S>& contradiction() const { return contradiction_; }
  InverseDynamics<S>& inverse_dynamics() { return id_; }
  /// Loads `a` into the inverse dynamics stage and applies the contact forces to its bodies; with
  /// `more` (rows), those of lambda + more, the friction of lambda alone.
  void apply_forces(const S* more = nullptr);
  /// Zeroes the lanes whose status is above NotConverged: what they hold is finite but means
  /// nothing.
  void clear_failed(std::vector<S>& results) const;

 private:
  void mark_bad_lanes(const S* q, const S* v);
  void mark(const auto& bad, Status status, std::vector<Status>& of_lanes);
  /// Copies an input and marks the lanes that are not finite; they get zeros.
  void load_finite(const S* in, int count, S* out);
  void factorize_once();
  void drift(S* out);
  /// Calls visit(k, r) for every entry k of v that is coupled to the contact of an active row r.
  void for_each_coupled(const auto& visit) const;
  /// lambda from column 0 of rho_, and the responses to friction from the others.
  void solve_lambda();
  /// Calls visit(i, c) for every entry i of rho_ in a column c that is solved for.
  void for_each_solved(const auto& visit);
  /// Proximal iterations of the lanes in `open`. Returns those that did not converge.
  auto refine(auto open);
  /// Of the lanes in `open`, those whose rows contradict each other are solved again without what
  /// no force can meet. Returns those that did not converge.
  auto settle_contradiction(const auto& open);
  void update_friction();
  void add_friction();

  Tree tree_;
  ContactSet set_;
  ContactSolver solver_;
  ActiveContacts active_;
  int active_version_ = 0;
  std::vector<char> is_active_;
  std::vector<Mat3<S>> reference_axes_;     ///< per contact, in the body that they are fixed in
  std::vector<CurvedSurface<S>> surfaces_;  ///< per contact, read where its reference is curved
  std::vector<S> coefficients_;             ///< per contact, read where it rubs
  std::vector<S> q_neutral_;
  std::vector<S> q_, v_, drift_;
  /// rows x stride_: right-hand sides and solutions of the contact-space system, that of the forces
  /// first and those of friction behind it
  std::vector<S> rho_, solved_, solved_before_;
  int stride_;
  std::vector<int> columns_;          ///< those that are solved for
  std::vector<S> at_rest_;            ///< nv zeros
  std::vector<Status> state_status_;  ///< per lane, of the state and its factors
  std::vector<Status> status_;        ///< per lane, of the last evaluation
  bool factorized_ = false;
  Kinematics<S> kinematics_;
  MassMatrix<S> mass_;
  Delassus<S> delassus_;
  FrictionCoupling<S> friction_;
  Contradiction<S> contradiction_;
  InverseDynamics<S> id_;
};

}  // namespace burnish
