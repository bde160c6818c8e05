#include "mjcf/mjcf_source.hpp"

#include <string_view>

#include "base/sentence.hpp"
#include "base/text_file.hpp"
#include "urdf/xml_document.hpp"

namespace burnish::mjcf {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_files = 100;

/// The name of its file hangs on a document.
std::string file_of(const XMLElement& element) {
  const void* name = element.GetDocument()->GetUserData();
  return name == nullptr ? "" : *static_cast<const std::string*>(name);
}

}  // namespace

Source::Source(const std::string& xml, const std::string& name, std::optional<fs::path> folder)
    : folder_(std::move(folder)) {
  root_ = parse(xml, name, nullptr).root;
  if (std::string_view(root_->Name()) == "mujoco") return;
  refuse(name, "its outermost element is <" + std::string(root_->Name()) + ">; wanted <mujoco>");
}

const std::string& Source::name() const { return files_.front()->name; }

Source::File& Source::parse(const std::string& xml, const std::string& name,
                            const File* included_by) {
  auto file = std::make_unique<File>();
  file->name = name;
  file->included_by = included_by;
  file->document = std::make_unique<tinyxml2::XMLDocument>();
  file->document->SetUserData(&file->name);
  file->root = &parse_xml(*file->document, xml, name, "MJCF", "<mujoco>");
  files_.push_back(std::move(file));
  return *files_.back();
}

std::optional<fs::path> Source::find(const fs::path& file) const {
  if (!folder_ || file.empty()) return std::nullopt;
  std::error_code ignored;
  const fs::path path = *folder_ / file;
  return fs::is_regular_file(path, ignored) ? std::optional(path) : std::nullopt;
}

const XMLElement& Source::included(const XMLElement& include) {
  const auto known = root_of_include_.find(&include);
  if (known != root_of_include_.end()) return *known->second;
  const std::string file = needed_attribute(include, "file", place_of(include));
  if (!folder_) {
    refuse_at(include, "it names the file " + in_quotes(file) +
                           "; a text by itself includes none, so read it from a file");
  }
  const auto from = std::find_if(files_.begin(), files_.end(), [&](const auto& one) {
    return one->document.get() == include.GetDocument();
  });
  // As MuJoCo has it beside the main file, or else beside the file that includes it.
  auto path = find(file);
  if (!path) path = find(fs::path((*from)->path).parent_path() / file);
  if (!path) refuse_at(include, "the file " + in_quotes(file) + " does not exist");
  const fs::path real = path->lexically_normal();
  for (const File* at = from->get(); at != nullptr; at = at->included_by) {
    if (at->path == real || (at->included_by == nullptr && fs::path(at->name) == real))
      refuse_at(include, "the file " + in_quotes(file) + " includes itself");
  }
  if (files_.size() >= most_files)
    refuse_at(include, "more than " + std::to_string(most_files) + " files are included");
  File& read = parse(read_text(real, "MJCF file"), real.string(), from->get());
  read.path = real;
  root_of_include_[&include] = read.root;
  return *read.root;
}

void Source::append(const XMLElement& element, std::vector<const XMLElement*>& children) {
  for (const XMLElement* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    if (std::string_view(child->Name()) == "include")
      append(included(*child), children);
    else
      children.push_back(child);
  }
}

std::vector<const XMLElement*> Source::children(const XMLElement& element) {
  std::vector<const XMLElement*> result;
  append(element, result);
  return result;
}

XmlPlace place_of(const XMLElement& element) {
  const char* name = element.Attribute("name");
  constexpr std::size_t longest = 80;
  const std::string kind = std::string(element.Name()).substr(0, longest);
  const bool has_name = name != nullptr && *name != '\0';
  return {file_of(element), has_name ? kind + " " + in_quotes(name) : "<" + kind + ">"};
}

void refuse_at(const XMLElement& element, const std::string& what) {
  refuse(place_of(element), element, what);
}

std::string example_of(const XMLElement& element) {
  return line_text(element) + place_of(element).element;
}

}  // namespace burnish::mjcf
