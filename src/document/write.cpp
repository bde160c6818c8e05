#include "base/sentence.hpp"
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

void put(const Node& node, std::string& out) {
  if (node.kind == Kind::Text) {
    put_quoted(node.text, out);
  } else if (node.is_scalar()) {
    out += node.kind == Kind::Null ? "null" : node.text;
  } else {
    const bool is_map = node.kind == Kind::Map;
    out += is_map ? '{' : '[';
    for (std::size_t i = 0; i < node.values.size(); ++i) {
      if (is_map && i % 2 == 0)
        put_quoted(node.values[i].text, out);
      else
        put(node.values[i], out);
      if (i + 1 < node.values.size()) out += is_map && i % 2 == 0 ? ": " : ", ";
    }
    out += is_map ? '}' : ']';
  }
}

}  // namespace

std::string one_line(const Node& node) {
  std::string out;
  put(node, out);
  return out;
}

}  // namespace burnish::document
