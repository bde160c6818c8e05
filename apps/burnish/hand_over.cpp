#include "hand_over.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "burnish/base/error.hpp"

namespace burnish::app {
namespace {

namespace fs = std::filesystem;

/// Of a list that ends with a null.
std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> list;
  for (std::string& word : words) list.push_back(word.data());
  list.push_back(nullptr);
  return list;
}

/// Whether a Python can import a module. It says nothing.
bool has(const std::string& python, const std::string& module) {
  std::vector<std::string> words{python, "-c", "import " + module};
  posix_spawn_file_actions_t silence;
  posix_spawn_file_actions_init(&silence);
  for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&silence, descriptor, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  int status = 0;
  const int failed =
      posix_spawnp(&child, python.c_str(), &silence, nullptr, pointers(words).data(), environ);
  posix_spawn_file_actions_destroy(&silence);
  return failed == 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) &&
         WEXITSTATUS(status) == 0;
}

/// The program itself, and the package of the build that it stands in.
void tell_python() {
  std::error_code unknown;
  const fs::path self = fs::read_symlink("/proc/self/exe", unknown);
  if (unknown) return;
  setenv("BURNISH_PROGRAM", self.c_str(), 1);
  const fs::path built = self.parent_path().parent_path().parent_path() / "python";
  if (!fs::exists(built / "burnish" / "campaign", unknown)) return;
  const char* const path = std::getenv("PYTHONPATH");
  const std::string longer =
      built.string() + (path != nullptr ? std::string(":") + path : std::string());
  setenv("PYTHONPATH", longer.c_str(), 1);
}

}  // namespace

void hand_over_to_python(const std::vector<std::string>& words, const std::string& module) {
  tell_python();
  // Debian's packages are for Debian's Python, which need not be the first one.
  std::string python;
  bool has_package = false;
  for (const char* candidate : {"python3", "/usr/bin/python3"}) {
    if (!has(candidate, "burnish.campaign")) continue;
    has_package = true;
    if (!has(candidate, module)) continue;
    python = candidate;
    break;
  }
  if (python.empty())
    throw Error(has_package
                    ? "Python does not find the module " + module +
                          ", which this needs; wanted: apt install python3-" + module
                    : "this is handed over to the Python package burnish, which python3 does not "
                      "find; wanted: apt install python3-burnish, or pip install . in the sources");
  std::vector<std::string> all{python, "-m", "burnish.campaign"};
  all.insert(all.end(), words.begin(), words.end());
  execvp(python.c_str(), pointers(all).data());
  throw Error("cannot start '" + python + "': " + std::strerror(errno));
}

}  // namespace burnish::app
