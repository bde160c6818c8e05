// burnish run: a task that its file names, in closed loop, with its figures and page.
#include <fmt/format.h>
#include <unistd.h>

#include "command.hpp"
#include "press_hold/record.hpp"
#include "progress_bar.hpp"
#include "record/json_text.hpp"
#include "record/run_folder.hpp"
#include "signals.hpp"

namespace burnish::app {
namespace {

struct RunArguments {
  std::string file, plant, out;
  int record_every = 10;
  bool no_page = false, mcap = false, force = false, quiet = false, json = false;
};

int run(const RunArguments& arguments) {
  const press_hold::Task task = press_hold::read_task(arguments.file);
  const PlantKind plant = arguments.plant.empty()
                              ? (has_mujoco() ? PlantKind::Mujoco : PlantKind::Ideal)
                              : (arguments.plant == "ideal" ? PlantKind::Ideal : PlantKind::Mujoco);
  named_by(arguments.file, [&] { (void)press_hold::make_setting(task); });
  const StopRequest stop("the run ends, and what there is of it is written");
  const std::string name = std::filesystem::path(arguments.file).stem().string();
  RunFolder folder({.out = arguments.out, .name = name + "_run", .force = arguments.force});
  folder.claim(press_hold::record_names());
  const bool talks = !arguments.quiet && !arguments.json;
  const bool bar = talks && isatty(STDERR_FILENO) != 0;
  const press_hold::RunResult result =
      press_hold::run_task(task, plant, [&](double time, double end) {
        if (bar) show_progress(name, time / end, fmt::format("{:.1f} s of {:.1f} s", time, end));
        return !StopRequest::asked();
      });
  if (bar) fmt::print(stderr, "\r\033[K");
  PageWriter pages(!arguments.no_page, arguments.mcap);
  const auto names = press_hold::write_run({name, plant, arguments.record_every}, task, result,
                                           folder.path(), pages);
  folder.finish();
  if (arguments.json)
    fmt::print("{}\n", json_text(press_hold::run_json({name, plant, arguments.record_every}, task,
                                                      result)));
  else if (talks || !result.done)
    fmt::print("{}: {}\n", name, result.outcome);
  if (talks) fmt::print("  {}: {}\n", folder.path().string(), fmt::join(names, ", "));
  return result.done ? exit_ok : exit_failed;
}

}  // namespace

void add_run(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "run", "Run a task that its file names, such as press_hold: control, simulation");
  const auto arguments = std::make_shared<RunArguments>();
  RunArguments& a = *arguments;
  command->add_option("TASK", a.file, "Task file that says `task: press_hold`")
      ->type_name("")
      ->required();
  command
      ->add_option("--plant", a.plant,
                   has_mujoco() ? "Simulator: mujoco or ideal [mujoco]"
                                : "Simulator: ideal; this build has no MuJoCo [ideal]")
      ->type_name("NAME")
      ->check(CLI::IsMember({"mujoco", "ideal"}));
  command
      ->add_option("--out", a.out,
                   "Folder for what is written [a new one: TASK_run, TASK_run_2, ...]")
      ->type_name("DIR");
  command->add_flag("--force", a.force, "Replace the run that the folder of --out holds");
  command
      ->add_option("--record-every", a.record_every,
                   "Rows of trace.csv are so many plant steps apart [10]")
      ->type_name("N")
      ->check(CLI::PositiveNumber);
  command->add_flag("--no-page", a.no_page, "Write no run.json and run.html");
  command->add_flag("--mcap", a.mcap, "Write run.mcap too, a recording that Foxglove opens");
  command->add_flag("--quiet", a.quiet, "Print nothing unless the run fails");
  command->add_flag("--json", a.json, "Print metrics.json and nothing else");
  command->footer(
      "Examples:\n"
      "  burnish run tasks/press_hold/arm7.yaml\n"
      "  burnish run my_task.yaml --plant ideal --out /tmp/my_run\n"
      "\n"
      "The file names its task: `task: press_hold` presses at a point and holds the force while "
      "the\n"
      "rest of the arm moves aside. Leaves trace.csv, metrics.json, task.yaml, run.html, run.json "
      "and\n"
      "after a fault last_second.csv. docs/tasks.md explains it; burnish polish is for polishing.\n"
      "Exit codes: 0 done; 1 not: a fault or an interruption; 2 bad input.");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace burnish::app
