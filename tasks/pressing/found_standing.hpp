// Search for the feet of a robot in its description, if a task does not state the feet.
#pragma once

#include <string>
#include <vector>

#include "burnish/robots/robot.hpp"
#include "burnish/tasks/pressing/standing.hpp"

namespace burnish::pressing {

/// Returns `standing` with its feet. If the stated feet are `auto`, or if the robot lacks all
/// stated frames, find_feet() determines feet and sizes. New frames are then added to `robot`, and
/// notes about the feet to `notes`. For each foot that is a wheel, `notes` receives another note.
/// Throws EntryError for "standing.feet" if no feet are found.
Standing standing_on(Robot& robot, const Standing& standing, std::vector<std::string>& notes);

}  // namespace burnish::pressing
