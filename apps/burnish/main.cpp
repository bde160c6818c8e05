// Program `burnish`: selects the command, and reports errors of the command line by exit codes.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>

#include "burnish/base/error.hpp"
#include "command.hpp"
#include "help_formatter.hpp"
#include "signals.hpp"

namespace burnish::app {
namespace {

constexpr const char* footer =
    "Examples:\n"
    "  burnish show talos:right_arm\n"
    "  burnish check my_arm.urdf --tool flange\n"
    "  burnish eval request.json\n"
    "  burnish solve examples/problems/reaching.yaml\n"
    "  burnish polish --surface table --controller mpc\n"
    "  burnish experiment paper\n"
    "  burnish bench my_arm.urdf --tool flange\n"
    "\n"
    "A robot is a URDF or MJCF file, a folder with robot.yaml, or a name that burnish --robots\n"
    "lists; ':variant' may follow.\n"
    "Exit codes: 0 success; 1 a check failed, an evaluation had a bad status, a solver did not\n"
    "converge or a run did not polish; 2 invalid usage or input.";

std::string lower_first(std::string text) {
  if (text.size() > 1 && std::islower(static_cast<unsigned char>(text[1])) != 0) {
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  }
  return text;
}

/// Returns the command that the command line selects; without a command, the program itself.
const CLI::App& chosen(const CLI::App& app) {
  const std::vector<CLI::App*> commands = app.get_subcommands();
  return commands.empty() ? app : *commands.front();
}

std::string usage_sentence(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = chosen(app);
  std::string sentence = lower_first(error.what());
  while (!sentence.empty() && (sentence.back() == '\n' || sentence.back() == '.')) {
    sentence.pop_back();
  }
  std::vector<std::string> strangers = app.remaining(true);
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError) &&
      !strangers.empty()) {
    // Moves unknown options to the front, because the words after them may be their values.
    std::stable_partition(strangers.begin(), strangers.end(),
                          [](const std::string& word) { return word.starts_with('-'); });
    std::vector<std::string> options;
    for (const CLI::Option* option : command.get_options())
      for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
    sentence = fmt::format("unknown argument '{}'{}", strangers.front(),
                           did_you_mean(strangers.front(), options));
  }
  const std::string name = &command == &app ? "" : " " + command.get_name();
  return fmt::format("{} (see burnish{} --help)", sentence, name);
}

/// Throws Error if the first word is not a command; the message names the nearest command.
void check_command(const CLI::App& app, int count, char** words) {
  if (count < 2 || words[1][0] == '-') return;
  std::vector<std::string> commands;
  for (const CLI::App* command : app.get_subcommands({})) commands.push_back(command->get_name());
  for (const std::string& name : commands)
    if (name == words[1]) return;
  throw Error(fmt::format("unknown command '{}'{} (burnish --help lists them{})", words[1],
                          did_you_mean(words[1], commands), other_commands));
}

int run(int count, char** words) {
  CLI::App app(
      "Contact dynamics, optimal control and polishing: robots that press, slide and walk.",
      "burnish");
  // Sets the formatter before the commands are added, because they inherit it.
  app.formatter(std::make_shared<HelpFormatter>());
  app.get_formatter()->column_width(34);
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.set_version_flag("--version", "burnish " BURNISH_VERSION, "Print the version and exit");
  app.footer(footer);
  app.require_subcommand(0, 1);
  int exit_code = exit_ok;
  add_commands(app, exit_code);
  if (count < 2) {
    fmt::print(stderr, "{}", app.help());
    return exit_usage;
  }
  try {
    check_command(app, count, words);
    app.parse(count, words);
  } catch (const CLI::Success& wanted) {  // --help, --version
    return app.exit(wanted);
  } catch (const CLI::ParseError& error) {
    throw Error(usage_sentence(app, error));
  }
  return exit_code;
}

/// Standard output. If it cannot be written completely, it is truncated to its previous length, so
/// that no partial table remains.
class Output {
 public:
  Output() {
    struct stat file {};
    if (fstat(STDOUT_FILENO, &file) == 0 && S_ISREG(file.st_mode) &&
        (fcntl(STDOUT_FILENO, F_GETFL) & O_APPEND) == 0)
      begin_ = lseek(STDOUT_FILENO, 0, SEEK_CUR);
  }
  /// Throws Error if some of the output could not be written.
  void finish() const {
    errno = 0;
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) refuse(errno);
  }
  [[noreturn]] void refuse(int reason) const {
    [[maybe_unused]] const bool cut = begin_ >= 0 && ftruncate(STDOUT_FILENO, begin_) == 0;
    // The program writes the rest of its output buffer when it ends, which would fail again.
    // Standard output is therefore redirected to /dev/null.
    if (const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0)
      dup2(nowhere, STDOUT_FILENO);
    throw Error(std::string("the output could not be written") +
                (reason != 0 ? std::string(": ") + std::strerror(reason) : std::string()));
  }

 private:
  /// Length of the output file at the start; -1: not a file, or opened to append.
  off_t begin_ = -1;
};

}  // namespace

int run_program(int count, char** words) {
  const Output output;
  try {
    const int exit_code = run(count, words);
    output.finish();
    return exit_code;
  } catch (const std::system_error& error) {  // fmt could not print
    if (std::ferror(stdout) == 0) throw;
    output.refuse(error.code().value());
  }
}

const char* program_version() { return BURNISH_VERSION; }

}  // namespace burnish::app

int main(int count, char** words) {
  burnish::app::end_on_signals();
  int exit_code = burnish::app::exit_usage;
  try {
    exit_code = burnish::app::run_program(count, words);
  } catch (const burnish::Error& error) {
    for (const std::string& sentence : error.sentences())
      fmt::print(stderr, "burnish: {}\n", sentence);
    return burnish::app::exit_usage;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "burnish: not enough memory\n");
    return burnish::app::exit_usage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "burnish: {}\n", error.what());
    return burnish::app::exit_usage;
  }
  return exit_code;
}
