// burnish show: tables of a robot, its HTML page, or a draft of its settings.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "burnish/contact/loops.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/tasks/polishing/margins.hpp"
#include "burnish/tasks/polishing/reach.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "command.hpp"
#include "draft_settings.hpp"
#include "pressing/arm.hpp"
#include "pressing/tool_direction.hpp"
#include "record/page_json.hpp"
#include "record/run_files.hpp"
#include "robot_arguments.hpp"
#include "settings_posture.hpp"
#include "show_json.hpp"
#include "tree_drawing.hpp"

namespace burnish::app {
namespace {

namespace fs = std::filesystem;

struct ShowArguments {
  RobotArguments robot;
  std::string posture;  ///< Name of the posture to show; empty: the default posture.
  std::string tool;     ///< Frame of the tool, for margins or for a draft; empty: none.
  bool all_frames = false;
  bool json = false;
  std::string html;      ///< File for the HTML page; empty: none.
  std::string settings;  ///< Folder for the drafted settings; empty: none.
};

/// Returns a number with four significant digits; "-" for infinity, which means that there is no
/// limit.
std::string brief(double value) {
  if (std::isinf(value)) return "-";
  const std::string text = fmt::format("{:.4g}", value);
  return text == "-0" ? "0" : text;
}

/// Returns a length or an angle as text, rounded to 0.1 mm or 0.1 mrad.
std::string fixed_point(double value) {
  const std::string text = fmt::format("{:.4f}", value);
  return text == "-0.0000" ? "0.0000" : text;
}

/// Table of text. The first `left` columns are aligned to the left, the others to the right.
class Table {
 public:
  explicit Table(std::size_t left) : left_(left) {}
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  void print() const {
    std::vector<std::size_t> widths;
    for (const auto& row : rows_) {
      widths.resize(std::max(widths.size(), row.size()), 0);
      for (std::size_t c = 0; c < row.size(); ++c) {
        widths[c] = std::max(widths[c], width_of(row[c]));
      }
    }
    for (const auto& row : rows_) {
      std::string line;
      for (std::size_t c = 0; c < row.size(); ++c) {
        line += "  " + padded(row[c], widths[c], c >= left_);
      }
      line.erase(line.find_last_not_of(' ') + 1);
      fmt::print("{}\n", line);
    }
  }

