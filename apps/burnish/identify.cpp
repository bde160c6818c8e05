// burnish identify: estimation of a payload, or of inertias of links, from a recorded motion.
#include <fmt/format.h>

#include <algorithm>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
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
  double torque_noise = 0.05;  // standard deviation of torque noise in simulations [Nm or N]
  bool json = false;
};

/// Returns a trace with the columns of a CSV table.
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

/// Row of the printed table: name, range of parameters, unit, and factor from SI units to this
/// unit.
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
    text += fmt::format("{}, in its axes; *: not identifiable from this motion\n", one.frame);
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
        const Estimate& e = (*list)[to_size(k)];
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

/// Returns whether mass and centre of mass are identifiable. If not, the printed settings omit
/// both, because the values are assumed.
bool shows_mass(const EstimatedInertia& one) {
  for (int i = 0; i < 4; ++i)
    if (!one.is_shown(i)) return false;
  return true;
}
bool shows_any_mass(const Identification& found) {
  return std::any_of(found.inertias.begin(), found.inertias.end(), shows_mass);
}

/// Returns the names of the moments and products of inertia that are not identifiable.
std::string hidden_moments(const EstimatedInertia& one) {
  std::string text;
  for (const int i : one.not_shown())
    if (i >= 4) text += fmt::format(" {}", estimate_names[to_size(i)]);
  return text;
}

std::string inertia_line(const EstimatedInertia& one, bool of_payload) {
  const Vector10& x = one.values;
  const std::string hidden = hidden_moments(one);
  // If all moments of inertia are assumed values, the line is written as a comment.
  const bool all_assumed = !one.is_shown(4) || !one.is_shown(7) || !one.is_shown(9);
  return fmt::format(
      "{}inertia: [{:.8g}, {:.8g}, {:.8g}, {:.8g}, {:.8g}, {:.8g}]  # xx xy xz yy yz zz about com, "
      "kg m^2{}\n",
      of_payload && all_assumed ? "# " : "", x[4], x[5], x[6], x[7], x[8], x[9],
      hidden.empty() ? "" : "; not identifiable from the motion:" + hidden);
}

