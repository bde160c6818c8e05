// Contact dynamics of many states at once, packed: one state per SIMD lane.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "burnish/derivatives/contact_dynamics.hpp"

namespace burnish {

/// States that one register of the processor this library was built for holds.
int pack_width();

/// Evaluates a batch of states with the same contacts. Results equal those of ContactDynamics state
/// by state, to rounding, and depend neither on how a batch is cut nor on the number of threads.
/// One call at a time; nothing is allocated after construction.
class ContactDynamicsBatch {
 public:
  /// Room for `capacity` states, shared out among `threads`, the calling one included. Pinned,
  /// thread i of the others stays on the i-th core that the calling thread may run on. Throws Error
  /// as ContactDynamics does, for no room and no threads, and for pinning to fewer cores than
  /// threads or on a system that cannot pin (other than Linux).
  ContactDynamicsBatch(const Model& model, const std::vector<ContactSpec>& contacts, int capacity,
                       const ContactSolver& solver = {}, int threads = 1, bool pin_threads = false);
  ~ContactDynamicsBatch();
  ContactDynamicsBatch(ContactDynamicsBatch&&) noexcept;
  ContactDynamicsBatch& operator=(ContactDynamicsBatch&&) noexcept;

  void set_active(int contact, bool active);
  /// As ContactDynamics::set_payload, of all states.
  Status set_payload(std::string_view frame, const InertiaSpec& payload);
  int rows() const;
  int capacity() const;
  int threads() const;

  using ConstMatrixRef = Eigen::Ref<const Eigen::MatrixXd>;
  /// One state per column: q is nq x n, v and tau nv x n, n at most capacity. Fills a and lambda.
  /// Returns the most severe status; see status(i).
  Status forward(const ConstMatrixRef& q, const ConstMatrixRef& v, const ConstMatrixRef& tau);
  /// The same, and the six derivative blocks.
  Status forward_with_derivatives(const ConstMatrixRef& q, const ConstMatrixRef& v,
                                  const ConstMatrixRef& tau);

  /// Returns the status of one state of the last call: NotEvaluated if the call had no such state,
  /// and for every state after set_active() or set_payload(). The views below hold no result of
  /// such a state. Derivatives are those of the last forward_with_derivatives().
  Status status(int state) const;
  /// The same in one sentence that names what is to blame, as ContactDynamics::explanation does.
  std::string explanation(int state) const;
  VectorView a(int state) const;       ///< nv
  VectorView lambda(int state) const;  ///< rows
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
