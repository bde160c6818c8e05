#include "urdf/srdf.hpp"

#include <cmath>
#include <unordered_map>

#include "base/sentence.hpp"
#include "base/text_file.hpp"
#include "model/posture.hpp"
#include "urdf/xml_document.hpp"
#include "urdf/xml_element.hpp"

namespace burnish {
namespace {

using tinyxml2::XMLElement;

/// Value of one <joint> element of a <group_state>.
struct Value {
  std::string joint;
  std::vector<double> numbers;
};

using TypeByJoint = std::unordered_map<std::string, JointType>;

Value read_value(const XMLElement& element, const XmlPlace& place) {
  Value value;
  value.joint = name_of(element, place.source);
  value.numbers = all_numbers(element, "value", place);
  return value;
}

/// Converts the angle of a continuous or planar joint if it is given as cosine and sine.
void take_angle(JointType type, std::vector<double>& numbers) {
  const std::size_t size = posture_size(type);
  const bool turns = type == JointType::Continuous || type == JointType::Planar;
  if (!turns || numbers.size() != size + 1) return;
  const double angle = std::atan2(numbers[size], numbers[size - 1]);
  numbers.resize(size);
  numbers.back() = angle;
}

[[noreturn]] void refuse_joint(const XMLElement& element, const std::string& joint,
                               const XmlPlace& place, const TypeByJoint& types, bool with_hint) {
  std::vector<std::string> names;
  if (with_hint) {
    for (const auto& [name, type] : types) names.push_back(name);
  }
  refuse(place, element,
         "joint " + in_quotes(joint) + " does not exist" + did_you_mean(joint, names));
}

void add_value(const XMLElement& element, Value value, const XmlPlace& place,
               const TypeByJoint& types, bool with_hint, Posture& posture) {
  const auto found = types.find(value.joint);
  if (found == types.end() && value.joint != root_joint_name) {
    refuse_joint(element, value.joint, place, types, with_hint);
  }
  const JointType type = found == types.end() ? JointType::Floating : found->second;
  if (type == JointType::Fixed) return;  // a fixed joint does not have values
  take_angle(type, value.numbers);
  check_posture_values(place.source, value.joint, value.numbers, posture_size(type));
  const auto [stated, is_new] = posture.emplace(value.joint, value.numbers);
  if (is_new || stated->second == value.numbers) return;
  refuse(place, element, "joint " + in_quotes(value.joint) + " has another value above");
}

}  // namespace

std::map<std::string, Posture> parse_srdf(const std::string& xml, const TreeSpec& tree,
                                          Findings& findings) {
  const std::string& source = findings.origin();
  tinyxml2::XMLDocument document;
  const XMLElement& robot = parse_robot_xml(document, xml, source, "SRDF");
  TypeByJoint types;
  for (const JointSpec& joint : tree.joints) types.emplace(joint.name, joint.type);
  std::map<std::string, Posture> postures;
  for (const XMLElement* state = robot.FirstChildElement("group_state"); state != nullptr;
       state = state->NextSiblingElement("group_state")) {
    findings.attempt_or_warn(
        [&] {
          const std::string name = name_of(*state, source);
          const XmlPlace place{source, "posture " + in_quotes(name)};
          Posture& posture = postures[name];
          for (const XMLElement* joint = state->FirstChildElement("joint"); joint != nullptr;
               joint = joint->NextSiblingElement("joint")) {
            findings.attempt_or_warn(
                [&] {
                  add_value(*joint, read_value(*joint, place), place, types, findings.are_few(),
                            posture);
                },
                "; this value is left out");
          }
        },
        "; this posture is left out");
  }
  return postures;
}

std::map<std::string, Posture> read_srdf(const std::filesystem::path& file, const TreeSpec& tree,
                                         Findings& findings) {
  return parse_srdf(read_text(file, "SRDF file"), tree, findings);
}

std::filesystem::path srdf_of(const std::filesystem::path& urdf) {
  const std::string name = urdf.stem().string() + ".srdf";
  std::error_code ignored;
  for (const std::filesystem::path& file :
       {urdf.parent_path() / name, urdf.parent_path() / ".." / "srdf" / name}) {
    if (std::filesystem::is_regular_file(file, ignored)) return file.lexically_normal();
  }
  return {};
}

}  // namespace burnish
