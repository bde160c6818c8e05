// What a run of press_hold leaves: tables, figures, its page and recording.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "burnish/tasks/press_hold/press_hold.hpp"
#include "record/page_files.hpp"

namespace burnish::press_hold {

struct RunName {
  std::string name;
  PlantKind plant;
  int record_every = 10;  ///< plant steps from row to row
};

/// All that write_run() may write.
std::vector<std::string> record_names();
/// trace.csv, metrics.json, task.yaml, after a fault last_second.csv, and what `pages` writes;
/// their names. Throws Error if a file cannot be written.
std::vector<std::string> write_run(const RunName& run, const Task& task, const RunResult& result,
                                   const std::filesystem::path& folder, PageWriter& pages);
nlohmann::ordered_json run_json(const RunName& run, const Task& task, const RunResult& result);
RunPage make_run_page(const RunName& run, const Task& task, const RunResult& result);

}  // namespace burnish::press_hold
