// Why the frame matters where the surface moves: one hand turns a plate that the other polishes.
#pragma once

#include "polishing/experiments/batch.hpp"

namespace burnish::polishing {

/// As task files have it.
const char* text_of(ForceAxes axes);

/// A turn of the plate, axes of contact and force, and its runs in a row of all runs.
struct PlateCase {
  double turn = 0.0;  ///< degrees to both sides
  ForceAxes axes;
  std::vector<std::size_t> runs = {};  ///< indices
};

/// Adds runs of the shipped task of two arms. The plant has to be MuJoCo.
std::vector<PlateCase> add_plate(const ExperimentSpec& spec, std::vector<BatchRun>& runs);

/// Errors by turn and axes; also a finding.
ResultTable plate_table(const std::vector<PlateCase>& cases, const std::vector<RunFigures>& figures,
                        ExperimentReport& report);

}  // namespace burnish::polishing
