// Common six-joint arm as the text of a URDF file.
#pragma once

#include <string>

namespace burnish::testing {

/// Dimensions that differ between wrists. Lengths along the last axis [m].
struct Wrist {
  double joint_before = 0.1;  ///< distance from the joint before to the last joint
  double mass_at = -0.02;     ///< distance from the last joint to the center of mass of its link
  double flange_at = 0.0;     ///< distance from the last joint to the flange
  double inertia = 0.01;      ///< inertia of the last link about its axes [kg m^2]
  std::string beyond = {};    ///< further links and joints; `flange` hangs on `l6`
};

inline std::string six_joint_arm(const Wrist& wrist = {}) {
  const auto text = [](double value) { return std::to_string(value); };
  const auto link = [&](const std::string& name, const std::string& com, double mass,
                        double inertia) {
    const std::string I = text(inertia);
    return "<link name='" + name + "'><inertial><origin xyz='" + com + "'/><mass value='" +
           text(mass) + "'/><inertia ixx='" + I + "' iyy='" + I + "' izz='" + I +
           "' ixy='0' ixz='0' iyz='0'/></inertial></link>\n";
  };
  const auto joint = [&](int i, const std::string& origin, const std::string& axis, int effort) {
    const std::string n = std::to_string(i);
    return "<joint name='j" + n + "' type='revolute'><parent link='" +
           (i == 1 ? "base" : "l" + std::to_string(i - 1)) + "'/><child link='l" + n +
           "'/><origin " + origin + "/><axis xyz='" + axis +
           "'/><limit lower='-3' upper='3' effort='" + std::to_string(effort) +
           "' velocity='3'/></joint>\n";
  };
  return "<robot name='six_joint_arm'><link name='base'/>\n" + link("l1", "0 0 0", 3, 0.02) +
         link("l2", "0.2 0 0", 4, 0.08) + link("l3", "0.18 0 0", 2.5, 0.04) +
         link("l4", "0 0 0", 1.5, 0.004) + link("l5", "0 0 0", 1.5, 0.004) +
         link("l6", "0 0 " + text(wrist.mass_at), 0.3, wrist.inertia) + "<link name='flange'/>\n" +
         joint(1, "xyz='0 0 0.16'", "0 0 1", 150) + joint(2, "", "0 1 0", 150) +
         joint(3, "xyz='0.42 0 0'", "0 1 0", 150) + joint(4, "xyz='0.39 0 0'", "0 1 0", 28) +
         joint(5, "xyz='0 0.13 0'", "0 0 1", 28) +
         joint(6, "xyz='" + text(wrist.joint_before) + " 0 0' rpy='0 1.5707963267948966 0'",
               "0 0 1", 28) +
         "<joint name='flange_joint' type='fixed'><parent link='l6'/><child link='flange'/>"
         "<origin xyz='0 0 " +
         text(wrist.flange_at) + "'/></joint>\n" + wrist.beyond + "</robot>";
}

/// Sliding finger on link `hand`.
inline std::string finger(const std::string& name, const std::string& hand, double y,
                          const std::string& mimic = "") {
  return "<joint name='" + name + "' type='prismatic'><parent link='" + hand + "'/><child link='" +
         name + "_link'/><origin xyz='0 " + std::to_string(y) + " 0.1'/><axis xyz='0 1 0'/>" +
         mimic + "<limit lower='0' upper='0.04' effort='20' velocity='0.2'/></joint><link name='" +
         name +
         "_link'><inertial><mass value='0.02'/><inertia ixx='1e-5' iyy='1e-5' izz='1e-5' ixy='0' "
         "ixz='0' iyz='0'/></inertial></link>\n";
}

/// Arm with two fingers on its last link, of which the second follows the first, and a link `tcp`
/// between their tips.
inline Wrist with_gripper() {
  return {.beyond = finger("left", "l6", 0.03) +
                    finger("right", "l6", -0.03, "<mimic joint='left' multiplier='-1'/>") +
                    "<link name='tcp'/><joint name='tcp_joint' type='fixed'><parent link='l6'/>"
                    "<child link='tcp'/><origin xyz='0 0 0.12'/></joint>\n"};
}

}  // namespace burnish::testing
