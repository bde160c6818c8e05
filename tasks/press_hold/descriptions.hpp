// Registration of the task for programs and Python: its file, its records, and their texts.
#pragma once

#include "press_hold/descriptions.gen.hpp"
#include "press_hold/figures.hpp"
#include "pressing/registration.hpp"

namespace burnish::press_hold {

const files::DescribedFile& file_of(const Task*);
pressing::RecordedRun recorded(const pressing::NamedRun<RunSpec>& run, const RunResult& result);

struct Registration : pressing::TaskTypes<Task, Setting, RunSpec, RunResult> {
  static constexpr const char* name = "press_hold";
  static constexpr const char* does =
      "presses at a point and holds the force while the rest of the arm moves aside";
  static constexpr const char* file = "tasks/press_hold/arm7.yaml";
  static const std::vector<std::string>& phases() { return phase_names(); }
  template <class See>
  static void each_result(const See& see) {
    see("metrics", &RunResult::metrics,
        "Metrics from 0.2 s after the ramp to the end of the hold; None if the hold was not "
        "reached.");
    see("hold", &RunResult::hold,
        "HoldFigures from the end of the ramp to the end of the hold; None if the hold was not "
        "reached.");
  }
};

}  // namespace burnish::press_hold
