#include "model/urdf_check.hpp"

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "model/sentence.hpp"
#include "model/text_file.hpp"
#include "model/tree_check.hpp"
#include "model/xml_element.hpp"

namespace burnish {
namespace {

using tinyxml2::XMLElement;

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr std::array<std::pair<std::string_view, JointType>, 6> joint_types = {
    {{"revolute", JointType::Revolute},
     {"continuous", JointType::Continuous},
     {"prismatic", JointType::Prismatic},
     {"fixed", JointType::Fixed},
     {"floating", JointType::Floating},
     {"planar", JointType::Planar}}};

/// Refuses by counting tags, before a tree of a million elements is built in memory.
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
        refuse(source, "it has more than " + std::to_string(max_links) +
                           " links; at most that many are supported");
      }
    }
    at = xml.find('<', at + 1);
  }
}

void parse_xml(tinyxml2::XMLDocument& document, const std::string& xml, const std::string& source) {
  if (xml.find_first_not_of(" \t\r\n") == std::string::npos) {
    refuse(source, "it is empty; a URDF description was wanted");
  }
  if (document.Parse(xml.data(), xml.size()) == tinyxml2::XML_SUCCESS) return;
  std::string reason = document.ErrorName();
  if (document.ErrorID() == tinyxml2::XML_ERROR_MISMATCHED_ELEMENT) {
    reason = "an element is closed by another one's tag or not at all";
  } else if (document.ErrorID() == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED) {
    reason = "elements are nested too deeply";
  } else if (document.ErrorID() == tinyxml2::XML_ERROR_PARSING ||
             document.ErrorID() == tinyxml2::XML_ERROR_PARSING_ELEMENT ||
             document.ErrorID() == tinyxml2::XML_ERROR_PARSING_ATTRIBUTE) {
    reason = "an element is cut off or misspelt";
  }
  refuse(source, "line " + std::to_string(document.ErrorLineNum()) +
                     ": the XML is not well formed: " + reason);
}

/// The readers look attributes up one by one, each time from the first.
class FewAttributes : public tinyxml2::XMLVisitor {
 public:
  explicit FewAttributes(const std::string& source) : source_(source) {}

  bool VisitEnter(const XMLElement& element, const tinyxml2::XMLAttribute* attribute) override {
    constexpr int most = 100;
    int count = 0;
    for (; attribute != nullptr; attribute = attribute->Next()) {
      if (++count > most) {
        refuse(source_, "line " + std::to_string(element.GetLineNum()) + ": <" + element.Name() +
                            "> has more than " + std::to_string(most) +
                            " attributes; at most that many are read");
      }
    }
    return true;
  }

 private:
  const std::string& source_;
};

/// Elements that have no name are pointed at by their line.
std::string name_of(const XMLElement& element, const std::string& source) {
  const char* name = element.Attribute("name");
  if (name != nullptr && *name != '\0') return name;
  refuse(source, "line " + std::to_string(element.GetLineNum()) + ": <" + element.Name() +
                     "> has no name; the attribute 'name' is needed");
}

void check_origin(XMLElement& parent, const XmlPlace& place) {
  XMLElement* origin = only_child(parent, "origin", place);
  if (origin == nullptr) return;
  for (const tinyxml2::XMLAttribute* attribute = origin->FirstAttribute(); attribute != nullptr;
       attribute = attribute->Next()) {
    const std::string_view name = attribute->Name();
    if (name == "xyz" || name == "rpy") continue;
    refuse(place,
           "<origin> has the attribute " + in_quotes(name) + "; only 'xyz' and 'rpy' are known");
  }
  numbers(*origin, "xyz", 3, place);
  numbers(*origin, "rpy", 3, place);
}

void check_inertial(XMLElement& link, const XmlPlace& place) {
  XMLElement* inertial = only_child(link, "inertial", place);
  if (inertial == nullptr) return;
  check_origin(*inertial, place);
  needed_number(needed_child(*inertial, "mass", place), "value", place);
  XMLElement& inertia = needed_child(*inertial, "inertia", place);
  for (const char* entry : {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}) {
    needed_number(inertia, entry, place);
  }
}

