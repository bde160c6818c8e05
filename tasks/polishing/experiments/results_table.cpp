#include "polishing/experiments/results_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/csv_cell.hpp"
#include "burnish/base/error.hpp"

namespace burnish::polishing {
namespace {

std::string rounded(double value, int digits) {
  char text[64];
  const bool readable = std::abs(value) < 1e9;
  // Removes the sign of a negative value that is rounded to zero.
  const double unit = std::pow(10.0, -digits);
  if (std::abs(value) < 0.5 * unit) value = 0.0;
  std::snprintf(text, sizeof text, readable ? "%.*f" : "%.*e", digits, value);
  return text;
}

std::string cell_text(const ResultCell& cell, const ResultColumn& column) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  const auto* value = std::get_if<double>(&cell);
  return value != nullptr && std::isfinite(*value) ? rounded(*value, column.digits) : "-";
}

/// Escapes the character "|", which separates the cells of a Markdown table.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result;
}

bool holds_numbers(const ResultTable& table, std::size_t column) {
  for (const auto& row : table.rows)
    if (std::holds_alternative<std::string>(row[column])) return false;
  return true;
}

}  // namespace

void ResultTable::add(std::vector<ResultCell> row) {
  if (row.size() != columns.size())
    throw Error("a row of the table '" + name + "' has " + std::to_string(row.size()) +
                " cells; wanted " + std::to_string(columns.size()));
  rows.push_back(std::move(row));
}

std::string markdown(const ResultTable& table) {
  // Pads the cells with blanks, so that the table is readable as plain text too.
  std::string head = "|", line = "|";
  std::vector<std::string> lines(table.rows.size(), "|");
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const ResultColumn& column = table.columns[i];
    const std::string name = column.name + (column.unit.empty() ? "" : " [" + column.unit + "]");
    const bool numbers = holds_numbers(table, i);
    std::vector<std::string> cells;
    std::size_t width = std::max<std::size_t>(name.size(), 4);
    for (const auto& row : table.rows) {
      cells.push_back(escaped(cell_text(row[i], column)));
      width = std::max(width, cells.back().size());
    }
    const auto padded = [&](const std::string& text) {
      const std::string space(width - text.size(), ' ');
      return " " + (numbers ? space + text : text + space) + " |";
    };
    head += padded(name);
    line += " " + std::string(numbers ? width - 1 : width, '-') + (numbers ? ":" : "") + " |";
    for (std::size_t k = 0; k < lines.size(); ++k) lines[k] += padded(cells[k]);
  }
  std::string text = head + "\n" + line + "\n";
  for (const std::string& each : lines) text += each + "\n";
  return text;
}

std::string csv(const ResultTable& table) {
  std::string text;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const ResultColumn& column = table.columns[i];
    if (i > 0) text += ",";
    append_cell(text, column.name + (column.unit.empty() ? "" : " [" + column.unit + "]"));
  }
  text += "\n";
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) text += ",";
      if (const auto* words = std::get_if<std::string>(&row[i])) append_cell(text, *words);
      const auto* value = std::get_if<double>(&row[i]);
      if (value != nullptr && std::isfinite(*value)) append_cell(text, *value);
    }
    text += "\n";
  }
  return text;
}

}  // namespace burnish::polishing
