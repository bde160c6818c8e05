#include <limits>

#include "base/descriptions.gen.hpp"
#include "base/to_size.hpp"
#include "base/whole_file.hpp"
#include "record/json_text.hpp"
#include "record/run_folder.hpp"
#include "record/solution.hpp"

namespace burnish {
namespace {

std::string word(StopReason reason) {
  switch (reason) {
    case StopReason::Converged:
      return "converged";
    case StopReason::MaxIterations:
      return "max_iterations";
    case StopReason::TimeBudget:
      return "time_budget";
    case StopReason::NotEvaluated:
      return "not_evaluated";
    case StopReason::NotPositiveDefinite:
      return "not_positive_definite";
    case StopReason::Infeasible:
      return "infeasible";
    case StopReason::NoStep:
      return "no_step";
    case StopReason::Callback:
      return "interrupted";
  }
  return "unknown";
}

Json knots_json(const Problem& problem, const DdpSolver& policy, const MatrixView& xs,
                const MatrixView& us) {
  Json knots = Json::array();
  for (int k = 0; k < problem.knots(); ++k) {
    const int nu = problem.controls(k);
    const VectorView feedforward = policy.feedforward(k);
    knots.push_back({{"knot", k},
                     {"name", problem.knot_name(k)},
                     {"time", problem.time_of(k)},
                     {"x", numbers_json(xs.row(k).transpose())},
                     {"u", numbers_json(us.row(k).head(nu).transpose())},
                     {"feedforward", numbers_json(feedforward)},
                     {"gain", matrix_json(policy.gain(k))}});
  }
  return knots;
}

/// Returns the constraint rows, each at its largest violation, with the times at which it is
/// active.
Json rows_json(const Problem& problem, const CostReport& report) {
  const auto times = active_times(problem, report);
  Json rows = Json::array();
  for (const CostReport::Row& row : report.rows) {
    rows.push_back({{"row", row.name},
                    {"knot", row.knot},
                    {"value", number_json(row.value)},
                    {"lower", number_json(row.lower)},
                    {"upper", number_json(row.upper)},
                    {"violation", number_json(row.violation)},
                    {"scale", number_json(row.scale)},
                    {"multiplier", number_json(row.multiplier)},
                    {"multiplier_at", row.pushed},
                    {"active_knots", row.active}});
    const auto found = times.find(row.name);
    if (found != times.end()) rows.back()["active_times"] = found->second;
  }
  return rows;
}

/// Returns the constraint rows that the initial state violates, for any control.
Json start_json(const Problem& problem, const DdpSummary& summary) {
  Json rows = Json::array();
  if (summary.start_violations.empty()) return rows;
  const std::vector<std::string> names = problem.row_names(0);
  for (const StartRow& row : summary.start_violations)
    rows.push_back({{"row", names.at(to_size(row.row))},
                    {"value", number_json(row.value)},
                    {"lower", number_json(row.lower)},
                    {"upper", number_json(row.upper)}});
  return rows;
}

Json step_error_json(const StepError& error) {
  return {{"error", number_json(error.error)},
          {"limit", number_json(error.limit)},
          {"unit", error.unit},
          {"entry", error.entry},
          {"knot", error.knot},
          {"time", number_json(error.time)},
          {"step", number_json(error.step)}};
}

Json steps_json(const StepReport& steps) {
  Json json{{"status", words_of(Status()).list()[to_size(steps.status)]},
            {"coarse", steps.coarse},
            {"position", step_error_json(steps.position)},
            {"velocity", step_error_json(steps.velocity)},
            {"sentence", steps.coarse ? steps.warning() : steps.text()}};
  if (steps.sufficient_step > 0.0) json["sufficient_step"] = number_json(steps.sufficient_step);
  return json;
}

}  // namespace

Json gains_json(Problem& problem, DdpSolver& solver) {
  const RowMatrix xs = solver.xs(), us = solver.us();
  std::vector<std::string> x_names;
  const StateLayout& layout = problem.layout();
  for (int i = 0; i < layout.nq; ++i) x_names.push_back("q " + problem.model().q_name(i));
  for (int i = 0; i < layout.nv; ++i) x_names.push_back("v " + problem.model().v_name(i));
  for (int i = 0; i < layout.filtered; ++i)
    x_names.push_back("tau " + problem.model().v_name(layout.actuated[to_size(i)]));
  for (const std::string& row : problem.force_state_names()) x_names.push_back("force " + row);
  Json json{{"policy", "u = u_k + feedforward + gain * (x (-) x_k)"},
            {"rows", problem.control_names()},
            {"columns", problem.state_names()},
            {"x_names", x_names},
            {"row_units", "Nm (N)"},
            {"column_units", "q: rad (m), v: rad/s (m/s), tau: Nm (N), force: N (Nm)"}};
  const MatrixView x_view(xs.data(), xs.rows(), xs.cols()), u_view(us.data(), us.rows(), us.cols());
  const StopReason reason = solver.summary().reason;
  if (reason == StopReason::Converged) {
    json["knots"] = knots_json(problem, solver, x_view, u_view);
    return json;
  }
  // Computes the policy at this trajectory by one iteration, whose step is not used.
  DdpOptions options = solver.options();
  options.max_iterations = 1;
  options.time_budget = std::numeric_limits<double>::infinity();
  options.callback = {};
  DdpSolver once(problem, options);
  once.set_guess(xs, us);
  const StopReason policy = once.solve().reason;
  const bool made = policy != StopReason::NotEvaluated && policy != StopReason::NotPositiveDefinite;
  json["knots"] = made ? knots_json(problem, once, x_view, u_view) : Json::array();
  return json;
}

Json summary_json(const std::string& file, Problem& problem, const DdpSolver& solver,
                  const StepReport& steps) {
  const DdpSummary& s = solver.summary();
  const CostReport report = solver.cost_report();
  Json terms = Json::object();
  for (const CostReport::Entry& term : report.terms) terms[term.name] = number_json(term.cost);
  Json log = Json::array();
  for (const DdpProgress& p : s.log)
    log.push_back({{"iteration", p.iteration},
                   {"cost", number_json(p.cost)},
                   {"expected_improvement", number_json(p.expected_improvement)},
                   {"largest_gap", number_json(p.largest_gap)},
                   {"violation", number_json(p.violation)},
                   {"factorizations", p.factorizations},
                   {"step_length", p.step_length},
                   {"regularization", p.regularization},
                   {"seconds", p.seconds}});
  return {{"problem", file},
          {"robot", problem.model().name},
          {"knots", problem.knots()},
          {"stages", problem.stage_names()},
          {"reason", word(s.reason)},
          {"sentence", solver.text()},
          {"converged", s.reason == StopReason::Converged},
          {"iterations", s.iterations},
          {"cost", number_json(s.cost)},
          {"feasible", s.feasible},
          {"largest_gap", number_json(s.largest_gap)},
          {"violation", number_json(s.violation)},
          {"start_violations", start_json(problem, s)},
          {"active_constraints", s.active_constraints},
          {"expected_improvement", number_json(s.expected_improvement)},
          {"stop_tolerance", s.options.stop_tolerance},
          {"gap_tolerance", s.options.gap_tolerance},
          {"threads", s.options.threads},
          {"seconds",
           {{"total", s.seconds.total},
            {"expand", s.seconds.expand},
            {"backward", s.seconds.backward},
            {"trial", s.seconds.trial}}},
          {"discretization", steps_json(steps)},
          {"cost_by_term", terms},
          {"constraints", rows_json(problem, report)},
          {"log", log}};
}

std::vector<std::string> write_solution(Problem& problem, DdpSolver& solver, const Json& summary,
                                        const std::filesystem::path& folder) {
  const Trace trace = solution_trace(problem, solver.xs(), solver.us());
  trace.write_csv(folder / "trajectory.csv");
  write_text(folder / "summary.json", json_text(summary));
  write_text(folder / "gains.json", json_text(gains_json(problem, solver)));
  std::vector<std::string> names{"trajectory.csv", "gains.json", "summary.json"};
  const CostReport report = solver.cost_report();
  if (!report.rows.empty()) {
    write_whole_file(folder / "limits.csv", limits_csv(problem, report));
    names.emplace_back("limits.csv");
  }
  for (std::string& plot : write_plots(problem, trace, solver.summary(), report, folder))
    names.push_back(std::move(plot));
  return names;
}

}  // namespace burnish
