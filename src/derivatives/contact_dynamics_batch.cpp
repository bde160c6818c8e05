#include "burnish/derivatives/contact_dynamics_batch.hpp"

#include <algorithm>

#include "base/thread_pool.hpp"
#include "base/to_size.hpp"
#include "derivatives/constrained_derivatives.hpp"
#include "derivatives/explanation.hpp"
#include "math/pack.hpp"

namespace burnish {

extern template class ConstrainedDynamics<NativePack>;
extern template class ConstrainedDerivatives<NativePack>;

int pack_width() { return native_lanes; }

namespace {

/// Loads column `first + lane` of a matrix into each lane. Lanes past the end repeat the last
/// column.
void gather(const Eigen::Ref<const Eigen::MatrixXd>& from, int first, std::vector<NativePack>& to) {
  const int last = static_cast<int>(from.cols()) - 1;
  for (int l = 0; l < native_lanes; ++l) {
    const double* column =
        from.data() + static_cast<std::ptrdiff_t>(std::min(first + l, last)) * from.outerStride();
    for (Eigen::Index i = 0; i < from.rows(); ++i) to[i].v[l] = column[i];
  }
}

/// Implements scatter(). Inlining lets the compiler treat `lanes` as a constant.
BURNISH_INLINE void scatter_lanes(const NativePack* from, int count, double* out, int stride,
                                  int lanes) {
  int i = 0;
  for (; i + native_lanes <= count; i += native_lanes)
    unpack(from + i, lanes, [&](int l) { return out + l * stride + i; });
  for (; i < count; ++i)
    for (int l = 0; l < lanes; ++l) out[l * stride + i] = from[i].v[l];
}

/// Stores lane l of `count` packs at out + l * stride.
void scatter(const NativePack* from, int count, double* out, int stride, int lanes) {
  if (lanes == native_lanes) {
    scatter_lanes(from, count, out, stride, native_lanes);
  } else {
    scatter_lanes(from, count, out, stride, lanes);
  }
}

}  // namespace

struct ContactDynamicsBatch::Impl {
  /// Workspace of one thread.
  struct Worker {
    Worker(const Model& model, const ContactSet& set, const ContactSolver& solver)
        : dynamics(model, set, solver),
          derivatives(dynamics),
          q(to_size(model.nq)),
          v(to_size(model.nv)),
          tau(to_size(model.nv)) {}

    ConstrainedDynamics<NativePack> dynamics;
    ConstrainedDerivatives<NativePack> derivatives;
    std::vector<NativePack> q, v, tau;
  };

  Impl(const Model& model, const std::vector<ContactSpec>& specs, int max_states,
       const ContactSolver& solver, int threads, bool pin_threads)
      : robot(model),
        set(model, specs),
        nq(model.nq),
        nv(model.nv),
        capacity(max_states),
        pool(threads, pin_threads ? Pinning::Cores : Pinning::None) {
    if (max_states < 1)
      throw Error("ContactDynamicsBatch: capacity is " + std::to_string(max_states) +
                  " states; wanted at least 1");
    workers.reserve(to_size(threads));
    for (int w = 0; w < threads; ++w) workers.emplace_back(model, set, solver);
    const auto states = to_size(max_states);
    invalidate();
    causes.assign(states * (nv + set.rows()), 0);
    for (const int joint : model.joint_of_v) joint_names.push_back(model.joints[joint].name);
    a.assign(states * nv, 0.0);
    lambda.assign(states * set.rows(), 0.0);
    unmet.assign(states * set.rows(), 0.0);
    for (auto* matrix : {&d_dq, &d_dv, &d_dtau})
      matrix->assign(states * (nv + set.rows()) * nv, 0.0);
  }

  Status run(const ConstMatrixRef& q_in, const ConstMatrixRef& v_in, const ConstMatrixRef& tau_in,
             bool with_derivatives) {
    const int n = static_cast<int>(q_in.cols());
    const bool fits = n > 0 && n <= capacity && q_in.rows() == nq && v_in.rows() == nv &&
                      tau_in.rows() == nv && v_in.cols() == n && tau_in.cols() == n;
    if (!fits) return Status::WrongSize;
    // A piece has so many states that the overhead of the thread pool is negligible.
    constexpr int states_per_piece = 8 * native_lanes;
    pool.for_each((n + states_per_piece - 1) / states_per_piece, [&](int worker, int piece) {
      const int end = std::min(n, (piece + 1) * states_per_piece);
      for (int first = piece * states_per_piece; first < end; first += native_lanes)
        run_pack(workers[to_size(worker)], q_in, v_in, tau_in, first, with_derivatives);
    });
    std::fill(status.begin() + n, status.end(), Status::NotEvaluated);
    Status worst_of_all = Status::Ok;
    for (int i = 0; i < n; ++i) worst_of_all = worst(worst_of_all, status[i]);
    return worst_of_all;
  }

