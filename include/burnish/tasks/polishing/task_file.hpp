// Reads and writes polishing tasks as YAML files that users edit.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "burnish/tasks/polishing/task.hpp"

namespace burnish::polishing {

/// Named surface: its normal, and a starting posture of the robot that suits the surface.
/// @described polishing @result
struct NamedSurface {
  std::string name;              ///< Name of the surface
  std::string posture;           ///< Name of a posture in the robot's settings
  Eigen::Vector3d normal_world;  ///< Normal of the surface in the world; points out of the material
};

/// Returns all named surfaces: table, board (in front of the robot), board_x (another name of
/// board), board_y, board_minus_y and tilt_45.
const std::vector<NamedSurface>& named_surfaces();
/// Sets the starting posture and the surface normal of `task` to the values in named_surfaces() for
/// the name `surface`. At the start, the surface then lies at the distance Task::clearance below
/// the tool. For an unknown name, throws Error that suggests the nearest known name.
void put_on(Task& task, const std::string& surface);

using burnish::disturbance_preset;
using burnish::disturbance_presets;

/// Reads a task file. Missing keys get their defaults; tasks/polishing/table.yaml states all keys.
/// Then applies `overrides` in order. Each override is a text "key.path=value" with a value in
/// YAML. Throws Error with the file (or override), line, key and requirement.
Task read_task(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});
/// Reads a task from the text of a task file, as read_task() does. Error messages use `name` as the
/// file's name.
Task parse_task(const std::string& text, const std::string& name,
                const std::vector<std::string>& overrides = {});
/// Applies `overrides` to a task in order. Each override is a text "key.path=value" with a value in
/// YAML. Throws Error with the override and the requirement.
void override_task(Task& task, const std::vector<std::string>& overrides);

/// Checks the settings of a task. Throws Error if a number is out of range or if settings
/// contradict each other. The message is one sentence.
void check_task(const Task& task);

/// Returns the text of a complete task file, with the unit and meaning of every key. Reading this
/// text returns the same task.
std::string task_text(const Task& task);
/// Writes the text of task_text() to a file. Throws Error if the file cannot be written.
void write_task(const Task& task, const std::filesystem::path& file);

}  // namespace burnish::polishing
