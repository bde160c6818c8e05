#include "pressing/light_joints.hpp"

#include <algorithm>
#include <cmath>

#include "base/decomposition.hpp"
#include "base/sentence.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "pressing/arm.hpp"

namespace burnish::pressing {
namespace {

/// kg m^2 (kg) that a joint has to move. White noise of 0.05 Nm, as the shipped disturbances have
/// it, drives this against the damping of the hold, 15 1/s, with a deviation of 1 rad/s.
constexpr double least_inertia = 3e-4;

/// nv: whether an entry is between a foot and the base, or the base's.
std::vector<bool> legs_of(const Model& model, const Standing& standing) {
  std::vector<bool> leg(static_cast<std::size_t>(model.nv), false);
  for (const std::string& foot : standing.feet) {
    if (!model.has_frame(foot)) continue;
    const Frame& frame = model.frames[static_cast<std::size_t>(model.frame_index(foot))];
    for (const int k : model.support(frame.body)) leg[static_cast<std::size_t>(k)] = true;
  }
  return leg;
}

constexpr double finger_mass = 0.01;  // of the robot's, that a finger weighs at most

/// Whether each joint of the model is one of a finger.
std::vector<bool> are_of_fingers(const Model& model) {
  const std::size_t count = model.joints.size();
  std::vector<double> carried(count, 0.0);  // kg, the joint's body and all beyond
  for (std::size_t i = count; i-- > 0;) {   // a parent comes before its children
    carried[i] += model.joints[i].mass;
    if (const int parent = model.joints[i].parent; parent >= 0)
      carried[static_cast<std::size_t>(parent)] += carried[i];
  }
  const double most = finger_mass * model.total_mass();
  std::vector<int> light_branches(count, 0);
  for (std::size_t i = 0; i < count; ++i)
    if (const int parent = model.joints[i].parent; parent >= 0 && carried[i] < most)
      ++light_branches[static_cast<std::size_t>(parent)];
  std::vector<bool> finger(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    const int parent = model.joints[i].parent;
    if (parent < 0) continue;
    const auto p = static_cast<std::size_t>(parent);
    finger[i] = finger[p] || (carried[i] < most && light_branches[p] > 1);
  }
  return finger;
}

/// nv: what a torque at that entry alone has to move, kg m^2 (kg).
Eigen::VectorXd moved_inertia(const Robot& robot) {
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(robot.model.nv);
  ContactDynamics dynamics(robot.model);
  if (dynamics.forward(robot.reference_configuration(), rest, rest) > Status::NotConverged)
    throw Error(dynamics.explanation());
  const Eigen::Index n = robot.model.nv;
  return solve_positive(dynamics.mass_matrix(), Eigen::MatrixXd::Identity(n, n))
      .diagonal()
      .cwiseInverse();
}

}  // namespace

std::vector<std::string> light_joints(const Robot& robot, const Standing& standing) {
  const Model& model = robot.model;
  std::vector<std::string> light;
  if (!model.loops.empty()) return light;
  const std::vector<bool> leg = legs_of(model, standing);
  const Eigen::VectorXd inertia = moved_inertia(robot);
  const std::vector<bool> finger = are_of_fingers(model);
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    if (joint.nv != 1 || leg[static_cast<std::size_t>(joint.v_index)]) continue;
    if (inertia[joint.v_index] < least_inertia ||
        (finger[i] && model.armature[joint.v_index] == 0.0))
      light.push_back(joint.name);
  }
  return light;
}

Robot light_joints_locked(Robot robot, const std::string& name, const Standing& standing) {
  const std::vector<std::string> light = light_joints(robot, standing);
  if (light.empty()) return robot;
  robot = load_floating(name, light);
  std::string text = "locked: joint";
  constexpr std::size_t most = 4;
  for (std::size_t i = 0; i < std::min(most, light.size()); ++i)
    text += (i == 0 ? light.size() > 1 ? "s " : " " : ", ") + in_quotes(light[i]);
  if (light.size() > most) text += " and " + std::to_string(light.size() - most) + " others";
  robot.notes.push_back(text + ": fingers, or joints that move less than " + number(least_inertia) +
                        " kg m^2 and would shake from motor noise; to leave one free, give it an "
                        "armature in robot.yaml (joints:)");
  return robot;
}

}  // namespace burnish::pressing
