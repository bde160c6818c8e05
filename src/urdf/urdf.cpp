#include "burnish/urdf/urdf.hpp"

#include <cctype>

#include "base/sentence.hpp"
#include "base/text_file.hpp"
#include "model/tree_check.hpp"
#include "urdf/urdf_element.hpp"
#include "urdf/xml_document.hpp"

namespace burnish {
namespace {

using tinyxml2::XMLElement;

/// Limits the number of links by counting tags, before a tree of elements is built in memory.
void check_link_count(const std::string& xml, const std::string& source) {
  std::size_t links = 0;
  std::size_t at = xml.find('<');
  while (at != std::string::npos) {
    if (xml.compare(at, 4, "<!--") == 0) {
      at = xml.find("-->", at);
      if (at == std::string::npos) return;
    } else if (xml.compare(at, 5, "<link") == 0 && at + 5 < xml.size() &&
               std::string_view(" \t\r\n/>").find(xml[at + 5]) != std::string_view::npos) {
      if (++links > max_links) {
        refuse(source, "the file has more than " + std::to_string(max_links) +
                           " links, the maximum number");
      }
    }
    at = xml.find('<', at + 1);
  }
}

/// Returns the name of the robot. A robot without a name gets the name of its file. If the file is
/// a device or pipe, or if its name does not begin with a letter, the robot is called "robot".
std::string robot_name(const XMLElement& robot, const std::string& source, Findings& findings) {
  const char* stated = robot.Attribute("name");
  if (stated != nullptr && *stated != '\0') return stated;
  std::string name = std::filesystem::path(source).stem().string();
  const bool is_name = !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0;
  if (!is_name || source.starts_with("/dev/")) name = "robot";
  findings.warn(line_text(robot) + "<robot> has no name; it is called " + in_quotes(name));
  return name;
}

/// Checks for xacro elements that were not expanded. Definitions and inclusions give a warning.
/// Other elements cause an Error, since links would be missing.
void check_macros(const XMLElement& robot, Findings& findings) {
  for (const XMLElement* child = robot.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    const std::string_view name = child->Name();
    if (!name.starts_with("xacro:")) continue;
    const std::string what = line_text(*child) + "<" + child->Name() + "> ";
    if (name != "xacro:property" && name != "xacro:arg" && name != "xacro:macro" &&
        name != "xacro:include") {
      refuse(findings.origin(), what + "is a macro; expand the file with xacro first");
    }
    findings.warn(what + "was left by xacro and is ignored");
  }
}

/// Reads links and joints. Returns false if a link or joint could not be read. A check of the
/// topology would in this case report errors that the file does not have.
bool read_elements(const XMLElement& robot, TreeSpec& tree, Findings& findings) {
  const Colours colours = read_colours(robot);
  bool complete = true;
  for (const XMLElement* child = robot.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    const std::string_view kind = child->Name();
    if (kind == "link") {
      complete &=
          findings.attempt([&] { tree.links.push_back(read_link(*child, colours, findings)); });
    } else if (kind == "joint") {
      complete &= findings.attempt([&] { tree.joints.push_back(read_joint(*child, findings)); });
    }
  }
  return complete;
}

}  // namespace

TreeSpec parse_urdf(const std::string& xml, const std::string& source) {
  check_link_count(xml, source);
  tinyxml2::XMLDocument document;
  const XMLElement& robot = parse_robot_xml(document, xml, source, "URDF");
  Findings findings(source);
  TreeSpec tree;
  tree.source = source;
  tree.name = robot_name(robot, source, findings);
  check_macros(robot, findings);
  const bool complete = read_elements(robot, tree, findings);
  tree.warnings = findings.warnings();  // build_model adds warnings about values
  if (complete) check_topology(tree, findings);
  check_values(tree, findings);
  findings.refuse_problems();
  return tree;
}

std::vector<LinkSolid> parse_collisions(const std::string& xml, const std::string& source) {
  tinyxml2::XMLDocument document;
  const XMLElement& robot = parse_robot_xml(document, xml, source, "URDF");
  std::vector<LinkSolid> solids;
  for (const XMLElement* link = robot.FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link"))
    read_collisions(*link, solids);
  return solids;
}

TreeSpec read_urdf(const std::filesystem::path& file) {
  return parse_urdf(read_text(file, "URDF file"), file.string());
}

}  // namespace burnish
