// Words in names, whatever their case.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>

namespace burnish {

/// The text with A to Z in small letters; other bytes stay.
inline std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// Whether a text contains one of the words, which are in small letters, in any case.
inline bool has_one_of(std::string_view text, std::initializer_list<std::string_view> words) {
  const std::string small = lower_case(std::string(text));
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return small.find(word) != std::string::npos; });
}

}  // namespace burnish
