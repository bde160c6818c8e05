// The commands of the program that ./demo builds: it takes half the time of the whole one.
#include "command.hpp"

namespace burnish::app {

void add_polish(CLI::App& app, int& exit_code);
void add_report(CLI::App& app, int& exit_code);

const char* const other_commands =
    "; the other commands are in the whole program: cmake --build build --target burnish_app";

void add_commands(CLI::App& app, int& exit_code) {
  add_polish(app, exit_code);
  add_report(app, exit_code);
}

}  // namespace burnish::app
