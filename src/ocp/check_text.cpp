// The report of a problem's check as a table.
#include <algorithm>
#include <array>
#include <cstdio>

#include "burnish/ocp/check.hpp"
#include "model/sentence.hpp"

namespace burnish {
namespace {

constexpr std::size_t columns = 4;
using Cells = std::array<std::string, columns>;

std::string scientific(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1e", value);
  return text;
}

std::string precise(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

std::string entry_text(const CheckEntry& entry) {
  return entry.block.empty() ? "-" : entry.block + "(" + entry.row + ", " + entry.column + ")";
}

Cells cells_of(const ProblemCheckRow& row) {
  return {row.stage, row.term, scientific(row.worst_error) + "  " + entry_text(row.worst),
          row.states == 0 ? "passed over"
          : row.pass      ? "pass"
                          : "FAIL"};
}

std::string table(const std::vector<Cells>& lines) {
  std::array<std::size_t, columns> widths{};
  for (const Cells& cells : lines)
    for (std::size_t c = 0; c < columns; ++c) widths[c] = std::max(widths[c], cells[c].size());
  std::string text;
  for (const Cells& cells : lines) {
    for (std::size_t c = 0; c + 1 < columns; ++c)
      text += cells[c] + std::string(widths[c] - cells[c].size() + 2, ' ');
    text += cells.back() + "\n";
  }
  return text;
}

std::string failure_text(const ProblemCheckRow& row) {
  return "stage '" + row.stage + "', " + row.term + ": " + entry_text(row.worst) + " is " +
         precise(row.worst.value) + ", differences say " + precise(row.worst.expected) +
         " (state " + std::to_string(row.worst.state) + ")\n";
}

}  // namespace

std::string ProblemReport::text() const {
  if (rows.empty()) return "nothing was checked\n";
  std::string text = robot + ": every stage and cost term, tolerance " + number(tolerance) + "\n\n";
  std::vector<Cells> lines{{"stage", "term", "worst error and its entry", "result"}};
  std::size_t failed = 0;
  for (const ProblemCheckRow& row : rows) {
    lines.push_back(cells_of(row));
    failed += row.pass ? 0 : 1;
  }
  text += table(lines) + "\n";
  for (const ProblemCheckRow& row : rows)
    if (!row.pass) text += failure_text(row);
  if (failed > 0)
    return text + "FAIL: " + std::to_string(failed) + " of " + std::to_string(rows.size()) +
           (rows.size() == 1 ? " row\n" : " rows\n");
  const auto worst = std::max_element(rows.begin(), rows.end(), [](const auto& x, const auto& y) {
    return x.worst_error < y.worst_error;
  });
  const std::string passed =
      rows.size() == 1 ? "1 row" : "all " + std::to_string(rows.size()) + " rows";
  return text + "pass: " + passed + ", worst error " + scientific(worst->worst_error) + "\n";
}

}  // namespace burnish
