// Tree of the values of a YAML or JSON document, with the place of each value in the text.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace burnish::document {

enum class Kind : std::uint8_t { Null, Bool, Number, Text, List, Map };

/// Line and column at which a value begins, counted from 1; 0: the value does not come from a text.
struct Place {
  std::uint32_t line = 0, column = 0;
};

/// One value: a scalar, a list or a map.
struct Node {
  Kind kind = Kind::Null;
  Place place = {};
  std::string text = {};  ///< Scalar: text as in the file, without quotes
  /// List: the entries. Map: key, value, key, value, ..., in the order of the file.
  std::vector<Node> values = {};

  bool is_scalar() const { return kind < Kind::List; }
  /// Number of entries of a list, or of pairs of a map.
  std::size_t size() const { return kind == Kind::Map ? values.size() / 2 : values.size(); }
};

/// Maximum nesting depth of a tree. It bounds the recursion of the functions that read trees.
inline constexpr std::size_t max_nesting = 64;

}  // namespace burnish::document
