// Cells of the CSV files that are written.
#pragma once

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

namespace burnish {

/// Reads back as it was; nothing where it is not a number.
inline void append_cell(std::string& line, double value) {
  if (std::isnan(value)) return;
  char text[32];
  line.append(text, std::to_chars(text, text + sizeof text, value).ptr);
}

/// Between quotes where a comma, a quote or a line's end would end the cell.
inline void append_cell(std::string& line, std::string_view text) {
  if (text.find_first_of(",\"\n") == std::string_view::npos) {
    line += text;
    return;
  }
  line += '"';
  for (const char c : text) line.append(c == '"' ? 2 : 1, c);
  line += '"';
}

}  // namespace burnish
