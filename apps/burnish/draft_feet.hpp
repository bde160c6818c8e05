// Entries of a drafted settings file for a legged robot: feet, and a standing posture.
#pragma once

#include <set>
#include <string>

#include "burnish/robots/robot.hpp"

namespace burnish::app {

/// Lines of a drafted settings file; all empty for a robot without legs.
struct DraftedFeet {
  std::string comment;  ///< feet that were found, and the `standing` keys of tasks for them
  std::string frames;   ///< entries of `frames:` for frames that the description does not have
  std::string posture;  ///< values of a posture `standing` with level soles; empty: none was found

  std::set<std::string> legs;  ///< joints that carry a foot

  bool any() const { return !comment.empty(); }
};

/// Finds the feet of the robot in a description file, loaded with a floating base. `floats`: true
/// if the user states that the base floats. If false, only links named after feet count, so that
/// arms on a fixed trunk are not taken for legs.
DraftedFeet draft_feet(const std::string& file, bool floats);

}  // namespace burnish::app
