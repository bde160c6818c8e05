// Keys of a task file: robot, tool, surface, path, phases.
#include <cmath>
#include <limits>

#include "burnish/tasks/polishing/task_file.hpp"
#include "files/csv_table.hpp"
#include "files/read_values.hpp"
#include "polishing/task_keys.hpp"

namespace burnish::polishing {
namespace {

using files::YamlReader;

std::vector<std::string> names_of_surfaces() {
  std::vector<std::string> names;
  for (const NamedSurface& surface : named_surfaces()) names.push_back(surface.name);
  return names;
}

std::optional<std::string> not_written(const Task& /*task*/) { return std::nullopt; }

TaskKey point_key() {
  return {"point", "[x, y, z] of any point on it, m; or under_tool: clearance below the start",
          [](Task& task, const YamlReader& reader) {
            if (reader.is("under_tool"))
              task.point_world.reset();
            else
              task.point_world = reader.vector3();
          },
          [](const Task& task) -> std::optional<std::string> {
            return task.point_world ? yaml(*task.point_world) : "under_tool";
          }};
}

/// A number, or a word for none.
TaskKey extent_key() {
  return {"extent", "m that there is surface beyond the path, on all four sides; or endless",
          [](Task& task, const YamlReader& reader) {
            task.extent = reader.is("endless") ? std::numeric_limits<double>::infinity()
                                               : reader.not_negative();
          },
          [](const Task& task) -> std::optional<std::string> {
            return std::isinf(task.extent) ? "endless" : yaml(task.extent);
          }};
}

TaskKey axis_key() {
  return {
      "axis",
      "[x, y, z] that it presses along, in its frame; or auto: z or -z of a frame of robot.yaml, "
      "of others the last joint's axis, away from the arm",
      [](Task& task, const YamlReader& reader) {
        if (reader.is("auto")) {
          task.tool_axis.reset();
          return;
        }
        task.tool_axis = reader.vector3();
        if (!(task.tool_axis->norm() > 1e-9))
          reader.refuse("the axis has no direction; wanted a vector that is not zero");
      },
      [](const Task& task) -> std::optional<std::string> {
        return task.tool_axis ? yaml(*task.tool_axis) : "auto";
      }};
}

TaskSection search_section() {
  const auto limit = [](const char* name, const char* meaning, double PostureLimits::*member) {
    return number_key(name, meaning, Range::NotNegative, at(&Task::search, member));
  };
  return {"search",
          "What a posture that is searched keeps to.",
          {limit("tilt", "rad between the tool's axis and the normal", &PostureLimits::tilt),
           limit("joint_margin", "rad that joints keep from their limits at the start",
                 &PostureLimits::joint_margin),
           limit("body_distance",
                 "m between the last link and the robot's body; less where the arm is short",
                 &PostureLimits::body_distance)}};
}

TaskKey normal_key() {
  return {"normal", "[x, y, z] out of the material towards the robot, any length, world",
          [](Task& task, const YamlReader& reader) {
            task.normal_world = reader.vector3();
            if (!(task.normal_world.norm() > 1e-9))
              reader.refuse("the normal has no direction; wanted a vector that is not zero");
          },
          [](const Task& task) -> std::optional<std::string> { return yaml(task.normal_world); }};
}

TaskSection surface_section() {
  constexpr auto positive = Range::Positive;
  return {
      "surface",
      "Or one word for posture, normal and point: table, board, board_x, board_y, board_minus_y,\n"
      "tilt_45. The controller knows where it is; it knows nothing of friction and stiffness.",
      {{"name", "",
        [](Task& task, const YamlReader& reader) {
          put_on(task, reader.word(names_of_surfaces()));
        },
        not_written},
       normal_key(),
       point_key(),
       extent_key(),
       number_key("friction", "Coulomb coefficient of the plant", Range::NotNegative,
                  at(&Task::friction)),
       number_key("stiffness", "N/m, of the plant", positive, at(&Task::stiffness)),
       number_key("damping", "Ns/m, of the plant; with friction below force / (3 friction speed)",
                  Range::NotNegative, at(&Task::damping))},
      "name"};
}

std::vector<Eigen::Vector2d> read_points(const YamlReader& reader) {
  std::vector<Eigen::Vector2d> points;
  if (reader.is_list()) {
    for (const YamlReader& entry : reader.entries()) points.emplace_back(entry.numbers(2));
    return points;
  }
  const std::filesystem::path folder = std::filesystem::path(reader.file()).parent_path();
  reader.named([&] {
    const files::CsvTable table = files::read_csv(files::beside(folder, reader.text()));
    const Eigen::VectorXd u = table.column("u"), w = table.column("w");
    for (Eigen::Index i = 0; i < u.size(); ++i) points.emplace_back(u[i], w[i]);
  });
  return points;
}

TaskKey points_key() {
  return {"points",
          "[[u, w], ...] in the surface's tangents, m, or a CSV file with columns u and w (points)",
          [](Task& task, const YamlReader& reader) { task.path.points = read_points(reader); },
          [](const Task& task) -> std::optional<std::string> {
            std::string text = "[";
            for (const Eigen::Vector2d& p : task.path.points)
              text += (text.size() > 1 ? ", " : "") + yaml(p);
            return text + "]";
          }};
}

TaskSection path_section() {
  constexpr auto positive = Range::Positive;
  const auto path = [](auto member) { return at(&Task::path, member); };
  return {
      "path",
      "In the plane of the surface, from the point under the start, beginning at rest.",
      {word_key("kind", "circle, spiral, zigzag or points",
                {"circle", "spiral", "zigzag", "points"}, path(&PathSpec::kind)),
       number_key("radius", "m (circle, and the largest of a spiral)", positive,
                  path(&PathSpec::radius)),
       number_key("rate", "rad/s (circle, spiral)", Range::Any, path(&PathSpec::rate)),
       number_key("start_up", "s until the full radius (circle), the full growth (spiral)",
                  positive, path(&PathSpec::start_up)),
       number_key("pitch", "m between two turns (spiral)", positive, path(&PathSpec::pitch)),
       number_key("width", "m along the first tangent (zigzag)", positive, path(&PathSpec::width)),
       number_key("height", "m along the second tangent (zigzag)", positive,
                  path(&PathSpec::height)),
       count_key("rows", "lines (zigzag)", 2, path(&PathSpec::rows)),
       number_key("speed", "m/s, the highest along a line (zigzag, points)", positive,
                  path(&PathSpec::speed)),
       points_key()},
      "kind"};
}

TaskSection phases_section() {
  constexpr auto positive = Range::Positive;
  return {
      "phases",
      "Reach above the surface, approach until contact, ramp the force, polish, retreat.",
      {number_key("clearance", "m between tool and surface where the reach ends", positive,
                  at(&Task::clearance)),
       number_key("reach_duration", "s", positive, at(&Task::reach_duration)),
       number_key("approach_speed", "m/s towards the surface", positive, at(&Task::approach_speed)),
       number_key("touch_force",
                  "N, at once where contact is made, so that the tool does not rebound",
                  Range::NotNegative, at(&Task::touch_force)),
       number_key("ramp_duration", "s from contact to the full force", positive,
                  at(&Task::ramp_duration)),
       number_key("polish_duration", "s on the path", positive, at(&Task::polish_duration)),
       number_key("retreat_duration", "s back to the clearance", positive,
                  at(&Task::retreat_duration))}};
}

TaskSection verdict_section() {
  const auto share = [](const char* name, const char* meaning, double Verdict::*member) {
    return number_key(name, meaning, Range::Share, at(&Task::verdict, member));
  };
  return {
      "verdict",
      "What \"polished\" asks for, of the plant's true force and place, from the end of the ramp "
      "on.",
      {share("contact_share", "of the time in contact, at least; 0 to 1", &Verdict::contact_share),
       number_key("force_rmse", "of the force: rms error of its mean over 10 ms, at most; or never",
                  Range::PositiveOrNever, at(&Task::verdict, &Verdict::force_rmse)),
       share("path_share", "of the path's length with the tip over its target, at least; 0 to 1",
             &Verdict::path_share)}};
}

}  // namespace

std::vector<TaskSection> where_sections() {
  return {
      {"",
       "",
       {text_key("robot", "a robot's name, folder or settings file, with :variant",
                 at(&Task::robot)),
        text_key("posture",
                 "start of the arm, what its null space is drawn to; search: found for the surface",
                 at(&Task::posture)),
        number_key("force", "N, that the tool presses with", Range::Positive, at(&Task::force))}},
      {"tool",
       "",
       {text_key("frame", "its origin is the centre of a round tip", at(&Task::tool)), axis_key(),
        number_key("tip_radius", "m", Range::Positive, at(&Task::tip_radius))}},
      surface_section(),
      search_section(),
      path_section(),
      phases_section(),
      verdict_section()};
}

}  // namespace burnish::polishing
