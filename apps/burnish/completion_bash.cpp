// Generation of the completion script for bash.
#include <fmt/format.h>

#include "describe.hpp"
#include "shell_word.hpp"

namespace burnish::app {
namespace {

constexpr const char* bash_head =
    R"bash(# Completion of burnish for bash; written by "burnish --completion bash".
_burnish() {
  # Bash splits words at colons and equals signs too: they are put together again.
  local words=() word glued=
  for word in "${COMP_WORDS[@]:0:COMP_CWORD+1}"; do
    if [[ ( $glued || $word == [:=]* ) && ${#words[@]} -gt 1 ]]; then
      words[-1]+=$word
    else
      words+=("$word")
    fi
    [[ $word == [:=] ]] && glued=yes || glued=
  done
  local current=${words[-1]} previous=${words[-2]} command=
  if [[ $current == --*=* ]]; then
    previous=${current%%=*}
    current=${current#*=}
  fi
  for word in "${words[@]:1:${#words[@]}-2}"; do
    [[ $word == -* ]] || { command=$word; break; }
  done
  local options= value= offer= list=
  case $command in
)bash";

constexpr const char* bash_tail = R"bash(  esac
  if [[ ! $value && $current == -* ]]; then
    offer=words list=$options
  fi
  case $offer in
    words) ;;
    robots) list=$("${words[0]/#\~/$HOME}" --robots 2>/dev/null | cut -d ' ' -f 1) ;;
    folders) compopt -o dirnames 2>/dev/null; return ;;
    files) return ;;
    *) compopt +o default 2>/dev/null; return ;;
  esac
  mapfile -t COMPREPLY < <(compgen -W "$list" -- "$current")
  [[ $offer == robots ]] || compopt +o default 2>/dev/null
  [[ ${COMPREPLY[0]} != *= ]] || compopt -o nospace 2>/dev/null
  # Bash replaces only what stands behind the last colon or equals sign.
  local own=${COMP_WORDS[COMP_CWORD]}
  [[ $own != [:=] ]] || own=
  local kept=${current%"$own"}
  COMPREPLY=("${COMPREPLY[@]#"$kept"}")
}
complete -o default -F _burnish burnish
)bash";

std::string bash_assignments(const OptionText& option) {
  switch (option.offer) {
    case Offer::Words:
      return "offer=words list=" + shell_word(fmt::format("{}", fmt::join(option.words, " ")));
    case Offer::Robots:
      return "offer=robots";
    case Offer::Files:
      return "offer=files";
    case Offer::Folders:
      return "offer=folders";
    case Offer::Nothing:
      break;
  }
  return "offer=";
}

/// Returns the part of the script for one command: completions of its options, of its positional
/// argument, and of the value of the option before the cursor.
std::string bash_branch(const CommandText& command, const std::string& name,
                        const OptionText& place) {
  std::string options, cases;
  for (const OptionText& option : command.options) {
    options += fmt::format("{}{}", options.empty() ? "" : " ", fmt::join(option.names, " "));
    if (option.value.empty()) continue;
    cases += fmt::format("        {}) value=yes {} ;;\n", fmt::join(option.names, " | "),
                         bash_assignments(option));
  }
  std::string text = fmt::format("    {})\n      options={}\n", name, shell_word(options));
  if (place.offer != Offer::Nothing) text += "      " + bash_assignments(place) + "\n";
  if (!cases.empty()) text += "      case $previous in\n" + cases + "      esac\n";
  return text + "      ;;\n";
}

}  // namespace

std::string bash_completion(const ProgramText& program) {
  OptionText commands{.value = "COMMAND", .offer = Offer::Words};
  for (const CommandText& command : program.commands) commands.words.push_back(command.name);
  std::string text = bash_head + bash_branch(program.itself, "''", commands);
  for (const CommandText& command : program.commands)
    text += bash_branch(command, command.name,
                        command.places.empty() ? OptionText{} : command.places.front());
  return text + bash_tail;
}

}  // namespace burnish::app
