// Expansion of <attach> and <replicate>: copies bodies and the elements that refer to them.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "mjcf/reading.hpp"

namespace burnish::mjcf {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Elements = std::vector<const XMLElement*>;

/// Rule for the names of copies. In copies of another model, it also renames classes and assets.
struct Renaming {
  std::string prefix, suffix;
  bool of_another = false;

  std::string operator()(const std::string& name) const { return prefix + name + suffix; }
  std::string main_class() const { return prefix + "main"; }
};

/// Names of bodies, joints, geoms, sites and tendons.
using NamesByKind = std::map<std::string_view, std::set<std::string>>;

/// Returns the kind of element that an attribute of tendons, equalities and actuators names; "" if
/// the attribute names none.
std::string_view kind_named_by(std::string_view attribute) {
  constexpr std::array<std::string_view, 5> numbered = {"joint", "body", "site", "geom", "tendon"};
  if (attribute == "jointinparent") return "joint";
  for (const char* of_site : {"sidesite", "refsite", "cranksite", "slidersite"})
    if (attribute == of_site) return "site";
  const bool has_number = attribute.ends_with('1') || attribute.ends_with('2');
  if (has_number) attribute.remove_suffix(1);
  const auto kind = std::find(numbered.begin(), numbered.end(), attribute);
  return kind == numbered.end() ? std::string_view() : *kind;
}

void set(XMLElement& element, const char* attribute, const std::string& value) {
  element.SetAttribute(attribute, value.c_str());
}

/// Renames the values of the listed attributes, as far as the element has them.
template <std::size_t n>
void rename(XMLElement& element, const std::array<const char*, n>& attributes,
            const Renaming& renaming) {
  for (const char* attribute : attributes) {
    const char* stated = element.Attribute(attribute);
    if (stated != nullptr && *stated != '\0') set(element, attribute, renaming(stated));
  }
}

constexpr std::array<const char*, 1> names{"name"};
constexpr std::array<const char*, 6> of_model{"class",  "childclass", "mesh",
                                              "hfield", "material",   "texture"};

/// Returns the changes to elements inside copied bodies.
Source::Rewrite in_bodies(const Renaming& renaming) {
  return [renaming](XMLElement& copy) {
    rename(copy, names, renaming);
    if (renaming.of_another) rename(copy, of_model, renaming);
  };
}

void gather(const Elements& elements, NamesByKind& found, Reading& reading) {
  for (const XMLElement* element : elements) {
    std::string_view kind = element->Name();
    if (kind == "freejoint") kind = "joint";
    const char* name = element->Attribute("name");
    if (name != nullptr && *name != '\0' &&
        (kind == "body" || kind == "joint" || kind == "geom" || kind == "site"))
      found[kind == "body"    ? "body"
            : kind == "joint" ? "joint"
            : kind == "geom"  ? "geom"
                              : "site"]
          .insert(name);
    if (kind == "body" || kind == "frame")
      gather(reading.source.children(*element), found, reading);
  }
}

// ---- Elements that name copied elements

/// Numbers of references from an element and its parts to copied elements and to other elements.
struct Reach {
  int among = 0, others = 0;
  void add(const XMLElement& element, const NamesByKind& copied) {
    for (const tinyxml2::XMLAttribute* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
      const std::string_view kind = kind_named_by(a->Name());
      if (kind.empty()) continue;
      const auto names_of_kind = copied.find(kind);
      const bool is_copied =
          names_of_kind != copied.end() && names_of_kind->second.contains(a->Value());
      ++(is_copied ? among : others);
    }
  }
};

Reach reach(const XMLElement& element, const NamesByKind& copied, Reading& reading) {
  Reach result;
  result.add(element, copied);
  for (const XMLElement* part : reading.source.children(element)) result.add(*part, copied);
  return result;
}

/// Returns whether an element is copied: an equality or actuator if all elements that it names are
/// copied, a tendon if at least one is.
bool is_copied(const std::string& section, const Reach& reach) {
  return reach.among > 0 && (section == "tendon" || reach.others == 0);
}

const XMLElement& copy_naming(const XMLElement& element, const NamesByKind& copied,
                              const Renaming& renaming, Reading& reading) {
  const auto rewrite = [&](XMLElement& copy) {
    for (const tinyxml2::XMLAttribute* a = copy.FirstAttribute(); a != nullptr; a = a->Next()) {
      const std::string_view kind = kind_named_by(a->Name());
      const auto names_of_kind = copied.find(kind);
      if (!kind.empty() && names_of_kind != copied.end() &&
          names_of_kind->second.contains(a->Value()))
        set(copy, a->Name(), renaming(a->Value()));
    }
    rename(copy, names, renaming);
    if (renaming.of_another) rename(copy, of_model, renaming);
  };
  XMLElement& copy = reading.source.copy(element, rewrite);
  if (renaming.of_another && copy.Attribute("class") == nullptr)
    set(copy, "class", renaming.main_class());
  return copy;
}

constexpr std::array<const char*, 3> naming_sections{"tendon", "equality", "actuator"};

/// Adds copies of the tendons, equalities and actuators that refer to copied elements.
void copy_naming_elements(NamesByKind copied, const std::vector<Renaming>& renamings,
                          const Part& from, Part& to, Reading& reading) {
  for (const std::string section : naming_sections) {
    const auto found = from.elements.find(section);
    if (found == from.elements.end()) continue;
    const Elements elements = found->second;  // A copy, because to.elements can be the same list
    for (const XMLElement* element : elements) {
      if (!is_copied(section, reach(*element, copied, reading))) continue;
      const char* name = element->Attribute("name");
      if (section == "tendon" && name != nullptr) copied["tendon"].insert(name);
      for (const Renaming& renaming : renamings)
        to.elements[section].push_back(&copy_naming(*element, copied, renaming, reading));
    }
  }
}

/// Removes tendons, equalities and actuators that refer to the deleted elements `gone`.
void drop_naming_elements(NamesByKind gone, Part& part, Reading& reading) {
  for (const std::string section : naming_sections) {
    Elements& elements = part.elements[section];
    std::erase_if(elements, [&](const XMLElement* element) {
      const Reach reached = reach(*element, gone, reading);
      if (reached.among == 0) return false;
      const char* name = element->Attribute("name");
      if (section == "tendon" && name != nullptr) gone["tendon"].insert(name);
      if (!is_copied(section, reached))
        reading.warning_notes.note(
            "elements that refer both to replicated and to other elements are dropped",
            example_of(*element));
      return true;
    });
  }
}

// ---- <replicate>

Matrix3d turned(const Vector3d& euler, const Compiler& compiler) {
  Matrix3d result = Matrix3d::Identity();
  for (int i = 0; i < 3; ++i) {
    const char axis = compiler.euler[to_size(i)];
    const bool is_fixed = axis < 'a';
    const Vector3d along = Vector3d::Unit(is_fixed ? axis - 'X' : axis - 'x');
    const Matrix3d turn = Eigen::AngleAxisd(compiler.angle(euler[i]), along).toRotationMatrix();
    result = is_fixed ? Matrix3d(turn * result) : Matrix3d(result * turn);
  }
  return result;
}

Vector3d three(const XMLElement& at, const char* attribute) {
  const auto stated = numbers(at, attribute, 3, place_of(at));
  return stated ? Vector3d((*stated)[0], (*stated)[1], (*stated)[2]) : Vector3d(Vector3d::Zero());
}

int count_of(const XMLElement& at) {
  const double stated = needed_number(at, "count", place_of(at));
  constexpr double max_count = 2000.0;
  if (stated < 0.0 || stated > max_count || stated != std::floor(stated))
    refuse_at(at, "count is " + in_quotes(at.Attribute("count")) +
                      "; wanted a whole number from 0 to 2000");
  return static_cast<int>(stated);
}

/// Returns the suffix of copy i, with as many digits as the count has.
std::string suffix_of(const XMLElement& at, int count, int i) {
  const char* separator = at.Attribute("sep");
  const std::string digits = std::to_string(i);
  const std::size_t width = std::to_string(count).size();
  return (separator == nullptr ? "" : separator) + std::string(width - digits.size(), '0') + digits;
}

std::string written(const double* begin, int count) {
  std::string text;
  char one[40];
  for (int i = 0; i < count; ++i) {
    std::snprintf(one, sizeof one, i == 0 ? "%.17g" : " %.17g", begin[i]);
    text += one;
  }
  return text;
}

XMLElement& frame_at(const XMLElement& at, const Eigen::Isometry3d& placement, Elements inside,
                     Reading& reading) {
  XMLElement& frame = reading.source.make_around(at, "frame", std::move(inside));
  const Vector3d p = placement.translation();
  const Eigen::Quaterniond r(placement.linear());
  const double wxyz[4] = {r.w(), r.x(), r.y(), r.z()};
  set(frame, "pos", written(p.data(), 3));
  set(frame, "quat", written(wxyz, 4));
  return frame;
}

/// Returns the copies of a <replicate>. Copy i is rotated by i times `euler`. Its offset from copy
/// i - 1 is in the axes of copy i - 1.
Elements replicate(const XMLElement& at, Reading& reading) {
  const int count = count_of(at);
  const Vector3d offset = three(at, "offset"), euler = three(at, "euler");
  Part& part = reading.part_of(at);
  // Inner <replicate> elements are expanded first
  const Elements inside = reading.source.children(at);
  NamesByKind copied;
  gather(inside, copied, reading);
  std::vector<Renaming> renamings;
  Elements frames;
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
  for (int i = 0; i < count; ++i) {
    renamings.push_back({"", suffix_of(at, count, i)});
    placement.linear() = turned(i * euler, part.compiler);
    Elements copies;
    for (const XMLElement* element : inside)
      copies.push_back(&reading.source.copy(*element, in_bodies(renamings.back())));
    XMLElement& frame = frame_at(at, placement, std::move(copies), reading);
    if (const char* inherited = at.Attribute("childclass")) set(frame, "childclass", inherited);
    frames.push_back(&frame);
    placement.translation() += placement.linear() * offset;
  }
  copy_naming_elements(copied, renamings, part, part, reading);
  drop_naming_elements(copied, part, reading);
  return frames;
}

// ---- <attach>

/// Element to attach, and the default class that it inherits; "": the outermost class.
struct Found {
  const XMLElement* element = nullptr;
  std::string inherited;
};

std::string inherited_inside(const XMLElement& element, const std::string& around) {
  const char* stated = element.Attribute("childclass");
  return stated == nullptr || *stated == '\0' ? around : stated;
}

class Search {
 public:
  /// `expands`: also search copies from other <attach> and <replicate> elements.
  Search(std::string kind, std::string name, bool expands, Reading& reading)
      : kind_(std::move(kind)), name_(std::move(name)), expands_(expands), reading_(reading) {}

