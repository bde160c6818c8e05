// What a robot stands on, found in its description where a task does not say it.
#pragma once

#include <string>
#include <vector>

#include "burnish/robots/robot.hpp"
#include "burnish/tasks/pressing/standing.hpp"

namespace burnish::pressing {

/// Returns `standing`, unchanged unless its feet are `auto` or the robot has none of the stated
/// frames. In these cases takes feet and sizes from find_feet(), adds the new frames to `robot` and
/// a sentence to `notes`, and one for each foot that is a wheel. Throws EntryError for
/// "standing.feet" if no feet are found.
Standing standing_on(Robot& robot, const Standing& standing, std::vector<std::string>& notes);

}  // namespace burnish::pressing
