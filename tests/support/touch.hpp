// Two bodies that touch.
#pragma once

#include <ostream>
#include <string>

namespace burnish::test {

/// A frame of a robot, and another of it or the world.
struct Touch {
  std::string robot, tool, base;
};

/// How a test names it.
inline void PrintTo(const Touch& touch, std::ostream* out) {
  *out << touch.robot << ": " << touch.tool << " on " << touch.base;
}

}  // namespace burnish::test
