// Files of an MJCF model as one tree: the main file and its included files.
#pragma once

#include <tinyxml2.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "urdf/xml_element.hpp"

namespace burnish::mjcf {

using tinyxml2::XMLElement;

/// Counts the nesting depth of calls.
class DepthGuard {
 public:
  explicit DepthGuard(int& depth) : depth_(depth) { ++depth_; }
  ~DepthGuard() { --depth_; }
  DepthGuard(const DepthGuard&) = delete;
  DepthGuard& operator=(const DepthGuard&) = delete;

 private:
  int& depth_;
};

class Source {
 public:
  /// Parses the main file. Files that the model names are searched in `folder`; without a folder,
  /// no file is opened. Throws Error if the outermost element is not <mujoco>.
  Source(const std::string& xml, const std::string& name,
         std::optional<std::filesystem::path> folder);

  const XMLElement& root() const { return *root_; }
  const std::string& name() const;

  /// Returns the child elements. An <include> is replaced by the elements of its file; <attach> and
  /// <replicate> are replaced by their copies. Throws Error if a file cannot be read, includes
  /// itself, or exceeds the maximum number of files.
  std::vector<const XMLElement*> children(const XMLElement& element);
  /// Returns the child elements without replacing <attach> and <replicate>.
  std::vector<const XMLElement*> stated_children(const XMLElement& element);

  /// Function that returns the copies of an <attach> or <replicate>; called once per element.
  using Expand = std::function<std::vector<const XMLElement*>(const XMLElement&)>;
  void expand_by(Expand expand) { expand_ = std::move(expand); }
  /// Creates an element that belongs to the file and line of another element.
  XMLElement& make(const XMLElement& beside, const char* name);
  /// Creates an element with the given children.
  XMLElement& make_around(const XMLElement& beside, const char* name,
                          std::vector<const XMLElement*> children);
  /// Changes a copied element before its children are added.
  using Rewrite = std::function<void(XMLElement&)>;
  /// Copies an element with its children. Throws Error if the maximum number of copies is exceeded.
  XMLElement& copy(const XMLElement& element, const Rewrite& rewrite);

  /// Returns the root of the model that contains the element: the main model or an opened one.
  const XMLElement& model_of(const XMLElement& element) const;
  /// Returns the root of the model in the file that an element names.
  const XMLElement& open_model(const XMLElement& naming);
  /// Returns the folder of a model's file, relative to the folder of the main file.
  std::filesystem::path folder_of(const XMLElement& root) const;

  /// Returns the path of a file; nothing if it does not exist or no file may be opened.
  std::optional<std::filesystem::path> find(const std::filesystem::path& file) const;

 private:
  struct File {
    std::string name;
    std::filesystem::path path;
    const File* included_by = nullptr;
    const File* model = nullptr;  ///< Main file of the model that includes this file
    std::unique_ptr<tinyxml2::XMLDocument> document;
    const XMLElement* root = nullptr;
  };

  void append(const XMLElement& element, bool expands, std::vector<const XMLElement*>& children);
  const std::vector<const XMLElement*>& expansion(const XMLElement& element);
  /// Returns the root of the file that the element `naming` names: a separate model (`is_model`),
  /// or a part of the same model.
  const XMLElement& opened(const XMLElement& naming, bool is_model);
  File& parse(const std::string& xml, const std::string& name, const File* included_by);
  File& file_of(const XMLElement& element) const;

  std::optional<std::filesystem::path> folder_;
  std::vector<std::unique_ptr<File>> files_;
  std::map<const XMLElement*, const XMLElement*> opened_;  // Key: the naming element
  std::map<const XMLElement*, std::vector<const XMLElement*>> expansions_;
  std::map<const XMLElement*, std::vector<const XMLElement*>>
      inside_;  // Children of elements from make_around()
  Expand expand_;
  std::size_t copies_ = 0;
  int copying_ = 0;
  const XMLElement* root_ = nullptr;
};

/// Returns file and element for messages: "geom 'pad'", or "<geom>" for an element without a name.
XmlPlace place_of(const XMLElement& element);

/// Throws Error("<file>: line 12: geom 'pad': <what>").
[[noreturn]] void refuse_at(const XMLElement& element, const std::string& what);

/// Returns an example for messages, such as "line 12: geom 'pad'".
std::string example_of(const XMLElement& element);

}  // namespace burnish::mjcf
