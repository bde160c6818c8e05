// Joints of a task whose rotors are missing in the robot's description.
#pragma once

#include <string>
#include <vector>

#include "burnish/tasks/polishing/stages.hpp"
#include "sim/light_joints.hpp"

namespace burnish::polishing {

/// See burnish::light_joints(): at the start, under the task's disturbances. Those that
/// Task::assume_rotors has given a rotor are none.
std::vector<LightJoint> light_joints(const Task& task, const Setting& setting);

/// "joint 'wrist' 0.019 kg m^2, joint ...": what Task::assume_rotors added.
std::string assumed_rotors_text(const Setting& setting);

}  // namespace burnish::polishing
