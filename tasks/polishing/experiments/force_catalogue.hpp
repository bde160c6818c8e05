// The tests of force control: what each asks of the task and the plant, and what is measured.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "burnish/tasks/polishing/run.hpp"
#include "polishing/experiments/run_figures.hpp"

namespace burnish::polishing {

/// What a figure of force control is.
struct ForceFigure {
  std::string name, unit, meaning;
  bool larger_is_better = false;
};
/// Of all tests, in the order in which they are shown.
const std::vector<ForceFigure>& force_figures();

/// A run of the catalogue.
struct ForceTest {
  std::string name;     ///< of the run
  std::string meaning;  ///< what is done, with its numbers; empty: told before
  Task task;
  std::function<std::vector<MeasuredFigure>(const RunResult& result)> measure;
  bool has_curve = false;  ///< shown in the figure of responses
  double frequency = 0.0;  ///< Hz, of the sweep; 0: none of it
};

/// All tests of a task, by what is pressed with: its force, and its surface's normal and place.
std::vector<ForceTest> force_catalogue(const Task& task, const Setting& setting, bool quick);

}  // namespace burnish::polishing
