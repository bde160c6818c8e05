#include "mjcf/mjcf_source.hpp"

#include <algorithm>
#include <string_view>

#include "base/sentence.hpp"
#include "base/text_file.hpp"
#include "urdf/xml_document.hpp"

namespace burnish::mjcf {
namespace {

namespace fs = std::filesystem;

// Limits that stop endless expansions, chosen by hand.
constexpr std::size_t max_files = 100;
constexpr std::size_t max_copies = 50'000;
constexpr int max_nested_copies = 1000;

/// Returns the name of the file, which is the user data of the document.
std::string name_of_file(const XMLElement& element) {
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
  file->model = included_by == nullptr ? file.get() : included_by->model;
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

Source::File& Source::file_of(const XMLElement& element) const {
  const auto file = std::find_if(files_.begin(), files_.end(), [&](const auto& one) {
    return one->document.get() == element.GetDocument();
  });
  return **file;
}

const XMLElement& Source::opened(const XMLElement& naming, bool is_model) {
  const auto known = opened_.find(&naming);
  if (known != opened_.end()) return *known->second;
  const std::string file = needed_attribute(naming, "file", place_of(naming));
  if (!folder_) {
    refuse_at(naming,
              "it names the file " + in_quotes(file) +
                  ", but a model given as a text cannot include files; wanted the model as a file");
  }
  const File& from = file_of(naming);
  // As in MuJoCo, a path is relative to the model's main file. If no such file exists, the path is
  // relative to the file that contains the element.
  auto path = find(folder_of(*from.model->root) / file);
  if (!path) path = find(fs::path(from.path).parent_path() / file);
  if (!path) refuse_at(naming, "the file " + in_quotes(file) + " does not exist");
  const fs::path real = path->lexically_normal();
  for (const File* at = &from; at != nullptr; at = at->included_by) {
    if (at->path == real || (at->included_by == nullptr && fs::path(at->name) == real))
      refuse_at(naming, "the file " + in_quotes(file) + " includes itself");
  }
  if (files_.size() >= max_files)
    refuse_at(naming, "more than " + std::to_string(max_files) + " files are included");
  File& read = parse(read_text(real, "MJCF file"), real.string(), &from);
  read.path = real;
  if (is_model) read.model = &read;
  opened_[&naming] = read.root;
  return *read.root;
}

const XMLElement& Source::open_model(const XMLElement& naming) { return opened(naming, true); }

const XMLElement& Source::model_of(const XMLElement& element) const {
  return *file_of(element).model->root;
}

fs::path Source::folder_of(const XMLElement& root) const {
  const File& file = file_of(root);
  if (file.included_by == nullptr) return {};
  return file.path.parent_path().lexically_relative(folder_->lexically_normal());
}

const std::vector<const XMLElement*>& Source::expansion(const XMLElement& element) {
  const auto known = expansions_.find(&element);
  if (known != expansions_.end()) return known->second;
  return expansions_[&element] = expand_(element);
}

void Source::append(const XMLElement& element, bool expands,
                    std::vector<const XMLElement*>& children) {
  const auto made_around = inside_.find(&element);
  if (made_around != inside_.end()) {
    children.insert(children.end(), made_around->second.begin(), made_around->second.end());
    return;
  }
  for (const XMLElement* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    const std::string_view kind = child->Name();
    if (kind == "include") {
      append(opened(*child, false), expands, children);
    } else if (expands && (kind == "attach" || kind == "replicate")) {
      const auto& others = expansion(*child);
      children.insert(children.end(), others.begin(), others.end());
    } else {
      children.push_back(child);
    }
  }
}

std::vector<const XMLElement*> Source::children(const XMLElement& element) {
  std::vector<const XMLElement*> result;
  append(element, true, result);
  return result;
}

std::vector<const XMLElement*> Source::stated_children(const XMLElement& element) {
  std::vector<const XMLElement*> result;
  append(element, false, result);
  return result;
}

XMLElement& Source::make(const XMLElement& beside, const char* name) {
  if (++copies_ > max_copies)
    refuse_at(beside, "the model copies more than " + std::to_string(max_copies) +
                          " elements, the maximum number");
  XMLElement* made = file_of(beside).document->NewElement(name);
  const void* original = beside.GetUserData() == nullptr ? &beside : beside.GetUserData();
  // tinyxml2 only stores the pointer. NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast)
  made->SetUserData(const_cast<void*>(original));
  return *made;
}

XMLElement& Source::make_around(const XMLElement& beside, const char* name,
                                std::vector<const XMLElement*> children) {
  XMLElement& made = make(beside, name);
  // The children may belong to other documents, and a tinyxml2 document does not accept foreign
  // elements.
  inside_[&made] = std::move(children);
  return made;
}

XMLElement& Source::copy(const XMLElement& element, const Rewrite& rewrite) {
  const DepthGuard deeper(copying_);
  if (copying_ > max_nested_copies)
    refuse_at(element,
              "its copies are nested more than " + std::to_string(max_nested_copies) + " deep");
  const std::vector<const XMLElement*> inside = children(element);
  std::vector<const XMLElement*> copies;
  copies.reserve(inside.size());
  for (const XMLElement* child : inside) copies.push_back(&copy(*child, rewrite));
  XMLElement& made = copies.empty() ? make(element, element.Name())
                                    : make_around(element, element.Name(), std::move(copies));
  for (const tinyxml2::XMLAttribute* a = element.FirstAttribute(); a != nullptr; a = a->Next())
    made.SetAttribute(a->Name(), a->Value());
  rewrite(made);
  return made;
}

XmlPlace place_of(const XMLElement& element) {
  const char* name = element.Attribute("name");
  constexpr std::size_t max_length = 80;
  const std::string kind = std::string(element.Name()).substr(0, max_length);
  const bool has_name = name != nullptr && *name != '\0';
  return {name_of_file(element), has_name ? kind + " " + in_quotes(name) : "<" + kind + ">"};
}

void refuse_at(const XMLElement& element, const std::string& what) {
  refuse(place_of(element), element, what);
}

std::string example_of(const XMLElement& element) {
  return line_text(element) + place_of(element).element;
}

}  // namespace burnish::mjcf
