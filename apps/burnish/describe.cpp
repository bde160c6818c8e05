#include "describe.hpp"

#include <algorithm>
#include <map>

#include "burnish/base/error.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "help_formatter.hpp"
#include "named_tasks.hpp"
#include "polishing/descriptions.hpp"
#include "polishing/experiments/experiment.hpp"

namespace burnish::app {
namespace {

using Words = std::vector<std::string>;

Words surface_names() {
  Words words;
  for (const polishing::NamedSurface& surface : polishing::named_surfaces())
    words.push_back(surface.name);
  return words;
}

Words experiment_names() {
  Words words;
  for (const polishing::Experiment& experiment : polishing::experiments())
    words.push_back(experiment.name);
  return words;
}

/// Returns the keys of a task's file with an equals sign: "force=", "path.kind=", ...
template <class Task>
Words task_key_words() {
  Words words;
  for (const std::string& key : file_of(static_cast<const Task*>(nullptr)).keys())
    words.push_back(key + "=");
  return words;
}

/// Returns the keys of all tasks of `burnish run`, each once.
Words named_task_key_words() {
  Words words;
  each_named_task([&](const auto& named) {
    for (std::string& word : task_key_words<typename std::decay_t<decltype(named)>::Task>())
      if (std::find(words.begin(), words.end(), word) == words.end())
        words.push_back(std::move(word));
  });
  return words;
}

/// Returns the choices in a text such as "NAME:{mpc,baseline,both}".
Words choices_in(const std::string& type) {
  const std::size_t open = type.find('{'), close = type.find('}');
  if (open == std::string::npos || close == std::string::npos) return {};
  return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

/// Sets the completion of an option's value from the choices in `type`, such as "{mpc,baseline}".
/// Without choices, the name of the value, such as FILE, decides.
void find_offer(const std::string& type, OptionText& text) {
  static const std::map<std::string, Words (*)()> words{
      {"SURFACE", surface_names},
      {"PRESET", [] { return polishing::disturbance_presets(); }},
      {"EXPERIMENT", experiment_names},
      {"KEY=VALUE", task_key_words<polishing::Task>},
      {"PATH=VALUE", named_task_key_words},
      {"SHELL", [] { return completion_shells(); }}};
  static const std::map<std::string, Offer> others{
      {"ROBOT", Offer::Robots}, {"DIR", Offer::Folders},   {"FILE", Offer::Files},
      {"TASK", Offer::Files},   {"PROBLEM", Offer::Files}, {"RUN", Offer::Files}};
  text.words = choices_in(type);
  if (const auto found = words.find(text.value); found != words.end() && text.words.empty())
    text.words = found->second();
  if (const auto other = others.find(text.value); other != others.end()) text.offer = other->second;
  if (!text.words.empty()) text.offer = Offer::Words;
}

OptionText describe(const CLI::Option& option) {
  OptionText text;
  for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  const bool takes_value = option.get_type_size_max() > 0;
  if (takes_value) text.value = text.names.empty() ? option.get_name(true) : value_name(option);
  text.meaning = option.get_description();
  if (!option.get_default_str().empty()) text.meaning += " [" + option.get_default_str() + "]";
  text.required = option.get_required();
  text.several =
      takes_value && (option.get_expected_max() >= CLI::detail::expected_max_vector_size ||
                      option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll);
  if (takes_value) find_offer(option.get_type_name(), text);
  return text;
}

CommandText describe_command(const CLI::App& app) {
  CommandText text{.name = app.get_name(), .meaning = app.get_description()};
  text.footer = app.get_footer();
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;  // hidden option
    (option->nonpositional() ? text.options : text.places).push_back(describe(*option));
  }
  return text;
}

}  // namespace

ProgramText describe(const CLI::App& app) {
  ProgramText text{.itself = describe_command(app), .commands = {}};
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    text.commands.push_back(describe_command(*command));
  return text;
}

const std::vector<std::string>& completion_shells() {
  static const std::vector<std::string> shells{"bash", "zsh", "fish"};
  return shells;
}

std::string completion(const ProgramText& program, const std::string& shell) {
  if (shell == "bash") return bash_completion(program);
  if (shell == "zsh") return zsh_completion(program);
  if (shell == "fish") return fish_completion(program);
  throw Error("no completion for '" + shell + "'; wanted bash, zsh or fish" +
              did_you_mean(shell, completion_shells()));
}

}  // namespace burnish::app
