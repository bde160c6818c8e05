// burnish bench: durations of computations for a robot or a task's controller on this machine.
#include <fmt/format.h>

#include <thread>

#include "bench_measure.hpp"
#include "bench_task.hpp"
#include "burnish/base/error.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "command.hpp"
#include "model/mass_check.hpp"
#include "record/json_text.hpp"
#include "robot_arguments.hpp"

namespace burnish::app {
namespace {

struct BenchArguments {
  RobotArguments robot;
  BenchSpec spec;
  std::string task;
  std::vector<std::string> overrides;
  std::optional<double> seconds;
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

/// Returns a duration with three significant digits, in us or ms.
std::string time_text(double seconds) {
  const auto [value, unit] =
      seconds < 1e-3 ? std::pair{1e6 * seconds, "us"} : std::pair{1e3 * seconds, "ms"};
  const int digits = value < 9.995 ? 2 : value < 99.95 ? 1 : 0;
  return fmt::format("{:.{}f} {}", value, digits, unit);
}

/// Returns the report as a Markdown table.
std::string report_text(const BenchReport& report) {
  std::string text = fmt::format(
      "{}: nq = {}, nv = {}; contact of {} along z, {}; horizon of {} knots, nx = {}, nu = {}\n"
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

Json spread_json(const Spread& spread) {
  return {{"count", spread.count},
          {"median_s", spread.median},
          {"p99_s", spread.p99},
          {"maximum_s", spread.maximum}};
}

Json allocations_json(long allocations) { return allocations < 0 ? Json() : Json(allocations); }

Json task_json(const TaskBenchReport& report) {
  const RealTime& real = report.real;
  return {{"robot", report.robot},
          {"nv", report.nv},
          {"nx", report.nx},
          {"nu", report.nu},
          {"knots", report.knots},
          {"horizon_s", report.horizon},
          {"pack_width", report.pack_width},
          {"cores", report.cores},
          {"threads", report.threads},
          {"plan", spread_json(report.plans.whole)},
          {"expand", spread_json(report.plans.expand)},
          {"backward", spread_json(report.plans.backward)},
          {"trial", spread_json(report.plans.trial)},
          {"recursions", report.plans.recursions},
          {"real_time",
           {{"tick_period_s", report.tick_period},
            {"ticks", real.ticks},
            {"missed", real.missed},
            {"tick", spread_json(real.tick)},
            {"woken", spread_json(real.woken)},
            {"plan", spread_json(real.plan)},
            {"age", spread_json(real.age)},
            {"plans_per_second", real.plans_per_second},
            {"tick_allocations", allocations_json(real.tick_allocations)},
            {"plan_allocations", allocations_json(real.plan_allocations)},
            {"plant_share", real.plant_share},
            {"has_priority", real.has_priority},
            {"force_rmse_N", real.force_rmse},
            {"path_rmse_m", real.path_rmse},
            {"fault", real.fault.kind == FaultKind::None ? "" : real.fault.text()}}}};
}

void add_times(std::string& text, const char* per, const char* work, const Spread& spread) {
  text += fmt::format("| {:<9} | {:<41} | {:>8} | {:>8} | {:>8} | {:>7} |\n", per, work,
                      time_text(spread.median), time_text(spread.p99), time_text(spread.maximum),
                      spread.count);
}

std::string real_time_text(const TaskBenchReport& report) {
  const RealTime& real = report.real;
  const auto counted = [](long allocations) {
    return allocations < 0 ? std::string("not counted") : std::to_string(allocations);
  };
  return fmt::format(
      "\n{:.0f} plans per second; {} of {} ticks at {:.0f} Hz were unfinished when the next tick "
      "was due\nallocations in ticks: {}; in plans: {}\nrms error of the true force: {:.2f} N; of "
      "the path: {:.2f} mm\n{}; the plant took {:.0f} % of the time of the tick thread, between "
      "ticks\n{}",
      real.plans_per_second, real.missed, real.ticks, 1.0 / report.tick_period,
      counted(real.tick_allocations), counted(real.plan_allocations), real.force_rmse,
      1e3 * real.path_rmse,
      real.has_priority
          ? "the tick thread had real-time priority"
          : "the tick thread had no real-time priority, because this user may not set one (chrt)",
      100.0 * real.plant_share,
      real.fault.kind == FaultKind::None ? "" : "fault: " + real.fault.text() + "\n");
}

/// Returns the report of a task as a Markdown table.
std::string task_text(const TaskBenchReport& report) {
  std::string text = fmt::format(
      "{}: nv = {}; {} knots over {:.2f} s, nx = {}, nu = {}\n"
      "packs of {} states; {} thread{} per plan; {} core{}\n\n",
      report.robot, report.nv, report.knots, report.horizon, report.nx, report.nu,
      report.pack_width, report.threads, report.threads == 1 ? "" : "s", report.cores,
      report.cores == 1 ? "" : "s");
  text += fmt::format("| {:<9} | {:<41} | {:>8} | {:>8} | {:>8} | {:>7} |\n", "", "", "median",
                      "p99", "max", "count");
  text += fmt::format("|:{:-<9}-|:{:-<41}-|-{:->8}:|-{:->8}:|-{:->8}:|-{:->7}:|\n", "", "", "", "",
                      "", "");
  const PlanTimes& plans = report.plans;
  const std::string backward = fmt::format("  backward pass, {:.1f} recursions", plans.recursions);
  add_times(text, "plan", "alone", plans.whole);
  add_times(text, "", "  derivatives", plans.expand);
  add_times(text, "", backward.c_str(), plans.backward);
  add_times(text, "", "  line search", plans.trial);
  add_times(text, "real time", "plan, in its thread", report.real.plan);
  add_times(text, "", "age of the plan in use", report.real.age);
  add_times(text, "", "tick", report.real.tick);
  add_times(text, "", "delay of the start of a tick", report.real.woken);
  return text + real_time_text(report);
}

int bench_task(const BenchArguments& arguments) {
  TaskBenchSpec spec{.threads = arguments.spec.threads};
  spec.task = polishing::read_task(arguments.task, arguments.overrides);
  spec.seconds = arguments.seconds.value_or(spec.seconds);
  const TaskBenchReport report = named_by(arguments.task, [&] { return measure_task(spec); });
  fmt::print("{}", arguments.json ? json_text(task_json(report)) + "\n" : task_text(report));
  return report.real.fault.kind == FaultKind::None ? exit_ok : exit_failed;
}

int bench(const BenchArguments& arguments) {
  if (!arguments.task.empty()) return bench_task(arguments);
  BenchSpec spec = arguments.spec;
  spec.seconds = arguments.seconds.value_or(spec.seconds);
  spec.robot = arguments.robot.load();
  require_simulable(spec.robot.model);
  const BenchReport report = measure_speed(spec);
  fmt::print("{}", arguments.json ? json_text(report_json(report)) + "\n" : report_text(report));
  return exit_ok;
}

/// Adds the options that select a task, in place of a robot, for the measurements.
void add_task_options(CLI::App* command, BenchArguments& arguments) {
  CLI::Option* task =
      command
          ->add_option(
              "--task", arguments.task,
              "Polishing task whose controller is measured: its plans, and its ticks in real time")
          ->type_name("FILE");
  for (const char* other : {"ROBOT", "--tool", "--posture", "--knots", "--pin-threads"})
    task->excludes(command->get_option(other));
  command
      ->add_option("--set", arguments.overrides,
                   "Set a key of the polishing task, such as controller.knots=40; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false)
      ->needs(task);
}

}  // namespace

void add_bench(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "bench", "Measure the time per state, per solver iteration and per tick on this machine");
  const auto arguments = std::make_shared<BenchArguments>();
  arguments->robot.robot = "talos:right_arm";
  arguments->robot.add_to(*command);
  command->get_option("ROBOT")->required(false)->default_str("talos:right_arm");
  BenchSpec& spec = arguments->spec;
  command
      ->add_option("--tool", spec.tool,
                   "Frame in contact [the frame 'tool', else the last leaf frame]")
      ->type_name("FRAME");
  command
      ->add_option("--posture", spec.posture,
                   "Posture around which states are drawn [the robot's default posture]")
      ->type_name("NAME");
  command->add_option("--knots", spec.knots, "Number of knots of the horizon [100]")
      ->type_name("N")
      ->check(CLI::Range(1, 100000));
  command->add_option("--threads", spec.threads, "Number of threads [1]")
      ->type_name("N")
      ->check(CLI::Range(1, 256));
  command->add_flag("--pin-threads", spec.pin_threads,
                    "Pin each thread except the first to a core");
  command
      ->add_option("--seconds", arguments->seconds,
                   "Approximate measuring time for each line of the table, in seconds [0.3]; with "
                   "--task, time on the path [10]")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  add_task_options(command, *arguments);
  command->add_flag("--json", arguments->json, "Print JSON, with times in seconds");
  command->footer(
      "States are near the posture, with the tool in contact along world z. The horizon presses\n"
      "with 30 N along a circle. 'of peak': rate of multiplications or of additions, whichever is\n"
      "larger, as a fraction of the core's peak rate of multiply-adds. Compare numbers of one run\n"
      "only, on an otherwise idle machine.\n"
      "\n"
      "With --task, the robot of a polishing task polishes twice: in simulated time, to measure\n"
      "plans alone, and in real time, with ticks at the period of the clock and plans in another\n"
      "thread. The simulator runs between the ticks. taskset selects the cores.\n"
      "\n"
      "Examples:\n"
      "  burnish bench\n"
      "  burnish bench arm7 --threads 2\n"
      "  burnish bench my_arm.urdf --tool flange --knots 50 --json\n"
      "  taskset -c 0,1 burnish bench --task tasks/polishing/standing.yaml");
  command->callback([arguments, &exit_code] { exit_code = bench(*arguments); });
}

}  // namespace burnish::app
