// The files of an MJCF model: the one that is read and those that it includes, as one tree.
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

/// Counts how deep calls are inside each other.
class Deeper {
 public:
  explicit Deeper(int& depth) : depth_(depth) { ++depth_; }
  ~Deeper() { --depth_; }
  Deeper(const Deeper&) = delete;
  Deeper& operator=(const Deeper&) = delete;

 private:
  int& depth_;
};

class Source {
 public:
  /// `folder`: where the files that the model names are looked for; nothing: none is opened. Throws
  /// Error unless <mujoco> is outermost.
  Source(const std::string& xml, const std::string& name,
         std::optional<std::filesystem::path> folder);

  const XMLElement& root() const { return *root_; }
  const std::string& name() const;

  /// The elements in an element. In place of an <include> stand those of the file that it names, in
  /// place of <attach> and <replicate> what they stand for. Throws Error where a file cannot be
  /// read, includes itself, or is one too many.
  std::vector<const XMLElement*> children(const XMLElement& element);
  /// With <attach> and <replicate> among them as they are.
  std::vector<const XMLElement*> stated_children(const XMLElement& element);

  /// What <attach> and <replicate> stand for, which is asked once for each.
  using Expand = std::function<std::vector<const XMLElement*>(const XMLElement&)>;
  void expand_by(Expand expand) { expand_ = std::move(expand); }
  /// A new element that belongs to the same file and line as another.
  XMLElement& make(const XMLElement& beside, const char* name);
  /// A new element of which others are the children.
  XMLElement& make_around(const XMLElement& beside, const char* name,
                          std::vector<const XMLElement*> children);
  /// Changes a copy of one element, whose children are not there yet.
  using Rewrite = std::function<void(XMLElement&)>;
  /// A copy of an element and of all in it. Throws Error for one too many.
  XMLElement& copy(const XMLElement& element, const Rewrite& rewrite);

  /// The root of the model that an element belongs to: the file's, or one that was opened.
  const XMLElement& model_of(const XMLElement& element) const;
  /// The root of the model in the file that an element names.
  const XMLElement& open_model(const XMLElement& naming);
  /// The folder of a model's file, from that of the main one.
  std::filesystem::path folder_of(const XMLElement& root) const;

  /// The file by that name, or nothing where it is not there or none is opened.
  std::optional<std::filesystem::path> find(const std::filesystem::path& file) const;

 private:
  struct File {
    std::string name;
    std::filesystem::path path;
    const File* included_by = nullptr;
    const File* model = nullptr;  ///< that it is a part of
    std::unique_ptr<tinyxml2::XMLDocument> document;
    const XMLElement* root = nullptr;
  };

  void append(const XMLElement& element, bool expands, std::vector<const XMLElement*>& children);
  const std::vector<const XMLElement*>& expansion(const XMLElement& element);
  /// The root of the file that an element names, which is a model of its own or part of another.
  const XMLElement& opened(const XMLElement& naming, bool is_model);
  File& parse(const std::string& xml, const std::string& name, const File* included_by);
  File& file_of(const XMLElement& element) const;

  std::optional<std::filesystem::path> folder_;
  std::vector<std::unique_ptr<File>> files_;
  std::map<const XMLElement*, const XMLElement*> opened_;  // by what names them
  std::map<const XMLElement*, std::vector<const XMLElement*>> expansions_;
  std::map<const XMLElement*, std::vector<const XMLElement*>>
      inside_;  // of elements of make_around()
  Expand expand_;
  std::size_t copies_ = 0;
  int copying_ = 0;
  const XMLElement* root_ = nullptr;
};

/// File and element, for sentences: "geom 'pad'", or "<geom>" where it has no name.
XmlPlace place_of(const XMLElement& element);

/// Throws Error("<file>: line 12: geom 'pad': <what>").
[[noreturn]] void refuse_at(const XMLElement& element, const std::string& what);

/// "line 12: geom 'pad'", as an example in a sentence.
std::string example_of(const XMLElement& element);

}  // namespace burnish::mjcf