  void run_pack(Worker& with, const ConstMatrixRef& q_in, const ConstMatrixRef& v_in,
                const ConstMatrixRef& tau_in, int first, bool with_derivatives) {
    gather(q_in, first, with.q);
    gather(v_in, first, with.v);
    gather(tau_in, first, with.tau);
    with.dynamics.set_state(with.q.data(), with.v.data());
    with.dynamics.forward(with.tau.data());
    if (with_derivatives) with.derivatives.forward(with.dynamics);
    const int lanes = std::min(native_lanes, static_cast<int>(q_in.cols()) - first);
    store(with, first, lanes, with_derivatives);
    for (int l = 0; l < lanes; ++l) {
      status[first + l] = with.dynamics.status(l);
      if (status[first + l] == Status::Ok) [[likely]]
        continue;
      record_causes(with.dynamics, l, causes.data() + (first + l) * (nv + set.rows()));
      const std::vector<NativePack>& residual = with.dynamics.contradiction().unmet;
      for (std::size_t r = 0; r < residual.size(); ++r)
        unmet[to_size((first + l) * set.rows()) + r] = residual[r].v[l];
    }
  }

  /// Writes the causes of a failure to `out`, as a code per entry of v, then a code per row. 0: no
  /// cause; 1: the entry moves no mass, or the row is dependent; 2: the row is the normal of a tool
  /// that jams.
  void record_causes(const ConstrainedDynamics<NativePack>& dynamics, int lane, char* out) const {
    for (int k = 0; k < nv; ++k) out[k] = dynamics.moves_no_mass(k, lane) ? 1 : 0;
    for (int r = 0; r < dynamics.rows(); ++r) out[nv + r] = dynamics.is_dependent(r, lane) ? 1 : 0;
    for (const int c : dynamics.friction().contacts)
      if (dynamics.jams(c, lane)) out[nv + dynamics.active().first_row[c]] = 2;
  }

  void store(const Worker& from, std::ptrdiff_t first, int lanes, bool with_derivatives) {
    const int m = rows();
    scatter(from.dynamics.a.data(), nv, a.data() + first * nv, nv, lanes);
    scatter(from.dynamics.lambda.data(), m, lambda.data() + first * set.rows(), set.rows(), lanes);
    if (!with_derivatives) return;
    const int stride = static_cast<int>(block(1));
    const int count = (nv + m) * nv;
    scatter(from.derivatives.d_dq.data(), count, d_dq.data() + block(first), stride, lanes);
    scatter(from.derivatives.d_dv.data(), count, d_dv.data() + block(first), stride, lanes);
    scatter(from.derivatives.d_dtau.data(), count, d_dtau.data() + block(first), stride, lanes);
  }

  /// Invalidates all results.
  void invalidate() { status.assign(to_size(capacity), Status::NotEvaluated); }
  int rows() const { return workers.front().dynamics.rows(); }
  /// Returns the offset of a state's derivatives. It can exceed the range of int.
  std::ptrdiff_t block(std::ptrdiff_t state) const { return state * (nv + set.rows()) * nv; }
  MatrixView rows_of_a(const std::vector<double>& stacked, int state) const {
    return {stacked.data() + block(state), nv, nv};
  }
  MatrixView rows_of_lambda(const std::vector<double>& stacked, int state) const {
    return {stacked.data() + block(state) + nv * nv, rows(), nv};
  }

