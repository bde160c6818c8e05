// Checks of task files given on the command line, and names of their runs.
#pragma once

#include <string>

#include "burnish/tasks/polishing/task.hpp"
#include "burnish/tasks/pressing/standing.hpp"
#include "files/described_file.hpp"

namespace burnish::app {

/// Returns the name of a task's surface, for the names of its runs. It is `surface`, or a
/// description such as "tilt_30_sphere" if settings change the normal or shape of the surface.
std::string place_name(const std::string& surface, const polishing::Task& task);

/// Returns true for a file with a task of polishing, by its top-level keys.
bool is_polishing_task(const std::string& file);

/// Throws Error if `file` describes a robot, or is a task for another command. `wanted`: command
/// that reads the file, "polish" or "run" (all tasks). For a robot, the message names
/// `robot_option`, the option that takes robots.
void refuse_other_file(const std::string& file, const std::string& wanted,
                       const std::string& robot_option);

/// Throws Error if the YAML file `file` is for another command than `wanted`; the message names the
/// command. The file may be a task, an optimal-control problem or settings of a robot. `wanted`:
/// "polish", "run", "solve", or "show" for all commands that take a robot.
void refuse_file_of_another_command(const std::string& file, const std::string& wanted);

/// Returns whether an override states `key`. `texts`: the task file, then its overrides.
bool is_overridden(const std::vector<files::Reader>& texts, const std::string& key);

/// Throws EntryError "standing.feet" for a frame that the robot does not have. Feet in a task file
/// are not checked if an override selects another robot, because standing_on() then replaces them.
/// `texts`: the task file, then its overrides.
void check_stated_feet(const Model& model, const Standing& standing,
                       const std::vector<files::Reader>& texts);

}  // namespace burnish::app
