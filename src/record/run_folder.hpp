// Where a command leaves what it makes: one folder for one run of the program.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace burnish {

/// Creates the folder. Throws Error if that cannot be done.
void make_folder(const std::filesystem::path& folder);
/// Writes a file as a whole or not at all, with a line's end behind the text. Throws Error if that
/// cannot be done.
void write_text(const std::filesystem::path& file, const std::string& text);

/// What a command line says of its folder.
struct FolderChoice {
  std::filesystem::path out = {};  ///< as --out names it; empty: a new one, called `name`
  std::string name;                ///< of new folders: NAME, NAME_2, NAME_3, ...
  bool force = false;              ///< replaces the run that `out` holds
  bool resume = false;             ///< goes on with the run that `out` holds
};

/// Writes "stopped" over "running" in the mark of the folder that this process writes into; nothing
/// where there is none. A signal's handler may call it.
void mark_running_as_stopped() noexcept;

/// A folder that is made, marked as running, held against all others, and finished. Its mark, the
/// file `.burnish`, says what became of the run (running, finished, failed, or stopped by a signal)
/// and what in the folder is of it. It
/// is held by a lock that ends with the process. Where nothing was written the folder goes again; a
/// run that was broken off stays marked as not finished.
class RunFolder {
 public:
  /// Throws Error where the folder cannot be made, holds a run (unless `force` or `resume`), holds
  /// what no run left (with `force`), or is another run's that is not over yet. With `force` the
  /// old run goes out of the way in one step, before anything is written.
  explicit RunFolder(const FolderChoice& choice);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Files, and folders with '/' behind, that are going to be written into it. Throws Error for a
  /// folder that others have filled.
  void claim(const std::vector<std::string>& names);
  /// The run is over and all of it written: marks the folder as finished, and where its name was
  /// not chosen leads the link `latest` beside it there.
  void finish();

 private:
  void mark_as_failed() noexcept;
  void make_new(const std::string& name);
  void take(const FolderChoice& choice);
  void replace();
  void lock();

  std::filesystem::path path_;
  std::set<std::string> claimed_;
  int lock_ = -1;          ///< file descriptor
  bool numbered_ = false;  ///< the name was not chosen
  bool made_ = false;      ///< it was not there before
  bool resumed_ = false;   ///< what it holds is the run's own
  bool finished_ = false;
};

}  // namespace burnish
