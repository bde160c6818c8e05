#include "pressing/light_joints.hpp"

#include <algorithm>
#include <cmath>

#include "base/decomposition.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "pressing/arm.hpp"

namespace burnish::pressing {
namespace {

/// Smallest inertia of a joint that can be held still [kg m^2 (kg)]. The shipped disturbances have
/// a white torque noise of 0.05 Nm, and the holding controller has a damping of 15 1/s. Together,
/// they give a joint of this inertia a speed with a standard deviation of 1 rad/s.
constexpr double min_inertia = 3e-4;

/// Returns whether each entry of v (nv) belongs to the base or to a joint between the base and a
/// foot.
std::vector<bool> legs_of(const Model& model, const Standing& standing) {
  std::vector<bool> leg(to_size(model.nv), false);
  for (const std::string& foot : standing.feet) {
    if (!model.has_frame(foot)) continue;
    const Frame& frame = model.frames[to_size(model.frame_index(foot))];
    for (const int k : model.support(frame.body)) leg[to_size(k)] = true;
  }
  return leg;
}

/// Largest mass of a finger, as a fraction of the robot's mass. Chosen by hand.
constexpr double max_finger_mass = 0.01;

/// Returns whether each joint of the model belongs to a finger.
std::vector<bool> are_of_fingers(const Model& model) {
  const std::size_t count = model.joints.size();
  // Mass of each joint's body, including all descendants of this body [kg].
  std::vector<double> carried(count, 0.0);
  for (std::size_t i = count; i-- > 0;) {  // backwards, because parents come before their children
    carried[i] += model.joints[i].mass;
    if (const int parent = model.joints[i].parent; parent >= 0)
      carried[to_size(parent)] += carried[i];
  }
  const double max_mass = max_finger_mass * model.total_mass();
  std::vector<int> light_branches(count, 0);
  for (std::size_t i = 0; i < count; ++i)
    if (const int parent = model.joints[i].parent; parent >= 0 && carried[i] < max_mass)
      ++light_branches[to_size(parent)];
  std::vector<bool> finger(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    const int parent = model.joints[i].parent;
    if (parent < 0) continue;
    const auto p = to_size(parent);
    finger[i] = finger[p] || (carried[i] < max_mass && light_branches[p] > 1);
  }
  return finger;
}

/// Returns the effective inertia of each entry of v (nv) at the reference posture, 1 / (M^-1)_kk
/// [kg m^2 (kg)].
Eigen::VectorXd effective_inertia(const Robot& robot) {
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(robot.model.nv);
  ContactDynamics dynamics(robot.model);
  if (!is_usable(dynamics.forward(robot.reference_configuration(), rest, rest)))
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
  const Eigen::VectorXd inertia = effective_inertia(robot);
  const std::vector<bool> finger = are_of_fingers(model);
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    if (joint.nv != 1 || leg[to_size(joint.v_index)]) continue;
    if (inertia[joint.v_index] < min_inertia || (finger[i] && model.armature[joint.v_index] == 0.0))
      light.push_back(joint.name);
  }
  return light;
}

Robot light_joints_locked(Robot robot, const std::string& name, const Standing& standing) {
  const std::vector<std::string> light = light_joints(robot, standing);
  if (light.empty()) return robot;
  robot = load_floating(name, light);
  std::string text = "locked: joint";
  constexpr std::size_t max_names = 4;
  for (std::size_t i = 0; i < std::min(max_names, light.size()); ++i)
    text += (i == 0 ? light.size() > 1 ? "s " : " " : ", ") + in_quotes(light[i]);
  if (light.size() > max_names)
    text += " and " + std::to_string(light.size() - max_names) + " others";
  robot.notes.push_back(text + " (fingers, or joints with an inertia below " + number(min_inertia) +
                        " kg m^2, which motor noise would shake); to keep a joint free, state its "
                        "armature in robot.yaml (joints:)");
  return robot;
}

}  // namespace burnish::pressing
