#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/to_size.hpp"
#include "burnish/solver/ddp.hpp"

namespace burnish {
namespace {

std::string short_number(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", value);
  return buffer;
}

std::string seconds(double value) {
  if (value < 1e-3) return short_number(1e6 * value) + " us";
  if (value < 1.0) return short_number(1e3 * value) + " ms";
  return short_number(value) + " s";
}

template <class Names>
std::string name_or_number(const Names& names, int index) {
  if (index >= 0 && to_size(index) < names.size()) return "'" + names[to_size(index)] + "'";
  return std::to_string(index);
}

/// Example: "not finite: cost term 'force' at press, knot 12".
std::string failure(const DdpSummary& s, const ShootingProblem& problem) {
  const std::string where = " at " + problem.knot_name(s.knot);
  if (s.status == Status::NotFinite) {
    if (s.in_derivatives) return "not finite: derivatives" + where;
    if (s.term >= 0)
      return "not finite: cost term " + name_or_number(problem.term_names(s.knot), s.term) + where;
    if (s.row >= 0)
      return "not finite: constraint " + name_or_number(problem.row_names(s.knot), s.row) + where;
    return "not finite: dynamics" + where;
  }
  return "not evaluated" + where + ": " + std::string(describe(s.status));
}

/// Returns the name of each row once, with its first and last knot.
std::string row_list(const std::vector<RowPlace>& places, const ShootingProblem& problem) {
  struct RowGroup {
    std::string name;
    int first, last;
  };
  std::vector<RowGroup> rows;
  for (const RowPlace& place : places) {
    const std::string name = name_or_number(problem.row_names(place.knot), place.row);
    const auto known =
        std::find_if(rows.begin(), rows.end(), [&](const RowGroup& r) { return r.name == name; });
    if (known == rows.end()) {
      rows.push_back({name, place.knot, place.knot});
    } else {
      known->first = std::min(known->first, place.knot);
      known->last = std::max(known->last, place.knot);
    }
  }
  constexpr std::size_t max_names = 5;
  std::string list;
  for (std::size_t i = 0; i < std::min(rows.size(), max_names); ++i) {
    list += (i == 0 ? "" : ", ") + rows[i].name + " (knot " + std::to_string(rows[i].first);
    if (rows[i].last > rows[i].first) list += " to " + std::to_string(rows[i].last);
    list += ")";
  }
  if (rows.size() > max_names) list += " and " + std::to_string(rows.size() - max_names) + " more";
  return list;
}

/// Example: "'lean/tilt' is 0.398, allowed -0.3 to 0.3".
std::string start_text(const DdpSummary& s, const ShootingProblem& problem) {
  std::string list;
  for (const StartRow& row : s.start_violations) {
    list += (list.empty() ? "" : "; ") + name_or_number(problem.row_names(0), row.row) + " is " +
            short_number(row.value) + ", allowed ";
    if (std::isinf(row.upper))
      list += "at least " + short_number(row.lower);
    else if (std::isinf(row.lower))
      list += "at most " + short_number(row.upper);
    else
      list += short_number(row.lower) + " to " + short_number(row.upper);
  }
  return list;
}

/// Describes the violated rows and the active rows that conflict with them.
std::string conflict_text(const DdpSummary& s, const ShootingProblem& problem) {
  if (s.conflict.empty()) return "no trajectory from this start satisfies all limits";
  std::string text =
      "no trajectory near this one satisfies all limits: " + row_list(s.conflict, problem);
  if (!s.stopping.empty()) text += ", in conflict with " + row_list(s.stopping, problem);
  return text;
}

std::string reason_text(const DdpSummary& s, const ShootingProblem& problem) {
  const std::string improvement =
      "the expected improvement " + short_number(s.expected_improvement) + " is ";
  const std::string below = "below " + short_number(s.options.stop_tolerance);
  const std::string largest = short_number(s.options.regularization.largest);
  switch (s.reason) {
    case StopReason::Converged:
      return "converged: " + improvement +
             (s.expected_improvement < s.options.stop_tolerance
                  ? below
                  : "less than the change of cost that the limit tolerance can cause");
    case StopReason::MaxIterations:
      return "stopped after " + std::to_string(s.iterations) + " iterations: " + improvement +
             (s.expected_improvement < s.options.stop_tolerance ? below : "not " + below);
    case StopReason::TimeBudget:
      return "time budget of " + seconds(s.options.time_budget) + " spent after " +
             std::to_string(s.iterations) + " iterations";
    case StopReason::NotEvaluated:
      return failure(s, problem);
    case StopReason::NotPositiveDefinite:
      return "the Hessian of the controls (Quu) is not positive definite at " +
             problem.knot_name(s.knot) + ", control " +
             name_or_number(problem.control_names(), s.control) + ", even with regularization " +
             largest;
    case StopReason::Infeasible:
      return conflict_text(s, problem);
    case StopReason::NoStep:
      return "no step length lowers the cost, even with regularization " +
             short_number(s.regularization) +
             (s.knot >= 0 ? "; the last trial was " + failure(s, problem) : "");
    case StopReason::Callback:
      return "stopped by the callback after " + std::to_string(s.iterations) + " iterations";
  }
  return "unknown";
}

/// Lists the active rows with the largest multipliers.
std::string active_text(const std::vector<CostReport::Row>& rows) {
  if (rows.empty()) return "";
  std::string lines = "active constraints: " + std::to_string(rows.size()) +
                      (rows.size() == 1 ? " row\n" : " rows\n");
  for (std::size_t i = 0; i < std::min<std::size_t>(rows.size(), 5); ++i)
    lines += "  " + short_number(rows[i].multiplier) + "  " + rows[i].name + ": at " +
             rows[i].pushed + ", at " + std::to_string(rows[i].active) +
             (rows[i].active == 1 ? " knot" : " knots") + " in all\n";
  return lines;
}

/// Lists the rows with the largest violations, or states that no row is violated.
std::string rows_text(const std::vector<CostReport::Row>& rows) {
  if (rows.empty()) return "";
  std::vector<CostReport::Row> broken;
  for (const CostReport::Row& row : rows)
    if (row.broken()) broken.push_back(row);
  if (broken.empty()) return "constraints: every row is inside its limits\n";
  std::stable_sort(broken.begin(), broken.end(), [](const auto& a, const auto& b) {
    return a.violation > b.violation || (std::isnan(a.violation) && !std::isnan(b.violation));
  });
  std::string lines = "constraints: " + std::to_string(broken.size()) + " of " +
                      std::to_string(rows.size()) + " rows are outside their limits\n";
  for (std::size_t i = 0; i < std::min<std::size_t>(broken.size(), 5); ++i)
    lines += "  " + short_number(broken[i].violation) + "  " + broken[i].name + ": " +
             short_number(broken[i].value) + ", limits " + short_number(broken[i].lower) + " and " +
             short_number(broken[i].upper) + ", at " + broken[i].knot + "\n";
  return lines;
}

}  // namespace

std::string DdpSummary::text(const ShootingProblem& problem) const {
  std::string sentence = reason_text(*this, problem);
  if (reason == StopReason::NotEvaluated) return sentence;
  if (!start_violations.empty())
    sentence += "; the initial state violates limits: " + start_text(*this, problem);
  sentence += "; cost " + short_number(cost) + ", ";
  if (violation_knot >= 0)
    return sentence +
           "not feasible: " + name_or_number(problem.row_names(violation_knot), violation_row) +
           " is outside its limits by " + short_number(violation) + " of its scale at " +
           problem.knot_name(violation_knot);
  if (feasible) return sentence + "feasible";
  const std::vector<std::string> names = problem.state_names();
  return sentence + "not feasible: largest gap " + short_number(largest_gap) + " in " +
         name_or_number(names, gap_entry) + " before " + problem.knot_name(gap_knot);
}

/// A row is violated if it exceeds its limit by more than the solver's tolerance and rounding
/// errors.
bool CostReport::Row::broken() const {
  const double limit = value > upper ? upper : lower;
  return !(violation <= std::max(1e-8 * scale, 1e-9 * std::max(1.0, std::abs(limit))));
}

std::vector<CostReport::Row> CostReport::active_constraints() const {
  std::vector<Row> active_constraints = rows;
  std::erase_if(active_constraints, [](const Row& row) { return row.active == 0; });
  const auto multiplier_size = [](const Row& row) { return std::abs(row.multiplier) * row.scale; };
  std::stable_sort(
      active_constraints.begin(), active_constraints.end(),
      [&](const Row& a, const Row& b) { return multiplier_size(a) > multiplier_size(b); });
  return active_constraints;
}

std::string CostReport::text() const {
  std::vector<Entry> by_term = terms;
  std::stable_sort(by_term.begin(), by_term.end(),
                   [](const Entry& a, const Entry& b) { return a.cost > b.cost; });
  std::vector<Entry> by_knot;
  for (const Knot& k : knots) by_knot.push_back({k.name, k.cost});
  std::stable_sort(by_knot.begin(), by_knot.end(),
                   [](const Entry& a, const Entry& b) { return a.cost > b.cost; });
  if (by_knot.size() > 5) by_knot.resize(5);
  std::string lines = "cost " + short_number(total) + "\n";
  for (const Entry& e : by_term) lines += "  " + short_number(e.cost) + "  " + e.name + "\n";
  lines += "most expensive knots\n";
  for (const Entry& e : by_knot) lines += "  " + short_number(e.cost) + "  " + e.name + "\n";
  return lines + rows_text(rows) + active_text(active_constraints());
}

}  // namespace burnish
