// Pieces of the sentences that bad input is answered with.
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/base/error.hpp"

namespace burnish {

/// A number as a reader would write it: six significant digits.
inline std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

/// A name between quotes; what is too long for a name is cut.
inline std::string in_quotes(std::string_view name) {
  constexpr std::size_t longest = 80;
  std::string result(1, '\'');
  result.append(name.substr(0, longest)).append(name.size() > longest ? "..." : "");
  return result.append(1, '\'');
}

/// "joint 'a'", "joints 'a', 'b' and 'c'"; of more than ten "joints 'a', ... and 5 more".
inline std::string listed(const std::string& kind, const std::vector<std::string>& names) {
  constexpr std::size_t most = 10;
  std::string text = kind + (names.size() == 1 ? " " : "s ");
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) {
    const bool is_last = i > 0 && i + 1 == names.size();
    text += (i == 0 ? "" : is_last ? " and " : ", ") + in_quotes(names[i]);
  }
  return names.size() > most ? text + " and " + std::to_string(names.size() - most) + " more"
                             : text;
}

/// Throws Error("<origin>: <what>").
[[noreturn]] inline void refuse(const std::string& origin, const std::string& what) {
  throw Error(origin + ": " + what);
}

}  // namespace burnish
