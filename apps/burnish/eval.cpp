// burnish eval: contact dynamics from JSON to JSON.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "answer.hpp"
#include "command.hpp"
#include "json_text.hpp"

namespace burnish::app {
namespace {

struct EvalArguments {
  std::string file;
  bool compact = false;
};

std::string contents(const std::string& file) {
  std::ostringstream text;
  if (file == "-") {
    text << std::cin.rdbuf();
    return text.str();
  }
  if (std::filesystem::is_directory(file)) throw Error("'" + file + "' is a folder");
  std::ifstream stream(file);
  if (!stream) throw Error("cannot read '" + file + "'");
  text << stream.rdbuf();
  return text.str();
}

int eval(const EvalArguments& arguments) {
  const std::string source = arguments.file == "-" ? "standard input" : arguments.file;
  const std::filesystem::path folder =
      arguments.file == "-" ? "" : std::filesystem::path(arguments.file).parent_path();
  const nlohmann::json parsed = parse_json(contents(arguments.file), source);
  const JsonReader reader(parsed, "");
  std::vector<EvalRequest> requests;
  try {
    if (reader.is_list()) {
      for (const JsonReader& entry : reader.entries()) {
        const JsonReader named(entry.json(), "request " + entry.place());
        requests.push_back(read_request(named, folder));
      }
    } else {
      requests.push_back(read_request(reader, folder));
    }
  } catch (const Error& error) {
    throw Error(source + ": " + error.what());
  }
  nlohmann::ordered_json answers = nlohmann::ordered_json::array();
  bool good = true;
  for (const EvalRequest& request : requests) {
    Answer answer = evaluate(request);
    good = good && answer.good;
    answers.push_back(std::move(answer.json));
  }
  const nlohmann::ordered_json& result = reader.is_list() ? answers : answers.front();
  fmt::print("{}\n", arguments.compact ? result.dump() : json_text(result));
  return good ? exit_ok : exit_failed;
}

}  // namespace

void add_eval(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("eval", "Contact dynamics of a request in JSON, as JSON");
  const auto arguments = std::make_shared<EvalArguments>();
  command
      ->add_option("FILE", arguments->file, "A request or a list of them; - reads standard input")
      ->type_name("")
      ->required();
  command->add_flag("--compact", arguments->compact, "One line instead of indented text");
  command->footer(
      "Examples:\n"
      "  burnish eval examples/eval/polishing.json\n"
      "  echo '{\"robot\": \"arm7\", \"contacts\": [{\"tool\": \"tool\", \"directions\": \"z\"}],\n"
      "         \"compute\": [\"forward\", \"forces\"]}' | burnish eval -\n"
      "\n"
      "docs/eval.md describes requests and answers. Exit code 1: a state's status is not ok.");
  command->callback([arguments, &exit_code] { exit_code = eval(*arguments); });
}

}  // namespace burnish::app
