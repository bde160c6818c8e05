#include <charconv>
#include <cmath>

#include "base/yaml_word.hpp"
#include "document/text.hpp"

namespace burnish::document {
namespace {

void put_quoted(const std::string& text, std::string& out) {
  out += '"';
  for (const char c : text) {
    char code[8] = {c};
    if (c == '"' || c == '\\') std::snprintf(code, sizeof code, "\\%c", c);
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
      std::snprintf(code, sizeof code, "\\u%04X", static_cast<unsigned>(c));
    out += code;
  }
  out += '"';
}

/// Appends a tree to `out`. Texts in the tree are appended by `put_text`.
template <class PutText>
void put(const Node& node, const PutText& put_text, std::string& out) {
  if (node.kind == Kind::Text) {
    put_text(node.text, out);
  } else if (node.is_scalar()) {
    out += node.kind == Kind::Null ? "null" : node.text;
  } else {
    const bool is_map = node.kind == Kind::Map;
    out += is_map ? '{' : '[';
    for (std::size_t i = 0; i < node.values.size(); ++i) {
      const bool is_key = is_map && i % 2 == 0;
      if (is_key)
        put_text(node.values[i].text, out);
      else
        put(node.values[i], put_text, out);
      if (i + 1 < node.values.size()) out += is_key ? ": " : ", ";
    }
    out += is_map ? '}' : ']';
  }
}

}  // namespace

std::string json_text(const Node& node) {
  std::string out;
  put(node, put_quoted, out);
  return out;
}

std::string yaml_text(const Node& node) {
  std::string out;
  const auto put_text = [](const std::string& text, std::string& to) {
    if (kind_of_plain(text) == Kind::Text)
      to += yaml_word(text);
    else
      put_quoted(text, to);
  };
  put(node, put_text, out);
  return out;
}

std::string number_text(double value) {
  char text[32];
  const double size = std::abs(value);
  const bool plain = value == 0.0 || (size >= 1e-4 && size < 1e9);
  const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
  return {text, std::to_chars(text, text + sizeof text, value, format).ptr};
}

}  // namespace burnish::document