void check_geometry(XMLElement& visual, const XmlPlace& place) {
  XMLElement& geometry = needed_child(visual, "geometry", place);
  XMLElement* shape = geometry.FirstChildElement();
  if (shape == nullptr || shape->NextSiblingElement() != nullptr) {
    refuse(place, "<geometry> must hold one shape");
  }
  const std::string_view kind = shape->Name();
  if (kind == "box") {
    needed_attribute(*shape, "size", place);
    numbers(*shape, "size", 3, place);
  } else if (kind == "cylinder") {
    needed_number(*shape, "radius", place);
    needed_number(*shape, "length", place);
  } else if (kind == "sphere") {
    needed_number(*shape, "radius", place);
  } else if (kind == "mesh") {
    needed_attribute(*shape, "filename", place);
    numbers(*shape, "scale", 3, place);
  } else {
    refuse(place,
           "<geometry> holds <" + std::string(kind) + ">; wanted box, cylinder, sphere or mesh");
  }
}

/// The colour that a material states itself, as the text of its rgba.
const char* own_colour(XMLElement& material, const XmlPlace& place) {
  XMLElement* colour = only_child(material, "color", place);
  if (colour == nullptr) return nullptr;
  needed_attribute(*colour, "rgba", place);
  const std::vector<double> rgba = *numbers(*colour, "rgba", 4, place);
  for (const double value : rgba) {
    if (value >= 0.0 && value <= 1.0) continue;
    refuse(place, "<color> has rgba = " + in_quotes(colour->Attribute("rgba")) +
                      "; its numbers must be from 0 to 1");
  }
  return colour->Attribute("rgba");
}

/// Colours by material name, those of the robot before those that a visual defines for others.
using Colours = std::map<std::string, std::string>;

Colours collect_colours(XMLElement& robot, const std::string& source) {
  Colours colours;
  for (XMLElement* material = robot.FirstChildElement("material"); material != nullptr;
       material = material->NextSiblingElement("material")) {
    const std::string name = name_of(*material, source);
    const char* colour = own_colour(*material, {source, "material " + in_quotes(name)});
    if (colour != nullptr && !colours.emplace(name, colour).second) {
      refuse(source, "material " + in_quotes(name) + " is defined twice; names must be unique");
    }
  }
  for (XMLElement* link = robot.FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link")) {
    const XmlPlace place{source, "link " + in_quotes(name_of(*link, source))};
    for (XMLElement* visual = link->FirstChildElement("visual"); visual != nullptr;
         visual = visual->NextSiblingElement("visual")) {
      XMLElement* material = only_child(*visual, "material", place);
      if (material == nullptr || material->Attribute("name") == nullptr) continue;
      const char* colour = own_colour(*material, place);
      if (colour != nullptr) colours.emplace(material->Attribute("name"), colour);
    }
  }
  return colours;
}

/// Gives the visual a material of its own with the colour that its name stands for. Where there is
/// none the solid is drawn in the default grey: a drawing is no reason to refuse a robot.
void resolve_material(XMLElement& visual, const Colours& colours, const XmlPlace& place,
                      int& material_count) {
  XMLElement* material = only_child(visual, "material", place);
  if (material == nullptr) return;
  const char* own = own_colour(*material, place);
  std::string rgba = own == nullptr ? "" : own;
  const char* name = material->Attribute("name");
  if (rgba.empty() && name != nullptr) {
    const auto known = colours.find(name);
    if (known != colours.end()) rgba = known->second;
  }
  visual.DeleteChild(material);
  if (rgba.empty()) return;
  XMLElement* resolved = visual.InsertNewChildElement("material");
  resolved->SetAttribute("name", ("colour_" + std::to_string(++material_count)).c_str());
  resolved->InsertNewChildElement("color")->SetAttribute("rgba", rgba.c_str());
}

LinkSpec check_link(XMLElement& element, const std::string& source, const Colours& colours,
                    int& material_count) {
  LinkSpec link;
  link.name = name_of(element, source);
  const XmlPlace place{source, "link " + in_quotes(link.name)};
  keep_children(element, {"inertial", "visual"});
  check_inertial(element, place);
  for (XMLElement* visual = element.FirstChildElement("visual"); visual != nullptr;
       visual = visual->NextSiblingElement("visual")) {
    check_origin(*visual, place);
    check_geometry(*visual, place);
    resolve_material(*visual, colours, place, material_count);
  }
  return link;
}

JointType type_of(const XMLElement& element, const XmlPlace& place) {
  const std::string name = needed_attribute(element, "type", place);
  std::vector<std::string> known;
  for (const auto& [type_name, type] : joint_types) {
    if (type_name == name) return type;
    known.emplace_back(type_name);
  }
  const std::string nearest = did_you_mean(name, known);
  refuse(place, "type " + in_quotes(name) + " is unknown" +
                    (nearest.empty() ? "; wanted revolute, continuous, prismatic, fixed, floating "
                                       "or planar"
                                     : nearest));
}

