// Record of a polishing run: what its files and its page contain.
#pragma once

#include <string>

#include "burnish/tasks/polishing/run.hpp"
#include "pressing/recorded_run.hpp"

namespace burnish::polishing {

/// Planned or completed run. Its name is that of the run's folder, such as "table_mpc".
struct PolishJob : pressing::NamedRun<RunSpec> {
  std::string place = {};  ///< Name of the task's surface, such as "table".
};

pressing::RecordedRun recorded(const PolishJob& job, const RunResult& result);

}  // namespace burnish::polishing
