// Comparison of contact frames on a moving surface: one hand turns a plate that the other polishes.
#pragma once

#include "polishing/experiments/batch.hpp"

namespace burnish::polishing {

/// Returns the word that task files use for these axes.
const char* text_of(ForceAxes axes);

/// Runs with one amplitude of the plate's rotation and one choice of axes of contact and force.
struct PlateCase {
  double turn = 0.0;  ///< Amplitude of the rotation to both sides [deg].
  ForceAxes axes;
  std::vector<std::size_t> runs = {};  ///< Indices of the runs in the batch.
};

/// Adds runs of the bundled task `two_arms`. The plant must be MuJoCo.
std::vector<PlateCase> add_plate(const ExperimentSpec& spec, std::vector<BatchRun>& runs);

/// Returns a table of errors by rotation amplitude and axes, and adds a finding to the report.
ResultTable plate_table(const std::vector<PlateCase>& cases, const std::vector<RunFigures>& figures,
                        ExperimentReport& report);

}  // namespace burnish::polishing
