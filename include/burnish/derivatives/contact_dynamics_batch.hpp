// Contact dynamics of many states in one call; each SIMD lane computes one state.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "burnish/derivatives/contact_dynamics.hpp"

namespace burnish {

/// Returns the number of states that fit into one SIMD register of the processor that this library
/// was built for.
int pack_width();

/// Evaluates the contact dynamics of a batch of states with the same contacts. Results equal the
/// results of ContactDynamics up to rounding. They do not depend on the number of threads, or on
/// how states are split into batches. Only one call may run at a time. Allocates nothing after
/// construction.
class ContactDynamicsBatch {
 public:
  /// Prepares batches of up to `capacity` states, computed by `threads` threads including the
  /// calling thread. If `pin_threads` is true, each additional thread runs on its own core. The
  /// cores are chosen from those on which the calling thread may run. The first of these cores
  /// stays free for the calling thread.
  ///
  /// Throws Error for contacts that ContactDynamics rejects, and if `capacity` or `threads` is
  /// below 1. With pinned threads, also throws Error on systems other than Linux, and if there are
  /// more threads than cores.
  ContactDynamicsBatch(const Model& model, const std::vector<ContactSpec>& contacts, int capacity,
                       const ContactSolver& solver = {}, int threads = 1, bool pin_threads = false);
  ~ContactDynamicsBatch();
  ContactDynamicsBatch(ContactDynamicsBatch&&) noexcept;
  ContactDynamicsBatch& operator=(ContactDynamicsBatch&&) noexcept;

  void set_active(int contact, bool active);
  /// Sets the payload of the robot in all states; see ContactDynamics::set_payload().
  Status set_payload(std::string_view frame, const InertiaSpec& payload);
  int rows() const;
  int capacity() const;
  int threads() const;

  using ConstMatrixRef = Eigen::Ref<const Eigen::MatrixXd>;
  /// Computes the joint accelerations a and contact forces lambda of n states, one state per
  /// column: `q` is nq x n, `v` and `tau` are nv x n. At most capacity() states are allowed.
  /// Returns the most severe status of all states; status(i) returns the status of state i.
  Status forward(const ConstMatrixRef& q, const ConstMatrixRef& v, const ConstMatrixRef& tau);
  /// Computes a, lambda and their derivatives with respect to q, v and tau, for n states as in
  /// forward(). Returns the most severe status of all states.
  Status forward_with_derivatives(const ConstMatrixRef& q, const ConstMatrixRef& v,
                                  const ConstMatrixRef& tau);

  /// Returns the status of one state in the last call of forward() or forward_with_derivatives().
  /// Returns NotEvaluated if this call had fewer states, or if set_active() or set_payload() was
  /// called since. In these cases, the views a() to dlambda_dtau() have no valid result for the
  /// state. After forward(), derivatives still are those of an earlier forward_with_derivatives().
  Status status(int state) const;
  /// Returns a sentence about the status of one state that names the cause; see
  /// ContactDynamics::explanation().
  std::string explanation(int state) const;
  VectorView a(int state) const;       ///< Joint accelerations of a state, nv
  VectorView lambda(int state) const;  ///< Contact forces of a state, one per active row
  MatrixView da_dq(int state) const;   ///< nv x nv
  MatrixView da_dv(int state) const;
  MatrixView da_dtau(int state) const;
  MatrixView dlambda_dq(int state) const;  ///< rows x nv
  MatrixView dlambda_dv(int state) const;
  MatrixView dlambda_dtau(int state) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
