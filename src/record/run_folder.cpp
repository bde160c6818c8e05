#include "record/run_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>

#include "base/whole_file.hpp"
#include "burnish/base/error.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;

constexpr const char* mark_name = ".burnish";
constexpr const char* running = "running";
constexpr const char* stopped = "stopped";  // Must be as long as `running`, which it overwrites
constexpr const char* failed = "failed";
constexpr const char* finished = "finished";
constexpr int max_numbered_folders = 100'000;

/// Content of a folder's marker file: whether the run has finished, and the names of its files.
struct Mark {
  bool finished = false;
  std::set<std::string> names;
};

void write_mark(const fs::path& folder, const char* state, const std::set<std::string>& names) {
  std::string text = fmt::format("{}\n", state);
  for (const std::string& name : names) text += name + '\n';
  write_whole_file(folder / mark_name, text);
}

std::optional<Mark> read_mark(const fs::path& folder) {
  std::ifstream stream(folder / mark_name);
  std::string line;
  if (!std::getline(stream, line)) return std::nullopt;
  Mark mark{.finished = line == finished, .names = {}};
  while (std::getline(stream, line)) mark.names.insert(line);
  return mark;
}

/// Path of the marker file of the current run, for the signal handler.
char running_mark[4096] = "";

/// Returns whether the folder contains a run of an older version, which wrote no marker file.
bool looks_like_a_run(const fs::path& folder) {
  std::error_code ignored;
  const auto has = [&](const fs::path& where, std::initializer_list<const char*> names) {
    return std::any_of(names.begin(), names.end(),
                       [&](const char* name) { return fs::exists(where / name, ignored); });
  };
  if (has(folder, {"summary.json", "results.json", "metrics.json", "trajectory.csv"})) return true;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.is_directory(ignored) && has(entry.path(), {"metrics.json"})) return true;
  return false;
}

/// Throws Error unless everything in the folder belongs to the run of its marker file.
void check_replaceable(const fs::path& folder) {
  const std::optional<Mark> mark = read_mark(folder);
  if (!mark)
    throw Error(
        fmt::format("'{}' holds a run of an older version, without a list of its files, so --force "
                    "cannot replace the folder; remove the folder, or choose another one",
                    folder.string()));
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const bool unfinished_file = name.starts_with('.') && name.ends_with(".part");
    if (name == mark_name || unfinished_file || mark->names.contains(name) ||
        mark->names.contains(name + '/'))
      continue;
    throw Error(
        fmt::format("'{}' holds '{}', which is not part of a run, so --force cannot replace the "
                    "folder; move the file away, or choose another folder",
                    folder.string(), name));
  }
}

/// Returns whether a path still refers to the open file `descriptor`.
bool leads_to(const fs::path& path, int descriptor) {
  struct stat by_path {
  }, by_descriptor{};
  return stat(path.c_str(), &by_path) == 0 && fstat(descriptor, &by_descriptor) == 0 &&
         by_path.st_dev == by_descriptor.st_dev && by_path.st_ino == by_descriptor.st_ino;
}

void lead_latest_to(const fs::path& folder) {
  const fs::path link = folder.parent_path() / "latest";
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(link, ignored)) && !fs::is_symlink(link, ignored)) return;
  const fs::path part = folder.parent_path() / fmt::format(".latest.{}.part", getpid());
  fs::create_directory_symlink(folder.filename(), part, ignored);
  if (ignored) return;
  fs::rename(part, link, ignored);
  if (ignored) fs::remove(part, ignored);
}

}  // namespace

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder))
    throw Error(fmt::format("cannot make the folder '{}'{}", folder.string(),
                            error ? ": " + error.message() : ""));
}

void write_text(const fs::path& file, const std::string& text) {
  write_whole_file(file, text + '\n');
}

void mark_running_as_stopped() noexcept {
  if (running_mark[0] == 0) return;
  const int mark = open(running_mark, O_WRONLY | O_CLOEXEC);
  if (mark < 0) return;
  [[maybe_unused]] const auto written = pwrite(mark, stopped, std::strlen(stopped), 0);
  close(mark);
}

RunFolder::RunFolder(const FolderChoice& choice) {
  if (choice.out.empty())
    make_new(choice.name);
  else
    take(choice);
}

