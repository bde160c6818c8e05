#include "run_arguments.hpp"

#include "burnish/tasks/pressing/plants.hpp"
#include "robot_arguments.hpp"

namespace burnish::app {
namespace {

/// Adds the options that select the runs.
void add_selection(CLI::App& command, RunArguments& a, const RunTexts& texts) {
  command
      .add_option("--robot", a.robot,
                  "Robot: name, URDF or MJCF file, folder or settings file; :variant may follow [" +
                      texts.robot + "]")
      ->type_name("ROBOT");
  command
      .add_option("--tool", a.tool,
                  "Frame with its origin at the centre of the round tip [" + texts.tool + "]")
      ->type_name("FRAME");
  command
      .add_option("--plant", a.plant,
                  has_mujoco() ? "Simulator: mujoco or ideal [mujoco]"
                               : "Simulator: ideal; this build has no MuJoCo [ideal]")
      ->type_name("NAME")
      ->check(CLI::IsMember({"mujoco", "ideal"}));
  command
      .add_option("--set", a.overrides, "Set a key of the task file, such as force=20; repeatable")
      ->type_name(texts.key)
      ->allow_extra_args(false);
  command
      .add_option("--seed", a.seeds,
                  "Seed of the random disturbances; repeat for more runs [from the task file]")
      ->type_name("N")
      ->check(CLI::NonNegativeNumber)
      ->allow_extra_args(false);
}

}  // namespace

void add_run_options(CLI::App& command, RunArguments& a, const RunTexts& texts) {
  add_selection(command, a, texts);
  command.add_option("--out", a.out, "Output folder [a new one: " + texts.out + "]")
      ->type_name("DIR");
  command.add_flag("--force", a.force, "Replace the run in the output folder");
  command
      .add_option("--record-every", a.record_every,
                  "Number of plant steps between rows of trace.csv [10]")
      ->type_name("N")
      ->check(CLI::PositiveNumber);
  command.add_flag("--no-page", a.no_page, "Omit run.json, run.html and comparison.html");
  command.add_flag("--plots", a.plots,
                   "Write force.svg, path.svg, torques.svg and solver.svg as well. The page "
                   "shows the same curves; --no-page implies --plots");
  command.add_flag("--mcap", a.mcap, "Write run.mcap as well, a recording for Foxglove");
  command.add_flag("--unchecked", a.unchecked, "Run even if the reach check fails");
  command
      .add_option("--write-task", a.write_task,
                  "Write the task to a file, with an explanation of every key, and exit")
      ->type_name("FILE");
  command.add_flag("--quiet", a.quiet, texts.quiet);
  command.add_flag("--json", a.json, texts.json);
  add_strict(command, a.strict);
}

}  // namespace burnish::app
