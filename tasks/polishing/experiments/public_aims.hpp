// What public robots should do, which of them do not, and why some were not tried.
#pragma once

#include "polishing/experiments/experiment.hpp"
#include "polishing/experiments/public_robots.hpp"

namespace burnish::polishing {

/// Something that every robot should do.
struct PublicAim {
  std::string what;
  std::string where = {};  ///< surface or ground
  int met = 0, all = 0;
  std::vector<std::string> missed = {};  ///< names of robots

  void count(const std::string& robot, bool meets);
};

/// A robot of which there are no runs, or whose runs were refused, and the reason.
struct UntriedRobot {
  std::string robot, where, reason;
};

/// What is measured of a public robot's run besides its figures.
namespace public_figures {
inline constexpr const char* mass = "mass";      ///< kg that move
inline constexpr const char* force = "force";    ///< Force that the tool presses with [N].
inline constexpr const char* rotors = "rotors";  ///< joints with assumed rotors
inline constexpr const char* light = "light";    ///< joints whose rotor is missing
/// s of extra delay that margins() predicts, beyond that of the disturbances `sensors`
inline constexpr const char* delay = "delay";
}  // namespace public_figures

/// What arms and robots with legs have in common in a report.
class PublicReport {
 public:
  PublicReport();
  /// Adds a row of the table of all runs.
  void add_run(const std::string& robot, const std::string& where, const std::string& run,
               const RunFigures& figures);
  void add_aim(PublicAim aim) { aims_.push_back(std::move(aim)); }
  void add_untried(UntriedRobot robot) { untried_.push_back(std::move(robot)); }
  /// Puts the table of all runs first, adds those of aims and of robots that were not tried and a
  /// sentence for how many aims are met, and each reason to the failures.
  void write(ExperimentReport& report) const;

 private:
  ResultTable runs_{.name = "runs", .title = "Every run", .for_people = false};
  std::vector<PublicAim> aims_;
  std::vector<UntriedRobot> untried_;
};

/// The measured figure of a run, NaN where it was refused.
double measured(const RunFigures& run, const std::string& figure);

/// "assumed", "missing" or "-": rotors of an arm's motors that its description leaves out.
std::string rotors_text(const RunFigures& run);

/// Runs by their numbers.
std::vector<RunFigures> chosen(const std::vector<RunFigures>& runs,
                               const std::vector<std::size_t>& numbers);

/// Whether all runs were made. Tables and aims skip a set in which a run was stopped or left out.
bool all_made(const std::vector<RunFigures>& runs);

/// How many polished (of robots with legs: stood to the end).
int polished_of(const std::vector<RunFigures>& runs);

/// Why the first of the runs was refused; empty where it was not.
std::string refusal_of(const std::vector<RunFigures>& runs);

}  // namespace burnish::polishing
