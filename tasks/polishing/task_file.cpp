#include "burnish/tasks/polishing/task_file.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "base/whole_file.hpp"
#include "document/described.hpp"
#include "files/csv_table.hpp"
#include "files/read_values.hpp"
#include "polishing/descriptions.hpp"
#include "polishing/horizon.hpp"
#include "pressing/task_checks.hpp"
#include "pressing/task_form.hpp"

namespace burnish::polishing {
namespace {

namespace fs = std::filesystem;
using document::Reader;

/// Reads the name of the surface. The name also determines posture and normal.
void read_surface_name(Task& task, const Reader& reader) {
  std::vector<std::string> names;
  for (const NamedSurface& surface : named_surfaces()) names.push_back(surface.name);
  put_on(task, reader.word(names));
}

/// Reads points of a path from numbers or from a CSV table. The path of the CSV file is relative to
/// the task file. In an override on the command line, it is relative to the working folder.
void read_points(PathSpec& path, const Reader& reader) {
  const Description& description = description_of(&path);
  if (reader.is_list()) return document::read_entry(description.field("points"), &path, reader);
  const bool is_file = !reader.file().starts_with("override ");
  const fs::path folder = is_file ? fs::path(reader.file()).parent_path() : fs::path();
  path.points.clear();
  reader.named([&] {
    const files::CsvTable table = files::read_csv(files::beside(folder, reader.text()));
    const Eigen::VectorXd u = table.column("u"), w = table.column("w");
    for (Eigen::Index i = 0; i < u.size(); ++i) path.points.emplace_back(u[i], w[i]);
  });
}

[[noreturn]] void refuse_together(const std::string& what) { throw Error("the task: " + what); }

bool is_multiple(double large, double small) {
  const double ratio = large / small;
  return ratio > 0.5 && std::abs(ratio - std::round(ratio)) < 1e-6 * ratio;
}

/// Throws Error for durations and rates with which a run would take too long or too much memory.
/// The limits are chosen by hand.
void check_times(const Task& task) {
  constexpr double max_time = 1e5;       // largest duration of a phase [s]
  constexpr double max_tick_rate = 1e5;  // largest rate of ticks [Hz]
  constexpr double max_steps = 5e8;      // largest number of plant steps
  if (task.tick_rate > max_tick_rate)
    refuse_together("controller.tick_rate is " + number(task.tick_rate) + " Hz; wanted at most " +
                    number(max_tick_rate) + " Hz");
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
    if (!(time <= max_time))
      refuse_together(std::string(name) + " is " + number(time) + " s; wanted at most " +
                      number(max_time) + " s");
    sum += time;
  }
  // A plant takes steps of at most 0.5 ms.
  const double steps = sum * std::max(task.tick_rate, 2000.0);
  if (steps > max_steps)
    refuse_together("phases of " + number(sum) + " s at controller.tick_rate of " +
                    number(task.tick_rate) + " Hz are " + number(steps) +
                    " steps; wanted at most " + number(max_steps));
}

/// Throws Error if the knots of plans are impossible or would make the loop unstable.
void check_knots(const Task& task) {
  pressing::check_contact_step(task.step, "controller.contact_kd", task.contact_kd);
  if (task.standing.stands())
    pressing::check_contact_step(task.step, "standing.contact_kd", task.standing.contact_kd);
  if (task.knots > 0) {
    ProblemSpec spec;
    spec.stages = {{.name = "plan", .step = task.step}};
    spec.horizon = {horizon_of(task, "plan")};
    try {
      (void)knot_steps(spec);
    } catch (const Error& error) {
      refuse_together(error.what());
    }
    return;
  }
  if (!is_multiple(task.horizon, task.step))
    refuse_together("controller.horizon of " + number(task.horizon) +
                    " s is not a multiple of controller.step of " + number(task.step) +
                    " s; wanted a whole number of steps");
  if (task.horizon / task.step > static_cast<double>(max_knots))
    refuse_together("controller.horizon of " + number(task.horizon) + " s has more than " +
                    std::to_string(max_knots) + " steps of " + number(task.step) +
                    " s; wanted at most " + std::to_string(max_knots) + " steps");
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
  for (const NamedSurface& named : named_surfaces()) {
    names.push_back(named.name);
    if (named.name != surface) continue;
    task.posture = named.posture;
    task.normal_base = named.normal_world;
    task.point_base.reset();
    return;
  }
  throw Error("unknown surface " + in_quotes(surface) + "; wanted " + files::either(names) +
              did_you_mean(surface, names));
}

const files::DescribedFile& file_of(const Task* /*of*/) {
  static const files::DescribedFile all = [] {
    files::DescribedFile form(description_of(static_cast<const Task*>(nullptr)),
                              "A polishing task for `burnish polish`. SI units, angles in rad. A "
                              "key that is left out has\nits default.",
                              "polishing", false);
    form.reads("surface", "name", read_surface_name).word("surface", "name");
    form.reads<Task>("path", "points",
                     [](Task& task, const Reader& reader) { read_points(task.path, reader); })
        .word("path", "kind")
        .word("force_profile", "kind")
        .word("home", "posture");
    pressing::read_presets<Task>(form, "surface.friction");
    form.gone("weights", "position_limits", "constraints.joint_margin, which limits plans")
        .gone("weights", "velocity_limits", "constraints.joint_speed, which limits plans")
        .gone("weights", "torque_limits", "constraints.torque, which limits plans");
    // Orders the limits in the file by how often they are used.
    form.first("limits",
               {"force", "force_window", "tool_speed", "joint_speed_ratio", "joint_margin", "stale",
                "bad", "contact_lost", "contact_threshold", "late_contact_travel",
                "late_contact_time", "unexpected_force", "release"});
    return form;
  }();
  return all;
}

files::SpecTexts<Task> parse_said_task(const std::string& text, const std::string& name,
                                       const std::vector<files::Override>& overrides) {
  files::SpecTexts<Task> said = files::parse_said<Task>(text, name, overrides);
  try {
    check_task(said.spec);
  } catch (const Error& error) {
    throw Error(name + ": " + error.what());
  }
  return said;
}

Task read_task(const fs::path& file, const std::vector<std::string>& overrides) {
  return parse_task(read_text(file, "YAML file"), file.string(), overrides);
}

Task parse_task(const std::string& text, const std::string& name,
                const std::vector<std::string>& overrides) {
  return parse_said_task(text, name, files::as_overrides(overrides)).spec;
}

void override_task(Task& task, const std::vector<std::string>& overrides) {
  files::SpecTexts<Task> said{.spec = task};
  files::change(said, overrides);
  task = said.spec;
}

std::string task_text(const Task& task) { return file_of(&task).text(&task); }

void check_task(const Task& task) {
  check_ranges(description_of(&task), &task,
               [](const std::string& entry) { return "the task: " + entry; });
  check_times(task);
  check_knots(task);
  if (!is_multiple(task.tick_rate, task.update_rate))
    refuse_together("update_rate is " + number(task.update_rate) + " Hz and tick_rate " +
                    number(task.tick_rate) + " Hz; wanted a whole number of ticks per update");
  if (task.timing == PlanTiming::Fixed && task.solver_delay > 1.0 / task.update_rate + 1e-12)
    refuse_together("solver_delay is " + number(task.solver_delay) + " s; wanted at most the " +
                    number(1.0 / task.update_rate) + " s between two updates");
  try {
    task.force_profile.check(task.force);
  } catch (const Error& error) {
    refuse_together(error.what());
  }
  const double max_force = task.force_profile.max_force(task.force);
  if (task.tool_limits.force <= max_force)
    refuse_together("limits.force is " + number(task.tool_limits.force) +
                    " N; wanted more than the largest force of the task, " + number(max_force) +
                    " N");
  const Path path(task.path);
}

void write_task(const Task& task, const fs::path& file) { write_whole_file(file, task_text(task)); }

}  // namespace burnish::polishing
