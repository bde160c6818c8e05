// burnish eval: evaluation of contact dynamics, with request and answer in JSON.
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <set>

#include "answer.hpp"
#include "base/text_file.hpp"
#include "command.hpp"
#include "record/json_text.hpp"
#include "robot_arguments.hpp"

namespace burnish::app {
namespace {

struct EvalArguments {
  std::string file;
  bool compact = false, strict = false;
};

/// Prints the first warning about a state, with the number of other states that have warnings. The
/// answer contains all warnings.
void print_odd_states(const EvalRequest& request, bool strict) {
  std::size_t odd = 0;
  std::string first;
  for (std::size_t i = 0; i < request.states.size(); ++i) {
    const std::vector<std::string>& warnings = request.states[i].warnings;
    if (warnings.empty()) continue;
    if (odd++ == 0) first = fmt::format("states[{}]: {}", i, warnings.front());
  }
  if (odd == 0) return;
  if (strict) throw Error(first);
  fmt::print(stderr, "burnish: warning: {}{}\n", first,
             odd > 1 ? fmt::format("; {} more {}", odd - 1,
                                   odd == 2 ? "state has a warning" : "states have warnings")
                     : "");
}

int eval(const EvalArguments& arguments) {
  const std::string source = arguments.file == "-" ? "standard input" : arguments.file;
  const std::filesystem::path folder =
      arguments.file == "-" ? "" : std::filesystem::path(arguments.file).parent_path();
  const std::string text = arguments.file == "-" ? read_text(std::cin, source)
                                                 : read_text(arguments.file, "request in JSON");
  const EvalRequests asked = read_requests(text, source, folder);
  nlohmann::ordered_json answers = nlohmann::ordered_json::array();
  std::set<std::string> robots;
  for (const EvalRequest& request : asked.requests)
    if (robots.insert(request.robot_name).second) print_warnings(request.robot, arguments.strict);
  for (const EvalRequest& request : asked.requests) print_odd_states(request, arguments.strict);
  bool good = true;
  for (const EvalRequest& request : asked.requests) {
    Answer answer = evaluate(request);
    good = good && answer.good;
    answers.push_back(std::move(answer.json));
  }
  const nlohmann::ordered_json& result = asked.is_list ? answers : answers.front();
  fmt::print("{}\n", arguments.compact ? result.dump() : json_text(result));
  return good ? exit_ok : exit_failed;
}

}  // namespace

void add_eval(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("eval", "Evaluate contact dynamics: request and answer in JSON");
  const auto arguments = std::make_shared<EvalArguments>();
  command
      ->add_option("FILE", arguments->file,
                   "File with a request or a list of requests; - reads the standard input")
      ->type_name("")
      ->required();
  command->add_flag("--compact", arguments->compact, "Print one line instead of indented text");
  add_strict(*command, arguments->strict);
  command->footer(
      "Examples:\n"
      "  burnish eval examples/eval/polishing.json\n"
      "  echo '{\"robot\": \"arm7\", \"contacts\": [{\"tool\": \"tool\", \"directions\": \"z\"}],\n"
      "         \"compute\": [\"forward\", \"forces\"]}' | burnish eval -\n"
      "\n"
      "docs/eval.md describes requests and answers.\n"
      "Exit codes: 0 every status is ok; 1 the status of a state is not ok; 2 invalid input.");
  command->callback([arguments, &exit_code] { exit_code = eval(*arguments); });
}

}  // namespace burnish::app
