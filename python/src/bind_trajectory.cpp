// Bindings of Problem: values and derivatives of a whole trajectory.
#include "bind_ocp.hpp"
#include "specs_ocp.hpp"

namespace burnish::python {

namespace {

// Docstrings.

constexpr const char* problem_evaluate_doc = R"(Evaluates all knots of a trajectory.

Parameters
----------
xs : array_like, shape (N + 1, nx)
    States.
us : array_like, shape (N, max_controls)
    Controls.
threads : int
    Number of threads.

Returns
-------
TrajectoryValues
    Costs, next states and statuses.

Raises
------
Error
    If sizes are wrong.)";

constexpr const char* problem_expand_doc = R"(Evaluates all knots of a trajectory with derivatives.

Parameters
----------
xs : array_like, shape (N + 1, nx)
    States.
us : array_like, shape (N, max_controls)
    Controls.
threads : int
    Number of threads.

Returns
-------
TrajectoryExpansion
    Gradients, Gauss-Newton Hessians and linearized dynamics.

Raises
------
Error
    If sizes are wrong.)";

TrajectoryView trajectory(const char* call, const Problem& problem, const Numbers& xs,
                          const Numbers& us) {
  const auto check = [call](const char* name, const Numbers& m, int rows, int columns) {
    if (m.ndim() != 2 || m.shape(0) != rows || m.shape(1) != columns)
      throw Error(std::string(call) + ": " + name + " has the shape " +
                  std::string(py::str(m.attr("shape"))) + "; wanted (" + std::to_string(rows) +
                  ", " + std::to_string(columns) + ")");
  };
  check("xs", xs, problem.knots() + 1, problem.layout().nx());
  check("us", us, problem.knots(), problem.max_controls());
  return {xs.data(), us.data()};
}

/// Calls call(worker, range) for all ranges of knots on `threads` threads. Must be called without
/// the GIL.
template <class Call>
void for_each_range(ProblemMachine& machine, const char* name, int threads, Call&& call) {
  if (threads < 1)
    throw Error(std::string(name) + ": threads is " + std::to_string(threads) +
                "; wanted at least 1");
  machine.problem.prepare(threads);
  if (!machine.pool || machine.pool->workers() != threads)
    machine.pool = std::make_unique<ThreadPool>(threads);
  const std::span<const KnotRange> ranges = machine.problem.ranges();
  machine.pool->for_each(static_cast<int>(ranges.size()), [&](int worker, int piece) {
    call(worker, ranges[static_cast<std::size_t>(piece)]);
  });
}

/// Sets the members that TrajectoryValues and TrajectoryExpansion have in common.
template <class Answer>
void take_values(const std::vector<KnotValue>& values, const RowMatrix& next, Answer& answer) {
  answer.next_states = next.topRows(next.rows() - 1);
  answer.costs.resize(static_cast<Eigen::Index>(values.size()));
  for (std::size_t k = 0; k < values.size(); ++k) {
    answer.costs[static_cast<Eigen::Index>(k)] = values[k].cost;
    answer.statuses.push_back(values[k].status);
    answer.terms.push_back(values[k].term);
  }
}

TrajectoryValues evaluate(ProblemMachine& machine, const Numbers& xs, const Numbers& us,
                          int threads) {
  constexpr const char* call = "Problem.evaluate";
  const Busy::Lock lock(machine.busy, call);
  Problem& problem = machine.problem;
  const TrajectoryView at = trajectory(call, problem, xs, us);
  const py::gil_scoped_release release;
  std::vector<KnotValue> values(static_cast<std::size_t>(problem.knots()) + 1);
  RowMatrix next = RowMatrix::Zero(problem.knots() + 1, problem.layout().nx());
  for_each_range(machine, call, threads, [&](int worker, KnotRange range) {
    problem.evaluate(worker, range, at, next.data(), values.data());
  });
  TrajectoryValues answer;
  take_values(values, next, answer);
  return answer;
}

/// Memory for the expansions of a horizon.
struct ExpansionRoom {
  explicit ExpansionRoom(const Problem& problem) : nz(problem.layout().nz()) {
    const StateShape& state = problem.state();
    const auto knots = static_cast<std::size_t>(problem.knots()) + 1;
    const auto entries = static_cast<std::size_t>(nz);
    const auto rows = static_cast<std::size_t>(state.ndx);
    std::size_t tangent_blocks = 0;
    for (const NonEuclideanBlock& block : state.blocks)
      tangent_blocks += 2 * static_cast<std::size_t>(block.size * block.size);
    // The problem writes whole packs (SIMD vectors), which can extend beyond the end of a row.
    constexpr std::size_t slack = 16;
    const std::size_t stride = entries + slack;
    const std::size_t each = stride * (1 + entries + rows) + tangent_blocks + rows + slack;
    memory.assign(each * knots, 0.0);
    out.resize(knots);
    double* from = memory.data();
    for (KnotExpansion& e : out) {
      e.stride = static_cast<int>(stride);
      e.gradient = from;
      e.hessian = e.gradient + stride;
      e.dynamics = e.hessian + stride * entries;
      e.tangent_blocks = e.dynamics + stride * rows;
      e.decay = e.tangent_blocks + tangent_blocks;
      from += each;
    }
  }
  int nz;
  std::vector<double> memory;
  std::vector<KnotExpansion> out;
};

