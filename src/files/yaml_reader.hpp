// A node of a YAML file that knows where it stands, read strictly.
#pragma once

#include <yaml-cpp/yaml.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "burnish/base/error.hpp"

namespace burnish::files {

/// Every refusal is an Error "FILE: line N: path.of.keys: sentence".
class YamlReader {
 public:
  YamlReader(const YamlReader&) = default;
  /// Assigning a YAML::Node writes into the tree that it belongs to.
  YamlReader& operator=(const YamlReader&) = delete;

  /// The whole file. Throws Error where it cannot be opened or is no YAML.
  static YamlReader load(const std::filesystem::path& file);
  /// A text, called `name` in refusals. Throws Error where it is no YAML.
  static YamlReader parse(const std::string& text, const std::string& name);

  [[noreturn]] void refuse(const std::string& what) const;
  const std::string& path() const { return path_; }
  const std::string& file() const { return file_; }

  bool is_map() const { return node_.IsMap(); }
  bool is_list() const { return node_.IsSequence(); }
  bool is_text() const;
  bool is_number() const;
  /// A plain word, such as `here`.
  bool is(const std::string& word) const { return node_.IsScalar() && node_.Scalar() == word; }

  /// Refuses anything but a map with keys among these.
  void allow_only(const std::vector<std::string>& keys) const;
  bool has(const std::string& key) const;
  /// The value of a key; refuses where it is missing.
  YamlReader operator[](const std::string& key) const;
  std::optional<YamlReader> find(const std::string& key) const;
  /// Keys and values in the order of the file; refuses keys that are stated twice.
  std::vector<std::pair<std::string, YamlReader>> items() const;
  /// Entries of a list.
  std::vector<YamlReader> entries() const;
  /// This map, with the keys of `changes` in place of its own. Stands where `changes` stands.
  YamlReader changed_by(const YamlReader& changes) const;

  double number() const;
  double positive() const;
  double not_negative() const;
  int count(int least) const;  ///< a whole number >= least
  bool yes_or_no() const;
  std::string text() const;
  std::vector<std::string> texts() const;  ///< a text or a list of them
  Eigen::VectorXd numbers() const;         ///< a list of any length, not empty
  Eigen::VectorXd numbers(Eigen::Index size) const;
  Eigen::Vector3d vector3() const { return numbers(3); }
  /// One of these words; refuses others with the nearest one.
  std::string word(const std::vector<std::string>& known) const;

  /// Calls `function` and puts this place in front of the sentence of any Error.
  template <class Function>
  decltype(auto) named(Function&& function) const {
    try {
      return function();
    } catch (const Error& error) {
      refuse(error.what());
    }
  }

 private:
  YamlReader(std::string file, std::string path, const YAML::Node& node)
      : file_(std::move(file)), path_(std::move(path)), node_(node) {}
  YamlReader child(const std::string& key, const YAML::Node& value) const;

  std::string file_, path_;
  YAML::Node node_;
};

/// Known words as a sentence names them: "a, b or c".
std::string either(const std::vector<std::string>& words);

}  // namespace burnish::files
