// What a robot stands on, found in its description where a task does not say it.
#pragma once

#include <string>
#include <vector>

#include "burnish/robots/robot.hpp"
#include "burnish/tasks/pressing/standing.hpp"

namespace burnish::pressing {

/// Returns `standing`. Where its feet are `auto`, or the robot has none of its frames, they and
/// their sizes are those of find_feet(): `robot` gets the frames that those need, and `notes` a
/// sentence. Throws EntryError, "standing.feet", where none were found.
Standing standing_on(Robot& robot, const Standing& standing, std::vector<std::string>& notes);

}  // namespace burnish::pressing
