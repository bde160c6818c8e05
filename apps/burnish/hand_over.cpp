#include "hand_over.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>

#include "burnish/base/error.hpp"

namespace burnish::app {
namespace {

namespace fs = std::filesystem;

/// Returns pointers to the words, followed by a null pointer.
std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> list;
  for (std::string& word : words) list.push_back(word.data());
  list.push_back(nullptr);
  return list;
}

/// Returns only the absolute entries of a search path. Other entries, such as `.` or an empty one,
/// would refer to the working folder, whose contents are not trusted.
std::string absolute_entries(const std::string& path) {
  std::string kept;
  std::istringstream stream(path);
  for (std::string entry; std::getline(stream, entry, ':');)
    if (entry.starts_with('/')) kept += (kept.empty() ? "" : ":") + entry;
  return kept;
}

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

/// Returns the folder build/python if this program is build/apps/burnish of a build tree; empty for
/// an installed program.
std::string package_of_the_build(const fs::path& self) {
  const fs::path folder = self.parent_path(), apps = folder.parent_path();
  const fs::path built = apps.parent_path() / "python";
  std::error_code unknown;
  const bool is_build = folder.filename() == "burnish" && apps.filename() == "apps" &&
                        fs::exists(built / "burnish" / "campaign", unknown);
  return is_build ? built.string() : std::string();
}

/// Sets the environment variables in which Python and its child processes search for programs and
/// modules. The working folder is excluded.
void set_search_paths() {
  std::string modules = absolute_entries(variable("PYTHONPATH"));
  std::error_code unknown;
  if (const fs::path self = fs::read_symlink("/proc/self/exe", unknown); !unknown) {
    setenv("BURNISH_PROGRAM", self.c_str(), 1);
    if (const std::string built = package_of_the_build(self); !built.empty())
      modules = modules.empty() ? built : built + ":" + modules;
  }
  // Removes an empty PYTHONPATH, because Python would search in the working folder.
  modules.empty() ? unsetenv("PYTHONPATH") : setenv("PYTHONPATH", modules.c_str(), 1);
  setenv("PYTHONSAFEPATH", "1", 1);  // effective from Python 3.11 on
  const std::string programs = absolute_entries(variable("PATH"));
  setenv("PATH", programs.empty() ? "/usr/local/bin:/usr/bin:/bin" : programs.c_str(), 1);
}

/// Returns the Python interpreters to try: the first python3 in PATH, then /usr/bin/python3, which
/// has the modules of Debian's packages.
std::vector<std::string> pythons() {
  std::vector<std::string> found;
  std::istringstream stream(variable("PATH"));
  for (std::string folder; std::getline(stream, folder, ':');)
    if (const std::string file = folder + "/python3"; access(file.c_str(), X_OK) == 0) {
      found.push_back(file);
      break;
    }
  found.emplace_back("/usr/bin/python3");
  return found;
}

/// Returns `code` for `python3 -c`, preceded by code that removes the working folder from sys.path.
/// Python before 3.11 adds the working folder.
std::string safely(const std::string& code) {
  return "import sys; sys.path[:] = [p for p in sys.path if p]; " + code;
}

/// Returns whether a Python interpreter can import a module. Discards the interpreter's output.
bool has(const std::string& python, const std::string& module) {
  std::vector<std::string> words{python, "-c", safely("import " + module)};
  posix_spawn_file_actions_t silence;
  posix_spawn_file_actions_init(&silence);
  for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&silence, descriptor, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  int status = 0;
  const int failed =
      posix_spawn(&child, python.c_str(), &silence, nullptr, pointers(words).data(), environ);
  posix_spawn_file_actions_destroy(&silence);
  return failed == 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) &&
         WEXITSTATUS(status) == 0;
}

}  // namespace

void hand_over_to_python(const std::vector<std::string>& words, const std::string& module) {
  set_search_paths();
  std::string python;
  bool has_package = false;
  for (const std::string& candidate : pythons()) {
    if (!has(candidate, "burnish.campaign")) continue;
    has_package = true;
    if (!has(candidate, module)) continue;
    python = candidate;
    break;
  }
  if (python.empty())
    throw Error(has_package
                    ? "this command needs the Python module " + module +
                          ", which python3 does not find; wanted: apt install python3-" + module
                    : "this command needs the Python package burnish, which python3 does not find; "
                      "wanted: apt install python3-burnish, or pip install . in the sources");
  std::vector<std::string> all{
      python, "-c", safely("from burnish.campaign.__main__ import main; sys.exit(main())")};
  all.insert(all.end(), words.begin(), words.end());
  execv(python.c_str(), pointers(all).data());
  throw Error("cannot start '" + python + "': " + std::strerror(errno));
}

}  // namespace burnish::app
