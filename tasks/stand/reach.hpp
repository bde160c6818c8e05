// How far the feet and the joints of a robot let its trunk sway.
#pragma once

#include <string>
#include <vector>

#include "burnish/tasks/stand/stand.hpp"

namespace burnish::stand {

/// The task's sway, or what of it the robot can follow: shifts are at most 0.05 of the height of
/// the centre of mass, on balls 0.11. A direction of which no part has a posture
/// on the feet is left out; others are made smaller until there is one on the whole way. As it is
/// for robots with loops, and where the robot cannot even stand at the start. `setting`: complete
/// but for its sway.
Sway fitted_sway(const Task& task, const Setting& setting);

/// A sentence for directions that Setting::sway leaves out, and one for those that it has smaller.
std::vector<std::string> sway_notes(const Task& task, const Setting& setting);

}  // namespace burnish::stand
