// Files of runs: pages and recordings of single runs, and pages with several runs side by side.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "report/run_page.hpp"

namespace burnish {

/// Writer of the pages and recordings of all runs of one command.
class PageWriter {
 public:
  PageWriter(bool pages, bool recordings) : pages_(pages), recordings_(recordings) {}
  /// Writes run.json, run.html and run.mcap, as far as requested and possible. Returns the names of
  /// the written files. The function `make` returns the content of the page and is called only if a
  /// file needs the content. Without `make`, no file is written.
  std::vector<std::string> write(const std::filesystem::path& folder,
                                 const std::function<RunPage()>& make);
  /// Returns whether runs have an HTML page, which contains all plots.
  bool makes_pages() const;
  /// Must be called after the last run. Writes comparison.html to the common folder of several
  /// runs. Returns a line for the user about the pages; empty: none.
  std::string finish(const std::filesystem::path& folder) const;
  /// Returns a sentence about meshes that are missing in the pages of these runs; empty: none.
  std::string missing_meshes() const;

 private:
  bool pages_, recordings_;
  std::set<std::string> missing_meshes_;   ///< File names of missing meshes
  std::vector<std::string> names_, runs_;  ///< Name of each run, and its JSON
  std::size_t size_ = 0;                   ///< Total size of runs_ [bytes]
};

/// Writes a page with these runs (JSON of each), titled with their names. Throws Error if the file
/// cannot be written or this build does not contain the page.
void write_runs_page(const std::vector<std::string>& names, const std::vector<std::string>& runs,
                     const std::filesystem::path& file);
/// Writes the page of a robot. Throws Error as write_runs_page() does.
void write_robot_page(const RobotDrawing& robot, const std::filesystem::path& file);

/// Returns names in one phrase, such as "table_mpc, table_baseline and 3 more".
std::string joined_names(const std::vector<std::string>& names);

}  // namespace burnish
