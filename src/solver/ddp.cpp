#include "burnish/solver/ddp.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/to_size.hpp"
#include "solver/ddp_impl.hpp"
#include "solver/linear_dynamics.hpp"

namespace burnish {

DdpSolver::DdpSolver(ShootingProblem& problem, DdpOptions options)
    : impl_(std::make_unique<Impl>(problem, std::move(options))) {}
DdpSolver::~DdpSolver() = default;
DdpSolver::DdpSolver(DdpSolver&&) noexcept = default;
DdpSolver& DdpSolver::operator=(DdpSolver&&) noexcept = default;

const DdpOptions& DdpSolver::options() const { return impl_->options; }

void DdpSolver::set_options(DdpOptions options) { impl_->apply_options(std::move(options)); }

void DdpSolver::set_time_budget(double seconds) {
  impl_->options.time_budget = seconds >= 0.0 ? seconds : 0.0;
  impl_->summary.options.time_budget = impl_->options.time_budget;
}

void DdpSolver::set_max_iterations(int iterations) {
  const int room = static_cast<int>(impl_->summary.log.capacity());
  impl_->options.max_iterations = std::clamp(iterations, 0, room);
  impl_->summary.options.max_iterations = impl_->options.max_iterations;
}

void DdpSolver::set_limit_budget(int max_factorizations, int max_sweeps) noexcept {
  LimitOptions& limits = impl_->options.limits;
  limits.max_factorizations = impl_->summary.options.limits.max_factorizations =
      std::max(1, max_factorizations);
  limits.max_sweeps = impl_->summary.options.limits.max_sweeps = std::max(0, max_sweeps);
}

void DdpSolver::set_guess(const Eigen::Ref<const RowMatrix>& xs,
                          const Eigen::Ref<const RowMatrix>& us) {
  const Impl& s = *impl_;
  const auto check = [](const char* name, const Eigen::Ref<const RowMatrix>& m, int rows,
                        int columns) {
    if (m.rows() != rows || m.cols() != columns)
      throw Error("solver: guess of " + std::string(name) + " is " + std::to_string(m.rows()) +
                  " x " + std::to_string(m.cols()) + "; wanted " + std::to_string(rows) + " x " +
                  std::to_string(columns));
  };
  check("states", xs, s.N + 1, s.nx);
  check("controls", us, s.N, s.nu_max);
  Eigen::Map<RowMatrix>(impl_->current.xs.data(), s.N + 1, s.nx) = xs;
  Eigen::Map<RowMatrix>(impl_->current.us.data(), s.N, s.nu_max) = us;
}

void DdpSolver::set_guess(const TrajectoryView& guess) {
  Impl& s = *impl_;
  std::copy_n(guess.x, s.current.xs.size(), s.current.xs.data());
  std::copy_n(guess.u, s.current.us.size(), s.current.us.data());
}

void DdpSolver::forget_limits() noexcept {
  if (impl_->limited) impl_->forget_limits();
}

void DdpSolver::shift_limits(int knots) noexcept {
  if (!impl_->limited) return;
  for (int k = 0; k < std::min(knots, impl_->N); ++k) impl_->limited->shift(impl_->controls);
}

void DdpSolver::shift_limits(std::span<const int> from) noexcept {
  if (impl_->limited) impl_->limited->shift(impl_->controls, from);
}

const DdpSummary& DdpSolver::solve() {
  impl_->began = Impl::Clock::now();
  const ThreadPool::Awake awake(*impl_->pool);
  impl_->start();
  impl_->iterate();
  impl_->finish();
  return impl_->summary;
}

const DdpSummary& DdpSolver::summary() const { return impl_->summary; }
std::string DdpSolver::text() const { return impl_->summary.text(impl_->problem); }

MatrixView DdpSolver::xs() const { return {impl_->current.xs.data(), impl_->N + 1, impl_->nx}; }
MatrixView DdpSolver::us() const { return {impl_->current.us.data(), impl_->N, impl_->nu_max}; }

VectorView DdpSolver::feedforward(int knot) const {
  return {impl_->policy(knot).feedforward, impl_->controls[to_size(knot)]};
}

PaddedView DdpSolver::gain(int knot) const {
  return {impl_->policy(knot).gain, impl_->controls[to_size(knot)], impl_->ndx,
          Eigen::OuterStride<>(impl_->gain_stride)};
}

VectorView DdpSolver::multipliers(int knot) const {
  const auto k = to_size(knot);
  if (!impl_->limited) return {nullptr, 0};
  return {impl_->row_multipliers.data() + knot * impl_->rows_max, impl_->row_counts[k]};
}

VectorView DdpSolver::value_gradient(int knot) const {
  return {impl_->value(knot).gradient, impl_->ndx};
}

PaddedView DdpSolver::value_hessian(int knot) const {
  return {impl_->value(knot).hessian, impl_->ndx, impl_->ndx,
          Eigen::OuterStride<>(impl_->value_stride)};
}

NamedMatrix DdpSolver::named_gain(int knot) const {
  NamedMatrix m{impl_->problem.control_names(), impl_->problem.state_names(), gain(knot)};
  m.rows.resize(to_size(m.values.rows()));
  return m;
}

NamedMatrix DdpSolver::named_value_hessian(int knot) const {
  const std::vector<std::string> names = impl_->problem.state_names();
  return {names, names, value_hessian(knot)};
}

namespace {
/// Merges the row of one more knot into `rows`, which has one entry per row name. The entry states
/// the largest violation over the knots.
void add_row(CostReport::Row row, std::vector<CostReport::Row>& rows) {
  const auto known = std::find_if(rows.begin(), rows.end(),
                                  [&](const CostReport::Row& r) { return r.name == row.name; });
  if (known == rows.end()) {
    rows.push_back(std::move(row));
    return;
  }
  row.active += known->active;
  if (std::abs(row.multiplier) <= std::abs(known->multiplier)) {
    row.multiplier = known->multiplier;
    row.pushed = known->pushed;
  }
  if (!(row.violation <= known->violation)) {
    *known = std::move(row);
  } else {
    known->active = row.active;
    known->multiplier = row.multiplier;
    known->pushed = row.pushed;
  }
}

/// Adds the constraint rows of a knot to the report.
void add_rows(ShootingProblem& problem, int knot, const double* x, const double* u,
              const VectorView& multipliers, CostReport& report) {
  if (problem.rows(knot) == 0) return;
  const std::vector<std::string> names = problem.row_names(knot);
  const std::vector<double> values = problem.row_values(knot, x, u);
  for (std::size_t i = 0; i < names.size(); ++i) {
    CostReport::Row row{names[i],
                        problem.knot_name(knot),
                        values[i],
                        problem.row_lower(knot)[i],
                        problem.row_upper(knot)[i],
                        0.0,
                        problem.row_scale(knot)[i]};
    row.violation = std::max(row.lower - row.value, row.value - row.upper);
    if (multipliers.size() > static_cast<Eigen::Index>(i))
      row.multiplier = multipliers[static_cast<Eigen::Index>(i)];
    row.pushed = row.multiplier != 0.0 ? row.knot : "";
    row.active = row.multiplier != 0.0 ? 1 : 0;
    if (row.active > 0 || row.broken())
      report.limits.push_back({knot, row.name, row.value, row.lower, row.upper, row.multiplier});
    add_row(std::move(row), report.rows);
  }
}
}  // namespace

CostReport DdpSolver::cost_report() const {
  const Impl& s = *impl_;
  CostReport report;
  for (int k = 0; k <= s.N; ++k) {
    CostReport::Knot knot{s.problem.knot_name(k), 0.0, {}};
    const std::vector<std::string> names = s.problem.term_names(k);
    const double* u = k < s.N ? s.current.us.data() + k * s.nu_max : nullptr;
    const std::vector<double> costs = s.problem.term_costs(k, s.current.xs.data() + k * s.nx, u);
    for (std::size_t t = 0; t < names.size() && t < costs.size(); ++t) {
      knot.cost += costs[t];
      knot.terms.push_back({names[t], costs[t]});
      const auto known =
          std::find_if(report.terms.begin(), report.terms.end(),
                       [&](const CostReport::Entry& e) { return e.name == names[t]; });
      if (known == report.terms.end())
        report.terms.push_back({names[t], costs[t]});
      else
        known->cost += costs[t];
    }
    add_rows(s.problem, k, s.current.xs.data() + k * s.nx, u, multipliers(k), report);
    report.total += knot.cost;
    report.knots.push_back(std::move(knot));
  }
  return report;
}

double DdpSolver::optimality_error() {
  Impl& s = *impl_;
  const bool was_feasible = s.current.feasible;
  const bool good = s.expand(s.current);
  s.current.feasible = was_feasible;
  if (!good) return std::numeric_limits<double>::infinity();
  std::vector<double> multiplier(to_size(s.value_stride));
  const auto add_limits = [&](int k, double* gradient) {
    const KnotExpansion& e = s.expansions[to_size(k)];
    const VectorView of_rows = s.limited ? multipliers(k) : VectorView(nullptr, 0);
    const int nz = s.controls[to_size(k)] + s.ndx;
    const int* entry = s.problem.row_entry(k);
    const double* row = e.rows;
    for (Eigen::Index r = 0; r < of_rows.size(); ++r) {
      if (entry != nullptr && entry[r] >= 0) {
        gradient[entry[r]] += of_rows[r];
        continue;
      }
      for (int c = 0; c < nz; ++c) gradient[c] += of_rows[r] * row[c];
      row += e.stride;
    }
  };
  std::copy_n(s.expansions[to_size(s.N)].gradient, s.ndx, multiplier.data());
  add_limits(s.N, multiplier.data());
  double largest = 0.0;
  for (int k = s.N - 1; k >= 0; --k) {
    const auto i = to_size(k);
    const int nu = s.controls[i];
    double* gradient = s.z.data();
    std::copy_n(s.expansions[i].gradient, nu + s.ndx, gradient);
    add_limits(k, gradient);
    add_transposed(s.state, s.expansions[i], nu, multiplier.data(), s.scratch.data(), gradient);
    const ControlBox box = s.box(k);
    for (int c = 0; c < nu; ++c) {
      const bool bounded = box.lower != nullptr && box.upper != nullptr;
      // With constraint rows, the solver meets bounds only to a tolerance.
      const double near = s.limited ? 10.0 * s.options.limits.tolerance : 0.0;
      const auto at = [&](double bound) {
        return std::abs(box.u[c] - bound) <= near * std::max(1.0, std::abs(bound));
      };
      if (bounded && (((box.u[c] <= box.lower[c] || at(box.lower[c])) && gradient[c] > 0.0) ||
                      ((box.u[c] >= box.upper[c] || at(box.upper[c])) && gradient[c] < 0.0)))
        continue;
      largest = std::max(largest, std::abs(gradient[c]));
    }
    std::copy_n(gradient + nu, s.ndx, multiplier.data());
  }
  return largest;
}

}  // namespace burnish
