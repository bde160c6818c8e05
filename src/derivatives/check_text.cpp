// Text of a derivative check: a table with one line per row, failures and the verdict.
#include <algorithm>
#include <array>

#include "base/sentence.hpp"
#include "burnish/derivatives/check.hpp"
#include "derivatives/check_table.hpp"

namespace burnish {
namespace {

using Cells = std::array<std::string, 7>;

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

std::string failure_text(const CheckRow& row) {
  return entry_text(row.worst) + " is " + precise(row.worst.value) + ", finite differences give " +
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
  std::size_t soft = 0;
  for (const CheckRow& row : rows) {
    lines.push_back(cells_of(row));
    soft += row.mu > 0.0 ? 1 : 0;
  }
  text += table(lines) + "\n";
  if (soft > 0) {
    text += std::to_string(soft) + (soft == 1 ? " row" : " rows") +
            " checked with a compliance mu, because the contact is singular at too many random "
            "postures\n";
  }
  for (const CheckRow& row : rows)
    if (!row.pass) text += failure_text(row);
  if (singular_mass.empty()) return text + verdict(rows);
  const bool others =
      std::all_of(rows.begin(), rows.end(), [](const auto& row) { return row.pass; });
  return text + (others ? "" : verdict(rows)) +
         "FAIL: the model has no forward dynamics: " + singular_mass +
         (others ? "; inverse dynamics and contact accelerations pass\n" : "\n");
}

}  // namespace burnish
