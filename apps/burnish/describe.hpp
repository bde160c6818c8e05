// The program's description of its own command line, as plain values: what the manual page and the
// completion of shells are written from.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace burnish::app {

/// What a shell can offer for a value.
enum class Offer {
  Nothing,  ///< a number, a name of something in a file
  Words,
  Robots,  ///< those known by name when the shell asks, and files
  Files,
  Folders,
};

struct OptionText {
  std::vector<std::string> names = {};  ///< "-h", "--help"; none: it is known by its place
  std::string value = {};               ///< what its value is called; empty: it has none
  std::string meaning = {};
  bool required = false;
  bool several = false;  ///< may be given again, or with several values
  Offer offer = Offer::Nothing;
  std::vector<std::string> words = {};  ///< for Offer::Words
};

struct CommandText {
  std::string name = {};
  std::string meaning = {};
  std::string footer = {};  ///< examples and more, in lines
  std::vector<OptionText> places = {}, options = {};
};

struct ProgramText {
  CommandText itself;
  std::vector<CommandText> commands;
};

ProgramText describe(const CLI::App& app);

/// A manual page for section 1, in the man macros of roff.
std::string man_page(const ProgramText& program, const std::string& version);

/// A script that teaches a shell to complete the program's command lines. Throws Error where the
/// shell is none of completion_shells().
std::string completion(const ProgramText& program, const std::string& shell);
std::string bash_completion(const ProgramText& program);
std::string zsh_completion(const ProgramText& program);
std::string fish_completion(const ProgramText& program);
const std::vector<std::string>& completion_shells();

}  // namespace burnish::app
