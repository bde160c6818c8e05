// Text of check reports: numbers, tables with left-aligned columns, and the verdict.
#pragma once

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

namespace burnish {

inline std::string scientific(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1e", value);
  return text;
}

inline std::string precise(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

template <std::size_t Columns>
std::string table(const std::vector<std::array<std::string, Columns>>& lines) {
  std::array<std::size_t, Columns> widths{};
  for (const auto& cells : lines)
    for (std::size_t c = 0; c < Columns; ++c) widths[c] = std::max(widths[c], cells[c].size());
  std::string text;
  for (const auto& cells : lines) {
    for (std::size_t c = 0; c + 1 < Columns; ++c)
      text += cells[c] + std::string(widths[c] - cells[c].size() + 2, ' ');
    text += cells.back() + "\n";
  }
  return text;
}

/// Returns the last line of a report: the number of failed rows, or the largest error of all rows.
/// `rows` must not be empty.
template <class Row>
std::string verdict(const std::vector<Row>& rows) {
  const auto failed = std::count_if(rows.begin(), rows.end(), [](const Row& r) { return !r.pass; });
  const std::string count = std::to_string(rows.size());
  if (failed > 0)
    return "FAIL: " + std::to_string(failed) + " of " + count +
           (rows.size() == 1 ? " row\n" : " rows\n");
  const auto worst = std::max_element(rows.begin(), rows.end(), [](const Row& x, const Row& y) {
    return x.worst_error < y.worst_error;
  });
  return "pass: " + (rows.size() == 1 ? "1 row" : "all " + count + " rows") + ", worst error " +
         scientific(worst->worst_error) + "\n";
}

}  // namespace burnish
