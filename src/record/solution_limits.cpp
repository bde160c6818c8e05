#include "base/csv_cell.hpp"
#include "record/json_text.hpp"
#include "record/solution.hpp"

namespace burnish {

std::string limits_csv(const Problem& problem, const CostReport& report) {
  std::string text = "knot [-],time [s],stage [-],row,value,lower,upper,multiplier\n";
  for (const CostReport::ActiveLimit& limit : report.limits) {
    text += std::to_string(limit.knot) + ',';
    append_cell(text, problem.time_of(limit.knot));
    text += ',' + std::to_string(problem.stage_of(limit.knot)) + ',';
    append_cell(text, limit.row);
    for (const double value : {limit.value, limit.lower, limit.upper, limit.multiplier}) {
      text += ',';
      append_cell(text, value);
    }
    text += '\n';
  }
  return text;
}

std::map<std::string, Json> active_times(const Problem& problem, const CostReport& report) {
  std::map<std::string, Json> times;
  std::map<std::string, int> last;  // Last knot at which the row was active
  for (const CostReport::ActiveLimit& limit : report.limits) {
    if (limit.multiplier == 0.0) continue;
    const double time = problem.time_of(limit.knot);
    Json& ranges = times[limit.row];
    const auto before = last.find(limit.row);
    if (before != last.end() && before->second == limit.knot - 1)
      ranges.back()[1] = time;
    else
      ranges.push_back({time, time});
    last[limit.row] = limit.knot;
  }
  return times;
}

}  // namespace burnish
