// Building blocks of error messages about invalid input.
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/base/error.hpp"

namespace burnish {

/// Formats a number with six significant digits.
inline std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

/// Returns a name in quotes. Names of more than 80 bytes are cut.
inline std::string in_quotes(std::string_view name) {
  constexpr std::size_t max_length = 80;
  std::string result(1, '\'');
  result.append(name.substr(0, max_length)).append(name.size() > max_length ? "..." : "");
  return result.append(1, '\'');
}

/// Lists names: "joint 'a'", "joints 'a', 'b' and 'c'". After ten names, the list ends with
/// "and 5 more".
inline std::string listed(const std::string& kind, const std::vector<std::string>& names) {
  constexpr std::size_t max_names = 10;
  std::string text = kind + (names.size() == 1 ? " " : "s ");
  for (std::size_t i = 0; i < std::min(names.size(), max_names); ++i) {
    const bool is_last = i > 0 && i + 1 == names.size();
    text += (i == 0 ? "" : is_last ? " and " : ", ") + in_quotes(names[i]);
  }
  return names.size() > max_names
             ? text + " and " + std::to_string(names.size() - max_names) + " more"
             : text;
}

/// Throws Error("<origin>: <what>").
[[noreturn]] inline void refuse(const std::string& origin, const std::string& what) {
  throw Error(origin + ": " + what);
}

}  // namespace burnish
