// Tests of what the program prints about itself: manual page, completion in shells, list of robots.
#include <algorithm>
#include <regex>

#include "apps/program.hpp"

namespace burnish::testing {
namespace {

std::vector<std::string> split_lines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Returns the commands that --help lists.
std::vector<std::string> listed_commands() {
  std::vector<std::string> names;
  bool listed = false;
  for (const std::string& line : split_lines(run("--help").out)) {
    if (line == "Subcommands:")
      listed = true;
    else if (line.empty())
      listed = false;
    else if (listed)
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return names;
}

/// Returns the long options that the help of a command lists; an empty command is the program.
std::vector<std::string> listed_options(const std::string& command) {
  std::vector<std::string> names;
  const std::regex option("^  (-[a-z],)?(--[a-z-]+)( .*)?$");
  for (const std::string& line : split_lines(run(command + " --help").out)) {
    std::smatch found;
    if (std::regex_match(line, found, option)) names.push_back(found[2]);
  }
  return names;
}

/// Returns the source of a section of the manual page, with plain minus signs.
std::string manual_section(const std::string& name) {
  const std::string page = run("--man").out;
  const std::size_t begin = page.find("\n.SH " + name + "\n");
  if (begin == std::string::npos) return "";
  const std::size_t end = page.find("\n.SH ", begin + 1);
  return std::regex_replace(page.substr(begin, end - begin), std::regex(R"(\\-)"), "-");
}

std::string upper_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

TEST(ManPage, Text_HasEveryCommandAndOption) {
  EXPECT_EQ(listed_commands().size(), 13U);
  EXPECT_NE(manual_section("COMMANDS"), "");
  std::vector<std::string> all{""};
  for (const std::string& command : listed_commands()) {
    EXPECT_NE(manual_section("COMMANDS").find("\n\\fB" + command + "\\fR\n"), std::string::npos);
    all.push_back(command);
  }
  for (const std::string& command : all) {
    SCOPED_TRACE("burnish " + command);
    const std::string text = manual_section(command.empty() ? "OPTIONS" : upper_case(command));
    EXPECT_GE(listed_options(command).size(), 2U);
    for (const std::string& option : listed_options(command)) {
      if (!command.empty() && option == "--help") continue;  // listed once for the program
      EXPECT_NE(text.find("\\fB" + option + "\\fR"), std::string::npos) << option;
    }
  }
  EXPECT_NE(run("--man").out.find("\"burnish " BURNISH_VERSION "\""), std::string::npos);
}

TEST(ManPage, Groff_FormatsItWithoutWarnings) {
  if (!is_installed("groff")) GTEST_SKIP() << "groff is not installed";
  const Outcome set = shell("groff -man -Tutf8 -ww", run("--man").out);
  EXPECT_EQ(set.exit_code, 0);
  EXPECT_EQ(set.err, "");
  // Remove overstruck letters and colours.
  const std::string text = std::regex_replace(set.out, std::regex(".\b|\x1b\\[[0-9;]*m"), "");
  for (const std::string words :
       {"--completion SHELL", "--surface SURFACE ...", "burnish experiment [options] EXPERIMENT",
        "echo '{\"robot\": \"arm7\", \"contacts\": [{\"tool\": \"tool\", \"directions\": \"z\"}],",
        "--contact tool=left_sole_link --contact tool=right_sole_link \\", "from the file, or 100"})
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
}

/// Returns bash's completions for the last word; `words` is a line as bash splits it.
std::string bash_offers(const std::string& words, const std::string& robots = BURNISH_ROBOTS_DIR) {
  const Scratch scratch;
  const auto script = scratch.write("script", run("--completion bash").out);
  const Outcome outcome =
      shell("BURNISH_ROBOTS='" + robots + "' bash --norc -c 'source " + script.string() +
            "\nCOMP_WORDS=(" + words + ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_burnish\n" +
            "echo \"${COMPREPLY[*]}\"'");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "") << words;
  return outcome.out.substr(0, outcome.out.find('\n'));
}

TEST(BashCompletion, Words_CompleteToCommandsOptionsAndChoices) {
  const std::string program = "\"" BURNISH_PROGRAM "\" ";
  EXPECT_EQ(bash_offers(program + "po"), "polish");
  EXPECT_EQ(bash_offers(program + "\"\""),
            "show check eval solve polish run experiment merge sweep tune report bench identify");
  EXPECT_EQ(bash_offers(program + "--ver"), "--version");
  EXPECT_EQ(bash_offers(program + "polish --sur"), "--surface");
  EXPECT_EQ(bash_offers(program + "polish --surface \"\""),
            "table board board_x board_y board_minus_y tilt_45");
  EXPECT_EQ(bash_offers(program + "polish --surface = ta"), "table");
  EXPECT_EQ(bash_offers(program + "polish --seed 1 --controller b"), "baseline both");
  EXPECT_EQ(bash_offers(program + "polish --set path.ra"), "path.radius= path.rate=");
  EXPECT_EQ(bash_offers(program + "polish --set force = 20 --dis"), "--disturbances");
  EXPECT_EQ(bash_offers(program + "experiment \"\""),
            "paper orientation frames seeds tilt surfaces robots force_test standing tick");
  EXPECT_EQ(bash_offers(program + "--completion \"\""), "bash zsh fish");
}

TEST(BashCompletion, RobotArgument_CompletesToNamesOfRobots) {
  const std::string program = "\"" BURNISH_PROGRAM "\" ";
  EXPECT_EQ(bash_offers(program + "show ta"),
            "talos talos:fixed talos:right_arm talos:two_arms talos:with_plate");
  EXPECT_EQ(bash_offers(program + "show talos : r"), "right_arm");
  EXPECT_EQ(bash_offers(program + "check --tool tool pend"), "pendulum");
  EXPECT_EQ(bash_offers(program + "show --posture ta"), "") << "a posture is not a robot";
  EXPECT_EQ(bash_offers(program + "polish ta"), "") << "the shell completes files itself";
}

TEST(ShellCompletion, Scripts_HaveEveryOption) {
  for (const std::string shell_name : {"bash", "zsh", "fish"}) {
    const std::string script = run("--completion " + shell_name).out;
    for (const std::string& command : listed_commands())
      for (const std::string& option : listed_options(command)) {
        const std::string word = shell_name == "fish" ? " -l " + option.substr(2) : option;
        EXPECT_NE(script.find(word), std::string::npos) << shell_name << " " << option;
      }
  }
  expect_refused(run("--completion tcsh"), "no completion for 'tcsh'; wanted bash, zsh or fish");
}

TEST(ShellCompletion, ZshScript_HasValidSyntax) {
  if (!is_installed("zsh")) GTEST_SKIP() << "zsh is not installed";
  const Outcome outcome = shell("zsh -n", run("--completion zsh").out);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
}

TEST(ShellCompletion, FishScript_CompletesCommandsOptionsAndChoices) {
  if (!is_installed("fish")) GTEST_SKIP() << "fish is not installed";
  const Scratch scratch;
  const auto script = scratch.write("script", run("--completion fish").out);
  const auto offers = [&](const std::string& line) {
    const Outcome outcome =
        shell("fish --no-config -c 'source " + script.string() + "; complete -C \"" + line +
              "\" | string replace -r \"\\t.*\" \"\"'");
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  };
  EXPECT_EQ(offers("burnish po"), "polish\n");
  EXPECT_EQ(offers("burnish polish --sur"), "--surface\n");
  EXPECT_EQ(offers("burnish polish --surface ta"), "table\n");
}

TEST(RobotList, Library_IsListedWithVariants) {
  const Outcome outcome = run("--robots");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  for (const std::string name :
       {"arm7 ", "arm7:six ", "crane ", "pendulum ", "quadruped ", "talos ", "talos:right_arm "})
    EXPECT_NE(("\n" + outcome.out).find("\n" + name), std::string::npos) << name;
  const std::vector<std::string> lines = split_lines(outcome.out);
  EXPECT_TRUE(std::all_of(lines.begin(), lines.end(), [](const std::string& line) {
    return line.find("  ") != std::string::npos && line.back() != ' ';
  })) << outcome.out;
}

TEST(RobotList, UnreadableRobot_IsNamedAndHidesNoOther) {
  const Scratch scratch;
  std::filesystem::create_directory(scratch.folder / "broken");
  scratch.write("broken/robot.yaml", "urdf: [");
  const Outcome outcome =
      shell("BURNISH_ROBOTS='" + scratch.folder.string() + "' '" BURNISH_PROGRAM "' --robots");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(std::regex_search(outcome.out, std::regex("\nbroken +cannot be read: ")))
      << outcome.out;
  EXPECT_NE(outcome.out.find("\ntalos "), std::string::npos);
}

}  // namespace
}  // namespace burnish::testing
