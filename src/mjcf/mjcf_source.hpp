// The files of an MJCF model: the one that is read and those that it includes, as one tree.
#pragma once

#include <tinyxml2.h>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "urdf/xml_element.hpp"

namespace burnish::mjcf {

using tinyxml2::XMLElement;

class Source {
 public:
  /// `folder`: where the files that the model names are looked for; nothing: none is opened. Throws
  /// Error unless <mujoco> is outermost.
  Source(const std::string& xml, const std::string& name,
         std::optional<std::filesystem::path> folder);

  const XMLElement& root() const { return *root_; }
  const std::string& name() const;

  /// The elements in an element. In place of an <include> stand those of the file that it names.
  /// Throws Error where that cannot be read, includes itself, or is one too many.
  std::vector<const XMLElement*> children(const XMLElement& element);

  /// The file by that name, or nothing where it is not there or none is opened.
  std::optional<std::filesystem::path> find(const std::filesystem::path& file) const;

 private:
  struct File {
    std::string name;
    std::filesystem::path path;
    const File* included_by = nullptr;
    std::unique_ptr<tinyxml2::XMLDocument> document;
    const XMLElement* root = nullptr;
  };

  void append(const XMLElement& element, std::vector<const XMLElement*>& children);
  const XMLElement& included(const XMLElement& include);
  File& parse(const std::string& xml, const std::string& name, const File* included_by);

  std::optional<std::filesystem::path> folder_;
  std::vector<std::unique_ptr<File>> files_;
  std::map<const XMLElement*, const XMLElement*> root_of_include_;
  const XMLElement* root_ = nullptr;
};

/// File and element, for sentences: "geom 'pad'", or "<geom>" where it has no name.
XmlPlace place_of(const XMLElement& element);

/// Throws Error("<file>: line 12: geom 'pad': <what>").
[[noreturn]] void refuse_at(const XMLElement& element, const std::string& what);

/// "line 12: geom 'pad'", as an example in a sentence.
std::string example_of(const XMLElement& element);

}  // namespace burnish::mjcf
