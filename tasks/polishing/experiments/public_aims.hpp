// Aims that public robots should meet, robots that miss aims, and reasons for robots without runs.
#pragma once

#include "polishing/experiments/experiment.hpp"
#include "polishing/experiments/public_robots.hpp"

namespace burnish::polishing {

/// Aim that every public robot should meet.
struct PublicAim {
  std::string what;
  std::string where = {};  ///< Surface or ground on which the aim is tested.
  int met = 0, all = 0;
  std::vector<std::string> missed = {};  ///< Names of robots that miss the aim.

  void count(const std::string& robot, bool meets);
};

/// Robot that was not tested or whose runs were rejected, with the reason.
struct UntriedRobot {
  std::string robot, where, reason;
};

/// Names of additional measurements of a public robot's run.
namespace public_figures {
inline constexpr const char* mass = "mass";    ///< Moving mass [kg].
inline constexpr const char* force = "force";  ///< Force that the tool presses with [N].
/// Number of joints whose rotor inertia was assumed.
inline constexpr const char* rotors = "rotors";
inline constexpr const char* light = "light";  ///< Number of light joints, see light_joints().
/// Extra delay of commands that the control loop tolerates, predicted by margins() [s]. It is added
/// to the delay of the preset `sensors`.
inline constexpr const char* delay = "delay";
}  // namespace public_figures

/// Common part of the reports on arms and on robots with legs.
class PublicReport {
 public:
  PublicReport();
  /// Adds a row of the table of all runs.
  void add_run(const std::string& robot, const std::string& where, const std::string& run,
               const RunFigures& figures);
  void add_aim(PublicAim aim) { aims_.push_back(std::move(aim)); }
  void add_untried(UntriedRobot robot) { untried_.push_back(std::move(robot)); }
  /// Writes the tables into the report, the table of all runs first. Adds a finding with the number
  /// of aims met, and adds the reasons of untried robots to the failures.
  void write(ExperimentReport& report) const;

 private:
  ResultTable runs_{.name = "runs", .title = "Every run", .for_people = false};
  std::vector<PublicAim> aims_;
  std::vector<UntriedRobot> untried_;
};

/// Returns an additional measurement of a run; NaN if the run was rejected.
double measured(const RunFigures& run, const std::string& figure);

/// Returns "assumed" or "missing" if the description of an arm lacks rotor inertias, else "-".
std::string rotors_text(const RunFigures& run);

/// Returns the runs with the given indices.
std::vector<RunFigures> chosen(const std::vector<RunFigures>& runs,
                               const std::vector<std::size_t>& numbers);

/// Returns whether all runs were made. Tables and aims skip groups of runs in which some were
/// stopped or omitted.
bool all_made(const std::vector<RunFigures>& runs);

/// Returns the number of runs that polished or, for robots with legs, stood to the end.
int polished_of(const std::vector<RunFigures>& runs);

/// Returns the reason why the first run was rejected; empty if the run was accepted.
std::string refusal_of(const std::vector<RunFigures>& runs);

}  // namespace burnish::polishing
