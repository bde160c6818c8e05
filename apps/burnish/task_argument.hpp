// Task files on the command line, and names of their runs.
#pragma once

#include <string>

#include "burnish/tasks/polishing/task.hpp"
#include "burnish/tasks/pressing/standing.hpp"
#include "files/described_file.hpp"

namespace burnish::app {

/// Name of the surface of a task, for its runs: `surface`, or a description of the surface if
/// settings change its normal or shape, such as "tilt_30_sphere".
std::string place_name(const std::string& surface, const polishing::Task& task);

/// Throws Error if `file` describes a robot in place of a task; the message names `robot_option`,
/// the option that takes a robot. Also throws Error if the file is a task of another command than
/// `wanted` ("polish" or "run").
void refuse_other_file(const std::string& file, const std::string& wanted,
                       const std::string& robot_option);

/// Throws Error if the YAML file `file` is for another command than `wanted`: a task, an
/// optimal-control problem or settings of a robot. `wanted`: "polish", "run", "solve", or "show"
/// for all that take a robot. The message names the command.
void refuse_file_of_another_command(const std::string& file, const std::string& wanted);

/// Returns whether an override states `key`. `texts` are the task's file and then its overrides.
bool is_overridden(const std::vector<files::Reader>& texts, const std::string& key);

/// Throws EntryError, "standing.feet", for a frame that the robot does not have. Feet that a file
/// states for its own robot pass where an override names another one: standing_on() replaces them.
/// `texts`: the task's file, then its overrides.
void check_stated_feet(const Model& model, const Standing& standing,
                       const std::vector<files::Reader>& texts);

}  // namespace burnish::app