 private:
  std::size_t left_;
  std::vector<std::vector<std::string>> rows_;
};

std::string entries(int first, int count) {
  if (count == 0) return "-";
  return count == 1 ? std::to_string(first) : fmt::format("{}-{}", first, first + count - 1);
}

void print_heading(const Robot& robot) {
  const Model& model = robot.model;
  fmt::print("{}: {} moving joints, {} entries in q, {} in v, {:.2f} kg of moving mass\n",
             model.name, model.joints.size(), model.nq, model.nv, model.total_mass());
  fmt::print("gravity ({}, {}, {}) m/s^2", brief(model.gravity.x()), brief(model.gravity.y()),
             brief(model.gravity.z()));
  fmt::print("\n");
}

void print_joints(const Model& model) {
  fmt::print("\nJoints (rad, m, s, Nm, N, kg; mass: body that the joint moves)\n");
  Table table(2);
  table.add({"joint", "kind", "q", "v", "lower", "upper", "velocity", "effort", "mass"});
  const std::vector<std::string> drawing = draw_tree(model);
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    const bool limited = joint.nq == 1;
    if (joint.follows) {
      table.add({drawing[i], std::string(name_of(joint.kind)), "-", "-", "-", "-", "-", "-",
                 brief(joint.mass)});
      continue;
    }
    table.add({drawing[i], std::string(name_of(joint.kind)), entries(joint.q_index, joint.nq),
               entries(joint.v_index, joint.nv),
               limited ? brief(model.q_lower[joint.q_index]) : "-",
               limited ? brief(model.q_upper[joint.q_index]) : "-",
               brief(model.velocity_limit[joint.v_index]), brief(model.effort_limit[joint.v_index]),
               brief(joint.mass)});
  }
  table.print();
}

/// Returns how a joint follows another joint, as text: "0.5 joint + 0.1".
std::string course_of(const Model& model, const Following& follows) {
  const std::string& leader = model.joints[to_size(follows.leader)].name;
  const std::string factor =
      follows.multiplier == 1.0 ? "" : fmt::format("{} ", brief(follows.multiplier));
  if (follows.offset == 0.0) return factor + leader;
  return fmt::format("{}{} {} {}", factor, leader, follows.offset < 0.0 ? "-" : "+",
                     brief(std::abs(follows.offset)));
}

void print_followers(const Model& model) {
  Table table(2);
  table.add({"joint", "position"});
  bool has_followers = false;
  for (const Joint& joint : model.joints) {
    if (!joint.follows) continue;
    table.add({joint.name, course_of(model, *joint.follows)});
    has_followers = true;
  }
  if (!has_followers) return;
  fmt::print("\nJoints that follow others (rad, m)\n");
  table.print();
}

/// Prints the kinematic loops, and how many degrees of freedom remain at a posture.
void print_loops(const Model& model, const Eigen::VectorXd& q, const std::string& posture) {
  if (model.loops.empty()) return;
  const LoopFreedom freedom = loop_freedom(model, q);
  fmt::print("\nLoops: {} entries of v, {} rows of rank {}: {} degrees of freedom at {}\n",
             model.nv, freedom.rows, freedom.rank, freedom.freedom, posture);
  Table table(4);
  table.add({"loop", "directions", "redundant", "between"});
  for (const Loop& loop : model.loops) {
    const auto found = std::find_if(freedom.redundant.begin(), freedom.redundant.end(),
                                    [&](const auto& of) { return of.loop == loop.name; });
    const auto body = [&](const std::string& frame) {
      const int of = model.frames[to_size(model.frame_index(frame))].body;
      return of < 0 ? std::string("world") : model.joints[to_size(of)].name;
    };
    table.add({loop.name, loop.directions.text(),
               found == freedom.redundant.end() ? "-" : found->directions.text(),
               fmt::format("{} and {}", body(loop.first), body(loop.second))});
  }
  table.print();
}

void print_held(const Model& model) {
  if (model.locked_joints.empty()) return;
  fmt::print("\nLocked joints\n");
  std::string line;
  for (const std::string& name : model.locked_joints) {
    if (!line.empty() && line.size() + name.size() > 98) {
      fmt::print("  {}\n", line);
      line.clear();
    }
    line += (line.empty() ? "" : " ") + name;
  }
  fmt::print("  {}\n", line);
}

/// Prints the frames of links and the frames that the robot's files add. With `all`, prints the
/// frames of joints too.
void print_frames(const Model& model, const Eigen::VectorXd& q, const std::string& posture,
                  bool all) {
  fmt::print("\nFrames in the world at {} (m; roll, pitch, yaw in rad)\n", posture);
  Table table(3);
  table.add({"frame", "kind", "moved by", "x", "y", "z", "roll", "pitch", "yaw"});
  const std::vector<Eigen::Isometry3d> placements = frame_placements(model, q);
  for (std::size_t i = 0; i < model.frames.size(); ++i) {
    const Frame& frame = model.frames[i];
    if (frame.kind == FrameKind::Joint && !all) continue;
    const Eigen::Vector3d p = placements[i].translation();
    const Eigen::Vector3d angles = roll_pitch_yaw(placements[i].linear());
    table.add({frame.name, kind_text(frame.kind),
               frame.body < 0 ? "world" : model.joints[to_size(frame.body)].name,
               fixed_point(p.x()), fixed_point(p.y()), fixed_point(p.z()), fixed_point(angles.x()),
               fixed_point(angles.y()), fixed_point(angles.z())});
  }
  table.print();
}

void print_postures(const Robot& robot) {
  if (robot.postures.empty()) return;
  fmt::print("\nPostures\n");
  for (const auto& [name, values] : robot.postures) {
    fmt::print("  {}{}\n", name, name == robot.default_posture ? " (default)" : "");
  }
}

/// Writes an HTML page that shows the robot in 3D.
void write_page(const Robot& robot, const Eigen::VectorXd& q, const ShowArguments& arguments) {
  const RobotDrawing drawing = drawing_of(robot, arguments.robot.robot, q);
  write_robot_page(drawing, arguments.html);
  fmt::print("{} in {}\n", robot.model.name, arguments.html);
  const std::vector<std::string> missing = missing_meshes(drawing);
  if (!missing.empty())
    fmt::print("omitted meshes, which could not be read: {}\n", fmt::join(missing, ", "));
}

/// Writes a draft of settings. If the tool can reach a table, the draft contains a posture for
/// polishing the table.
void draft(const Robot& robot, const ShowArguments& arguments) {
  const fs::path file = write_settings(robot, arguments.robot, arguments.settings, arguments.tool);
  fmt::print("draft written to {}; to load it: burnish show {}\n", file.string(),
             arguments.settings);
  polishing::Task task;
  polishing::put_on(task, "table");
  task.robot = arguments.settings;
  try {
    const Robot drafted = polishing::load_task_robot(task);
    if (!polishing::searches_posture(task, drafted)) return;
    std::vector<std::string> notes;
    pressing::note_tool_direction(task.tool, std::nullopt, drafted.model, notes);
    for (const std::string& note : notes) fmt::print(stderr, "burnish: note: {}\n", note);
    const Eigen::VectorXd q = polishing::find_posture(task, drafted).q;
    add_posture(file, "table", posture_of(drafted.model, q));
    fmt::print("added the posture 'table'; to polish a table: burnish polish --robot {}\n",
               arguments.settings);
  } catch (const Error& error) {
    fmt::print(stderr, "burnish: note: no posture for a table was added: {}\n", error.what());
  }
}

/// Stability margins with a tool, and the gains for which they were computed.
struct ToolMargins {
  polishing::FittedGains fitted;
  polishing::TaskMargins margins;
};

/// Returns the margins of the pressing controller with a tool on a table. The gains are those that
/// `burnish polish` fits.
ToolMargins margins_of(const Robot& robot, const ShowArguments& arguments) {
  polishing::Task task;
  task.robot = arguments.robot.robot;
  task.tool = arguments.tool;
  task.posture = arguments.posture;
  const polishing::Setting setting = polishing::make_setting(task, robot);
  const polishing::FittedGains fitted = polishing::fit_gains(task, setting);
  if (const auto margins = polishing::margins(task, setting)) return {fitted, *margins};
  const std::string why = without_margins(polishing::make_mpc(task, setting));
  throw Error(why.empty() ? "margins: the controller found no plan from the posture" : why);
}

void print_margins(const ToolMargins& of, const std::string& tool) {
  fmt::print("\nMargins at {} on a table\n", tool);
  if (!of.fitted.changes.empty()) fmt::print("  {}\n", of.fitted.changes);
  fmt::print("  the control loop tolerates {}\n", of.margins.text());
  Table table(1);
  table.add({"gain of joint", "in free air", "", "in contact", ""});
  for (std::size_t i = 0; i < of.margins.air.gains.size(); ++i) {
    const GainRange &air = of.margins.air.gains[i], &contact = of.margins.contact.gains[i];
    table.add({air.joint, fmt::format("{:.2f}", air.below), fmt::format("{:.2f}", air.above),
               fmt::format("{:.2f}", contact.below), fmt::format("{:.2f}", contact.above)});
  }
  table.print();
}

void show(const ShowArguments& arguments) {
  const Robot robot = arguments.robot.load();
  const std::string posture = arguments.posture.empty() ? robot.default_posture : arguments.posture;
  const Eigen::VectorXd q =
      posture.empty() ? robot.reference_configuration() : robot.posture(posture);
  if (!arguments.settings.empty()) return draft(robot, arguments);
  if (!arguments.html.empty()) {
    write_page(robot, q, arguments);
    return;
  }
  std::optional<ToolMargins> margins;
  if (!arguments.tool.empty()) {
    if (!robot.model.has_frame(arguments.tool))
      throw Error("--tool: " + pressing::none_of(robot.model, arguments.tool, true));
    try {
      margins = margins_of(robot, arguments);
    } catch (const Error& error) {  // the tables follow without margins
      fmt::print(stderr, "burnish: note: no margins at {}: {}\n", arguments.tool, error.what());
    }
  }
  if (arguments.json) {
    Json json = show_json(robot, q, posture);
    if (margins)
      json["margins"] = margins_json(margins->margins, arguments.tool, margins->fitted.changes);
    fmt::print("{}\n", json_text(json));
    return;
  }
  print_heading(robot);
  print_joints(robot.model);
  print_followers(robot.model);
  print_held(robot.model);
  const std::string at = posture.empty() ? "the neutral posture" : "'" + posture + "'";
  print_loops(robot.model, q, at);
  print_frames(robot.model, q, at, arguments.all_frames);
  print_postures(robot);
  if (margins) print_margins(*margins, arguments.tool);
}

}  // namespace

