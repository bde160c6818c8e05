// Description of the program's command line as plain data, from which manual page and shell
// completions are generated.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace burnish::app {

/// Kinds of completions that a shell offers for the value of an option.
enum class Offer {
  Nothing,  ///< No completion, for numbers and for names that a file defines.
  Words,
  Robots,  ///< Robots listed by `burnish --robots` at the time of completion, and files.
  Files,
  Folders,
};

struct OptionText {
  /// Names such as "-h", "--help"; empty for a positional argument.
  std::vector<std::string> names = {};
  std::string value = {};  ///< Name of the value in help texts; empty: the option takes no value.
  std::string meaning = {};
  bool required = false;
  bool several = false;  ///< True if the option may be repeated or takes several values.
  Offer offer = Offer::Nothing;
  std::vector<std::string> words = {};  ///< Words to offer for Offer::Words.
};

struct CommandText {
  std::string name = {};
  std::string meaning = {};
  std::string footer = {};  ///< Lines with examples and remarks, printed after the options.
  std::vector<OptionText> places = {}, options = {};
};

struct ProgramText {
  CommandText itself;
  std::vector<CommandText> commands;
};

ProgramText describe(const CLI::App& app);

/// Returns a manual page of section 1 in roff, with man macros.
std::string man_page(const ProgramText& program, const std::string& version);

/// Returns a script with completions of the program's command lines, for the shell `shell`. Throws
/// Error unless `shell` is one of completion_shells().
std::string completion(const ProgramText& program, const std::string& shell);
std::string bash_completion(const ProgramText& program);
std::string zsh_completion(const ProgramText& program);
std::string fish_completion(const ProgramText& program);
const std::vector<std::string>& completion_shells();

}  // namespace burnish::app