/// Returns lines for robot.yaml with the key `payload`, or with the key `inertias` for links.
std::string settings_of(const Identification& found, bool of_payload) {
  std::string text = "# Estimated by burnish identify; the comments are standard deviations.\n";
  text += of_payload ? "payload:\n" : "inertias:\n";
  for (const EstimatedInertia& one : found.inertias) {
    const Vector10 &x = one.values, &s = one.sigma;
    const std::string indent = of_payload ? "  " : "    ";
    if (!shows_mass(one)) {
      text +=
          fmt::format("  # {}: mass and centre are not identifiable from the motion\n", one.frame);
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
  fmt::print("{}: {:g} s from rest to rest; check it for collisions before use\n", a.excite,
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

/// Returns "met" or "missed" for a value with a limit. `below`: true for an upper limit, false for
/// a lower limit.
std::string aim_text(double value, double limit, bool below) {
  return (below ? value <= limit : value >= limit) ? "met" : "missed";
}

/// Prints the warnings of the first trial that has warnings, and the number of other trials with
/// warnings.
void print_first_warnings(const std::vector<Trial>& trials, int first_seed) {
  const auto has_some = [](const Trial& trial) { return !trial.warnings.empty(); };
  const auto first = std::find_if(trials.begin(), trials.end(), has_some);
  if (first == trials.end()) return;
  for (const std::string& warning : first->warnings)
    fmt::print(stderr, "burnish: seed {}: {}\n", first_seed + (first - trials.begin()), warning);
  if (const auto more = std::count_if(first + 1, trials.end(), has_some); more > 0)
    fmt::print(stderr, "burnish: {} more of {} trials have warnings\n", more, trials.size());
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
      "{} payloads at {} of {}, {:g} s each, disturbances: {}, torque sensor noise: {:g} Nm\n\n",
      all.trials, a.spec.payload, robot.model.name, motion.duration(), a.disturbances,
      disturbances.torque_sensor_noise);
  fmt::print("| {:<6} | {:>10} | {:>10} |\n|:-------|-----------:|-----------:|\n", "", "rms error",
             "rms sigma");
  for (const Row& row : inertia_rows)
    for (int i = row.first; i < row.first + row.count; ++i)
      fmt::print("| {:<6} | {:>10.3g} | {:>10.3g} | {}\n", estimate_names[to_size(i)],
                 row.factor * all.rms_error[i], row.factor * all.rms_sigma[i], row.unit);
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
  const bool identified = found.converged && shows_any_mass(found);
  if (!a.out.empty() && identified)
    write_whole_file(a.out, settings_of(found, a.spec.bodies.empty()));
  if (!a.out.empty() && !identified)
    fmt::print(
        stderr,
        "burnish: '{}' is not written: mass and centre are not identifiable from the motion\n",
        a.out);
  return identified ? exit_ok : exit_failed;
}

int identify_command(const IdentifyArguments& a) {
  const Robot robot = a.robot.load();
  if (!a.excite.empty()) return excite(a, robot);
  if (!a.simulate.empty()) return simulate(a, robot);
  if (a.seeds > 0) return try_seeds(a, robot);
  if (a.data.empty())
    throw Error(
        "no data are given; wanted DATA (the table of a recorded motion), --excite, --simulate or "
        "--seeds");
  return identify_file(a, robot);
}

void add_estimate(IdentifyArguments& a, CLI::App& command) {
  command
      .add_option(
          "DATA", a.data,
          "CSV file with the columns time, q_<joint> and tau_<joint>, or trace.csv of a run")
      ->type_name("");
  command
      .add_option("--bodies", a.spec.bodies,
                  "Links whose inertias are estimated, in place of a payload")
      ->type_name("LINK,...")
      ->delimiter(',');
  command.add_option("--payload", a.spec.payload, "Frame in which the payload is expressed [tool]")
      ->type_name("FRAME");
  command.add_flag("--friction", a.spec.friction,
                   "Estimate joint friction too, for torques measured at the motors");
  command.add_flag("--armature", a.spec.armature,
                   "Estimate rotor inertias too, in place of the model's values");
  command.add_flag("--offset", a.spec.offset, "Estimate a constant offset of each torque too");
  command
      .add_option("--motion-window", a.spec.motion_window,
                  "Window of the polynomials that differentiate the motion, in seconds [0.04]")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--window", a.spec.window,
                  "Window over which torques are smoothed, in seconds [0.25]")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--torque-noise", a.spec.torque_noise,
                  "Standard deviation of a torque sample, Nm (N) [estimated from neighbouring "
                  "samples]")
      ->type_name("NM")
      ->check(CLI::NonNegativeNumber);
  command
      .add_option("--start", a.spec.start,
                  "Ignored time at the start of the record, in seconds [0]")
      ->type_name("S")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--out", a.out, "Output file with keys for robot.yaml")->type_name("FILE");
  command.add_flag("--json", a.json, "Print JSON");
}

void add_motion(IdentifyArguments& a, CLI::App& command) {
  command
      .add_option("--excite", a.excite,
                  "Write a motion from which a payload can be identified, as CSV, and exit")
      ->type_name("FILE");
  command
      .add_option("--simulate", a.simulate,
                  "Write a simulated record of a motion with a random payload, as CSV, and exit")
      ->type_name("FILE");
  command
      .add_option("--posture", a.posture,
                  "Posture at which the written motion begins [the robot's default posture]")
      ->type_name("NAME");
  command
      .add_option("--duration", a.excitation.duration,
                  "Duration of the written motion, in seconds [10]")
      ->type_name("S");
  command
      .add_option("--highest", a.excitation.highest,
                  "Frequency of the fastest harmonic, in Hz [0.7]")
      ->type_name("HZ");
  command
      .add_option("--range", a.excitation.range,
                  "Largest displacement of a joint from the start, in rad (m) [0.8]")
      ->type_name("RAD");
  command.add_option("--speed", a.excitation.speed, "Largest speed of a joint, in rad/s (m/s) [2]")
      ->type_name("RAD/S")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--speed-share", a.excitation.speed_share,
                  "Largest speed of a joint, as a fraction of its velocity limit [0.4]")
      ->type_name("SHARE")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--effort-share", a.excitation.effort_share,
                  "Largest effort without a payload, as a fraction of the effort limit [0.8]")
      ->type_name("SHARE")
      ->check(CLI::PositiveNumber);
  command.add_option("--joints", a.excitation.joints, "Joints that move [all]")
      ->type_name("JOINT,...")
      ->delimiter(',');
  command
      .add_option("--seed", a.excitation.seed, "Seed of the random motion, payload and noise [1]")
      ->type_name("N");
  command
      .add_option("--seeds", a.seeds,
                  "Number of random payloads to identify in simulation, as a test of the method")
      ->type_name("N")
      ->check(CLI::Range(1, 100000));
  command.add_option("--first-seed", a.first_seed, "Seed of the first random payload [0]")
      ->type_name("N")
      ->check(CLI::Range(0, 1000000000));
  command
      .add_option("--disturbances", a.disturbances,
                  "Disturbance preset of the simulations [sensors]")
      ->type_name("NAME");
}

}  // namespace

void add_identify(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("identify", "Estimate a payload or link inertias from a recorded motion");
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
      "docs/identification.md describes the method.\n"
      "Exit codes: 0 success; 1 the mass is not identifiable from the motion, or an aim of\n"
      "--seeds was missed; 2 invalid usage, or an implausible record.");
  command->callback([arguments, &exit_code] { exit_code = identify_command(*arguments); });
}

}  // namespace burnish::app
