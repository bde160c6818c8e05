#include "burnish/tasks/polishing/task_file.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/sentence.hpp"
#include "base/text_file.hpp"
#include "base/whole_file.hpp"
#include "polishing/descriptions.hpp"
#include "polishing/task_keys.hpp"

namespace burnish::polishing {
namespace {

namespace fs = std::filesystem;
using document::Reader;

void apply_override(Task& task, const std::string& word) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == word.size())
    throw Error(in_quotes(word) + " is no override; wanted key.path=value");
  const std::string path = word.substr(0, equals);
  std::string value = word.substr(equals + 1);
  // Files that a command line names lie where it runs.
  if (path == "path.points" && value.front() != '[') value = fs::absolute(value).string();
  read_sections(task, Reader::parse_override(path, value, "override " + in_quotes(word)));
}

[[noreturn]] void refuse_together(const std::string& what) { throw Error("the task: " + what); }

bool is_multiple(double large, double small) {
  const double ratio = large / small;
  return ratio > 0.5 && std::abs(ratio - std::round(ratio)) < 1e-6 * ratio;
}

/// What a run is asked for has an end, and fits into memory.
void check_times(const Task& task) {
  constexpr double most_time = 1e5;  // s
  constexpr double most_rate = 1e5;  // Hz
  constexpr double most_steps = 5e8;
  if (task.tick_rate > most_rate)
    refuse_together("controller.tick_rate is " + number(task.tick_rate) + " Hz; wanted at most " +
                    number(most_rate) + " Hz");
  const double approach = task.clearance / task.approach_speed;
  const double late = task.tool_limits.late_contact_time;
  double sum = 0.0;
  for (const auto& [name, time] :
       {std::pair("phases.reach_duration", task.reach_duration),
        std::pair("phases.clearance / approach_speed", approach),
        std::pair("phases.ramp_duration", task.ramp_duration),
        std::pair("phases.polish_duration", task.polish_duration),
        std::pair("phases.retreat_duration", task.retreat_duration),
        std::pair("limits.late_contact_time", std::isinf(late) ? 0.0 : late)}) {
    if (!(time <= most_time))
      refuse_together(std::string(name) + " is " + number(time) + " s; wanted at most " +
                      number(most_time) + " s");
    sum += time;
  }
  // Plants take steps of half a millisecond at the longest.
  const double steps = sum * std::max(task.tick_rate, 2000.0);
  if (steps > most_steps)
    refuse_together("phases of " + number(sum) + " s at controller.tick_rate of " +
                    number(task.tick_rate) + " Hz are " + number(steps) +
                    " steps; wanted at most " + number(most_steps));
}

}  // namespace

const std::vector<NamedSurface>& named_surfaces() {
  static const std::vector<NamedSurface> surfaces{
      {"table", "table", {0.0, 0.0, 1.0}},
      {"board", "board_x", {-1.0, 0.0, 0.0}},
      {"board_x", "board_x", {-1.0, 0.0, 0.0}},
      {"board_y", "board_y", {0.0, 1.0, 0.0}},
      {"board_minus_y", "board_minus_y", {0.0, -1.0, 0.0}},
      {"tilt_45", "tilt_45", Eigen::Vector3d(-1.0, 0.0, 1.0).normalized()}};
  return surfaces;
}

void put_on(Task& task, const std::string& surface) {
  std::vector<std::string> names;
  for (const NamedSurface& known : named_surfaces()) {
    names.push_back(known.name);
    if (known.name != surface) continue;
    task.posture = known.posture;
    task.normal_world = known.normal_world;
    task.point_world.reset();
    return;
  }
  throw Error("surface " + in_quotes(surface) + " is not known; wanted " + files::either(names) +
              did_you_mean(surface, names));
}

const std::vector<std::string>& disturbance_presets() {
  static const std::vector<std::string> names{"none", "sensors", "mismatch", "joint_friction"};
  return names;
}

Disturbances disturbance_preset(const std::string& name) {
  const std::vector<std::string>& names = disturbance_presets();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw Error("disturbances " + in_quotes(name) + " are not known; wanted " +
                files::either(names) + did_you_mean(name, names));
  Disturbances result;
  if (name == "none") return result;
  constexpr double cutoff = 100.0 * std::numbers::pi;  // 50 Hz, rad/s
  result.command_delay = 1e-3;
  result.torque_noise = 0.05;
  result.encoder_bits = 17;
  result.finite_difference_velocity = true;
  result.velocity_cutoff = cutoff;
  result.force_noise = 0.3;
  result.force_cutoff = cutoff;
  if (name == "sensors") return result;
  result.mass_scale = 1.05;
  result.surface_friction = 0.3;
  if (name == "mismatch") return result;
  result.joint_coulomb = 1.0;
  result.joint_viscous = 1.0;
  return result;
}

Task read_task(const fs::path& file, const std::vector<std::string>& overrides) {
  return parse_task(read_text(file, "YAML file"), file.string(), overrides);
}

Task parse_task(const std::string& text, const std::string& name,
                const std::vector<std::string>& overrides) {
  Task task;
  read_sections(task, Reader::parse(text, name));
  override_task(task, overrides);
  try {
    check_task(task);
  } catch (const Error& error) {
    throw Error(name + ": " + error.what());
  }
  return task;
}

void override_task(Task& task, const std::vector<std::string>& overrides) {
  for (const std::string& word : overrides) apply_override(task, word);
}

void check_task(const Task& task) {
  check_ranges(description_of(&task), &task,
               [](const std::string& entry) { return "the task: " + entry; });
  check_times(task);
  if (!is_multiple(task.horizon, task.step))
    refuse_together("the horizon of " + number(task.horizon) + " s is no multiple of its step of " +
                    number(task.step) + " s; wanted a whole number of steps");
  if (task.horizon / task.step > static_cast<double>(max_knots))
    refuse_together("the horizon of " + number(task.horizon) + " s has more than " +
                    std::to_string(max_knots) + " steps of " + number(task.step) +
                    " s; wanted at most that many");
  if (!is_multiple(task.tick_rate, task.update_rate))
    refuse_together("update_rate is " + number(task.update_rate) + " Hz and tick_rate " +
                    number(task.tick_rate) + " Hz; wanted a whole number of ticks per update");
  if (task.solver_delay > 1.0 / task.update_rate + 1e-12)
    refuse_together("solver_delay is " + number(task.solver_delay) + " s; wanted at most the " +
                    number(1.0 / task.update_rate) + " s between two updates");
  if (task.tool_limits.force <= task.force)
    refuse_together("the force of " + number(task.force) + " N reaches limits.force of " +
                    number(task.tool_limits.force) + " N; wanted less");
  const Path path(task.path);
}

void write_task(const Task& task, const fs::path& file) { write_whole_file(file, task_text(task)); }

}  // namespace burnish::polishing
