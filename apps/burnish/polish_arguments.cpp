#include "polish_arguments.hpp"

namespace burnish::app {

void PolishArguments::add_to(CLI::App& command) {
  command
      .add_option("TASK", file,
                  "Task file [the default task on table and board; with --robot on the table only]")
      ->type_name("");
  command
      .add_option("--surface", surfaces,
                  "Surface: table, board (in front), board_x, board_y, board_minus_y, tilt_45; "
                  "repeatable")
      ->type_name("SURFACE")
      ->allow_extra_args(false);
  command
      .add_option(
          "--controller", controller,
          "Controller: mpc, baseline (impedance), admittance, both (mpc and baseline), or all "
          "[both; mpc if the robot stands or carries the surface]")
      ->type_name("NAME")
      ->check(CLI::IsMember({"mpc", "baseline", "admittance", "both", "all"}));
  command
      .add_option("--disturbances", disturbances,
                  "Disturbances that the controller does not model: none, sensors, mismatch or "
                  "joint_friction; each includes the previous ones [from the task file, or "
                  "mismatch]")
      ->type_name("PRESET");
  command.add_flag("--assume-rotors", assume_rotors,
                   "Assume a typical rotor inertia for joints without one in the description, in "
                   "controller and plant; tables state it");
  command
      .add_option("--duration", duration,
                  "Time on the path, in seconds [from the task file, or the default task]")
      ->type_name("S");
  add_run_options(command, *this,
                  {.robot = "from the task file, or talos:right_arm",
                   .tool = "from the task file, or 'tool'",
                   .out = "TASK_run or polishing_run, polishing_run_2, ...",
                   .key = "KEY=VALUE",
                   .quiet = "Print only the table of results",
                   .json = "Print summary.json and nothing else"});
  command.add_flag("--time", time, "Print the computing times of the controller's ticks");
  command
      .add_option(
          "--write-posture", write_posture,
          "Name under which the start posture found by the search is added to the robot's settings")
      ->type_name("NAME");
}

}  // namespace burnish::app
