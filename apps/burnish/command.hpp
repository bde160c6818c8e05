// The commands of the program: each adds itself to the command line and leaves its exit code.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "base/entry_error.hpp"
#include "burnish/base/error.hpp"

namespace burnish::app {

/// What the program returns.
inline constexpr int exit_ok = 0;
inline constexpr int exit_failed = 1;  ///< a check failed, or an evaluation had a bad status
inline constexpr int exit_usage = 2;   ///< bad usage or input

/// What `work` gives. An Error that does not name the file that it is about does then.
template <class Work>
auto named_by(const std::string& file, const Work& work) {
  try {
    return work();
  } catch (const EntryError&) {
    throw;  // files::placed() says where
  } catch (const Error& error) {
    const std::string sentence = error.what();
    const bool named = sentence.find(file) != std::string::npos || error.sentences().size() > 1;
    if (file.empty() || named) throw;
    throw Error(file + ": " + sentence);
  }
}

/// Adds the commands of this program to the command line. `exit_code` is set when one has run.
void add_commands(CLI::App& app, int& exit_code);
/// Where other commands are, as an end of a sentence; empty in the whole program.
extern const char* const other_commands;

/// Of burnish, such as "0.3.0".
const char* program_version();

}  // namespace burnish::app
