// burnish check: comparison of a robot's derivatives with finite differences.
#include "burnish/derivatives/check.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "command.hpp"
#include "contact_text.hpp"
#include "record/json_text.hpp"
#include "robot_arguments.hpp"

namespace burnish::app {
namespace {

struct CheckArguments {
  RobotArguments robot;
  CheckOptions options;
  std::vector<std::string> contacts, surfaces;
  bool all_accelerations = false;
  bool json = false;
};

Json row_json(const CheckRow& row) {
  return {{"reference", row.reference},
          {"directions", row.directions},
          {"bodies", row.bodies},
          {"acceleration", row.acceleration},
          {"error", row.error},
          {"gains", row.gains},
          {"states", row.states},
          {"mu", row.mu},
          {"worst_error", number_json(row.worst_error)},
          {"worst_entry",
           {{"block", row.worst.block},
            {"row", row.worst.row},
            {"column", row.worst.column},
            {"value", number_json(row.worst.value)},
            {"expected", number_json(row.worst.expected)},
            {"state", row.worst.state}}},
          {"pass", row.pass}};
}

Json report_json(const CheckReport& report) {
  Json json{
      {"robot", report.robot},
      {"pass", report.pass},
      {"tolerance", report.tolerance},
      {"singular_mass", report.singular_mass.empty() ? Json(nullptr) : Json(report.singular_mass)},
      {"rows", Json::array()}};
  for (const CheckRow& row : report.rows) json["rows"].push_back(row_json(row));
  return json;
}

/// Prints the progress on a terminal, and erases the line at the end.
void show_checked(int done, int total) {
  fmt::print(stderr, "\r{} of {} rows", done, total);
  if (done == total) fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
}

int check(const CheckArguments& arguments) {
  const Robot robot = arguments.robot.load();
  CheckOptions options = arguments.options;
  const Eigen::VectorXd q = robot.reference_configuration();
  for (const std::string& text : arguments.contacts)
    options.contacts.push_back(parse_contact(text, robot.model, q));
  if (!arguments.surfaces.empty()) {
    options.references.clear();
    options.surfaces.clear();
    for (const std::string& text : arguments.surfaces)
      options.surfaces.push_back(SurfaceShape::parse(text));
  }
  if (arguments.all_accelerations) {
    options.accelerations = {Acceleration::TimeDerivative, Acceleration::Spatial,
                             Acceleration::Classical};
  }
  if (isatty(STDERR_FILENO) != 0) options.progress = show_checked;
  const CheckReport report = check_derivatives(robot.model, options);
  if (arguments.json) {
    fmt::print("{}\n", json_text(report_json(report)));
  } else {
    fmt::print("{}", report.text());
  }
  return report.pass ? exit_ok : exit_failed;
}

void add_options(CLI::App& command, CheckArguments& arguments) {
  CheckOptions& options = arguments.options;
  command
      .add_option("--tool", options.tool,
                  "Frame in contact [the frame 'tool', else the last leaf frame]")
      ->type_name("FRAME");
  command.add_option("--base", options.base, "Frame of the body that the tool touches [world]")
      ->type_name("FRAME");
  command
      .add_option("--contact", arguments.contacts,
                  "Contact to check, in place of the built-in list; repeat to check several "
                  "contacts at once")
      ->type_name("SPEC")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
      .add_option("--surface", arguments.surfaces,
                  "Curved surface of a reference whose axes turn with its normal, in place of the "
                  "built-in references; repeat to check several surfaces in turn")
      ->type_name("SHAPE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_flag(
      "--all-accelerations", arguments.all_accelerations,
      "Check the spatial and the classical acceleration as well as the time derivative");
  command
      .add_option("--states", options.states,
                  "Number of random states for each row of the table [20]")
      ->type_name("N");
  command.add_option("--seed", options.seed, "Seed of the random states [1]")->type_name("N");
  command
      .add_option(
          "--tolerance", options.tolerance,
          "Largest permitted error, relative to the largest entry of a block of derivatives [1e-6]")
      ->type_name("T");
  command.add_flag("--json", arguments.json, "Print JSON");
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("check", "Check derivatives against finite differences of the values");
  const auto arguments = std::make_shared<CheckArguments>();
  arguments->robot.add_to(*command);
  add_options(*command, *arguments);
  command->footer(
      "Without --contact, one tool is checked in four references and on a saddle, in eight sets "
      "of\n"
      "directions, with and without gains. A SHAPE is sphere:RADIUS, cylinder:RADIUS,\n"
      "cone:RADIUS:HALF_ANGLE, torus:RADIUS:RING, ellipsoid:A:B:C or saddle:K:K (m, rad, 1/m),\n"
      "followed by :hollow if the tool is inside; it is fixed in the base.\n"
      "\n"
      "A contact's SPEC is a list of key=value: tool (needed), name, base, reference (local,\n"
      "centered, surface, world), normal (of a surface, x,y,z), directions (x y z rx ry rz all\n"
      "linear angular pad_x|y|z), acceleration (time_derivative, spatial, classical), error "
      "(split,\n"
      "log6), kp, kd (1 or 6 numbers); or the notation of problem files, in braces. The default\n"
      "target is the placement of the tool at the reference posture.\n"
      "\n"
      "Examples:\n"
      "  burnish check arm7\n"
      "  burnish check talos:right_arm --tool tool --states 100\n"
      "  burnish check arm7 --surface sphere:0.3 --surface torus:0.1:0.5:hollow\n"
      "  burnish check crane --tool left_tip --base right_tip --all-accelerations\n"
      "  burnish check talos --contact tool=left_sole_link --contact tool=right_sole_link \\\n"
      "    --contact tool=tool,reference=surface,normal=0,0.2,1,directions=z,rx,ry,kd=50\n"
      "\n"
      "Exit codes: 0 all rows passed; 1 a row failed; 2 invalid input.");
  command->callback([arguments, &exit_code] { exit_code = check(*arguments); });
}

}  // namespace burnish::app