/// Writes the linearized dynamics of one knot as a dense matrix (ndx x nz). `e` may have any
/// DynamicsForm. Columns of controls that the knot lacks are zero.
void write_dynamics(const StateShape& state, const KnotExpansion& e, int nu, int max_nu,
                    Eigen::Ref<RowMatrix> F) {
  using Strided = Eigen::Map<const RowMatrix, Eigen::Unaligned, Eigen::OuterStride<>>;
  F.setZero();
  const int skip = max_nu - nu;
  const bool dense = e.form == DynamicsForm::Dense;
  const int rows = dense ? state.ndx : state.nv;
  const Strided given(e.dynamics, rows, nu + state.ndx, Eigen::OuterStride<>(e.stride));
  F.block(dense ? 0 : state.nv, skip, rows, nu + state.ndx) = given;
  if (dense) return;
  const int nv = state.nv, q = max_nu;
  RowMatrix A = RowMatrix::Identity(nv, nv), B = A;
  const double* tangent_blocks = e.tangent_blocks;
  for (const NonEuclideanBlock& block : state.blocks) {
    const Eigen::Map<const RowMatrix> a(tangent_blocks, block.size, block.size);
    const Eigen::Map<const RowMatrix> b(tangent_blocks + a.size(), block.size, block.size);
    A.block(block.first, block.first, block.size, block.size) = a;
    B.block(block.first, block.first, block.size, block.size) = b;
    tangent_blocks += 2 * a.size();
  }
  F.topRows(nv) = e.step * B * F.middleRows(nv, nv);
  F.block(0, q, nv, nv) += A;
  for (int i = 0; i < state.filtered; ++i) {
    F(2 * nv + i, q + 2 * nv + i) = e.decay[i];
    if (nu > 0) F(2 * nv + i, skip + i) = 1.0 - e.decay[i];
  }
}

/// Writes gradient and Hessian of a knot. Entries of controls that the knot lacks are zero.
void write_costs(const KnotExpansion& e, int n, Eigen::Ref<Eigen::RowVectorXd> gradient,
                 Eigen::Ref<RowMatrix> hessian) {
  const Eigen::Index skip = gradient.size() - n;
  gradient.setZero();
  hessian.setZero();
  gradient.tail(n) = Eigen::Map<const Eigen::RowVectorXd>(e.gradient, n);
  for (int r = 0; r < n; ++r)
    for (int c = 0; c <= r; ++c)
      hessian(skip + r, skip + c) = hessian(skip + c, skip + r) = e.hessian[r * e.stride + c];
}

TrajectoryExpansion expand(ProblemMachine& machine, const Numbers& xs, const Numbers& us,
                           int threads) {
  constexpr const char* call = "Problem.expand";
  const Busy::Lock lock(machine.busy, call);
  Problem& problem = machine.problem;
  const TrajectoryView at = trajectory(call, problem, xs, us);
  const int N = problem.knots(), ndx = problem.layout().ndx(), nz = problem.layout().nz();
  TrajectoryExpansion answer;
  answer.gradients.resize(N + 1, nz);
  answer.hessians = py::array_t<double>(std::vector<py::ssize_t>{N + 1, nz, nz});
  answer.dynamics = py::array_t<double>(std::vector<py::ssize_t>{N, ndx, nz});
  double *hessian = answer.hessians.mutable_data(), *F = answer.dynamics.mutable_data();

  const py::gil_scoped_release release;
  std::vector<KnotValue> values(static_cast<std::size_t>(N) + 1);
  RowMatrix next = RowMatrix::Zero(N + 1, problem.layout().nx());
  ExpansionRoom room(problem);
  for_each_range(machine, call, threads, [&](int worker, KnotRange range) {
    problem.expand(worker, range, at, next.data(), values.data(), room.out.data());
  });
  for (int k = 0; k <= N; ++k, hessian += nz * nz, F += ndx * nz) {
    const KnotExpansion& e = room.out[static_cast<std::size_t>(k)];
    const int nu = problem.controls(k);
    write_costs(e, nu + ndx, answer.gradients.row(k), Eigen::Map<RowMatrix>(hessian, nz, nz));
    if (k < N)
      write_dynamics(problem.state(), e, nu, problem.max_controls(),
                     Eigen::Map<RowMatrix>(F, ndx, nz));
  }
  take_values(values, next, answer);
  return answer;
}

}  // namespace

void bind_trajectory(ProblemClass& c) {
  c.def("evaluate", &evaluate, py::arg("xs"), py::arg("us"), py::arg("threads") = 1,
        problem_evaluate_doc)
      .def("expand", &expand, py::arg("xs"), py::arg("us"), py::arg("threads") = 1,
           problem_expand_doc);
}

}  // namespace burnish::python
