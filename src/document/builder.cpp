#include "document/builder.hpp"

#include <algorithm>
#include <string_view>

#include "base/sentence.hpp"

namespace burnish::document {

std::string place_text(Place place, const std::string& path) {
  return (place.line == 0 ? "" : "line " + std::to_string(place.line) + ": ") +
         (path.empty() ? "" : path + ": ");
}

std::string path_into(const std::string& path, const Node& holder, std::size_t index) {
  if (holder.kind == Kind::List) return path + "[" + std::to_string(index) + "]";
  return (path.empty() ? "" : path + ".") + holder.values[index - index % 2].text;
}

std::string Builder::sentence(Place place, const std::string& what) const {
  std::string path;
  for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
    const bool is_map = open_[i].kind == Kind::Map;
    const std::size_t count = open_[i].values.size();
    if (is_map && count % 2 == 0) break;  // the next open node is a key, which does not have a path
    path = path_into(path, open_[i], is_map ? count - 1 : count);
  }
  return name_ + ": " + place_text(place, path) + what;
}

void Builder::refuse(Place place, const std::string& what) const {
  throw Error(sentence(place, what));
}

Node Builder::take() {
  if (!bad_key_.empty()) throw Error(bad_key_);
  return std::move(root_);
}

void Builder::check_key(const Node& node) {
  if (expects_key() && bad_key_.empty() && (!node.is_scalar() || node.kind == Kind::Null))
    bad_key_ = sentence(node.place, "a key is not a name; wanted a name");
}

void Builder::count(const Node& node, std::size_t depth) {
  if (++values_ > max_values_)
    refuse(node.place, "the document has more than " + std::to_string(max_values_) +
                           " values, the maximum number");
  if (node.is_scalar()) return;
  if (depth >= max_nesting)
    refuse(node.place,
           "values are nested more than " + std::to_string(max_nesting) + " deep, the maximum");
  for (const Node& value : node.values) count(value, depth + 1);
}

void Builder::put(Node&& node) {
  if (open_.empty())
    root_ = std::move(node);
  else
    open_.back().values.push_back(std::move(node));
}

void Builder::add(Node&& node) {
  count(node, open_.size());
  check_key(node);
  put(std::move(node));
}

namespace {
/// Number of values in a tree. Each 32 bytes of a long text count as one more value.
std::size_t weight(const Node& node) {
  std::size_t sum = 1 + node.text.size() / 32;
  for (const Node& value : node.values) sum += weight(value);
  return sum;
}
}  // namespace

void Builder::count_copy(const Node& node, Place place) {
  constexpr std::size_t max_copied = 200'000;
  copied_ += weight(node);
  if (copied_ > max_copied)
    refuse(place, "anchors and aliases expand to more than " + std::to_string(max_copied) +
                      " values, the maximum number");
}

void Builder::add_copy(const Node& node, Place place) {
  count_copy(node, place);
  add(Node(node));
}

void Builder::begin(Kind kind, Place place) {
  Node node{.kind = kind, .place = place};
  count(node, open_.size());
  check_key(node);
  open_.push_back(std::move(node));
}

void Builder::check_keys(const Node& map) const {
  if (map.kind != Kind::Map || !bad_key_.empty()) return;
  std::vector<const Node*> keys;
  for (std::size_t i = 0; i < map.values.size(); i += 2) keys.push_back(&map.values[i]);
  std::stable_sort(keys.begin(), keys.end(),
                   [](const Node* a, const Node* b) { return a->text < b->text; });
  const auto twin = std::adjacent_find(
      keys.begin(), keys.end(), [](const Node* a, const Node* b) { return a->text == b->text; });
  if (twin != keys.end())
    refuse((*(twin + 1))->place,
           "key " + in_quotes((*twin)->text) + " is stated twice; state it once");
}

}  // namespace burnish::document
