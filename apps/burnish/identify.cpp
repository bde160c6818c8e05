// burnish identify: what a robot carries or weighs, from a recorded motion.
#include <fmt/format.h>

#include <algorithm>

#include "base/sentence.hpp"
#include "base/whole_file.hpp"
#include "burnish/identify/identification.hpp"
#include "burnish/identify/trial.hpp"
#include "command.hpp"
#include "files/csv_table.hpp"
#include "record/json_text.hpp"
#include "robot_arguments.hpp"

namespace burnish::app {
namespace {

struct IdentifyArguments {
  RobotArguments robot;
  std::string data, out, excite, simulate, posture, disturbances = "sensors";
  IdentificationSpec spec;
  ExcitationSpec excitation;
  int seeds = 0, first_seed = 0;
  double period = 1e-3;
  double torque_noise = 0.05;  // Nm (N), of the sensors in simulations
  bool json = false;
};

/// A table as the trace that it once was.
Trace trace_of(const files::CsvTable& table) {
  std::vector<TraceColumn> columns;
  for (const std::string& name : table.names) columns.push_back({name, "-"});
  const auto rows = static_cast<int>(table.values.rows());
  Trace trace(columns, rows);
  for (int i = 0; i < rows; ++i)
    Eigen::Map<Eigen::VectorXd>(trace.add_row(), table.values.cols()) = table.values.row(i);
  return trace;
}

std::string estimate_text(double value, double sigma, double unit) {
  return fmt::format("{:.5g} +- {:.2g}", unit * value, unit * sigma);
}

/// Of each row of values what it is called and a unit that suits.
struct Row {
  const char* name;
  int first, count;
  const char* unit;
  double factor;
};
constexpr Row inertia_rows[] = {{"mass", 0, 1, "kg", 1.0},
                                {"com", 1, 3, "mm", 1e3},
                                {"Ixx Ixy Ixz", 4, 3, "g m^2", 1e3},
                                {"Iyy Iyz Izz", 7, 3, "g m^2", 1e3}};

std::string table_of(const Model& model, const Identification& found) {
  std::string text;
  for (const EstimatedInertia& one : found.inertias) {
    text += fmt::format("{}, in its axes; * what the motion does not show\n", one.frame);
    for (const Row& row : inertia_rows) {
      text += fmt::format("  {:<12}", row.name);
      for (int i = row.first; i < row.first + row.count; ++i)
        text += fmt::format(" {:>22}{}", estimate_text(one.values[i], one.sigma[i], row.factor),
                            one.is_shown(i) ? " " : "*");
      text += fmt::format(" {}\n", row.unit);
    }
  }
  if (found.delay.sigma > 0.0)
    text += fmt::format("torques are {} ms behind positions\n",
                        estimate_text(found.delay.value, found.delay.sigma, 1e3));
  text += fmt::format("\n{:<24} {:>12} {:>12} {:>12}", "rms of torque, Nm (N)", "as modelled",
                      "as found", "noise");
  if (!found.viscous.empty()) text += fmt::format(" {:>22} {:>22}", "viscous", "Coulomb");
  if (!found.armature.empty()) text += fmt::format(" {:>22}", "rotor inertia");
  if (!found.offset.empty()) text += fmt::format(" {:>22}", "offset");
  text += "\n";
  for (int k = 0; k < model.nv; ++k) {
    text += fmt::format("{:<24} {:>12.4g} {:>12.4g} {:>12.4g}", model.v_name(k),
                        found.rms_before[k], found.rms_after[k], found.rms_expected[k]);
    for (const auto* list : {&found.viscous, &found.coulomb, &found.armature, &found.offset})
      if (!list->empty()) {
        const Estimate& e = (*list)[static_cast<std::size_t>(k)];
        text += fmt::format(" {:>22}", estimate_text(e.value, e.sigma, 1.0));
      }
    text += "\n";
  }
  text += fmt::format("{} samples of {} torques\n", found.samples, model.nv);
  return text;
}

Json json_of(const Identification& found) {
  const auto numbers = [](const auto& values) {
    Json list = Json::array();
    for (const double x : values) list.push_back(x);
    return list;
  };
  const auto estimates = [](const std::vector<Estimate>& values) {
    Json list = Json::array();
    for (const Estimate& e : values) list.push_back({{"value", e.value}, {"sigma", e.sigma}});
    return list;
  };
  Json json{{"inertias", Json::array()}};
  for (const EstimatedInertia& one : found.inertias) {
    Json shown = Json::array();
    for (int i = 0; i < 10; ++i) shown.push_back(one.is_shown(i));
    json["inertias"].push_back({{"frame", one.frame},
                                {"names", estimate_names},
                                {"values", numbers(one.values)},
                                {"sigma", numbers(one.sigma)},
                                {"prior_sigma", numbers(one.prior_sigma)},
                                {"shown", std::move(shown)}});
  }
  json["viscous"] = estimates(found.viscous);
  json["coulomb"] = estimates(found.coulomb);
  json["armature"] = estimates(found.armature);
  json["offset"] = estimates(found.offset);
  json["delay"] = {{"value", found.delay.value}, {"sigma", found.delay.sigma}};
  json["rms_before"] = numbers(found.rms_before);
  json["rms_after"] = numbers(found.rms_after);
  json["rms_expected"] = numbers(found.rms_expected);
  json["samples"] = found.samples;
  json["converged"] = found.converged;
  json["warnings"] = found.warnings;
  return json;
}

/// Whether the motion shows mass and centre: of less a file would hold what was assumed.
bool shows_mass(const EstimatedInertia& one) {
  for (int i = 0; i < 4; ++i)
    if (!one.is_shown(i)) return false;
  return true;
}
bool shows_any_mass(const Identification& found) {
  return std::any_of(found.inertias.begin(), found.inertias.end(), shows_mass);
}

/// Names of moments and products of inertia that the motion does not show.
std::string hidden_moments(const EstimatedInertia& one) {
  std::string text;
  for (const int i : one.not_shown())
    if (i >= 4) text += fmt::format(" {}", estimate_names[static_cast<std::size_t>(i)]);
  return text;
}

std::string inertia_line(const EstimatedInertia& one, bool of_payload) {
  const Vector10& x = one.values;
  const std::string hidden = hidden_moments(one);
  // A payload's moments that were assumed are no payload's: the line is a comment.
  const bool all_assumed = !one.is_shown(4) || !one.is_shown(7) || !one.is_shown(9);
  return fmt::format(
      "{}inertia: [{:.8g}, {:.8g}, {:.8g}, {:.8g}, {:.8g}, {:.8g}]  # xx xy xz yy yz zz about com, "
      "kg m^2{}\n",
      of_payload && all_assumed ? "# " : "", x[4], x[5], x[6], x[7], x[8], x[9],
      hidden.empty() ? "" : "; not shown by the motion:" + hidden);
}

/// What robot.yaml takes: `payload`, or `inertias` of links.
std::string settings_of(const Identification& found, bool of_payload) {
  std::string text = "# Estimated by burnish identify; the comments are standard deviations.\n";
  text += of_payload ? "payload:\n" : "inertias:\n";
  for (const EstimatedInertia& one : found.inertias) {
    const Vector10 &x = one.values, &s = one.sigma;
    const std::string indent = of_payload ? "  " : "    ";
    if (!shows_mass(one)) {
      text += fmt::format("  # {}: the motion does not show its mass and centre\n", one.frame);
      continue;
    }
    text +=
        of_payload ? fmt::format("  frame: {}\n", one.frame) : fmt::format("  {}:\n", one.frame);
    text += fmt::format("{}mass: {:.8g}  # {:.2g} kg\n", indent, x[0], s[0]);
    text += fmt::format("{}com: [{:.8g}, {:.8g}, {:.8g}]  # {:.2g}, {:.2g}, {:.2g} m\n", indent,
                        x[1], x[2], x[3], s[1], s[2], s[3]);
    text += indent + inertia_line(one, of_payload);
  }
  return text;
}

void print_sentences(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) fmt::print(stderr, "burnish: {}\n", warning);
}

Excitation excitation_of(const IdentifyArguments& a, const Robot& robot) {
  const Eigen::VectorXd start =
      a.posture.empty() ? robot.reference_configuration() : robot.posture(a.posture);
  Excitation motion(robot.model, start, a.spec.payload, a.excitation);
  print_sentences(motion.warnings());
  return motion;
}

int excite(const IdentifyArguments& a, const Robot& robot) {
  const Excitation motion = excitation_of(a, robot);
  motion.trace(a.period).write_csv(std::filesystem::path(a.excite));
  fmt::print("{}: {:g} s from rest to rest; look whether anything is in its way\n", a.excite,
             motion.duration());
  return exit_ok;
}

Disturbances disturbances_of(const IdentifyArguments& a) {
  Disturbances disturbances = disturbance_preset(a.disturbances);
  if (a.disturbances != "none") disturbances.torque_sensor_noise = a.torque_noise;
  disturbances.seed = a.excitation.seed;
  return disturbances;
}

int simulate(const IdentifyArguments& a, const Robot& robot) {
  const Excitation motion = excitation_of(a, robot);
  const Payload carried = drawn_payload(a.spec.payload, a.excitation.seed);
  const Trace trace = record_motion(robot.model, carried, motion, disturbances_of(a));
  print_sentences(check_followed(robot.model, motion, trace));
  trace.write_csv(std::filesystem::path(a.simulate));
  const InertiaSpec& truth = carried.inertia;
  const Eigen::Matrix3d& I = truth.inertia_at_com;
  fmt::print(
      "{}: {} carries {:.5g} kg at ({:.4g}, {:.4g}, {:.4g}) m of {}, inertia {:.4g} {:.4g} {:.4g} "
      "{:.4g} {:.4g} {:.4g} kg m^2\n",
      a.simulate, robot.model.name, truth.mass, truth.com[0], truth.com[1], truth.com[2],
      carried.frame, I(0, 0), I(0, 1), I(0, 2), I(1, 1), I(1, 2), I(2, 2));
  return exit_ok;
}

/// "met" or "missed" of an aim.
std::string aim_text(double value, double limit, bool below) {
  return (below ? value <= limit : value >= limit) ? "met" : "missed";
}

/// The warnings of the first trial that has some, and how many others have some.
void print_first_warnings(const std::vector<Trial>& trials, int first_seed) {
  const auto has_some = [](const Trial& trial) { return !trial.warnings.empty(); };
  const auto first = std::find_if(trials.begin(), trials.end(), has_some);
  if (first == trials.end()) return;
  for (const std::string& warning : first->warnings)
    fmt::print(stderr, "burnish: seed {}: {}\n", first_seed + (first - trials.begin()), warning);
  if (const auto more = std::count_if(first + 1, trials.end(), has_some); more > 0)
    fmt::print(stderr, "burnish: {} more of {} trials leave the motion\n", more, trials.size());
}

int try_seeds(const IdentifyArguments& a, const Robot& robot) {
  const Excitation motion = excitation_of(a, robot);
  const Disturbances disturbances = disturbances_of(a);
  std::vector<Trial> trials;
  for (int seed = a.first_seed; seed < a.first_seed + a.seeds; ++seed)
    trials.push_back(named_by("seed " + std::to_string(seed), [&] {
      return try_identification(robot.model, motion, disturbances, a.spec,
                                static_cast<std::uint64_t>(seed));
    }));
  print_first_warnings(trials, a.first_seed);
  const TrialSummary all = summary_of(trials);
  fmt::print(
      "{} payloads at {} of {}, {:g} s each, disturbances: {}, {:g} Nm of sensor "
      "noise\n\n",
      all.trials, a.spec.payload, robot.model.name, motion.duration(), a.disturbances,
      disturbances.torque_sensor_noise);
  fmt::print("| {:<6} | {:>10} | {:>10} |\n|:-------|-----------:|-----------:|\n", "", "rms error",
             "rms stated");
  for (const Row& row : inertia_rows)
    for (int i = row.first; i < row.first + row.count; ++i)
      fmt::print("| {:<6} | {:>10.3g} | {:>10.3g} | {}\n",
                 estimate_names[static_cast<std::size_t>(i)], row.factor * all.rms_error[i],
                 row.factor * all.rms_sigma[i], row.unit);
  fmt::print("\n| {:<34} | {:>8} | {:>6} | {:<6} |\n|:{:-<34}-|-{:->8}:|-{:->6}:|:{:-<6}-|\n", "",
             "measured", "aim", "", "", "", "", "");
  const auto line = [](const char* what, double value, double limit, bool below) {
    fmt::print("| {:<34} | {:>8.3g} | {:>6g} | {:<6} |\n", what, value, limit,
               aim_text(value, limit, below));
    return aim_text(value, limit, below) == "met";
  };
  bool met = line("largest error of a mass, %", 100.0 * all.mass_error, 1.0, true);
  met = line("largest error of a centre, mm", 1e3 * all.centre_error, 2.0, true) && met;
  met = line("errors within 2 sigma, %", 100.0 * all.within_two_sigma, 95.0, false) && met;
  met = line("largest error, sigma", all.largest_in_sigma, 4.0, true) && met;
  return met ? exit_ok : exit_failed;
}

int identify_file(const IdentifyArguments& a, const Robot& robot) {
  const Identification found = named_by(a.data, [&] {
    return identify(robot.model, motion_record(robot.model, trace_of(files::read_csv(a.data))),
                    a.spec);
  });
  fmt::print("{}", a.json ? json_text(json_of(found)) + "\n" : table_of(robot.model, found));
  print_sentences(found.warnings);
  const bool known = found.converged && shows_any_mass(found);
  if (!a.out.empty() && known) write_whole_file(a.out, settings_of(found, a.spec.bodies.empty()));
  if (!a.out.empty() && !known)
    fmt::print(stderr, "burnish: '{}' is not written: the motion does not show mass and centre\n",
               a.out);
  return known ? exit_ok : exit_failed;
}

int identify_command(const IdentifyArguments& a) {
  const Robot robot = a.robot.load();
  if (!a.excite.empty()) return excite(a, robot);
  if (!a.simulate.empty()) return simulate(a, robot);
  if (a.seeds > 0) return try_seeds(a, robot);
  if (a.data.empty())
    throw Error(
        "nothing to identify from; wanted DATA, a table of a motion, or --excite, --simulate "
        "or --seeds");
  return identify_file(a, robot);
}

void add_estimate(IdentifyArguments& a, CLI::App& command) {
  command.add_option("DATA", a.data, "CSV with time, q_<joint> and tau_<joint>, or a run's trace")
      ->type_name("");
  command
      .add_option("--bodies", a.spec.bodies, "Links whose own masses are wanted, not a payload's")
      ->type_name("LINK,...")
      ->delimiter(',');
  command.add_option("--payload", a.spec.payload, "Frame that the payload is written in [tool]")
      ->type_name("FRAME");
  command.add_flag("--friction", a.spec.friction,
                   "Joint friction too: for torques that motors give");
  command.add_flag("--armature", a.spec.armature,
                   "Inertias of the joints' rotors too, in place of the model's");
  command.add_flag("--offset", a.spec.offset, "A constant error of each torque too");
  command
      .add_option("--motion-window", a.spec.motion_window,
                  "Seconds that a polynomial spans which differentiates the motion [0.04]")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  command.add_option("--window", a.spec.window, "Seconds that torques are smoothed over [0.25]")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--torque-noise", a.spec.torque_noise,
                  "Deviation of a torque sample's noise, Nm (N) [as neighbouring samples say]")
      ->type_name("NM")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--start", a.spec.start, "Seconds of the record that are left out first [0]")
      ->type_name("S")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--out", a.out, "File for the lines that robot.yaml takes")->type_name("FILE");
  command.add_flag("--json", a.json, "As JSON");
}

