#include "burnish/mjcf/mjcf.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "base/sentence.hpp"
#include "base/text_file.hpp"
#include "mjcf/read_model.hpp"
#include "mjcf/reading.hpp"
#include "model/tree_check.hpp"

namespace burnish {
namespace mjcf {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 16> known_sections = {
    "compiler",  "option",  "size",   "visual",   "statistic", "default", "custom",   "asset",
    "worldbody", "contact", "tendon", "equality", "actuator",  "sensor",  "keyframe", "extension"};

Sections sections_of(const XMLElement& root, Reading& reading) {
  Sections sections;
  for (const XMLElement* section : reading.source.children(root)) {
    const std::string name = section->Name();
    const bool is_known =
        std::find(known_sections.begin(), known_sections.end(), name) != known_sections.end();
    if (!is_known && name != "deformable")
      reading.warning_notes.note("sections with unknown names are ignored", example_of(*section));
    sections[name].push_back(section);
  }
  return sections;
}

/// Returns the elements of all sections with this name.
std::vector<const XMLElement*> elements_of(const Sections& sections, std::string_view name,
                                           Reading& reading) {
  std::vector<const XMLElement*> all;
  const auto found = sections.find(name);
  if (found == sections.end()) return all;
  for (const XMLElement* section : found->second) {
    const auto children = reading.source.children(*section);
    all.insert(all.end(), children.begin(), children.end());
  }
  return all;
}

template <class Read>
void for_each_section(const Sections& sections, std::string_view name, Reading& reading,
                      Read&& read) {
  const auto found = sections.find(name);
  if (found == sections.end()) return;
  for (const XMLElement* section : found->second) reading.findings.attempt([&] { read(*section); });
}

void read_option(const XMLElement& section, Reading& reading) {
  const Item item(section, nullptr);
  if (const auto stated = item.numbers("gravity", 3))
    reading.tree.gravity = Eigen::Vector3d((*stated)[0], (*stated)[1], (*stated)[2]);
  if (item.number("density", 0.0) != 0.0 || item.number("viscosity", 0.0) != 0.0)
    reading.warning_notes.note("drag of the medium (density, viscosity) is ignored",
                               example_of(section));
  for (const XMLElement* child : reading.source.children(section)) {
    const char* gravity = child->Attribute("gravity");
    if (gravity != nullptr && std::string_view(gravity) == "disable")
      reading.tree.gravity = Eigen::Vector3d::Zero();
  }
}

std::string model_name(const Reading& reading) {
  const char* stated = reading.source.root().Attribute("model");
  if (stated != nullptr && *stated != '\0') return stated;
  const std::string name = fs::path(reading.source.name()).stem().string();
  const bool is_name = !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0;
  return is_name && !reading.source.name().starts_with("/dev/") ? name : "robot";
}

/// Draws visual geoms (groups 0 to 2) where the file has any, else collision geoms.
void add_visuals(Reading& reading) {
  constexpr int seen_groups = 3;
  const auto is_seen = [](const LinkVisual& drawn) { return drawn.group < seen_groups; };
  const bool has_visuals = std::any_of(reading.drawn.begin(), reading.drawn.end(), is_seen);
  for (LinkVisual& drawn : reading.drawn)
    if (!has_visuals || is_seen(drawn))
      reading.tree.links[drawn.link].visuals.push_back(std::move(drawn.visual));
}

void scale_masses(Reading& reading) {
  const double total = reading.compiler_of(reading.source.root()).total_mass;
  if (total <= 0.0) return;
  double sum = 0.0;
  for (const LinkSpec& link : reading.tree.links) sum += link.inertia.mass;
  if (!(sum > 0.0)) return;
  for (LinkSpec& link : reading.tree.links) {
    link.inertia.mass *= total / sum;
    link.inertia.inertia_at_com *= total / sum;
  }
}

/// Adds one note that lists the ignored elements without effect on the dynamics.
void note_ignored_elements(const Sections& sections, Reading& reading) {
  for (const std::string_view name : {"contact", "sensor", "custom", "extension", "deformable"})
    for (const XMLElement* element : elements_of(sections, name, reading)) {
      if (std::string_view(element->Name()) == "flex") continue;  // <flex> has its own warning
      ++reading.ignored_elements[element->Name()];
    }
  if (reading.ignored_elements.empty()) return;
  constexpr std::size_t max_kinds = 30;
  std::string kinds;
  std::size_t listed = 0;
  for (const auto& [name, count] : reading.ignored_elements) {
    if (++listed > max_kinds) {
      kinds +=
          " and " + std::to_string(reading.ignored_elements.size() - max_kinds) + " more kinds";
      break;
    }
    kinds += (kinds.empty() ? "" : ", ") + std::to_string(count) + " <" + name.substr(0, 80) + ">";
  }
  reading.tree.notes.push_back(reading.source.name() +
                               ": ignored elements without effect on the dynamics: " + kinds);
}

void read_sections(const Sections& sections, Reading& reading) {
  for_each_section(sections, "option", reading,
                   [&](const XMLElement& s) { read_option(s, reading); });
  for_each_section(sections, "default", reading,
                   [&](const XMLElement& s) { reading.classes.read(s, reading.source); });
  for (const XMLElement* asset : elements_of(sections, "asset", reading))
    read_asset(*asset, reading);
  for_each_section(sections, "worldbody", reading,
                   [&](const XMLElement& s) { read_world(s, reading); });
  for (const XMLElement* element : elements_of(sections, "deformable", reading))
    if (std::string_view(element->Name()) == "flex")
      reading.warning_notes.note(
          "soft and composed bodies (<composite>, <flexcomp>, <flex>) are ignored",
          example_of(*element));
  // Too many links end the reading: later sections would only add errors about missing links.
  if (reading.tree.links.size() > max_links) return;
  Sections& elements = reading.part_of(reading.source.root()).elements;
  read_tendons(elements["tendon"], reading);
  read_actuators(elements["actuator"], reading);
  read_equalities(elements["equality"], reading);
  read_keyframes(elements_of(sections, "keyframe", reading), reading);
}

}  // namespace

std::string Names::unique(const std::string& wanted) {
  std::string name = wanted;
  while (!taken_.insert(name).second) name = wanted + "_" + std::to_string(++numbers_[wanted]);
  return name;
}

Reading::Reading(const std::string& xml, const std::string& name,
                 std::optional<std::filesystem::path> folder)
    : source(xml, name, std::move(folder)), findings(name) {
  source.expand_by([this](const XMLElement& element) {
    std::vector<const XMLElement*> copies;
    if (!expanding.insert(&element).second)
      refuse_at(element, "it attaches an element that contains it");
    const DepthGuard deeper(expanding_depth);
    constexpr int max_depth_of_copies = 20;
    if (expanding_depth > max_depth_of_copies)
      refuse_at(element,
                "copies are nested more than " + std::to_string(max_depth_of_copies) + " deep");
    findings.attempt([&] { copies = expand(element, *this); });
    return copies;
  });
}

Part& Reading::part_of(const XMLElement& element) {
  const XMLElement& root = source.model_of(element);
  const auto known = parts.find(&root);
  return known != parts.end() ? known->second : parts[&root] = read_part(root, *this);
}

Part read_part(const XMLElement& root, Reading& reading) {
  Part part;
  part.folder = reading.source.folder_of(root);
  part.sections = sections_of(root, reading);
  for_each_section(part.sections, "compiler", reading,
                   [&](const XMLElement& s) { part.compiler.read(s); });
  for (const char* section : {"tendon", "equality", "actuator"})
    part.elements[section] = elements_of(part.sections, section, reading);
  return part;
}

Item Reading::item(const XMLElement& xml, const DefaultClass* around) const {
  const char* stated = xml.Attribute("class");
  if (stated != nullptr && *stated != '\0') return {xml, &classes.named(stated, xml)};
  return {xml, around == nullptr ? &classes.main() : around};
}

const DefaultClass* Reading::class_inside(const XMLElement& xml, const DefaultClass* around) const {
  const char* stated = xml.Attribute("childclass");
  return stated == nullptr || *stated == '\0' ? around : &classes.named(stated, xml);
}

std::string Reading::hint(const std::string& name, const std::vector<std::string>& known) const {
  const std::string near = did_you_mean(name, known);
  return near.empty() && has_composed ? "; bodies of <composite> and <flexcomp> are not read"
                                      : near;
}

Coordinate& Reading::coordinate(const std::string& joint, const XMLElement& asking) {
  const auto found = joint_by_name.find(joint);
  if (found != joint_by_name.end()) return coordinates[found->second];
  std::vector<std::string> known;
  if (findings.are_few())
    for (const auto& [name, index] : joint_by_name) known.push_back(name);
  refuse_at(asking, "joint " + in_quotes(joint) + " does not exist" + hint(joint, known));
}

TreeSpec read_model(const std::string& xml, const std::string& name,
                    std::optional<fs::path> folder) {
  Reading reading(xml, name, std::move(folder));
  TreeSpec& tree = reading.tree;
  tree.source = name;
  tree.name = model_name(reading);
  tree.sibling_order = SiblingOrder::AsListed;
  const Sections& sections = reading.part_of(reading.source.root()).sections;
  if (!sections.contains("worldbody"))
    refuse(name, "it has no <worldbody>; wanted a <worldbody> with the bodies of a robot");
  read_sections(sections, reading);
  add_visuals(reading);
  scale_masses(reading);
  for (const std::string& sentence : reading.warning_notes.sentences())
    reading.findings.warn(sentence);
  for (const std::string& sentence : reading.info_notes.sentences())
    tree.notes.push_back(reading.source.name() + ": " + sentence);
  note_ignored_elements(sections, reading);
  tree.warnings = reading.findings.warnings();  // build_model() warns of unusual values
  if (!reading.findings.has_problems()) check_topology(tree, reading.findings);
  check_values(tree, reading.findings);
  reading.findings.refuse_problems();
  return std::move(tree);
}

}  // namespace mjcf

TreeSpec parse_mjcf(const std::string& xml, const std::string& source) {
  return mjcf::read_model(xml, source, std::nullopt);
}

TreeSpec read_mjcf(const std::filesystem::path& file) {
  return mjcf::read_model(read_text(file, "MJCF file"), file.string(), file.parent_path());
}

}  // namespace burnish
