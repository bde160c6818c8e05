// Text of a problem's derivative check: a table with one row for each stage and term.
#include <array>

#include "base/sentence.hpp"
#include "burnish/ocp/check.hpp"
#include "derivatives/check_table.hpp"

namespace burnish {
namespace {

using Cells = std::array<std::string, 4>;

std::string entry_text(const CheckEntry& entry) {
  return entry.block.empty() ? "-" : entry.block + "(" + entry.row + ", " + entry.column + ")";
}

Cells cells_of(const ProblemCheckRow& row) {
  return {row.stage, row.term, scientific(row.worst_error) + "  " + entry_text(row.worst),
          row.states == 0 ? "skipped"
          : row.pass      ? "pass"
                          : "FAIL"};
}

std::string failure_text(const ProblemCheckRow& row) {
  return "stage '" + row.stage + "', " + row.term + ": " + entry_text(row.worst) + " is " +
         precise(row.worst.value) + ", finite differences give " + precise(row.worst.expected) +
         " (state " + std::to_string(row.worst.state) + ")\n";
}

}  // namespace

std::string ProblemReport::text() const {
  if (rows.empty()) return "nothing was checked\n";
  std::string text = robot + ": every stage and cost term, tolerance " + number(tolerance) + "\n\n";
  std::vector<Cells> lines{{"stage", "term", "worst error and its entry", "result"}};
  for (const ProblemCheckRow& row : rows) lines.push_back(cells_of(row));
  text += table(lines) + "\n";
  for (const ProblemCheckRow& row : rows)
    if (!row.pass) text += failure_text(row);
  return text + verdict(rows);
}

}  // namespace burnish
