// Formats cells of CSV files.
#pragma once

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

namespace burnish {

/// Appends the shortest text that reads back as the same value. Appends nothing for NaN.
inline void append_cell(std::string& line, double value) {
  if (std::isnan(value)) return;
  char text[32];
  line.append(text, std::to_chars(text, text + sizeof text, value).ptr);
}

/// Appends `text`, in quotes if `text` contains a comma, a quote or a line break.
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
