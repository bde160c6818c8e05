// Pages and recordings of runs as files: of each run, and of several beside each other.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "report/run_page.hpp"

namespace burnish {

/// Writes what the runs of one call leave beside their tables.
class PageWriter {
 public:
  PageWriter(bool pages, bool recordings) : pages_(pages), recordings_(recordings) {}
  /// run.json, run.html and run.mcap as far as they are wanted and can be made; their names. `make`
  /// is asked for the page, which is dated here, where one is wanted; empty: there is nothing to
  /// show.
  std::vector<std::string> write(const std::filesystem::path& folder,
                                 const std::function<RunPage()>& make);
  /// Whether runs have a page, so that nobody needs their plots as files.
  bool makes_pages() const;
  /// Behind the last run: comparison.html in the folder of all runs, if there are several.
  /// Returns what is to be told about pages, one line, or nothing.
  std::string finish(const std::filesystem::path& folder) const;
  /// One sentence about meshes that robots of these runs are drawn without; empty: all are there.
  std::string missing_meshes() const;

 private:
  bool pages_, recordings_;
  std::set<std::string> missing_meshes_;   ///< by their file names
  std::vector<std::string> names_, runs_;  ///< of each run: name, and JSON as it is in a page
  std::size_t size_ = 0;                   ///< bytes of runs_
};

/// The page of these runs (JSON of each) with a title of their names. Throws Error if the file
/// cannot be written, or if this program has no page.
void write_runs_page(const std::vector<std::string>& names, const std::vector<std::string>& runs,
                     const std::filesystem::path& file);
/// The page of a robot. Throws Error as write_runs_page() does.
void write_robot_page(const RobotDrawing& robot, const std::filesystem::path& file);

/// Such as "table_mpc, table_baseline and 3 more".
std::string joined_names(const std::vector<std::string>& names);

}  // namespace burnish
