// Registration of the task for programs and Python: its file, its records, and their texts.
#pragma once

#include "pressing/registration.hpp"
#include "push_wall/descriptions.gen.hpp"
#include "push_wall/figures.hpp"

namespace burnish::push_wall {

const files::DescribedFile& file_of(const Task*);
pressing::RecordedRun recorded(const pressing::NamedRun<RunSpec>& run, const RunResult& result);

struct Registration : pressing::TaskTypes<Task, Setting, RunSpec, RunResult> {
  static constexpr const char* name = "push_wall";
  static constexpr const char* does =
      "pushes with both hands against a wall, and searches for the largest force";
  static constexpr const char* file = "tasks/push_wall/talos.yaml";
  static const std::vector<std::string>& phases() { return phase_names(); }
  template <class See>
  static void each_result(const See& see) {
    see("push", &RunResult::push, "PushFigures; None if the hold did not end.");
    see("limit", &RunResult::limit, "Limit that ended the search for the largest force.");
    see("limited_by", &RunResult::limited_by,
        "Names of the active constraints at the end of the search, or of the hand or foot that "
        "slipped.");
  }
};

}  // namespace burnish::push_wall
