// One tree for what YAML and JSON say: values, and where each of them stands.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace burnish::document {

enum class Kind : std::uint8_t { Null, Bool, Number, Text, List, Map };

/// Where a value begins in its text, counted from 1; 0: it was made, not read.
struct Place {
  std::uint32_t line = 0, column = 0;
};

struct Node {
  Kind kind = Kind::Null;
  Place place = {};
  std::string text = {};          ///< of a scalar: as it was written, a Text without its quotes
  std::vector<Node> values = {};  ///< of a list; of a map key, value, key, value, in order

  bool is_scalar() const { return kind < Kind::List; }
  /// Of a list its values, of a map its pairs.
  std::size_t size() const { return kind == Kind::Map ? values.size() / 2 : values.size(); }
};

/// Trees that are nested deeper are refused: those who read them follow by functions that call
/// themselves.
inline constexpr std::size_t max_nesting = 64;

}  // namespace burnish::document
