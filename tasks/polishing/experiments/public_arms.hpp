// Experiment on public arms: polishing with default settings, compared with the baseline, and with
// late commands.
#pragma once

#include <memory>
#include <mutex>

#include "polishing/experiments/batch.hpp"
#include "polishing/experiments/public_aims.hpp"

namespace burnish::polishing {

/// An arm before a surface. What a run needs besides its task is found before the first one.
struct ArmBench {
  PublicRobot arm;
  std::string surface;
  Task task;            ///< under `mismatch`
  Robot robot;          ///< as described
  std::string numbers;  ///< of the robot: see numbers_of()
  std::once_flag searched = {};
  std::string reason = {};       ///< why there is no start; empty: there is one
  double force = 0.0;            ///< N
  Eigen::VectorXd q_start = {};  ///< nq

  /// Finds start and force, once. The force is the task's; if posture or motors do not allow it,
  /// the largest allowed whole number of newtons, at least least_force.
  void search();
  /// 1.5 times the force that counts as contact (Task::contact_threshold) [N].
  static constexpr double least_force = 3.0;
};

/// Runs of an arm that differ in nothing but their seed.
struct ArmTrial {
  ArmBench* bench;
  std::string preset = "mismatch";  ///< of disturbances
  ControllerKind controller = ControllerKind::Mpc;
  double delay = 0.0;                  ///< command delay; 0: that of the preset [s]
  bool known = false;                  ///< the controller knows this delay
  std::vector<std::size_t> runs = {};  ///< by their numbers

  bool is(const char* of_preset, ControllerKind of_controller) const {
    return delay == 0.0 && preset == of_preset && controller == of_controller;
  }
  /// "mismatch, mpc" or "3 ms unknown"
  std::string name() const;
};

class PublicArms {
 public:
  /// The specification outlives it.
  explicit PublicArms(const ExperimentSpec& spec) : spec_(spec) {}
  /// Adds the runs of an arm whose description is that file.
  void add(const PublicRobot& arm, const std::filesystem::path& file, std::vector<BatchRun>& runs);
  /// Adds tables of what came of them, by the figures of all runs.
  void report(const std::vector<RunFigures>& figures, PublicReport& common,
              ExperimentReport& report) const;

 private:
  void add_trial(ArmTrial trial, int seeds, std::vector<BatchRun>& runs);

  const ExperimentSpec& spec_;
  std::vector<std::unique_ptr<ArmBench>> benches_;
  std::vector<ArmTrial> trials_;
  std::vector<UntriedRobot> unread_;  ///< whose description is refused
};

// Tables of a report, by the figures of all runs.
ResultTable arms_table(const std::vector<ArmTrial>& trials, const std::vector<RunFigures>& figures,
                       PublicReport& common);
ResultTable delays_table(const std::vector<ArmTrial>& trials,
                         const std::vector<RunFigures>& figures, PublicReport& common);

}  // namespace burnish::polishing