void add_motion(IdentifyArguments& a, CLI::App& command) {
  command
      .add_option("--excite", a.excite, "Write a motion that shows a payload, as CSV, and no more")
      ->type_name("FILE");
  command
      .add_option(
          "--simulate", a.simulate,
          "Write a simulated record of that motion with a payload that is drawn, and no more")
      ->type_name("FILE");
  command.add_option("--posture", a.posture, "Posture that it begins at [the robot's default]")
      ->type_name("NAME");
  command.add_option("--duration", a.excitation.duration, "Seconds of that motion [10]")
      ->type_name("S");
  command.add_option("--highest", a.excitation.highest, "Hz of its fastest harmonic [0.7]")
      ->type_name("HZ");
  command
      .add_option("--range", a.excitation.range, "Radians (m) that joints leave the start [0.8]")
      ->type_name("RAD");
  command.add_option("--speed", a.excitation.speed, "Radians (m) per second of joints at most [2]")
      ->type_name("RAD/S")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--speed-share", a.excitation.speed_share,
                  "Share of velocity limits that is used [0.4]")
      ->type_name("SHARE")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--effort-share", a.excitation.effort_share,
                  "Share of effort limits that is used, without a payload [0.8]")
      ->type_name("SHARE")
      ->check(CLI::PositiveNumber);
  command.add_option("--joints", a.excitation.joints, "Joints that move [all]")
      ->type_name("JOINT,...")
      ->delimiter(',');
  command.add_option("--seed", a.excitation.seed, "Of what is drawn: motion, payload, noise [1]")
      ->type_name("N");
  command
      .add_option("--seeds", a.seeds,
                  "Try it: payloads that are drawn, carried in simulation and identified")
      ->type_name("N")
      ->check(CLI::Range(1, 100000));
  command.add_option("--first-seed", a.first_seed, "The first of these seeds [0]")
      ->type_name("N")
      ->check(CLI::Range(0, 1000000000));
  command.add_option("--disturbances", a.disturbances, "Preset of these simulations [sensors]")
      ->type_name("NAME");
}

}  // namespace

void add_identify(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("identify", "What a robot carries or weighs, from a recorded motion");
  const auto arguments = std::make_shared<IdentifyArguments>();
  IdentifyArguments& a = *arguments;
  a.robot.add_to(*command);
  add_estimate(a, *command);
  add_motion(a, *command);
  command->footer(
      "Examples:\n"
      "  burnish identify arm7 --excite motion.csv\n"
      "  burnish identify arm7 recorded.csv --out payload.yaml\n"
      "  burnish identify arm7 recorded.csv --bodies link_6,link_7 --friction\n"
      "  burnish identify arm7 --seeds 100\n"
      "\n"
      "docs/identification.md has the method. Exit code 1: the motion does not show the mass, or "
      "an aim\n"
      "of --seeds was missed; 2: bad usage, or a record that cannot be right.");
  command->callback([arguments, &exit_code] { exit_code = identify_command(*arguments); });
}

}  // namespace burnish::app