  void look_in(const XMLElement& element, const std::string& around) {
    const std::string inherited = inherited_inside(element, around);
    const Elements inside =
        expands_ ? reading_.source.children(element) : reading_.source.stated_children(element);
    for (const XMLElement* child : inside) {
      const std::string_view kind = child->Name();
      const char* name = child->Attribute("name");
      if (kind == kind_ && name != nullptr) {
        known_.push_back(name);
        if (name == name_ && found_.element == nullptr) found_ = {child, inherited};
      }
      if (kind == "body" || kind == "frame" || kind == "replicate") look_in(*child, inherited);
    }
  }

  const Found& result(const XMLElement& asking) const {
    if (found_.element == nullptr)
      refuse_at(asking, kind_ + " " + in_quotes(name_) + " does not exist in the model" +
                            did_you_mean(name_, known_));
    return found_;
  }

 private:
  std::string kind_, name_;
  bool expands_;
  Reading& reading_;
  std::vector<std::string> known_;
  Found found_;
};

std::string own_name(const XMLElement& root) {
  const char* stated = root.Attribute("model");
  return stated == nullptr ? "MuJoCo Model" : stated;
}

/// Returns the root of a model by its name in <asset>, or else by its own name.
const XMLElement& asset_model(const std::string& wanted, const XMLElement& at, Reading& reading) {
  std::vector<std::string> known;
  for (const XMLElement* section : reading.part_of(at).sections["asset"]) {
    for (const XMLElement* asset : reading.source.children(*section)) {
      if (std::string_view(asset->Name()) != "model") continue;
      const char* name = asset->Attribute("name");
      const bool has_name = name != nullptr && *name != '\0';
      known.push_back(has_name ? name : own_name(reading.source.open_model(*asset)));
      if (known.back() == wanted) return reading.source.open_model(*asset);
    }
  }
  refuse_at(at, "<asset> has no <model> " + in_quotes(wanted) + did_you_mean(wanted, known));
}

/// Adds the classes and assets of another model under a prefix, unless they were added before.
void take_over(const XMLElement& root, const Renaming& renaming, Reading& reading) {
  if (!reading.attached.emplace(&root, renaming.prefix).second) return;
  Part& part = reading.part_of(root);
  Elements defaults;
  for (const XMLElement* section : part.sections["default"]) {
    const auto rewrite = [&](XMLElement& copy) { rename(copy, of_model, renaming); };
    defaults.push_back(&reading.source.copy(*section, rewrite));
  }
  reading.classes.attach(renaming.main_class(), defaults, reading.source);
  for (const XMLElement* section : part.sections["asset"]) {
    for (const XMLElement* asset : reading.source.children(*section)) {
      if (std::string_view(asset->Name()) == "model") continue;
      XMLElement& copy = reading.source.copy(*asset, in_bodies(renaming));
      if (copy.Attribute("class") == nullptr) set(copy, "class", renaming.main_class());
      const char* file = copy.Attribute("file");
      if (copy.Attribute("name") == nullptr && file != nullptr)
        set(copy, "name", renaming(std::filesystem::path(file).stem().string()));
      read_asset(copy, reading);
    }
  }
  if (!part.sections["keyframe"].empty())
    reading.info_notes.note("keyframes of attached models are ignored",
                            example_of(*part.sections["keyframe"].front()));
}

/// Returns a frame with copies of all elements in the world.
Elements attach_world(const XMLElement& root, const Renaming& renaming, NamesByKind& copied,
                      Reading& reading) {
  Elements frames;
  for (const XMLElement* world : reading.part_of(root).sections["worldbody"]) {
    const Elements inside = reading.source.children(*world);
    gather(inside, copied, reading);
    Elements copies;
    for (const XMLElement* element : inside)
      copies.push_back(&reading.source.copy(*element, in_bodies(renaming)));
    XMLElement& frame = frame_at(*world, Eigen::Isometry3d::Identity(), std::move(copies), reading);
    const std::string inherited = inherited_inside(*world, "");
    set(frame, "childclass", inherited.empty() ? renaming.main_class() : renaming(inherited));
    frames.push_back(&frame);
  }
  return frames;
}

Elements attach(const XMLElement& at, Reading& reading) {
  const char *prefix = at.Attribute("prefix"), *model = at.Attribute("model");
  if (prefix == nullptr) refuse_at(at, "it has no 'prefix'; the attribute is needed");
  const Renaming renaming{prefix, "", model != nullptr};
  const XMLElement& root =
      model == nullptr ? reading.source.model_of(at) : asset_model(model, at, reading);
  const char* kind = at.Attribute("body") != nullptr    ? "body"
                     : at.Attribute("frame") != nullptr ? "frame"
                                                        : nullptr;
  if (model == nullptr && kind == nullptr)
    refuse_at(
        at, "it names neither another model nor a body or frame of this model; wanted one of them");
  if (model != nullptr) take_over(root, renaming, reading);
  NamesByKind copied;
  Elements copies;
  if (kind == nullptr) {
    copies = attach_world(root, renaming, copied, reading);
  } else {
    Search search(kind, at.Attribute(kind), model != nullptr, reading);
    for (const XMLElement* world : reading.part_of(root).sections["worldbody"])
      search.look_in(*world, "");
    const Found& found = search.result(at);
    gather({found.element}, copied, reading);
    XMLElement& copy = reading.source.copy(*found.element, in_bodies(renaming));
    if (copy.Attribute("childclass") == nullptr && (model != nullptr || !found.inherited.empty()))
      set(copy, "childclass",
          model == nullptr          ? found.inherited
          : found.inherited.empty() ? renaming.main_class()
                                    : renaming(found.inherited));
    copies.push_back(&copy);
  }
  copy_naming_elements(copied, {renaming}, reading.part_of(root), reading.part_of(at), reading);
  return copies;
}

}  // namespace

std::vector<const XMLElement*> expand(const XMLElement& element, Reading& reading) {
  const bool copies = std::string_view(element.Name()) == "replicate";
  return copies ? replicate(element, reading) : attach(element, reading);
}

}  // namespace burnish::mjcf