  Model robot;
  ContactSet set;
  int nq, nv, capacity;
  ThreadPool pool;
  std::vector<Worker> workers;  ///< One per thread
  std::vector<Status> status;
  std::vector<char> causes;                ///< nv + rows codes per state; valid unless status Ok
  std::vector<std::string> joint_names;    ///< Joint of each entry of v
  std::vector<double> a, lambda;           ///< nv and rows entries per state
  std::vector<double> unmet;               ///< rows entries per state; valid unless status Ok
  std::vector<double> d_dq, d_dv, d_dtau;  ///< (nv + rows) x nv per state, row-major
};

ContactDynamicsBatch::ContactDynamicsBatch(const Model& model,
                                           const std::vector<ContactSpec>& contacts, int capacity,
                                           const ContactSolver& solver, int threads,
                                           bool pin_threads)
    : impl_(std::make_unique<Impl>(model, contacts, capacity, solver, threads, pin_threads)) {}
ContactDynamicsBatch::~ContactDynamicsBatch() = default;
ContactDynamicsBatch::ContactDynamicsBatch(ContactDynamicsBatch&&) noexcept = default;
ContactDynamicsBatch& ContactDynamicsBatch::operator=(ContactDynamicsBatch&&) noexcept = default;

void ContactDynamicsBatch::set_active(int contact, bool active) {
  if (contact < 0 || contact >= impl_->set.size())
    throw Error("set_active: contact " + std::to_string(contact) + " does not exist; the set has " +
                std::to_string(impl_->set.size()) + " contacts");
  for (Impl::Worker& worker : impl_->workers) worker.dynamics.set_active(contact, active);
  impl_->invalidate();
}
Status ContactDynamicsBatch::set_payload(std::string_view frame, const InertiaSpec& payload) {
  const LoadedBody loaded = loaded_body("set_payload", impl_->robot, frame, payload);
  if (loaded.status != Status::Ok) return loaded.status;
  for (Impl::Worker& worker : impl_->workers)
    worker.dynamics.set_body_inertia(loaded.body, body_inertia(loaded.inertia));
  impl_->invalidate();
  return Status::Ok;
}
int ContactDynamicsBatch::rows() const { return impl_->rows(); }
int ContactDynamicsBatch::capacity() const { return impl_->capacity; }
int ContactDynamicsBatch::threads() const { return impl_->pool.workers(); }

Status ContactDynamicsBatch::forward(const ConstMatrixRef& q, const ConstMatrixRef& v,
                                     const ConstMatrixRef& tau) {
  return impl_->run(q, v, tau, false);
}
Status ContactDynamicsBatch::forward_with_derivatives(const ConstMatrixRef& q,
                                                      const ConstMatrixRef& v,
                                                      const ConstMatrixRef& tau) {
  return impl_->run(q, v, tau, true);
}

Status ContactDynamicsBatch::status(int state) const { return impl_->status.at(state); }
std::string ContactDynamicsBatch::explanation(int state) const {
  const Status status = impl_->status.at(state);
  const char* const causes =
      impl_->causes.data() + static_cast<std::ptrdiff_t>(state) * (impl_->nv + impl_->set.rows());
  std::vector<std::string> joints, rows, jammed, names;
  if (status == Status::Ok || status == Status::NotEvaluated)
    return explain(status, joints, rows, jammed);
  for (int k = 0; k < impl_->nv; ++k)
    if (causes[k] != 0) joints.push_back(impl_->joint_names[k]);
  int row = 0;
  for (const int c : impl_->workers.front().dynamics.active().contacts)
    for (const int d : impl_->set.contacts()[c].directions) {
      const ContactSpec& spec = impl_->set.contacts()[c].spec;
      const char cause = causes[impl_->nv + row++];
      names.push_back(spec.name + "/" + std::string(direction_names[d]));
      if (cause == 1) rows.push_back(names.back());
      if (cause == 2) jammed.push_back(spec.name);
    }
  const double* const residual =
      impl_->unmet.data() + static_cast<std::ptrdiff_t>(state) * impl_->set.rows();
  return explain(status, joints, rows, jammed, unmet_rows(names, {residual, names.size()}));
}
VectorView ContactDynamicsBatch::a(int state) const {
  return {impl_->a.data() + static_cast<std::ptrdiff_t>(state) * impl_->nv, impl_->nv};
}
VectorView ContactDynamicsBatch::lambda(int state) const {
  return {impl_->lambda.data() + static_cast<std::ptrdiff_t>(state) * impl_->set.rows(), rows()};
}
MatrixView ContactDynamicsBatch::da_dq(int state) const {
  return impl_->rows_of_a(impl_->d_dq, state);
}
MatrixView ContactDynamicsBatch::da_dv(int state) const {
  return impl_->rows_of_a(impl_->d_dv, state);
}
MatrixView ContactDynamicsBatch::da_dtau(int state) const {
  return impl_->rows_of_a(impl_->d_dtau, state);
}
MatrixView ContactDynamicsBatch::dlambda_dq(int state) const {
  return impl_->rows_of_lambda(impl_->d_dq, state);
}
MatrixView ContactDynamicsBatch::dlambda_dv(int state) const {
  return impl_->rows_of_lambda(impl_->d_dv, state);
}
MatrixView ContactDynamicsBatch::dlambda_dtau(int state) const {
  return impl_->rows_of_lambda(impl_->d_dtau, state);
}

}  // namespace burnish
