// The polishing task as a YAML file that a user edits.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "burnish/tasks/polishing/task.hpp"

namespace burnish::polishing {

/// A surface by name: where its normal points and a starting posture of the robot for it.
/// @described polishing @result
struct NamedSurface {
  std::string name;
  std::string posture;           ///< of the robot's settings
  Eigen::Vector3d normal_world;  ///< out of the surface
};

/// table, board (in front of the robot), board_x (the same), board_y, board_minus_y, tilt_45.
const std::vector<NamedSurface>& named_surfaces();
/// Sets posture and normal, and puts the surface under the tool. Throws Error with the nearest
/// known name.
void put_on(Task& task, const std::string& surface);

using burnish::disturbance_preset;
using burnish::disturbance_presets;

/// Reads a task file. Keys that it does not state keep their defaults; tasks/polishing/table.yaml
/// states all of them. `overrides` are applied after it, in order, each "key.path=value" with a
/// value in YAML. Throws Error naming file (or override), line, key and what was wanted.
Task read_task(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});
/// The same from a text; `name` stands for the file's in refusals.
Task parse_task(const std::string& text, const std::string& name,
                const std::vector<std::string>& overrides = {});
/// Applies overrides to a task. Throws Error as read_task() does.
void override_task(Task& task, const std::vector<std::string>& overrides);

/// Throws Error with a sentence for numbers that are possible each but not together.
void check_task(const Task& task);

/// The whole task as such a file, every key with its unit and meaning; reads back as it was.
std::string task_text(const Task& task);
/// Throws Error if the file cannot be written.
void write_task(const Task& task, const std::filesystem::path& file);

}  // namespace burnish::polishing
