// URDF text of a robot with two legs.
#pragma once

#include <string>
#include <utility>

namespace burnish::stand {

/// Returns the URDF text of a biped without ankle roll. Lengths scale with `size`, masses with its
/// cube, efforts with the product of the two. `more` is appended to the links and joints.
inline std::string biped(double size, const std::string& more = "") {
  const auto text = [](double value) { return std::to_string(value); };
  const double m = size * size * size, I = m * size * size, effort = m * size;
  const auto link = [&](const std::string& name, double mass, double z, double inertia) {
    const std::string i = std::to_string(1e6 * inertia * I) + "e-6";
    return "<link name='" + name + "'><inertial><origin xyz='0 0 " + text(z * size) +
           "'/><mass value='" + text(mass * m) + "'/><inertia ixx='" + i +
           "' ixy='0' ixz='0' iyy='" + i + "' iyz='0' izz='" + i + "'/></inertial></link>";
  };
  const auto joint = [&](const std::string& name, const std::string& parent,
                         const std::string& child, double y, double z, const std::string& axis,
                         double lower, double upper, double max_effort) {
    return "<joint name='" + name + "' type='revolute'><parent link='" + parent +
           "'/><child link='" + child + "'/><origin xyz='0 " + text(y * size) + " " +
           text(z * size) + "'/><axis xyz='" + axis + "'/><limit lower='" + text(lower) +
           "' upper='" + text(upper) + "' effort='" + text(max_effort * effort) +
           "' velocity='20'/></joint>";
  };
  std::string all = "<robot name='biped'>" + link("pelvis", 25.0, 0.2, 0.7);
  for (const auto& [s, y] : {std::pair<std::string, double>{"l", 0.1}, {"r", -0.1}})
    all += link(s + "_1", 2.0, -0.03, 0.01) + link(s + "_2", 2.0, -0.03, 0.01) +
           link(s + "_3", 4.0, -0.2, 0.05) + link(s + "_4", 3.0, -0.2, 0.04) +
           link(s + "_foot", 1.0, -0.04, 0.005) +
           joint(s + "_yaw", "pelvis", s + "_1", y, 0.0, "0 0 1", -0.5, 0.5, 200.0) +
           joint(s + "_roll", s + "_1", s + "_2", 0.0, -0.08, "1 0 0", -0.5, 0.5, 200.0) +
           joint(s + "_pitch", s + "_2", s + "_3", 0.0, 0.0, "0 1 0", -1.6, 1.6, 200.0) +
           joint(s + "_knee", s + "_3", s + "_4", 0.0, -0.4, "0 1 0", -0.2, 2.2, 300.0) +
           joint(s + "_ankle", s + "_4", s + "_foot", 0.0, -0.4, "0 1 0", -1.0, 0.7, 100.0) +
           "<link name='" + s + "_sole'/><joint name='" + s + "_s' type='fixed'><parent link='" +
           s + "_foot'/><child link='" + s + "_sole'/><origin xyz='" + text(0.03 * size) + " 0 " +
           text(-0.06 * size) + "'/></joint>";
  return all + more + "</robot>";
}

}  // namespace burnish::stand
