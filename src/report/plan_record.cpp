#include "burnish/report/plan_record.hpp"

#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/solver/ddp.hpp"

namespace burnish {
namespace {

/// Approximate time between the recorded knots of a plan, chosen by hand [s].
constexpr double kept_every = 0.05;

}  // namespace

PlanRecorder::PlanRecorder(MpcController& controller, double step, double solver_delay, double rate)
    : controller_(controller), delay_(solver_delay), period_(rate > 0.0 ? 1.0 / rate : 0.0) {
  if (period_ == 0.0) return;
  const Problem& problem = controller.problem();
  record_.nq = problem.layout().nq;
  bool is_even = true;
  for (int k = 1; k < problem.knots(); ++k)
    is_even = is_even && problem.step_of(k) == problem.step_of(0);
  if (is_even) {
    stride_ = std::max(1, static_cast<int>(std::lround(kept_every / step)));
    record_.step = stride_ * step;
    record_.knots = problem.knots() / stride_ + 1;
  } else {
    const double duration = problem.time_of(problem.knots()) - problem.time_of(0);
    record_.step = kept_every;
    record_.knots = static_cast<int>(duration / kept_every + 1e-9) + 1;
  }
  term_of_.resize(problem.stage_names().size());
}

void PlanRecorder::look(double time, const Command& command) {
  constexpr double slack = 1e-9;  // tolerance for rounding errors of summed times [s]
  if (period_ == 0.0 || time == last_) return;
  last_ = time;
  if (command.solve_time <= 0.0 || time < next_ - slack) return;
  const MatrixView plan = controller_.plan();
  if (!plan.allFinite()) return;
  next_ = std::max(next_ + period_, time + 0.5 * period_);
  const double begin = time + (record_.time.empty() ? 0.0 : delay_);
  record_.time.push_back(begin);
  add_states();
  add_start();
  add_costs();
}

void PlanRecorder::add_states() {
  const Problem& problem = controller_.problem();
  const MatrixView plan = controller_.plan();
  Eigen::VectorXd x(plan.cols()), dx(problem.layout().ndx());
  int before = 0;  // last knot before the recorded time
  for (int kept = 0; kept < record_.knots; ++kept) {
    if (stride_ > 0) {
      x = plan.row(kept * stride_);
    } else {
      const double at = problem.time_of(0) + kept * record_.step;
      while (before + 1 < problem.knots() && problem.time_of(before + 1) <= at) ++before;
      const double begin = problem.time_of(before), length = problem.time_of(before + 1) - begin;
      problem.difference(plan.row(before).data(), plan.row(before + 1).data(), dx.data());
      dx *= std::min(1.0, (at - begin) / length);
      problem.integrate(plan.row(before).data(), dx.data(), x.data());
    }
    for (int i = 0; i < record_.nq; ++i) record_.q.push_back(static_cast<float>(x[i]));
  }
}

void PlanRecorder::add_start() {
  const DdpSolver& solver = controller_.solver();
  PlanStart& start = record_.start;
  const auto append = [](std::vector<double>& to, const auto& values) {
    for (const auto& row : values.rowwise()) to.insert(to.end(), row.begin(), row.end());
  };
  const MatrixView xs = solver.xs(), us = solver.us();
  const PaddedView gain = solver.gain(0);
  start.nx = static_cast<int>(xs.cols());
  start.nu = static_cast<int>(gain.rows());
  start.ndx = static_cast<int>(gain.cols());
  append(start.x, xs.row(0));
  append(start.u, us.row(0).head(start.nu));
  append(start.K, gain);
  append(start.Vx, solver.value_gradient(0).transpose());
  append(start.Vxx, solver.value_hessian(0));
}

void PlanRecorder::add_costs() {
  const Problem& problem = controller_.problem();
  const std::size_t plans = record_.time.size();
  for (int knot = 0; knot <= problem.knots(); ++knot) {
    const auto stage = to_size(problem.stage_of(knot));
    if (term_of_[stage].empty()) find_terms(stage, knot);
    for (std::vector<double>& costs : record_.costs) costs.resize(plans, 0.0);
    const std::vector<double> costs = controller_.plan_costs(knot);
    for (std::size_t term = 0; term < costs.size(); ++term)
      record_.costs[term_of_[stage][term]].back() += costs[term];
  }
}

void PlanRecorder::find_terms(std::size_t stage, int knot) {
  for (const std::string& name : controller_.problem().term_names(knot)) {
    const auto found = std::find(record_.terms.begin(), record_.terms.end(), name);
    term_of_[stage].push_back(to_size(found - record_.terms.begin()));
    if (found != record_.terms.end()) continue;
    record_.terms.push_back(name);
    record_.costs.emplace_back();
  }
}

}  // namespace burnish
