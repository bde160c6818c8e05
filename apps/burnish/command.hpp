// Registration of the program's commands, and its exit codes.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "base/entry_error.hpp"
#include "burnish/base/error.hpp"

namespace burnish::app {

/// Exit codes of the program.
inline constexpr int exit_ok = 0;
inline constexpr int exit_failed = 1;  ///< A check failed, or an evaluation had a bad status.
inline constexpr int exit_usage = 2;   ///< Invalid usage or input.

/// Returns the result of work(). If work() throws an Error of one sentence that does not contain
/// `file`, adds `file` in front of the message.
template <class Work>
auto named_by(const std::string& file, const Work& work) {
  try {
    return work();
  } catch (const EntryError&) {
    throw;  // files::placed() already names the file
  } catch (const Error& error) {
    const std::string sentence = error.what();
    const bool named = sentence.find(file) != std::string::npos || error.sentences().size() > 1;
    if (file.empty() || named) throw;
    throw Error(file + ": " + sentence);
  }
}

/// Adds all commands of this program to the command line. When a command ends, it sets `exit_code`.
void add_commands(CLI::App& app, int& exit_code);
/// End of error messages that says where other commands are available; empty in the full program.
extern const char* const other_commands;

/// Returns the version of burnish, such as "0.3.0".
const char* program_version();

}  // namespace burnish::app
