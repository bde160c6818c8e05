#include <array>
#include <utility>

#include "base/sentence.hpp"
#include "urdf/urdf_element.hpp"

namespace burnish {
namespace {

using tinyxml2::XMLElement;

constexpr std::array<std::pair<std::string_view, JointType>, 6> joint_types = {
    {{"revolute", JointType::Revolute},
     {"continuous", JointType::Continuous},
     {"prismatic", JointType::Prismatic},
     {"fixed", JointType::Fixed},
     {"floating", JointType::Floating},
     {"planar", JointType::Planar}}};

JointType type_of(const XMLElement& element, const XmlPlace& place) {
  const std::string name = needed_attribute(element, "type", place);
  std::vector<std::string> known;
  for (const auto& [type_name, type] : joint_types) {
    if (type_name == name) return type;
    known.emplace_back(type_name);
  }
  const std::string nearest = did_you_mean(name, known);
  refuse(
      place, element,
      "type " + in_quotes(name) + " is unknown" +
          (nearest.empty() ? "; wanted revolute, continuous, prismatic, fixed, floating or planar"
                           : nearest));
}

/// Reads one number of an element into `value`. `value` does not change if the attribute is
/// missing.
void read_number(const XMLElement& element, const char* attribute, const XmlPlace& place,
                 bool may_be_infinite, double& value, Findings& findings) {
  findings.attempt([&] {
    if (const auto read = numbers(element, attribute, 1, place, may_be_infinite)) {
      value = read->front();
    }
  });
}

void read_axis(const XMLElement& element, const XmlPlace& place, JointSpec& joint,
               Findings& findings) {
  const XMLElement* axis = first_child(element, "axis", place, findings);
  if (axis == nullptr) return;
  needed_attribute(*axis, "xyz", place);
  const std::vector<double> xyz = *numbers(*axis, "xyz", 3, place);
  joint.axis = Eigen::Vector3d(xyz[0], xyz[1], xyz[2]);
  // check_values reports a zero axis.
  if (joint.axis.norm() > 0.0) joint.axis.normalize();
}

/// Reads the range of a revolute or prismatic joint. URDF defines a missing end as zero. If both
/// ends are missing, or if zero would be beyond the other end, the missing end is taken as
/// unlimited, with a warning.
void read_range(const XMLElement& limit, const XmlPlace& place, JointSpec& joint,
                Findings& findings) {
  const bool has_lower = limit.Attribute("lower") != nullptr;
  const bool has_upper = limit.Attribute("upper") != nullptr;
  if (!has_lower && !has_upper) {
    findings.warn(line_text(limit) + place.element +
                  ": <limit> has neither 'lower' nor 'upper'; the joint is taken as unlimited");
    return;
  }
  double lower = 0.0, upper = 0.0;
  read_number(limit, "lower", place, true, lower, findings);
  read_number(limit, "upper", place, true, upper, findings);
  const auto missing = [&](const char* end, const char* other, double value) {
    findings.warn(line_text(limit) + place.element + ": <limit> has '" + other +
                  "' = " + number(value) + " but no '" + end +
                  "'; the joint is taken as unlimited at its " + end + " end");
  };
  if (!has_lower && upper < 0.0) {
    missing("lower", "upper", upper);
  } else {
    joint.lower = lower;
  }
  if (!has_upper && lower > 0.0) {
    missing("upper", "lower", lower);
  } else {
    joint.upper = upper;
  }
}

/// Warns if the <limit> of a continuous joint states a range of less than one turn. The range 0 to
/// 0 gives no warning, since some exporters write it for every joint.
void warn_of_range(const XMLElement& limit, const XmlPlace& place, Findings& findings) {
  constexpr double turn = 6.283;  // full turn, rounded as in files [rad]
  double lower = 0.0, upper = 0.0;
  read_number(limit, "lower", place, false, lower, findings);
  read_number(limit, "upper", place, false, upper, findings);
  if (!(upper > lower) || upper - lower >= turn) return;
  findings.warn(line_text(limit) + place.element + ": its type is continuous, so 'lower' = " +
                number(lower) + " and 'upper' = " + number(upper) +
                " of its <limit> are ignored; wanted type revolute if the joint is limited");
}

/// Reads a limit of velocity or effort. The format requires both, so authors write 0 for an unknown
/// limit. 0 is therefore taken as unlimited, with a warning.
void read_largest(const XMLElement& limit, const char* attribute, const XmlPlace& place,
                  double& value, Findings& findings) {
  double stated = value;
  read_number(limit, attribute, place, true, stated, findings);
  if (stated == 0.0)
    findings.warn(line_text(limit) + place.element + ": <limit> has '" + attribute +
                  "' = 0, which usually means unknown; it is taken as unlimited");
  else
    value = stated;
}

void read_limits(const XMLElement& element, const XmlPlace& place, JointSpec& joint,
                 Findings& findings) {
  const XMLElement* limit = first_child(element, "limit", place, findings);
  const bool has_range = joint.type == JointType::Revolute || joint.type == JointType::Prismatic;
  if (limit == nullptr) {
    if (has_range) {
      findings.warn(line_text(element) + place.element +
                    ": it has no <limit>; the joint is taken as unlimited");
    }
    return;
  }
  if (has_range) read_range(*limit, place, joint, findings);
  if (joint.type == JointType::Continuous) warn_of_range(*limit, place, findings);
  read_largest(*limit, "velocity", place, joint.velocity_limit, findings);
  // A mimic joint has no motor. Its effort limit is added to its leader's limit, and may be 0.
  if (element.FirstChildElement("mimic") != nullptr)
    read_number(*limit, "effort", place, true, joint.effort_limit, findings);
  else
    read_largest(*limit, "effort", place, joint.effort_limit, findings);
}

void read_dynamics(const XMLElement& element, const XmlPlace& place, JointSpec& joint,
                   Findings& findings) {
  const XMLElement* dynamics = first_child(element, "dynamics", place, findings);
  if (dynamics == nullptr) return;
  read_number(*dynamics, "damping", place, false, joint.damping, findings);
  read_number(*dynamics, "friction", place, false, joint.friction, findings);
  read_number(*dynamics, "armature", place, false, joint.armature, findings);
  read_number(*dynamics, "stiffness", place, false, joint.stiffness, findings);
  read_number(*dynamics, "rest", place, false, joint.rest, findings);
}

void read_mimic(const XMLElement& element, const XmlPlace& place, JointSpec& joint,
                Findings& findings) {
  const XMLElement* mimic = first_child(element, "mimic", place, findings);
  if (mimic == nullptr) return;
  MimicSpec spec;
  spec.leader = needed_attribute(*mimic, "joint", place);
  read_number(*mimic, "multiplier", place, false, spec.multiplier, findings);
  read_number(*mimic, "offset", place, false, spec.offset, findings);
  joint.mimic = std::move(spec);
}

}  // namespace

JointSpec read_joint(const XMLElement& element, Findings& findings) {
  JointSpec joint;
  joint.name = name_of(element, findings.origin());
  joint.line = element.GetLineNum();
  const XmlPlace place{findings.origin(), "joint " + in_quotes(joint.name)};
  const bool has_type = findings.attempt([&] { joint.type = type_of(element, place); });
  findings.attempt([&] { joint.placement = read_origin(element, place, findings); });
  if (has_type && joint.type != JointType::Fixed) {
    if (joint.type != JointType::Floating) {
      findings.attempt([&] { read_axis(element, place, joint, findings); });
    }
    findings.attempt([&] { read_limits(element, place, joint, findings); });
    findings.attempt([&] { read_dynamics(element, place, joint, findings); });
    findings.attempt([&] { read_mimic(element, place, joint, findings); });
  }
  warn_of_macros(element, place, findings);
  joint.parent_link = needed_attribute(needed_child(element, "parent", place), "link", place);
  joint.child_link = needed_attribute(needed_child(element, "child", place), "link", place);
  return joint;
}

}  // namespace burnish
