// The report of a check as a table.
#include <algorithm>
#include <array>
#include <cstdio>

#include "burnish/derivatives/check.hpp"
#include "model/sentence.hpp"

namespace burnish {
namespace {

constexpr std::size_t columns = 7;
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
  return entry.block + "(" + entry.row + ", " + entry.column + ")";
}

Cells cells_of(const CheckRow& row) {
  return {
      row.reference,
      row.directions,
      row.acceleration,
      row.gains + (row.error.find_first_not_of("-+ ") == std::string::npos ? "" : ", " + row.error),
      row.mu > 0.0 ? "mu " + scientific(row.mu) : "rigid",
      scientific(row.worst_error) + "  " + entry_text(row.worst),
      row.pass ? "pass" : "FAIL"};
}

std::string table(const std::vector<Cells>& lines) {
  std::array<std::size_t, columns> widths{};
  for (const Cells& cells : lines)
    for (std::size_t c = 0; c < columns; ++c) widths[c] = std::max(widths[c], cells[c].size());
  std::string text;
  for (const Cells& cells : lines) {
    for (std::size_t c = 0; c + 1 < columns; ++c) {
      text += cells[c] + std::string(widths[c] - cells[c].size() + 2, ' ');
    }
    text += cells.back() + "\n";
  }
  return text;
}

std::string failure_text(const CheckRow& row) {
  return entry_text(row.worst) + " is " + precise(row.worst.value) + ", differences say " +
         precise(row.worst.expected) + " (" + row.reference + ", " + row.directions + ", state " +
         std::to_string(row.worst.state) + ")\n";
}

}  // namespace

std::string CheckReport::text() const {
  if (rows.empty()) return "nothing was checked\n";
  std::string bodies = rows.front().bodies;
  std::string text = robot + ": " + bodies + ", " + std::to_string(rows.front().states) +
                     " states per row, tolerance " + number(tolerance) + "\n\n";
  std::vector<Cells> lines{{"reference", "directions", "acceleration", "gains", "contact",
                            "worst error and its entry", "result"}};
  std::size_t failed = 0, soft = 0;
  for (const CheckRow& row : rows) {
    lines.push_back(cells_of(row));
    failed += row.pass ? 0 : 1;
    soft += row.mu > 0.0 ? 1 : 0;
  }
  text += table(lines) + "\n";
  if (soft > 0) {
    text += std::to_string(soft) + (soft == 1 ? " row" : " rows") +
            " checked with compliance mu: at most postures the joints cannot hold that "
            "contact rigidly\n";
  }
  for (const CheckRow& row : rows)
    if (!row.pass) text += failure_text(row);
  if (failed > 0) {
    return text + "FAIL: " + std::to_string(failed) + " of " + std::to_string(rows.size()) +
           (rows.size() == 1 ? " row\n" : " rows\n");
  }
  const auto worst = std::max_element(rows.begin(), rows.end(), [](const auto& x, const auto& y) {
    return x.worst_error < y.worst_error;
  });
  const std::string passed =
      rows.size() == 1 ? "1 row" : "all " + std::to_string(rows.size()) + " rows";
  return text + "pass: " + passed + ", worst error " + scientific(worst->worst_error) + "\n";
}

}  // namespace burnish
