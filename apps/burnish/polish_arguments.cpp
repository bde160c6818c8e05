#include "polish_arguments.hpp"

#include "burnish/tasks/pressing/plants.hpp"
#include "robot_arguments.hpp"

namespace burnish::app {
namespace {

/// What is run.
void add_polish_task_options(CLI::App& command, PolishArguments& a) {
  command
      .add_option("TASK", a.file,
                  "Task file [the default task, on table and board; with --robot on the table]")
      ->type_name("");
  command
      .add_option(
          "--robot", a.robot,
          "Robot: a name, a URDF or MJCF file, a folder or a settings file, with :variant [the "
          "file's, or talos:right_arm]")
      ->type_name("ROBOT");
  command
      .add_option("--tool", a.tool,
                  "Frame whose origin is the centre of the round tip [the file's, or tool]")
      ->type_name("FRAME");
  command
      .add_option("--surface", a.surfaces,
                  "Surface: table, board (in front), board_x, board_y, board_minus_y, tilt_45; "
                  "again for more")
      ->type_name("SURFACE")
      ->allow_extra_args(false);
  command
      .add_option(
          "--controller", a.controller,
          "Controller: mpc, baseline (impedance), admittance, both of the first two, or all "
          "[both, or mpc where a robot stands or carries the surface]")
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
                  "What the controller does not know: none, sensors, mismatch or joint_friction, "
                  "each with those before [the file's, or mismatch]")
      ->type_name("PRESET");
  command.add_flag("--assume-rotors", a.assume_rotors,
                   "Give joints whose rotor is missing in the description a usual one, in the "
                   "plant too; tables say so");
  command.add_option("--set", a.overrides, "Any key of a task file, such as force=20; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--seed", a.seeds, "Seed of what is drawn at random; again for more runs")
      ->type_name("N")
      ->check(CLI::NonNegativeNumber)
      ->allow_extra_args(false);
  command
      .add_option("--duration", a.duration, "Seconds on the path [the file's, or the default's]")
      ->type_name("S");
}

/// What it leaves.
void add_polish_output_options(CLI::App& command, PolishArguments& a) {
  command
      .add_option(
          "--out", a.out,
          "Folder for what is written [a new one: TASK_run or polishing_run, polishing_run_2, ...]")
      ->type_name("DIR");
  command.add_flag("--force", a.force, "Replace the run that the folder of --out holds");
  command
      .add_option("--record-every", a.record_every,
                  "Rows of trace.csv are so many plant steps apart [10]")
      ->type_name("N")
      ->check(CLI::PositiveNumber);
  command.add_flag("--no-page", a.no_page, "Write no run.json, run.html and comparison.html");
  command.add_flag("--plots", a.plots,
                   "Write force.svg, path.svg, torques.svg and solver.svg beside the page, which "
                   "shows the same; without a page they are written in any case");
  command.add_flag("--mcap", a.mcap, "Write run.mcap too, a recording that Foxglove opens");
  command.add_flag("--time", a.time, "Print how long the controller's ticks took");
  command.add_flag("--unchecked", a.unchecked, "Run what the arm cannot reach, too");
  command
      .add_option("--write-task", a.write_task,
                  "Write the task with every key explained to a file, and do nothing else")
      ->type_name("FILE");
  command
      .add_option("--write-posture", a.write_posture,
                  "Add the start that is searched for to the robot's settings, under this name")
      ->type_name("NAME");
  command.add_flag("--quiet", a.quiet, "Print nothing but the table of results");
  command.add_flag("--json", a.json, "Print summary.json and nothing else");
  add_strict(command, a.strict);
}

}  // namespace

void PolishArguments::add_to(CLI::App& command) {
  add_polish_task_options(command, *this);
  add_polish_output_options(command, *this);
}

}  // namespace burnish::app
