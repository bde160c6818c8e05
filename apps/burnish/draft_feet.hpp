// What a drafted settings file says of a legged robot: its feet, and a posture on them.
#pragma once

#include <set>
#include <string>

#include "burnish/robots/robot.hpp"

namespace burnish::app {

/// Lines of a draft; all empty for a robot without legs.
struct DraftedFeet {
  std::string comment;  ///< which feet were found and how a task takes them
  std::string frames;   ///< entries below `frames:`, of frames that the description does not have
  std::string posture;  ///< values of a posture `standing` on level soles; empty: none was found

  std::set<std::string> legs;  ///< joints that carry a foot

  bool any() const { return !comment.empty(); }
};

/// Finds the feet of the robot in a description file with its base afloat. `floats`: the user says
/// that it does; otherwise only links named after feet count, so that arms on a fixed trunk are not
/// taken for legs.
DraftedFeet draft_feet(const std::string& file, bool floats);

}  // namespace burnish::app
