// Generation of the manual page.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "describe.hpp"

namespace burnish::app {
namespace {

/// Escapes text so that roff prints it unchanged. Special characters are written by their roff
/// names, as are characters that roff would replace by typographic ones.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '\\':
        result += "\\e";
        break;
      case '-':
        result += "\\-";
        break;
      case '\'':
        result += "\\(aq";
        break;
      case '`':
        result += "\\(ga";
        break;
      case '^':
        result += "\\(ha";
        break;
      case '~':
        result += "\\(ti";
        break;
      case '"':
        result += "\\(dq";
        break;
      default:
        result += c;
    }
  }
  return result;
}

/// Returns a line of text; a leading dot, which roff would read as a macro, is escaped.
std::string roff_line(const std::string& text) {
  return (text.starts_with('.') ? "\\&" : "") + roff(text) + "\n";
}

std::string bold(const std::string& text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + roff(text) + "\\fR"; }
std::string upper_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

/// Converts the text of --help. Indented lines stay separate lines, other lines are joined to
/// paragraphs, and each exit code begins a paragraph.
std::string roff_prose(const std::string& text) {
  std::istringstream lines(text);
  std::string result;
  bool example = false, fresh = true;
  for (std::string row; std::getline(lines, row);) {
    const bool indented = row.starts_with("  ");
    if (indented && !example) result += ".RS 4\n.EX\n";
    if (!indented && example) result += ".EE\n.RE\n";
    if (!indented && example) fresh = true;
    example = indented;
    if (row.empty()) {
      fresh = true;
      continue;
    }
    if ((fresh && !indented) || row.starts_with("Exit code")) result += ".PP\n";
    fresh = false;
    result += roff_line(indented ? row.substr(2) : row);
  }
  if (example) result += ".EE\n.RE\n";
  return result;
}

std::string roff_entry(const OptionText& option) {
  std::string head;
  for (const std::string& name : option.names) head += (head.empty() ? "" : ", ") + bold(name);
  if (!option.value.empty()) head += (head.empty() ? "" : " ") + italic(option.value);
  if (option.several) head += " ...";
  std::string text = ".TP\n" + head + "\n" + roff_line(option.meaning);
  // Lists the choices only if the description does not list them already.
  const bool named = std::all_of(
      option.words.begin(), option.words.end(),
      [&](const std::string& word) { return option.meaning.find(word) != std::string::npos; });
  if (named || option.words.size() > 12) return text;
  text += roff_line(fmt::format("One of: {}.", fmt::join(option.words, ", ")));
  return text;
}

std::string roff_entries(const CommandText& command, bool with_help) {
  std::string text;
  for (const OptionText& place : command.places) text += roff_entry(place);
  for (const OptionText& option : command.options)
    if (with_help || option.names.back() != "--help") text += roff_entry(option);
  return text;
}

std::string synopsis(const CommandText& command) {
  std::string text = bold("burnish " + command.name);
  if (!command.options.empty()) text += " [" + italic("options") + "]";
  for (const OptionText& place : command.places) {
    const std::string name = italic(place.value) + (place.several ? " ..." : "");
    text += place.required ? " " + name : " [" + name + "]";
  }
  return text + "\n";
}

}  // namespace

std::string man_page(const ProgramText& program, const std::string& version) {
  std::string what = program.itself.meaning;
  what[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(what[0])));
  if (what.ends_with('.')) what.pop_back();
  std::string text = fmt::format(
      ".\\\" Written by \"burnish --man\".\n.TH BURNISH 1 \"\" \"burnish {}\" \"\"\n.nr HY 0\n.ad "
      "l\n",
      roff(version));
  text += ".SH NAME\nburnish \\- " + roff_line(what);
  text += ".SH SYNOPSIS\n" + bold("burnish") + " " + italic("command") + " [" + italic("options") +
          "] [" + italic("arguments") + "]\n";
  for (const OptionText& option : program.itself.options)
    text += ".br\n" + bold("burnish " + option.names.back()) +
            (option.value.empty() ? "" : " " + italic(option.value)) + "\n";
  text += ".SH DESCRIPTION\n" + roff_prose(program.itself.footer);
  text += ".SH OPTIONS\n" + roff_entries(program.itself, true);
  text += ".SH COMMANDS\n";
  for (const CommandText& command : program.commands)
    text += ".TP\n" + bold(command.name) + "\n" + roff_line(command.meaning + ".");
  for (const CommandText& command : program.commands) {
    text += ".SH " + upper_case(command.name) + "\n" + synopsis(command) + ".PP\n" +
            roff_line(command.meaning + ".") + roff_entries(command, false) +
            roff_prose(command.footer);
  }
  text +=
      ".SH ENVIRONMENT\n.TP\n" + bold("BURNISH_ROBOTS") + "\n" +
      roff_line(
          "Folders with robots to find by name, separated by colons; searched before the bundled "
          "robots.");
  return text;
}

}  // namespace burnish::app
