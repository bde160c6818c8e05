// What is said of a polishing run before it begins.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "burnish/tasks/polishing/reach.hpp"
#include "files/described_file.hpp"
#include "polishing/record/run_files.hpp"

namespace burnish::app {

/// Prints notes on what is probably not meant and, if it `talks`, what the arm has left on the
/// path. `said`: the texts that the job's task comes from.
void describe_job(const polishing::PolishJob& job, const polishing::ReachReport& reach,
                  const std::vector<document::Reader>& said, bool talks);

/// Prints how the robot gets to its start at a place: from `home`, or without one from which of its
/// postures it could.
void describe_way(const std::string& place, const std::optional<HomeMove>& home,
                  const std::vector<polishing::FreeHome>& free_homes);

}  // namespace burnish::app
