// Search for words in names, independent of case.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>

namespace burnish {

/// Returns `text` with A to Z in lower case; other bytes do not change.
inline std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// Returns true if `text` contains one of `words`, in any case. `words` must be in lower case.
inline bool has_one_of(std::string_view text, std::initializer_list<std::string_view> words) {
  const std::string small = lower_case(std::string(text));
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return small.find(word) != std::string::npos; });
}

}  // namespace burnish
