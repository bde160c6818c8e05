// Strict reader of values in YAML or JSON text. Error messages name file, line and key.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "burnish/base/error.hpp"
#include "burnish/base/views.hpp"
#include "document/node.hpp"

namespace burnish::document {

/// Access to one value of a YAML or JSON tree. All functions throw Error
/// "FILE: line N: path.of.keys: sentence" if the value does not fit. Readers are cheap to copy and
/// share ownership of the tree.
class Reader {
 public:
  /// Reads a YAML file. Throws Error if the file cannot be opened or is not valid YAML.
  static Reader load(const std::filesystem::path& file);
  /// Parses YAML text, called `name` in messages. Throws Error if the text is not valid YAML.
  static Reader parse(const std::string& text, const std::string& name);
  /// Parses JSON text, called `name` in messages. Throws Error if the text is not valid JSON.
  static Reader parse_json(const std::string& text, const std::string& name);
  /// Returns the tree {a: {b: value}} for the path "a.b", called `name` in messages. A value that
  /// begins with a bracket, a brace or a quote is parsed as YAML; any other value is one scalar.
  static Reader parse_override(const std::string& path, const std::string& value,
                               const std::string& name);
  /// Gives access to a tree, called `name` in messages. `path` is the path of keys to its root.
  Reader(Node root, std::string name, std::string path = "");

  /// Throws Error about this value: "<file>: line N: <path>: <what>".
  [[noreturn]] void refuse(const std::string& what) const;
  std::string path() const;
  const std::string& file() const { return document_->name; }
  const Node& node() const { return *node_; }

  bool is_null() const { return node_->kind == Kind::Null; }
  bool is_map() const { return node_->kind == Kind::Map; }
  bool is_list() const { return node_->kind == Kind::List; }
  bool is_text() const { return node_->kind == Kind::Text || node_->kind == Kind::Bool; }
  bool is_number() const { return node_->kind == Kind::Number; }
  /// Returns true if the value is the scalar `word`.
  bool is(const std::string& word) const { return node_->is_scalar() && node_->text == word; }
  /// Number of entries of a list or of keys of a map; 0 for a scalar.
  std::size_t size() const { return node_->size(); }

  /// Throws Error unless the value is a map whose keys are all in `keys`.
  void allow_only(const std::vector<std::string>& keys) const;
  bool has(const std::string& key) const { return value_of(key) != nullptr; }
  /// Returns the value of a key. Throws Error if the key is missing.
  Reader operator[](const std::string& key) const;
  /// Returns the value of a key, or nothing if the key is missing.
  std::optional<Reader> find(const std::string& key) const;
  /// Returns keys and values of a map, in the order of the file.
  std::vector<std::pair<std::string, Reader>> items() const;
  /// Returns the entries of a list.
  std::vector<Reader> entries() const;
  /// Returns this map with the keys of `changes` added or replaced. Messages about the result name
  /// the place of `changes`.
  Reader changed_by(const Reader& changes) const;

  double number() const;                         ///< Returns a finite number
  double number(double low, double high) const;  ///< Returns a number from low to high
  double positive() const;
  double not_negative() const;
  /// Returns a whole number from `low` to `high`.
  int count(int low, int high = 1'000'000'000) const;
  bool yes_or_no() const;
  std::string text() const;
  std::vector<std::string> texts() const;              ///< Returns the texts of a list, or one text
  Eigen::VectorXd numbers() const;                     ///< Returns a list of any length except 0
  Eigen::VectorXd numbers(Eigen::Index wanted) const;  ///< Returns a list of this length
  Eigen::Vector3d vector3() const { return numbers(3); }
  /// Returns a text that is one of `known`. Throws Error with the nearest word for other texts.
  std::string word(const std::vector<std::string>& known) const;

  /// Calls `function` and rethrows its Error with file, line and path of this value in front. A
  /// message that already begins with this file does not change.
  template <class Function>
  decltype(auto) named(Function&& function) const {
    try {
      return function();
    } catch (const Error& error) {
      refuse(error.what());
    }
  }

 private:
  struct Document {
    std::string name;  ///< Name of the file
    std::string path;  ///< Path of keys to the root, if the tree is a part of a larger one
    Node root;
  };
  Reader(std::shared_ptr<const Document> document, const Node* node)
      : document_(std::move(document)), node_(node) {}

  const Node* value_of(const std::string& key) const;
  [[noreturn]] void refuse_kind(const std::string& wanted) const;

  std::shared_ptr<const Document> document_;
  const Node* node_;
};

/// Joins words for a sentence: "a, b or c".
std::string either(const std::vector<std::string>& words);

}  // namespace burnish::document
