// Generation of the completion script for fish.
#include <fmt/format.h>

#include "describe.hpp"

namespace burnish::app {
namespace {

/// Returns text in single quotes, with the escapes that fish needs.
std::string fish_quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\\' || c == '\'') result += '\\';
    result += c;
  }
  return result + "'";
}

/// Returns the flags of fish's `complete` for a value: -x to offer only the given words, -r and -F
/// to offer files.
std::string fish_offers(const OptionText& option, bool of_option) {
  const std::string files = of_option ? " -r -F" : " -F";
  switch (option.offer) {
    case Offer::Words:
      return fmt::format(" -x -a {}", fish_quoted(fmt::format("{}", fmt::join(option.words, " "))));
    case Offer::Robots:
      return files + R"( -a '(burnish --robots 2>/dev/null | string replace -r " .*" "")')";
    case Offer::Files:
      return files;
    case Offer::Folders:
      return " -x -a '(__fish_complete_directories)'";
    case Offer::Nothing:
      break;
  }
  return " -x";
}

std::string fish_lines(const CommandText& command, const std::string& condition) {
  const std::string begin = "complete -c burnish -n " + fish_quoted(condition);
  std::string text;
  for (const OptionText& option : command.options) {
    text += begin;
    for (const std::string& name : option.names)
      text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    if (!option.value.empty()) text += fish_offers(option, true);
    text += " -d " + fish_quoted(option.meaning) + "\n";
  }
  for (const OptionText& place : command.places)
    if (place.offer != Offer::Nothing) text += begin + fish_offers(place, false) + "\n";
  return text;
}

}  // namespace

std::string fish_completion(const ProgramText& program) {
  std::string text =
      "# Completion of burnish for fish; written by \"burnish --completion fish\".\n"
      "complete -c burnish -f\n";
  text += fish_lines(program.itself, "__fish_use_subcommand");
  for (const CommandText& command : program.commands)
    text += fmt::format("complete -c burnish -n __fish_use_subcommand -a {} -d {}\n", command.name,
                        fish_quoted(command.meaning));
  for (const CommandText& command : program.commands)
    text += fish_lines(command, "__fish_seen_subcommand_from " + command.name);
  return text;
}

}  // namespace burnish::app
