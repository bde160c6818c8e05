#include "push_wall/limits_near.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "burnish/ocp/problem.hpp"
#include "burnish/solver/ddp.hpp"

namespace burnish::push_wall {
namespace {

constexpr double near = 1e-3;  // of a limit's scale

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
  std::map<std::string, int> met;  // knots
  for (int k = 0; k < static_cast<int>(plan.stages.size()); ++k) {
    const auto i = static_cast<std::size_t>(k);
    problem.set_knot(k, plan.stages[i], plan.times[i]);
    const Eigen::VectorXd x = plan.xs.row(k), u = plan.us.row(k);
    const std::vector<double> values = problem.row_values(k, x.data(), u.data());
    const std::vector<std::string> names = problem.row_names(k);
    for (std::size_t r = 0; r < values.size(); ++r)
      if (is_at(values[r], problem.row_lower(k)[r], problem.row_upper(k)[r],
                problem.row_scale(k)[r]))
        ++met[names[r]];
    const double* const lower = problem.control_lower(k);
    const double* const upper = problem.control_upper(k);
    if (lower == nullptr || upper == nullptr)
      continue;  // torques are limited by rows, or not at all
    const std::vector<std::string> controls = problem.control_names();
    for (int c = 0; c < problem.controls(k); ++c)
      if (is_at(u[c], lower[c], upper[c], problem.control_scale(k)[c]))
        ++met["torque/" + controls[static_cast<std::size_t>(c)]];
  }
  std::vector<std::pair<int, std::string>> order;
  for (const auto& [name, knots] : met) order.emplace_back(-knots, name);
  std::sort(order.begin(), order.end());
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, order.size()); ++i)
    text += (text.empty() ? "" : ", ") + order[i].second;
  return text;
}

}  // namespace burnish::push_wall
