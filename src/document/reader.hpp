// A value of a YAML or JSON text that knows where it stands, read strictly.
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

/// Every refusal is an Error "FILE: line N: path.of.keys: sentence". Cheap to copy; the tree lives
/// as long as one of its readers.
class Reader {
 public:
  /// A whole file of YAML. Throws Error where it cannot be opened or is no YAML.
  static Reader load(const std::filesystem::path& file);
  /// A text, called `name` in refusals. Throws Error where it is no YAML.
  static Reader parse(const std::string& text, const std::string& name);
  /// The same of JSON.
  static Reader parse_json(const std::string& text, const std::string& name);
  /// {a: {b: value}} of the path "a.b", called `name` in refusals. The value is YAML where it
  /// begins with a bracket, a brace or a quote, and otherwise a scalar, whatever stands in it.
  static Reader parse_override(const std::string& path, const std::string& value,
                               const std::string& name);
  /// A tree that was made.
  Reader(Node root, std::string name, std::string path = "");

  [[noreturn]] void refuse(const std::string& what) const;
  std::string path() const;
  const std::string& file() const { return document_->name; }
  const Node& node() const { return *node_; }

  bool is_null() const { return node_->kind == Kind::Null; }
  bool is_map() const { return node_->kind == Kind::Map; }
  bool is_list() const { return node_->kind == Kind::List; }
  bool is_text() const { return node_->kind == Kind::Text || node_->kind == Kind::Bool; }
  bool is_number() const { return node_->kind == Kind::Number; }
  /// A word, such as `here`.
  bool is(const std::string& word) const { return node_->is_scalar() && node_->text == word; }
  /// Of a list its entries, of a map its keys, or 0.
  std::size_t size() const { return node_->size(); }

  /// Refuses anything but a map with keys among these.
  void allow_only(const std::vector<std::string>& keys) const;
  bool has(const std::string& key) const { return value_of(key) != nullptr; }
  /// The value of a key; refuses where it is missing.
  Reader operator[](const std::string& key) const;
  std::optional<Reader> find(const std::string& key) const;
  /// Keys and values in the order of the file.
  std::vector<std::pair<std::string, Reader>> items() const;
  /// Entries of a list.
  std::vector<Reader> entries() const;
  /// This map, with the keys of `changes` in place of its own. Stands where `changes` stands.
  Reader changed_by(const Reader& changes) const;

  double number() const;                         ///< finite
  double number(double low, double high) const;  ///< in this range
  double positive() const;
  double not_negative() const;
  int count(int least, int most = 1'000'000'000) const;  ///< a whole number in this range
  bool yes_or_no() const;
  std::string text() const;
  std::vector<std::string> texts() const;  ///< a text or a list of them
  Eigen::VectorXd numbers() const;         ///< a list of any length, not empty
  Eigen::VectorXd numbers(Eigen::Index wanted) const;
  Eigen::Vector3d vector3() const { return numbers(3); }
  /// One of these words; refuses others with the nearest one.
  std::string word(const std::vector<std::string>& known) const;

  /// Calls `function` and puts this place in front of the sentence of any Error, unless one of this
  /// file stands there.
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
    std::string name, path;  ///< path: of the root, where this is a part of something
    Node root;
  };
  Reader(std::shared_ptr<const Document> document, const Node* node)
      : document_(std::move(document)), node_(node) {}

  const Node* value_of(const std::string& key) const;
  [[noreturn]] void refuse_kind(const std::string& wanted) const;

  std::shared_ptr<const Document> document_;
  const Node* node_;
};

/// Known words as a sentence names them: "a, b or c".
std::string either(const std::vector<std::string>& words);

}  // namespace burnish::document
