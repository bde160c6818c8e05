// Output folder of one run of the program.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace burnish {

/// Creates the folder. Throws Error on failure.
void make_folder(const std::filesystem::path& folder);
/// Writes a file completely or not at all, and appends a newline. Throws Error on failure.
void write_text(const std::filesystem::path& file, const std::string& text);

/// Choice of the output folder on the command line.
struct FolderChoice {
  std::filesystem::path out = {};  ///< Folder given by --out; empty: a new folder called `name`
  std::string name;                ///< Name of new folders: NAME, NAME_2, NAME_3, ...
  bool force = false;              ///< Replace the run in `out`
  bool resume = false;             ///< Continue the run in `out`
};

/// Changes the state "running" to "stopped" in the marker file of the current folder, if there is
/// one. Safe in a signal handler.
void mark_running_as_stopped() noexcept;

/// Output folder that is created, marked as running, locked against other processes, and finished.
/// The marker file `.burnish` contains the state of the run (running, finished, failed or stopped)
/// and the names of its files. The lock ends with the process. The destructor removes the folder if
/// nothing was written. An interrupted run stays marked as not finished.
class RunFolder {
 public:
  /// Throws Error if the folder cannot be created, contains a run (unless `force` or `resume`),
  /// contains files that are not part of a run (with `force`), or belongs to a run in progress.
  /// With `force`, the old run is moved away in one step before anything is written.
  explicit RunFolder(const FolderChoice& choice);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Announces files to write; names of folders end with '/'. Throws Error if an announced folder
  /// already contains other files.
  void claim(const std::vector<std::string>& names);
  /// Marks the folder as finished, after all files are written. If the folder has a default name,
  /// the link `latest` beside it is updated.
  void finish();

 private:
  void mark_as_failed() noexcept;
  void make_new(const std::string& name);
  void take(const FolderChoice& choice);
  void replace();
  void lock();

  std::filesystem::path path_;
  std::set<std::string> claimed_;
  int lock_ = -1;          ///< File descriptor
  bool numbered_ = false;  ///< The folder has a default name
  bool made_ = false;      ///< The folder did not exist before
  bool resumed_ = false;   ///< The folder contains earlier files of this run
  bool finished_ = false;
};

}  // namespace burnish
