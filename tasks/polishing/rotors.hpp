// Joints of a task's robot for which the robot file states no rotor inertia.
#pragma once

#include <string>
#include <vector>

#include "burnish/tasks/polishing/stages.hpp"
#include "sim/light_joints.hpp"

namespace burnish::polishing {

/// Returns the light joints at the start posture under the task's disturbances, see
/// burnish::light_joints(). Joints that received a rotor inertia by Task::assume_rotors do not
/// appear.
std::vector<LightJoint> light_joints(const Task& task, const Setting& setting);

/// Returns the rotor inertias that Task::assume_rotors added: "joint 'wrist' 0.019 kg m^2, ...".
std::string assumed_rotors_text(const Setting& setting);

}  // namespace burnish::polishing
