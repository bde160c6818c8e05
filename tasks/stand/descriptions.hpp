// Registration of the task for programs and Python: its file, its records, and their texts.
#pragma once

#include "pressing/registration.hpp"
#include "stand/descriptions.gen.hpp"
#include "stand/figures.hpp"

namespace burnish::stand {

const files::DescribedFile& file_of(const Task*);
pressing::RecordedRun recorded(const pressing::NamedRun<RunSpec>& run, const RunResult& result);

struct Registration : pressing::TaskTypes<Task, Setting, RunSpec, RunResult> {
  static constexpr const char* name = "stand";
  static constexpr const char* does =
      "stands on its feet, sways with the trunk and comes back to rest";
  static constexpr const char* file = "tasks/stand/quadruped.yaml";
  static const std::vector<std::string>& phases() { return phase_names(); }
  template <class See>
  static void each_result(const See& see) {
    see("sway", &RunResult::sway, "SwayFigures; None if the sway did not begin.");
    see("fell", &RunResult::fell,
        "True if the robot had fallen when the run ended: its true centre of mass lost more than "
        "half of its height above the feet, or its base turned by more than 1 rad.");
  }
};

}  // namespace burnish::stand
