// A tree from the events of a parser, with what every text has to keep to.
#pragma once

#include <string>
#include <vector>

#include "document/node.hpp"

namespace burnish::document {

/// Throws Error for what is nested too deep or has too many values, for keys that are no names,
/// and for those that a map has twice.
class Builder {
 public:
  /// `name` is what refusals call the text; it has to live as long.
  Builder(const std::string& name, std::size_t max_values) : name_(name), max_values_(max_values) {}

  /// What comes next is a key of a map.
  bool expects_key() const {
    return !open_.empty() && open_.back().kind == Kind::Map && open_.back().values.size() % 2 == 0;
  }
  /// A scalar.
  void add(Node&& node);
  /// Counts what is about to be copied, of which there is less than of what is read: a text of a
  /// few lines can ask for a lot of it.
  void count_copy(const Node& node, Place place);
  /// A copy of a tree, which stands here.
  void add_copy(const Node& node, Place place);
  void begin(Kind kind, Place place);
  /// Ends the innermost list or map, which `seen` sees before it goes into what holds it.
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
  /// The tree; null where nothing came. Here keys that are no names are refused: of a text that is
  /// cut off they are no news.
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
  std::string bad_key_;  ///< what is wrong with the first one, or empty
};

/// "line 3: a.b[2]: ", as much of it as there is.
std::string place_text(Place place, const std::string& path);
/// The path of what a list or a map holds at `index` of its values.
std::string path_into(const std::string& path, const Node& holder, std::size_t index);

}  // namespace burnish::document
