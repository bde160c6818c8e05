// Catalogue of force control tests: task and plant of each test, and its measurements.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "burnish/tasks/polishing/run.hpp"
#include "polishing/experiments/run_figures.hpp"

namespace burnish::polishing {

/// Definition of a force-control figure (a measured quantity such as overshoot).
struct ForceFigure {
  std::string name, unit, meaning;
  bool larger_is_better = false;
};
/// Returns the figures of all tests, in the order of the tables.
const std::vector<ForceFigure>& force_figures();

/// Test of the catalogue.
struct ForceTest {
  std::string name;
  std::string meaning;  ///< Description with numbers; empty if equal to an earlier test's.
  Task task;
  std::function<std::vector<MeasuredFigure>(const RunResult& result)> measure;
  bool has_curve = false;  ///< True if the plot of responses shows this test.
  double frequency = 0.0;  ///< Frequency in the sine sweep; 0: not part of the sweep [Hz].
};

/// Returns all tests, for the target force and the surface of the task. `quick`: fewer and shorter
/// tests.
std::vector<ForceTest> force_catalogue(const Task& task, const Setting& setting, bool quick);

}  // namespace burnish::polishing
