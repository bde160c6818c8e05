// Notes about a polishing run that are printed before it begins.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "burnish/tasks/polishing/reach.hpp"
#include "files/described_file.hpp"
#include "polishing/record/run_files.hpp"

namespace burnish::app {

/// Prints notes about probable mistakes in the task. If `talks`, also prints the arm's margins to
/// joint, torque and clearance limits along the path. `said`: texts from which the task was read.
void describe_job(const polishing::PolishJob& job, const polishing::ReachReport& reach,
                  const std::vector<document::Reader>& said, bool talks);

/// Prints the motion from the posture `home` to the start of the path. Without `home`, prints the
/// postures `free_homes`, from which the motion to the start would be free of collisions.
void describe_home_move(const std::string& place, const std::optional<HomeMove>& home,
                        const std::vector<polishing::FreeHome>& free_homes);

}  // namespace burnish::app