void read_limits(XMLElement& element, JointSpec& joint, const XmlPlace& place) {
  const bool needed = joint.type == JointType::Revolute || joint.type == JointType::Prismatic;
  XMLElement* limit = only_child(element, "limit", place);
  if (limit == nullptr) {
    if (needed) refuse(place, "<joint> has no <limit>; revolute and prismatic joints need one");
    return;
  }
  const auto value = [&](const char* name) {
    const auto read = numbers(*limit, name, 1, place, true);
    return read ? std::optional<double>(read->front()) : std::nullopt;
  };
  const auto lower = value("lower"), upper = value("upper");
  if (needed && !lower && !upper) {
    refuse(place,
           "<limit> has neither 'lower' nor 'upper', which would hold the joint at zero; "
           "state its range, or make it continuous");
  }
  if (needed) {
    joint.lower = lower.value_or(0.0);  // the default of the URDF format
    joint.upper = upper.value_or(0.0);
  }
  joint.velocity_limit = value("velocity").value_or(infinity);
  joint.effort_limit = value("effort").value_or(infinity);
  // urdfdom wants all four and knows no infinity; its copy is not used.
  for (const char* name : {"lower", "upper", "velocity", "effort"}) limit->SetAttribute(name, "0");
}

void read_dynamics(XMLElement& element, JointSpec& joint, const XmlPlace& place) {
  XMLElement* dynamics = only_child(element, "dynamics", place);
  if (dynamics == nullptr) return;
  if (const auto armature = numbers(*dynamics, "armature", 1, place)) {
    joint.armature = armature->front();
  }
  for (const char* name : {"damping", "friction"}) {
    // urdfdom refuses <dynamics> that states neither.
    if (!numbers(*dynamics, name, 1, place)) dynamics->SetAttribute(name, "0");
  }
}

JointSpec check_joint(XMLElement& element, const std::string& source) {
  JointSpec joint;
  joint.name = name_of(element, source);
  const XmlPlace place{source, "joint " + in_quotes(joint.name)};
  joint.type = type_of(element, place);
  keep_children(element, {"parent", "child", "origin", "axis", "limit", "dynamics", "mimic"});
  joint.parent_link = needed_attribute(needed_child(element, "parent", place), "link", place);
  joint.child_link = needed_attribute(needed_child(element, "child", place), "link", place);
  check_origin(element, place);
  if (XMLElement* axis = only_child(element, "axis", place)) {
    needed_attribute(*axis, "xyz", place);
    numbers(*axis, "xyz", 3, place);
  }
  read_limits(element, joint, place);
  read_dynamics(element, joint, place);
  if (XMLElement* mimic = only_child(element, "mimic", place)) {
    needed_attribute(*mimic, "joint", place);
    numbers(*mimic, "multiplier", 1, place);
    numbers(*mimic, "offset", 1, place);
  }
  return joint;
}

void check_no_macros(const XMLElement& robot, const std::string& source) {
  for (const XMLElement* child = robot.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    if (std::string_view(child->Name()).starts_with("xacro:")) {
      refuse(source, "line " + std::to_string(child->GetLineNum()) + ": <" + child->Name() +
                         "> is a macro; expand the file with xacro first");
    }
  }
}

}  // namespace

UrdfOutline check_urdf(const std::string& xml, const std::string& source) {
  constexpr int megabytes = 16;  // of the shortest elements 1 GB in memory
  check_link_count(xml, source);
  check_size(xml, source, megabytes);
  tinyxml2::XMLDocument document;
  parse_xml(document, xml, source);
  XMLElement* robot = document.RootElement();
  if (robot == nullptr || std::string_view(robot->Name()) != "robot") {
    refuse(source, std::string("its outermost element is ") +
                       (robot == nullptr ? "missing" : "<" + std::string(robot->Name()) + ">") +
                       "; wanted <robot>");
  }
  UrdfOutline outline;
  outline.tree.source = source;
  outline.tree.name = name_of(*robot, source);
  FewAttributes check(source);
  robot->Accept(&check);
  robot->DeleteAttribute("version");  // urdfdom refuses versions that it does not know
  check_no_macros(*robot, source);
  const Colours colours = collect_colours(*robot, source);
  keep_children(*robot, {"link", "joint"});
  int material_count = 0;
  for (XMLElement* child = robot->FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    if (std::string_view(child->Name()) == "link") {
      outline.tree.links.push_back(check_link(*child, source, colours, material_count));
    } else {
      outline.tree.joints.push_back(check_joint(*child, source));
    }
  }
  check_topology(outline.tree);
  tinyxml2::XMLPrinter printer(nullptr, true);
  robot->Accept(&printer);
  outline.xml = printer.CStr();
  return outline;
}

}  // namespace burnish