void add_show(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "show", "Print the joints, limits, masses, frames and postures of a robot");
  const auto arguments = std::make_shared<ShowArguments>();
  arguments->robot.add_to(*command);
  command->add_option("--posture", arguments->posture, "Posture at which frames are placed")
      ->type_name("NAME");
  command
      ->add_option("--tool", arguments->tool,
                   "Frame of the tool, for which delay and gain margins of the pressing controller "
                   "are printed; with --write-settings, frame at which the draft places the tool")
      ->type_name("FRAME");
  command->add_flag("--all-frames", arguments->all_frames, "Print the frames of joints as well");
  command->add_flag("--json", arguments->json, "Print JSON, with all digits");
  command
      ->add_option("--html", arguments->html,
                   "Write a page with a 3D drawing of the robot, and print no table")
      ->type_name("FILE");
  command
      ->add_option("--write-settings", arguments->settings,
                   "Draft a robot.yaml for a URDF or MJCF file in this folder, and print no table")
      ->type_name("DIR");
  command->footer(
      "Examples:\n"
      "  burnish show talos:right_arm --posture table\n"
      "  burnish show quadruped --html quadruped.html\n"
      "  burnish show my_arm.urdf --tool flange\n"
      "  burnish show my_arm.urdf --lock finger_left finger_right --json\n"
      "  burnish show <(xacro my_arm.urdf.xacro)\n"
      "  burnish show my_arm.urdf --write-settings my_arm --tool flange\n"
      "\n"
      "docs/robots.md describes robot files and the warnings about them.");
  command->callback([arguments, &exit_code] {
    show(*arguments);
    exit_code = exit_ok;
  });
}

}  // namespace burnish::app
