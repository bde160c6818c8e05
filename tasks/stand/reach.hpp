// How far the feet and the joints of a robot let its trunk sway.
#pragma once

#include <string>
#include <vector>

#include "burnish/tasks/stand/stand.hpp"

namespace burnish::stand {

/// The part of the task's sway that the robot can follow. Shifts are at most 0.05 of the height of
/// the centre of mass, on balls 0.11. A direction in which no posture on the feet moves the trunk
/// is left out. Others are made smaller until there is a posture on the whole way. The sway stays
/// as it is for robots with loops, and for one that cannot stand at the start. `setting`: complete
/// except for its sway.
Sway fitted_sway(const Task& task, const Setting& setting);

/// A sentence for directions that Setting::sway leaves out, and one for those that it has smaller.
std::vector<std::string> sway_notes(const Task& task, const Setting& setting);

}  // namespace burnish::stand
