// burnish bench: how fast is all this on this robot and this machine?
#include <fmt/format.h>

#include <thread>

#include "bench_measure.hpp"
#include "burnish/base/error.hpp"
#include "command.hpp"
#include "record/json_text.hpp"
#include "robot_arguments.hpp"

namespace burnish::app {
namespace {

struct BenchArguments {
  RobotArguments robot;
  BenchSpec spec;
  bool json = false;
};

Json report_json(const BenchReport& report) {
  Json json{{"robot", report.robot},
            {"tool", report.tool},
            {"posture", report.posture},
            {"nq", report.nq},
            {"nv", report.nv},
            {"nx", report.nx},
            {"nu", report.nu},
            {"knots", report.knots},
            {"threads", report.threads},
            {"pack_width", report.pack_width},
            {"peak_multiply_adds_per_s", report.peak},
            {"lines", Json::array()}};
  for (const BenchLine& line : report.lines) {
    Json entry{{"group", line.group},   {"work", line.work}, {"median_s", line.median},
               {"best_s", line.best},   {"p99_s", line.p99}, {"peak_share", nullptr},
               {"allocations", nullptr}};
    if (line.peak_share > 0.0) entry["peak_share"] = line.peak_share;
    if (line.allocations >= 0.0) entry["allocations"] = line.allocations;
    if (line.group == "iteration") {
      entry["expand_s"] = line.expand;
      entry["backward_s"] = line.backward;
      entry["trial_s"] = line.trial;
    }
    json["lines"].push_back(std::move(entry));
  }
  return json;
}

/// Three digits that count, in a unit that suits.
std::string time_text(double seconds) {
  const auto [value, unit] =
      seconds < 1e-3 ? std::pair{1e6 * seconds, "us"} : std::pair{1e3 * seconds, "ms"};
  const int digits = value < 9.995 ? 2 : value < 99.95 ? 1 : 0;
  return fmt::format("{:.{}f} {}", value, digits, unit);
}

/// In Markdown, to paste.
std::string report_text(const BenchReport& report) {
  std::string text = fmt::format(
      "{}: nq = {}, nv = {}; {} held along z, {}; horizon of {} knots, nx = {}, nu = {}\n"
      "packs of {} states, {} of {} cores; peak of one core: {:.1f} multiply-adds per ns\n\n",
      report.robot, report.nq, report.nv, report.tool,
      report.posture.empty() ? "at zero" : "posture " + report.posture, report.knots, report.nx,
      report.nu, report.pack_width, report.threads, std::thread::hardware_concurrency(),
      1e-9 * report.peak);
  constexpr const char* row = "| {:<9} | {:<41} | {:>8} | {:>8} | {:>8} | {:>7} | {:>11} |\n";
  text += fmt::format(row, "per", "work", "median", "best", "p99", "of peak", "allocations");
  text += fmt::format("|:{:-<9}-|:{:-<41}-|-{:->8}:|-{:->8}:|-{:->8}:|-{:->7}:|-{:->11}:|\n", "",
                      "", "", "", "", "", "");
  for (const BenchLine& line : report.lines) {
    text += fmt::format(
        row, line.group, line.work, time_text(line.median), time_text(line.best),
        time_text(line.p99),
        line.peak_share > 0.0 ? fmt::format("{:.0f} %", 100.0 * line.peak_share) : "",
        line.allocations < 0.0 ? "not counted" : fmt::format("{:.3g}", line.allocations));
    if (line.group != "iteration") continue;
    for (const auto& [phase, seconds] :
         {std::pair{"derivatives", line.expand}, std::pair{"backward pass", line.backward},
          std::pair{"line search", line.trial}})
      text += fmt::format(row, "", fmt::format("  {}", phase), time_text(seconds), "", "", "", "");
  }
  return text;
}

int bench(const BenchArguments& arguments) {
  BenchSpec spec = arguments.spec;
  spec.robot = arguments.robot.load();
  const BenchReport report = measure_speed(spec);
  fmt::print("{}", arguments.json ? json_text(report_json(report)) + "\n" : report_text(report));
  return exit_ok;
}

}  // namespace

void add_bench(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("bench", "Time per state, per iteration and per tick on this machine");
  const auto arguments = std::make_shared<BenchArguments>();
  arguments->robot.robot = "talos:right_arm";
  arguments->robot.add_to(*command);
  command->get_option("ROBOT")->required(false)->default_str("talos:right_arm");
  BenchSpec& spec = arguments->spec;
  command
      ->add_option("--tool", spec.tool,
                   "Frame in contact [the frame 'tool', or else the last leaf frame]")
      ->type_name("FRAME");
  command
      ->add_option("--posture", spec.posture,
                   "Posture that the states are near [the robot's default]")
      ->type_name("NAME");
  command->add_option("--knots", spec.knots, "Knots of the horizon [100]")
      ->type_name("N")
      ->check(CLI::Range(1, 100000));
  command->add_option("--threads", spec.threads, "Threads that share the work [1]")
      ->type_name("N")
      ->check(CLI::Range(1, 256));
  command->add_flag("--pin-threads", spec.pin_threads, "Keep each thread but the first on a core");
  command->add_option("--seconds", spec.seconds, "Seconds that each line is measured, about [0.3]")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  command->add_flag("--json", arguments->json, "As JSON, in seconds");
  command->footer(
      "States are near the posture, the tool held along world z; the horizon presses it down with\n"
      "30 N along a circle. 'of peak': the larger of the numbers of multiplications and additions\n"
      "per second, of the multiply-adds that a core does at best. Compare figures of one run, on "
      "a\n"
      "machine that does nothing else.\n"
      "\n"
      "Examples:\n"
      "  burnish bench\n"
      "  burnish bench arm7 --threads 2\n"
      "  burnish bench my_arm.urdf --tool flange --knots 50 --json");
  command->callback([arguments, &exit_code] { exit_code = bench(*arguments); });
}

}  // namespace burnish::app
