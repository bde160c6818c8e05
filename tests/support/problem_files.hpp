// Folder for problem files of a test, and a small problem as their base.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>

#include "burnish/files/problem_file.hpp"
#include "support/scratch.hpp"

namespace burnish::testing {

namespace fs = std::filesystem;
/// Fixture with a folder for the files of one test.
class ProblemFiles : public ::testing::Test {
 protected:
  fs::path write(const std::string& text, const std::string& name = "problem.yaml") const {
    return scratch_.write(name, text);
  }
  ProblemFile read(const std::string& text) const { return read_problem_file(write(text)); }

  Scratch scratch_;
};

inline const std::string arm = "robot: " BURNISH_ROBOTS_DIR "/arm7\n";

/// Small problem with changes: `to` replaces `from` in the text; the lines `more` follow at the
/// end.
inline std::string small(const std::string& from = "", const std::string& to = "",
                         const std::string& more = "") {
  std::string text = arm +
                     "contacts:\n"
                     "  pad: {tool: tool, directions: z, kd: 50}\n"
                     "terms:\n"
                     "  posture: {type: state, weight: 2}\n"
                     "  point: {type: frame_position, frame: tool, target: here}\n"
                     "stages:\n"
                     "  press:\n"
                     "    contacts: [pad]\n"
                     "    step: 0.02\n"
                     "    costs:\n"
                     "      posture: 0.5\n"
                     "      point: {weight: 3}\n"
                     "      force: {type: contact_force, contact: pad, target: 30}\n"
                     "horizon:\n"
                     "  - press: 5\n"
                     "terminal: {posture: 7}\n";
  if (!from.empty()) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  }
  return text + more;
}

}  // namespace burnish::testing
