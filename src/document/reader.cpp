#include "document/reader.hpp"

#include <algorithm>
#include <cmath>

#include "base/parse_number.hpp"
#include "base/sentence.hpp"
#include "base/text_file.hpp"
#include "document/builder.hpp"
#include "document/text.hpp"

namespace burnish::document {
namespace {

/// Returns a description of a value for messages, such as "a list".
std::string kind_text(const Node& node) {
  switch (node.kind) {
    case Kind::Null:
      return "nothing";
    case Kind::Bool:
      return node.text;
    case Kind::Number:
      return "the number " + node.text;
    case Kind::Text:
      return "the text " + in_quotes(node.text);
    case Kind::List:
      return "a list";
    case Kind::Map:
      break;
  }
  return "keys with values";
}

/// Appends the path from `at` to `wanted`. Returns false if `wanted` is not below `at`.
bool find_path(const Node& at, const Node* wanted, std::string& path) {
  if (&at == wanted) return true;
  for (std::size_t i = 0; i < at.values.size(); ++i) {
    std::string longer = path_into(path, at, i);
    if (!find_path(at.values[i], wanted, longer)) continue;
    path = std::move(longer);
    return true;
  }
  return false;
}

/// Clears the places, since line numbers do not help in the single line of an override.
void forget_places(Node& node) {
  node.place = {};
  for (Node& value : node.values) forget_places(value);
}

}  // namespace

Reader::Reader(Node root, std::string name, std::string path)
    : document_(std::make_shared<const Document>(
          Document{std::move(name), std::move(path), std::move(root)})),
      node_(&document_->root) {}

Reader Reader::load(const std::filesystem::path& file) {
  return parse(read_text(file, "YAML file"), file.string());
}

Reader Reader::parse(const std::string& text, const std::string& name) {
  return {parse_yaml(text, name), name};
}

Reader Reader::parse_override(const std::string& path, const std::string& value,
                              const std::string& name) {
  Builder tree(name, 1'000'000);
  std::size_t depth = 0;
  for (std::size_t begin = 0; begin <= path.size(); ++depth) {
    const std::size_t dot = std::min(path.find('.', begin), path.size());
    tree.begin(Kind::Map, {});
    tree.add({.kind = Kind::Text, .text = path.substr(begin, dot - begin)});
    begin = dot + 1;
  }
  constexpr const char* blanks = " \t\r\n";
  const std::size_t first = std::min(value.find_first_not_of(blanks), value.size());
  const std::string bare = value.substr(first, value.find_last_not_of(blanks) + 1 - first);
  const bool is_yaml =
      !bare.empty() && std::string("[{\"'").find(bare.front()) != std::string::npos;
  Node node = is_yaml ? parse_yaml(bare, name) : Node{.kind = kind_of_plain(bare), .text = bare};
  forget_places(node);
  if (node.kind == Kind::Null) node.text.clear();
  tree.add(std::move(node));
  while (depth-- > 0) tree.end();
  return {tree.take(), name};
}

std::string Reader::path() const {
  std::string path = document_->path;
  find_path(document_->root, node_, path);
  return path;
}

void Reader::refuse(const std::string& what) const {
  if (what.starts_with(file() + ": ")) burnish::refuse(file(), what.substr(file().size() + 2));
  burnish::refuse(file(), place_text(node_->place, path()) + what);
}

void Reader::refuse_kind(const std::string& wanted) const {
  refuse("it is " + kind_text(*node_) + "; wanted " + wanted);
}

void Reader::allow_only(const std::vector<std::string>& keys) const {
  if (!is_map()) refuse_kind("keys with values");
  for (std::size_t i = 0; i < node_->values.size(); i += 2) {
    const std::string& key = node_->values[i].text;
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    const std::string nearest = did_you_mean(key, keys);
    const std::string sentence = "key " + in_quotes(key) + " is unknown" +
                                 (nearest.empty() ? "; known are " + either(keys) : nearest);
    burnish::refuse(file(), place_text(node_->values[i].place, path()) + sentence);
  }
}

const Node* Reader::value_of(const std::string& key) const {
  if (!is_map()) return nullptr;
  for (std::size_t i = 0; i < node_->values.size(); i += 2)
    if (node_->values[i].text == key) return &node_->values[i + 1];
  return nullptr;
}

std::optional<Reader> Reader::find(const std::string& key) const {
  const Node* const value = value_of(key);
  return value != nullptr ? std::optional(Reader(document_, value)) : std::nullopt;
}

Reader Reader::operator[](const std::string& key) const {
  if (!is_map()) refuse_kind("keys with values, including " + in_quotes(key));
  if (const Node* const value = value_of(key)) return {document_, value};
  refuse("key " + in_quotes(key) + " is missing");
}

std::vector<std::pair<std::string, Reader>> Reader::items() const {
  if (!is_map()) refuse_kind("keys with values");
  std::vector<std::pair<std::string, Reader>> result;
  for (std::size_t i = 0; i < node_->values.size(); i += 2)
    result.emplace_back(node_->values[i].text, Reader(document_, &node_->values[i + 1]));
  return result;
}

std::vector<Reader> Reader::entries() const {
  if (!is_list()) refuse_kind("a list");
  std::vector<Reader> result;
  result.reserve(size());
  for (const Node& value : node_->values) result.push_back({document_, &value});
  return result;
}

Reader Reader::changed_by(const Reader& changes) const {
  Node merged{.kind = Kind::Map, .place = changes.node_->place};
  const auto add = [&](const std::vector<Node>& values, std::size_t i) {
    merged.values.push_back(values[i]);
    merged.values.push_back(values[i + 1]);
  };
  const std::vector<Node>&mine = node_->values, &theirs = changes.node_->values;
  if (!is_map()) refuse_kind("keys with values");
  if (!changes.is_map()) changes.refuse_kind("keys with values");
  for (std::size_t i = 0; i < mine.size(); i += 2)
    if (!changes.has(mine[i].text)) add(mine, i);
  for (std::size_t i = 0; i < theirs.size(); i += 2) add(theirs, i);
  return {std::move(merged), file(), changes.path()};
}

double Reader::number() const {
  if (node_->kind == Kind::Text && !node_->text.empty())
    refuse(in_quotes(node_->text) +
           (kind_of_plain(node_->text) == Kind::Number
                ? " has quotes, so it is a text; wanted a number without quotes"
                : " is not a number"));
  const std::optional<double> value = is_number() ? parse_number(node_->text) : std::nullopt;
  if (!value) refuse_kind("a number");
  if (!std::isfinite(*value)) refuse(burnish::number(*value) + " is not finite");
  return *value;
}

double Reader::number(double low, double high) const {
  const double value = number();
  if (!(value >= low && value <= high))
    refuse("it is " + burnish::number(value) + "; wanted a number between " + burnish::number(low) +
           " and " + burnish::number(high));
  return value;
}

double Reader::positive() const {
  const double value = number();
  if (!(value > 0.0)) refuse("it is " + burnish::number(value) + "; wanted more than 0");
  return value;
}

double Reader::not_negative() const {
  const double value = number();
  if (value < 0.0) refuse("it is " + burnish::number(value) + "; wanted at least 0");
  return value;
}

int Reader::count(int low, int high) const {
  const double value = number();
  if (value != std::floor(value))
    refuse("it is " + burnish::number(value) + "; wanted a whole number");
  if (value < low)
    refuse("it is " + burnish::number(value) + "; wanted at least " + std::to_string(low));
  if (value > high)
    refuse("it is " + burnish::number(value) + "; wanted at most " + std::to_string(high));
  return static_cast<int>(value);
}

bool Reader::yes_or_no() const {
  if (node_->kind != Kind::Bool) refuse_kind("true or false");
  return is("true");
}

std::string Reader::text() const {
  if (!node_->is_scalar() || node_->text.empty()) refuse_kind("a text");
  return node_->text;
}

std::vector<std::string> Reader::texts() const {
  if (node_->is_scalar()) return {text()};
  std::vector<std::string> result;
  for (const Reader& entry : entries()) result.push_back(entry.text());
  return result;
}

Eigen::VectorXd Reader::numbers() const {
  if (!is_list()) refuse_kind("a list of numbers");
  if (size() == 0) refuse("the list is empty; wanted numbers");
  Eigen::VectorXd result(static_cast<Eigen::Index>(size()));
  for (std::size_t i = 0; i < size(); ++i)
    result[static_cast<Eigen::Index>(i)] = Reader(document_, &node_->values[i]).number();
  return result;
}

Eigen::VectorXd Reader::numbers(Eigen::Index wanted) const {
  if (!is_list()) refuse_kind("a list of " + std::to_string(wanted) + " numbers");
  if (static_cast<Eigen::Index>(size()) != wanted)
    refuse("it has " + std::to_string(size()) + " numbers; wanted " + std::to_string(wanted));
  return wanted == 0 ? Eigen::VectorXd() : numbers();
}

std::string Reader::word(const std::vector<std::string>& known) const {
  const std::string value = text();
  if (std::find(known.begin(), known.end(), value) != known.end()) return value;
  const std::string nearest = did_you_mean(value, known);
  refuse(in_quotes(value) + " is unknown" +
         (nearest.empty() ? "; wanted " + either(known) : nearest));
}

std::string either(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text;
}

}  // namespace burnish::document
