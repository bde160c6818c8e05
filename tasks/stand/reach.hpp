// Largest sway that the feet and the joints of a robot permit.
#pragma once

#include <string>
#include <vector>

#include "burnish/tasks/stand/stand.hpp"

namespace burnish::stand {

/// Returns the task's sway, reduced to a motion that the robot can follow. Shifts are limited to
/// 0.05 of the height of the centre of mass (0.11 on point feet). A direction is left out if no
/// posture on the feet moves the trunk in this direction. The amplitudes are then reduced until
/// every point of the sway has a posture. For robots with loops, and for a robot that cannot stand
/// at the start, the sway is unchanged. `setting`: complete except for its sway.
Sway fitted_sway(const Task& task, const Setting& setting);

/// Returns notes about Setting::sway: one about directions that are left out, one about reduced
/// directions.
std::vector<std::string> sway_notes(const Task& task, const Setting& setting);

}  // namespace burnish::stand
