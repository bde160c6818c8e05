// Contact between two bodies.
#pragma once

#include <ostream>
#include <string>

namespace burnish::test {

/// Frame of a robot, and another frame of the robot or the world.
struct Touch {
  std::string robot, tool, base;
};

/// Prints the frames for test output.
inline void PrintTo(const Touch& touch, std::ostream* out) {
  *out << touch.robot << ": " << touch.tool << " on " << touch.base;
}

}  // namespace burnish::test
