// What a run of push_wall leaves: tables, figures, its page and recording.
#pragma once

#include "burnish/tasks/push_wall/push_wall.hpp"
#include "record/run_files.hpp"

namespace burnish::push_wall {

/// A run that was made.
struct RunName {
  std::string name;          ///< on its page
  std::string command = {};  ///< that makes it again; empty: of its task.yaml
  RunSpec spec;
};

/// See write_run_files().
std::vector<std::string> write_run(const RunName& run, const RunResult& result,
                                   const RunFilesOptions& options,
                                   const std::filesystem::path& folder, PageWriter& pages);
/// Everything in numbers.
nlohmann::ordered_json run_json(const RunName& run, const RunResult& result);
RunPage make_run_page(const RunName& run, const RunResult& result, int record_every);

}  // namespace burnish::push_wall
