#include "base/yaml_word.hpp"

#include <cctype>
#include <cstdio>

namespace burnish {

std::string yaml_word(const std::string& text) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  const auto harmless = [&](unsigned char c) {
    return plain(c) || c == '/' || c == '.' || c == '-';
  };
  const bool is_path = text.starts_with('/') || text.starts_with("../");
  // A colon inside a word, as in talos:right_arm, does not end a key.
  bool bare = !text.empty() && (is_path || plain(text.front())) && plain(text.back());
  for (const char c : text) bare = bare && (harmless(c) || c == ':');
  // YAML words for a null value.
  for (const char* word : {"null", "Null", "NULL"}) bare = bare && text != word;
  if (bare) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    char code[8] = {c};
    if (c == '"' || c == '\\') std::snprintf(code, sizeof code, "\\%c", c);
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
      std::snprintf(code, sizeof code, "\\x%02X", static_cast<unsigned>(c));
    quoted += code;
  }
  return quoted + "\"";
}

}  // namespace burnish
