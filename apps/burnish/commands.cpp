// Commands of the full program.
#include "command.hpp"

namespace burnish::app {

void add_self_description(CLI::App& app);
// Each function is defined in the file named after its command.
void add_show(CLI::App& app, int& exit_code);
void add_check(CLI::App& app, int& exit_code);
void add_eval(CLI::App& app, int& exit_code);
void add_solve(CLI::App& app, int& exit_code);
void add_polish(CLI::App& app, int& exit_code);
void add_run(CLI::App& app, int& exit_code);
void add_experiment(CLI::App& app, int& exit_code);
void add_merge(CLI::App& app, int& exit_code);
/// The commands `sweep` and `tune` replace this process by a Python process and set no exit code.
void add_sweep(CLI::App& app);
void add_tune(CLI::App& app);
void add_report(CLI::App& app, int& exit_code);
void add_bench(CLI::App& app, int& exit_code);
void add_identify(CLI::App& app, int& exit_code);

const char* const other_commands = "";

void add_commands(CLI::App& app, int& exit_code) {
  add_self_description(app);
  add_show(app, exit_code);
  add_check(app, exit_code);
  add_eval(app, exit_code);
  add_solve(app, exit_code);
  add_polish(app, exit_code);
  add_run(app, exit_code);
  add_experiment(app, exit_code);
  add_merge(app, exit_code);
  add_sweep(app);
  add_tune(app);
  add_report(app, exit_code);
  add_bench(app, exit_code);
  add_identify(app, exit_code);
}

}  // namespace burnish::app
