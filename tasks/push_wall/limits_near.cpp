#include "push_wall/limits_near.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/to_size.hpp"
#include "burnish/ocp/problem.hpp"
#include "burnish/solver/ddp.hpp"

namespace burnish::push_wall {
namespace {

// Distance below which a limit counts as reached, as a fraction of its scale.
constexpr double near = 1e-3;

bool is_at(double value, double lower, double upper, double scale) {
  return std::min(value - lower, upper - value) < near * scale;
}

}  // namespace

PlanAt plan_now(const MpcController& mpc) {
  PlanAt plan;
  plan.xs = mpc.solver().xs();
  plan.us = mpc.solver().us();
  for (int k = 0; k < mpc.problem().knots(); ++k) {
    plan.stages.push_back(mpc.problem().stage_of(k));
    plan.times.push_back(mpc.problem().time_of(k));
  }
  plan.torque_error = mpc.torque_error();
  return plan;
}

std::string limits_near(const ProblemSpec& spec, const PlanAt& plan) {
  Problem problem(spec);
  (void)problem.set_torque_bias(plan.torque_error);
  // Number of knots at which each constraint is reached, by name of the constraint.
  std::map<std::string, int> reached;
  for (int k = 0; k < static_cast<int>(plan.stages.size()); ++k) {
    const auto i = to_size(k);
    problem.set_knot(k, plan.stages[i], plan.times[i]);
    const Eigen::VectorXd x = plan.xs.row(k), u = plan.us.row(k);
    const std::vector<double> values = problem.row_values(k, x.data(), u.data());
    const std::vector<std::string> names = problem.row_names(k);
    for (std::size_t r = 0; r < values.size(); ++r)
      if (is_at(values[r], problem.row_lower(k)[r], problem.row_upper(k)[r],
                problem.row_scale(k)[r]))
        ++reached[names[r]];
    const double* const lower = problem.control_lower(k);
    const double* const upper = problem.control_upper(k);
    if (lower == nullptr || upper == nullptr)
      continue;  // torques are limited by constraints, or unlimited
    const std::vector<std::string> controls = problem.control_names();
    for (int c = 0; c < problem.controls(k); ++c)
      if (is_at(u[c], lower[c], upper[c], problem.control_scale(k)[c]))
        ++reached["torque/" + controls[to_size(c)]];
  }
  std::vector<std::pair<int, std::string>> order;
  for (const auto& [name, knots] : reached) order.emplace_back(-knots, name);
  std::sort(order.begin(), order.end());
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, order.size()); ++i)
    text += (text.empty() ? "" : ", ") + order[i].second;
  return text;
}

}  // namespace burnish::push_wall
