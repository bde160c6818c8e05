// Commands of the smaller program that ./demo builds. It compiles in half the time of the full
// program.
#include "command.hpp"

namespace burnish::app {

void add_polish(CLI::App& app, int& exit_code);
void add_report(CLI::App& app, int& exit_code);

const char* const other_commands =
    "; the full program has the other commands: cmake --build build --target burnish_app";

void add_commands(CLI::App& app, int& exit_code) {
  add_polish(app, exit_code);
  add_report(app, exit_code);
}

}  // namespace burnish::app
