#include "polish_arguments.hpp"

#include "burnish/tasks/pressing/plants.hpp"
#include "robot_arguments.hpp"

namespace burnish::app {
namespace {

/// Adds the options that select the runs.
void add_polish_task_options(CLI::App& command, PolishArguments& a) {
  command
      .add_option("TASK", a.file,
                  "Task file [the default task on table and board; with --robot on the table only]")
      ->type_name("");
  command
      .add_option(
          "--robot", a.robot,
          "Robot: name, URDF or MJCF file, folder or settings file; :variant may follow [from the "
          "task file, or talos:right_arm]")
      ->type_name("ROBOT");
  command
      .add_option(
          "--tool", a.tool,
          "Frame with its origin at the centre of the round tip [from the task file, or 'tool']")
      ->type_name("FRAME");
  command
      .add_option("--surface", a.surfaces,
                  "Surface: table, board (in front), board_x, board_y, board_minus_y, tilt_45; "
                  "repeatable")
      ->type_name("SURFACE")
      ->allow_extra_args(false);
  command
      .add_option(
          "--controller", a.controller,
          "Controller: mpc, baseline (impedance), admittance, both (mpc and baseline), or all "
          "[both; mpc if the robot stands or carries the surface]")
      ->type_name("NAME")
      ->check(CLI::IsMember({"mpc", "baseline", "admittance", "both", "all"}));
  command
      .add_option("--plant", a.plant,
                  has_mujoco() ? "Simulator: mujoco or ideal [mujoco]"
                               : "Simulator: ideal; this build has no MuJoCo [ideal]")
      ->type_name("NAME")
      ->check(CLI::IsMember({"mujoco", "ideal"}));
  command
      .add_option("--disturbances", a.disturbances,
                  "Disturbances that the controller does not model: none, sensors, mismatch or "
                  "joint_friction; each includes the previous ones [from the task file, or "
                  "mismatch]")
      ->type_name("PRESET");
  command.add_flag("--assume-rotors", a.assume_rotors,
                   "Assume a typical rotor inertia for joints without one in the description, in "
                   "controller and plant; tables state it");
  command
      .add_option("--set", a.overrides, "Set a key of the task file, such as force=20; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--seed", a.seeds, "Seed of the random disturbances; repeat for more runs")
      ->type_name("N")
      ->check(CLI::NonNegativeNumber)
      ->allow_extra_args(false);
  command
      .add_option("--duration", a.duration,
                  "Time on the path, in seconds [from the task file, or the default task]")
      ->type_name("S");
}

/// Adds the options that select files to write and text to print.
void add_polish_output_options(CLI::App& command, PolishArguments& a) {
  command
      .add_option("--out", a.out,
                  "Output folder [a new one: TASK_run or polishing_run, polishing_run_2, ...]")
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
  command.add_flag("--time", a.time, "Print the computing times of the controller's ticks");
  command.add_flag("--unchecked", a.unchecked, "Run even if the reach check fails");
  command
      .add_option("--write-task", a.write_task,
                  "Write the task to a file, with an explanation of every key, and exit")
      ->type_name("FILE");
  command
      .add_option(
          "--write-posture", a.write_posture,
          "Name under which the start posture found by the search is added to the robot's settings")
      ->type_name("NAME");
  command.add_flag("--quiet", a.quiet, "Print only the table of results");
  command.add_flag("--json", a.json, "Print summary.json and nothing else");
  add_strict(command, a.strict);
}

}  // namespace

void PolishArguments::add_to(CLI::App& command) {
  add_polish_task_options(command, *this);
  add_polish_output_options(command, *this);
}

}  // namespace burnish::app
