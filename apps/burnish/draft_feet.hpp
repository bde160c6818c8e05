// Entries for feet and for a standing posture in the draft of a legged robot's settings file.
#pragma once

#include <set>
#include <string>

#include "burnish/robots/robot.hpp"

namespace burnish::app {

/// Lines for the draft of a settings file; all empty for a robot without legs.
struct DraftedFeet {
  std::string comment;  ///< YAML comment: names of the feet, and keys of tasks that stand on them.
  std::string frames;   ///< Entries of `frames:` for frames that the description lacks.
  std::string posture;  ///< Values of a posture `standing` with level soles; empty: none was found.

  std::set<std::string> legs;  ///< Joints that carry a foot.

  bool any() const { return !comment.empty(); }
};

/// Finds the feet of a robot that is loaded from its description file with a floating base.
/// `floats`: true if the user states that the base floats. If false, only links with names such as
/// "foot" or "sole" count as feet, so that arms on a fixed trunk are not mistaken for legs.
DraftedFeet draft_feet(const std::string& file, bool floats);

}  // namespace burnish::app
