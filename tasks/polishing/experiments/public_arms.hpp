// Experiment on public arms: polishing with default settings, compared with the baseline
// controller, and polishing with delayed commands.
#pragma once

#include <memory>
#include <mutex>

#include "polishing/experiments/batch.hpp"
#include "polishing/experiments/public_aims.hpp"

namespace burnish::polishing {

/// Arm at a surface, with the start posture and the force of its runs.
struct ArmBench {
  PublicRobot arm;
  std::string surface;
  Task task;            ///< Task with the disturbances of the preset `mismatch`.
  Robot robot;          ///< Robot as loaded, without changes for the task.
  std::string numbers;  ///< Numbers of the robot, see numbers_of().
  std::once_flag searched = {};
  std::string reason = {};       ///< Reason why no start was found; empty: a start was found.
  double force = 0.0;            ///< Force that the tool presses with [N].
  Eigen::VectorXd q_start = {};  ///< Start posture, nq entries.

  /// Searches a start posture, and sets the force to the force of the task. If posture or motors do
  /// not allow this force, sets the largest allowed whole number of newtons, at least least_force.
  void search();
  /// Smallest force that search() tries, 1.5 times Task::contact_threshold [N].
  static constexpr double least_force = 3.0;
};

/// Runs of an arm that differ only in their seed.
struct ArmTrial {
  ArmBench* bench;
  std::string preset = "mismatch";  ///< Preset of disturbances.
  ControllerKind controller = ControllerKind::Mpc;
  double delay = 0.0;                  ///< Delay of commands; 0: delay of the preset [s].
  bool known = false;                  ///< True if the controller compensates `delay`.
  std::vector<std::size_t> runs = {};  ///< Indices of the runs in the batch.

  bool is(const char* of_preset, ControllerKind of_controller) const {
    return delay == 0.0 && preset == of_preset && controller == of_controller;
  }
  /// Returns a name such as "mismatch, mpc" or "3 ms unknown".
  std::string name() const;
};

class PublicArms {
 public:
  /// `spec` must outlive this object.
  explicit PublicArms(const ExperimentSpec& spec) : spec_(spec) {}
  /// Adds the runs of an arm whose description is `file`.
  void add(const PublicRobot& arm, const std::filesystem::path& file, std::vector<BatchRun>& runs);
  /// Adds tables of the results to the report. `figures`: statistics of all runs.
  void report(const std::vector<RunFigures>& figures, PublicReport& common,
              ExperimentReport& report) const;

 private:
  void add_trial(ArmTrial trial, int seeds, std::vector<BatchRun>& runs);

  const ExperimentSpec& spec_;
  std::vector<std::unique_ptr<ArmBench>> benches_;
  std::vector<ArmTrial> trials_;
  std::vector<UntriedRobot> unread_;  ///< Robots whose descriptions were rejected.
};

// Tables of the report, from the statistics of all runs.
ResultTable arms_table(const std::vector<ArmTrial>& trials, const std::vector<RunFigures>& figures,
                       PublicReport& common);
ResultTable delays_table(const std::vector<ArmTrial>& trials,
                         const std::vector<RunFigures>& figures, PublicReport& common);

}  // namespace burnish::polishing
