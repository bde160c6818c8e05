// Generation of the completion script for zsh.
#include <fmt/format.h>

#include "describe.hpp"
#include "shell_word.hpp"

namespace burnish::app {
namespace {

constexpr const char* zsh_head = R"zsh(#compdef burnish
# Completion of burnish for zsh; written by "burnish --completion zsh".

_burnish_robots() {
  local -a robots
  robots=(${(f)"$($program --robots 2>/dev/null)"})
  robots=(${robots%% *})
  _alternative 'robots:robot:compadd -a robots' 'files:file:_files'
}

_burnish() {
  local program=${words[1]/#\~/$HOME} curcontext=$curcontext state line
  typeset -A opt_args
)zsh";

/// Escapes text for zsh's _arguments, where the characters [ ] and : have a special meaning.
std::string zsh_escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string zsh_action(const OptionText& option) {
  switch (option.offer) {
    case Offer::Words:
      return option.value.ends_with("=VALUE")  // the value is typed after the equals sign
                 ? fmt::format("{{compadd -S '' -- {}}}", fmt::join(option.words, " "))
                 : fmt::format("({})", fmt::join(option.words, " "));
    case Offer::Robots:
      return "_burnish_robots";
    case Offer::Files:
      return "_files";
    case Offer::Folders:
      return "_files -/";
    case Offer::Nothing:
      break;
  }
  return " ";
}

std::string zsh_specification(const OptionText& option, const std::string& name) {
  std::string text = option.several ? "*" : "";
  if (!option.several && option.names.size() > 1)
    text += fmt::format("({})", fmt::join(option.names, " "));
  text += name;
  // In zsh, the trailing equals sign makes `--seed 1` and `--seed=1` valid.
  if (!option.value.empty() && name.starts_with("--")) text += "=";
  text += "[" + zsh_escaped(option.meaning) + "]";
  if (!option.value.empty()) text += ":" + zsh_escaped(option.value) + ":" + zsh_action(option);
  return shell_word(text);
}

std::string zsh_arguments(const CommandText& command, const std::string& indent) {
  std::string text;
  const auto add = [&](const std::string& word) { text += " \\\n" + indent + word; };
  for (const OptionText& option : command.options)
    for (const std::string& name : option.names) add(zsh_specification(option, name));
  int place = 0;
  for (const OptionText& option : command.places) {
    const std::string where = option.several ? "*" : std::to_string(++place);
    const std::string colons = option.required || option.several ? ":" : "::";
    add(shell_word(where + colons + zsh_escaped(option.value) + ":" + zsh_action(option)));
  }
  return text;
}

}  // namespace

std::string zsh_completion(const ProgramText& program) {
  std::string text = zsh_head;
  text += "  _arguments -C" + zsh_arguments(program.itself, "    ") +
          " \\\n    '1:command:->command' \\\n    '*::argument:->argument'\n";
  text += "  case $state in\n    command)\n      local -a commands\n      commands=(\n";
  for (const CommandText& command : program.commands)
    text += "        " + shell_word(command.name + ":" + zsh_escaped(command.meaning)) + "\n";
  text += "      )\n      _describe command commands\n      ;;\n    argument)\n";
  text += "      case $words[1] in\n";
  for (const CommandText& command : program.commands)
    text += "        " + command.name + ")\n          _arguments" +
            zsh_arguments(command, "            ") + "\n          ;;\n";
  text += "      esac\n      ;;\n  esac\n}\n\n_burnish \"$@\"\n";
  return text;
}

}  // namespace burnish::app
