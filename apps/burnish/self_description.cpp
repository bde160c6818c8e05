// Options by which the program describes itself: list of robots, manual page, completion scripts of
// shells.
#include <fmt/format.h>

#include <memory>

#include "command.hpp"
#include "describe.hpp"
#include "robot_list.hpp"

namespace burnish::app {
namespace {

struct SelfDescription {
  bool robots = false, manual = false;
  std::string shell;

  void print(const CLI::App& app) const {
    if (robots) fmt::print("{}", robot_list());
    if (manual) fmt::print("{}", man_page(describe(app), program_version()));
    if (!shell.empty()) fmt::print("{}", completion(describe(app), shell));
  }
};

}  // namespace

void add_self_description(CLI::App& app) {
  const auto wanted = std::make_shared<SelfDescription>();
  app.add_flag("--robots", wanted->robots, "Print the robots that can be loaded by name");
  app.add_flag("--man", wanted->manual, "Print the manual page: burnish --man | man -l -");
  app.add_option("--completion", wanted->shell,
                 "Print the completion script of a shell: bash, zsh or fish")
      ->type_name("SHELL");
  app.callback([&app, wanted] { wanted->print(app); });
}

}  // namespace burnish::app