RunFolder::~RunFolder() {
  std::error_code ignored;
  running_mark[0] = 0;
  if (!finished_) {
    const auto written = [&](const std::string& name) { return fs::exists(path_ / name, ignored); };
    if (std::none_of(claimed_.begin(), claimed_.end(), written))
      fs::remove(path_ / mark_name, ignored);
    else
      mark_as_failed();
    if (made_) fs::remove(path_, ignored);  // Keeps a folder that is not empty
  }
  if (lock_ >= 0) close(lock_);
}

/// Marks the run as failed. If a full disk prevents a new marker file, overwrites the state in the
/// old one.
void RunFolder::mark_as_failed() noexcept {
  try {
    write_mark(path_, failed, claimed_);
  } catch (const std::exception&) {
    const std::string mark = (path_ / mark_name).string();
    if (const int file = open(mark.c_str(), O_WRONLY | O_CLOEXEC); file >= 0) {
      [[maybe_unused]] const auto written = pwrite(file, stopped, std::strlen(stopped), 0);
      close(file);
    }
  }
}

void RunFolder::claim(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    std::error_code ignored;
    if (!resumed_ && name.ends_with('/') && fs::exists(path_ / name, ignored) &&
        !fs::is_empty(path_ / name, ignored))
      throw Error(fmt::format("'{}' holds files that are not part of a run; wanted another folder",
                              (path_ / name).string()));
    claimed_.insert(name);
  }
  write_mark(path_, running, claimed_);
  const std::string mark = fs::absolute(path_ / mark_name).string();
  if (mark.size() < sizeof running_mark) std::strcpy(running_mark, mark.c_str());
}

void RunFolder::make_new(const std::string& name) {
  numbered_ = made_ = true;
  for (int number = 1; number <= max_numbered_folders; ++number) {
    path_ = number == 1 ? name : fmt::format("{}_{}", name, number);
    std::error_code error;
    if (fs::create_directory(path_, error)) return lock();
    if (error && error != std::errc::file_exists)
      throw Error(fmt::format("cannot make the folder '{}': {}", path_.string(), error.message()));
  }
  throw Error(fmt::format("{} folders '{}', '{}_2', ... exist; wanted --out with another folder",
                          max_numbered_folders, name, name));
}

void RunFolder::take(const FolderChoice& choice) {
  const fs::path& folder = choice.out;
  std::error_code ignored;
  made_ = !fs::exists(folder, ignored);
  make_folder(folder);
  path_ = folder;
  lock();
  const std::optional<Mark> mark = read_mark(folder);
  resumed_ = choice.resume && (mark || !looks_like_a_run(folder));
  if (resumed_ && mark) claimed_ = mark->names;
  if (resumed_ || (!mark && !looks_like_a_run(folder))) return;
  if (!choice.force)
    throw Error(fmt::format("'{}' holds a run{}; wanted another folder, or --force to replace it",
                            folder.string(),
                            mark && !mark->finished ? " that did not finish" : ""));
  check_replaceable(folder);
  replace();
}

/// Moves the old folder aside in one step and then deletes it.
void RunFolder::replace() {
  const fs::path whole = fs::absolute(path_).lexically_normal();
  const fs::path plain = whole.has_filename() ? whole : whole.parent_path();
  const fs::path aside =
      plain.parent_path() / fmt::format(".{}.{}.replaced", plain.filename().string(), getpid());
  std::error_code error;
  fs::rename(plain, aside, error);
  if (!error && !fs::create_directory(plain, error) && !error)
    error = std::make_error_code(std::errc::file_exists);
  if (error)
    throw Error(fmt::format("cannot replace the folder '{}': {}", path_.string(), error.message()));
  close(lock_);
  lock();
  fs::remove_all(aside, error);
  made_ = true;
}

/// Locks the folder. Throws Error if another program holds the lock, or if the path meanwhile leads
/// to another folder.
void RunFolder::lock() {
  lock_ = open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ < 0)
    throw Error(
        fmt::format("cannot open the folder '{}': {}", path_.string(), std::strerror(errno)));
  // File systems without locks, such as some network file systems, are not protected.
  const bool taken = flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  if (!taken && leads_to(path_, lock_)) return;
  close(lock_);
  lock_ = -1;
  made_ = false;
  throw Error(
      fmt::format("another run writes into '{}'; choose another folder, or wait for that run "
                  "to end",
                  path_.string()));
}

void RunFolder::finish() {
  write_mark(path_, finished, claimed_);
  running_mark[0] = 0;
  finished_ = true;
  if (numbered_) lead_latest_to(path_);
}

}  // namespace burnish
