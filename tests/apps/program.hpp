// Runs the burnish program in a shell, like a user.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "support/scratch.hpp"

namespace burnish::testing {

struct Outcome {
  int exit_code = -1;
  std::string out, err;
};

/// Returns a path as one word for a shell.
inline std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

inline int lines_of(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

/// Runs a command in a shell and returns its exit code and output.
inline Outcome shell(const std::string& command, const std::string& input = "") {
  const Scratch scratch;
  const auto file = [&](const char* name) { return (scratch.folder / name).string(); };
  scratch.write("in", input);
  const std::string redirected =
      "(" + command + ") <'" + file("in") + "' >'" + file("out") + "' 2>'" + file("err") + "'";
  const int status = std::system(redirected.c_str());
  Outcome outcome;
  if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
  outcome.out = contents(scratch.folder / "out");
  outcome.err = contents(scratch.folder / "err");
  return outcome;
}

/// Runs burnish with `arguments`, written as in a shell.
inline Outcome run(const std::string& arguments, const std::string& input = "") {
  return shell("'" BURNISH_PROGRAM "' " + arguments, input);
}

/// Returns whether a shell finds a program of this name.
inline bool is_installed(const std::string& program) {
  return shell("command -v " + program).exit_code == 0;
}

/// Expects exit code 2, no output, and one sentence on standard error that contains `words`.
inline void expect_refused(const Outcome& outcome, const std::string& words) {
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err.rfind("burnish: ", 0), 0U) << outcome.err;
  EXPECT_EQ(outcome.err.find('\n') + 1, outcome.err.size()) << outcome.err;
  EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
}

}  // namespace burnish::testing
