// Builds a tree of nodes from events of a YAML or JSON parser and checks limits of both formats.
#pragma once

#include <string>
#include <vector>

#include "document/node.hpp"

namespace burnish::document {

/// Builder of a tree. Throws Error if values are nested too deep, if there are too many values, if
/// a key is not a name, or if a map has a key twice.
class Builder {
 public:
  /// Messages call the text `name`, which must outlive the Builder.
  Builder(const std::string& name, std::size_t max_values) : name_(name), max_values_(max_values) {}

  /// Returns true if the next scalar is a key of a map.
  bool expects_key() const {
    return !open_.empty() && open_.back().kind == Kind::Map && open_.back().values.size() % 2 == 0;
  }
  /// Adds a scalar.
  void add(Node&& node);
  /// Counts the values of an anchored node before the node is copied. Copied values have a lower
  /// limit than other values, since a few lines of aliases can expand to millions of values.
  void count_copy(const Node& node, Place place);
  /// Adds a copy of `node` for an alias at `place`.
  void add_copy(const Node& node, Place place);
  /// Begins a list or a map.
  void begin(Kind kind, Place place);
  /// Ends the innermost list or map and passes it to `seen` before adding it to its parent.
  template <class See>
  void end(See&& seen) {
    check_keys(open_.back());
    Node node = std::move(open_.back());
    open_.pop_back();
    seen(node);
    put(std::move(node));
  }
  void end() {
    end([](const Node&) {});
  }
  /// Returns the tree, or a Null node if there were no events. Throws Error for the first key that
  /// is not a name. This check comes last, so that syntax errors are reported first.
  Node take();

  /// Throws Error("<name>: line N: <keys that lead to here>: <what>").
  [[noreturn]] void refuse(Place place, const std::string& what) const;

 private:
  std::string sentence(Place place, const std::string& what) const;
  void check_key(const Node& node);
  void count(const Node& node, std::size_t depth);
  void put(Node&& node);
  void check_keys(const Node& map) const;

  const std::string& name_;
  std::size_t max_values_, values_ = 0, copied_ = 0;
  std::vector<Node> open_;
  Node root_;
  std::string bad_key_;  ///< Message about the first invalid key, or empty
};

/// Returns a text such as "line 3: a.b[2]: ". Omits an unknown line (0) and an empty path.
std::string place_text(Place place, const std::string& path);
/// Returns the path of the value holder.values[index], where `path` is the path of `holder`.
std::string path_into(const std::string& path, const Node& holder, std::size_t index);

}  // namespace burnish::document
