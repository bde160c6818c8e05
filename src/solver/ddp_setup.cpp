// Memory of a solver, and initialisation of each solve.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/to_size.hpp"
#include "solver/ddp_impl.hpp"
#include "solver/dense.hpp"
#include "solver/linear_dynamics.hpp"

namespace burnish {
namespace {

void require(bool holds, const std::string& sentence) {
  if (!holds) throw Error("solver: " + sentence);
}

void check_shape(const ShootingProblem& problem) {
  const StateShape& s = problem.state();
  require(problem.knots() >= 1,
          "the problem has " + std::to_string(problem.knots()) + " knots; wanted at least 1");
  require(s.nx >= 1 && s.ndx >= 1 && s.ndx <= s.nx,
          "nx = " + std::to_string(s.nx) + " and ndx = " + std::to_string(s.ndx) +
              " are not valid sizes of a state; wanted 1 <= ndx <= nx");
  require(s.nv == 0 ? s.filtered == 0 : s.ndx == 2 * s.nv + s.filtered,
          "ndx is " + std::to_string(s.ndx) + "; wanted 2 nv + filtered = " +
              std::to_string(2 * s.nv + s.filtered) + ", or nv = filtered = 0");
  for (const NonEuclideanBlock& b : s.blocks)
    require(b.first >= 0 && b.size >= 1 && b.size <= max_tangent_size && b.first + b.size <= s.nv,
            "a non-Euclidean tangent block has " + std::to_string(b.size) + " entries at " +
                std::to_string(b.first) + "; wanted 1 to " + std::to_string(max_tangent_size) +
                " entries within the " + std::to_string(s.nv) + " entries of dq");
  for (int k = 0; k <= problem.knots(); ++k) {
    const int nu = problem.controls(k);
    require(nu >= 0 && nu <= problem.max_controls() && (k < problem.knots() || nu == 0),
            "knot " + std::to_string(k) + " has " + std::to_string(nu) +
                " controls; wanted 0 to max_controls = " + std::to_string(problem.max_controls()) +
                ", and 0 at the end");
  }
}

std::size_t size(int rows, int columns) { return to_size(rows) * to_size(columns); }

/// Returns the approximate number of bytes that allocate() needs per knot.
double bytes_of_knot(const RiccatiLayout& layout, int nx, int ndx, int nu) {
  const double expansion = (1.0 + layout.expansion_rows + ndx) * layout.expansion_stride;
  const double value = (2.0 + ndx) * layout.value_stride, policy = (1.0 + nu) * layout.gain_stride;
  const double iterates = 3.0 * (nx + nu + layout.value_stride) + nx;
  return sizeof(double) * (expansion + value + policy + iterates + 3.0 * layout.spare);
}

/// Checks the memory before any is allocated.
void check_memory(const RiccatiLayout& layout, int knots, int nx, int ndx, int nu) {
  constexpr double max_bytes = 4e9;  // chosen by hand
  const double wanted = knots * bytes_of_knot(layout, nx, ndx, nu);
  char text[160];
  std::snprintf(text, sizeof text,
                "%d knots of %d states and %d controls take %.1f GB of memory; at most %.0f GB are "
                "supported",
                knots, nx, nu, 1e-9 * wanted, 1e-9 * max_bytes);
  require(wanted <= max_bytes, text);
}

}  // namespace

DdpSolver::Impl::Impl(ShootingProblem& shooting_problem, DdpOptions wanted)
    : problem((check_shape(shooting_problem), shooting_problem)),
      state(problem.state()),
      N(problem.knots()),
      nx(state.nx),
      ndx(state.ndx),
      nu_max(problem.max_controls()),
      recursion(state, nu_max),
      value_stride(recursion.layout().value_stride),
      gain_stride(recursion.layout().gain_stride),
      control_stride(dense::round_up(std::max(1, nu_max))) {
  check_memory(recursion.layout(), N, nx, ndx, nu_max);
  apply_options(std::move(wanted));
  allocate();
  start();
}

void DdpSolver::Impl::apply_options(DdpOptions wanted) {
  wanted.check();
  check_segments(wanted.segments);
  const Pinning pinning = wanted.pin_threads ? Pinning::Cores : Pinning::None;
  if (!pool || pool->workers() != wanted.threads || pool->pinning() != pinning) {
    auto team = std::make_unique<ThreadPool>(wanted.threads, pinning);
    problem.prepare(wanted.threads);
    recursion = RiccatiRecursion(state, nu_max, wanted.threads);
    pool = std::move(team);
  }
  cut_horizon(wanted.segments);
  options = std::move(wanted);
  summary.options = options;
  summary.options.callback = nullptr;
  summary.log.reserve(to_size(options.max_iterations));
}

void DdpSolver::Impl::allocate() {
  const RiccatiLayout& layout = recursion.layout();
  const auto knots = to_size(N);
  for (Iterate* it : {&current, &trial, &best}) {
    it->xs.resize(size(N + 1, nx));
    it->us.assign(size(N, nu_max), 0.0);
    it->gaps = Buffer(size(N + 2, value_stride));
  }
  for (int k = 0; k <= N; ++k) std::copy_n(problem.initial_state(), nx, current.xs.data() + k * nx);
  next.resize(size(N, nx));
  values.resize(knots + 1);
  controls.resize(knots + 1);
  lower.resize(knots);
  upper.resize(knots);
  expansions.resize(knots + 1);
  const auto spare = to_size(layout.spare);
  int tangent_size = 0;
  for (const NonEuclideanBlock& b : state.blocks) tangent_size += 2 * b.size * b.size;
  tangent_size = dense::round_up(tangent_size);
  // Pads the number of rows, because transposed matrices are read in whole SIMD vectors.
  const int dynamics_rows = std::max(ndx, dense::round_up(state.nv));
  const int gain_rows = dense::round_up(nu_max);
  for (std::size_t k = 0; k <= knots; ++k) {
    const int stride = layout.expansion_stride;
    expansion_memory.emplace_back(size(1 + layout.expansion_rows + dynamics_rows, stride) +
                                  size(1, tangent_size) + size(1, dense::round_up(state.filtered)) +
                                  spare);
    KnotExpansion& e = expansions[k];
    e.stride = stride;
    e.gradient = expansion_memory.back().data();
    e.hessian = e.gradient + stride;
    e.dynamics = e.hessian + size(layout.expansion_rows, stride);
    e.tangent_blocks = e.dynamics + size(ndx, stride);
    e.decay = e.tangent_blocks + tangent_size;
    value_memory.emplace_back(size(ndx + 1, value_stride) + spare);
    policy_memory.emplace_back(size(1, control_stride) + size(gain_rows, gain_stride) + spare);
  }
  allocate_rows();
  hessian_gaps = Buffer(size(N + 2, value_stride));
  dxs = Buffer(size(N + 2, value_stride));
  dus = Buffer(size(N + 1, control_stride));
  z = Buffer(size(2, layout.expansion_stride));
  scratch = Buffer(size(2, layout.expansion_stride) + spare);
}

/// Reads data that the problem may have changed since the last solve, and resets the solver's
/// state.
void DdpSolver::Impl::start() {
  for (int k = 0; k < N; ++k) {
    const auto i = to_size(k);
    if (controls[i] != problem.controls(k)) std::fill_n(policy(k).feedforward, nu_max, 0.0);
    controls[i] = problem.controls(k);
    lower[i] = problem.control_lower(k);
    upper[i] = problem.control_upper(k);
    clamp(k, current.us.data() + k * nu_max);
  }
  controls[to_size(N)] = 0;
  start_rows();
  ranges = problem.ranges();
  current.feasible = false;
  best_is_current = true;
  best.feasible = false;
  expanded = false;
  searched_at_floor = false;
  regularization = options.regularization.initial;
  regularization_floor = 0.0;
  penalty = 0.0;
  trial_failure_knot = -1;
  summary.reason = StopReason::MaxIterations;
  summary.iterations = 0;
  summary.expected_improvement = 0.0;
  summary.status = Status::Ok;
  summary.in_derivatives = false;
  summary.knot = summary.term = summary.row = summary.control = -1;
  summary.seconds = {};
  summary.log.clear();
}

ValueStorage DdpSolver::Impl::value(int knot) {
  double* memory = value_memory[to_size(knot)].data();
  return {memory, memory + value_stride};
}

PolicyStorage DdpSolver::Impl::policy(int knot) {
  double* memory = policy_memory[to_size(knot)].data();
  return {memory, memory + control_stride};
}

void DdpSolver::Impl::clamp(int knot, double* u) const {
  const auto k = to_size(knot);
  if (lower[k] == nullptr || upper[k] == nullptr) return;
  for (int i = 0; i < controls[k]; ++i) u[i] = std::min(std::max(u[i], lower[k][i]), upper[k][i]);
}

}  // namespace burnish
