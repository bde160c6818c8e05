// Sweep over all variants of a contact: every reference x directions x one or two moving bodies x
// acceleration x stabilization, on a robot, over random states. Each derivative block is compared
// with automatic differentiation through the same kernels and with central differences.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "burnish/contact/contact.hpp"
#include "burnish/contact/contact_set.hpp"
#include "burnish/model/model.hpp"

namespace burnish::test {

/// Robot of the sweep, with the tool of its contact and the second body of contacts between two
/// bodies.
struct LawRobot {
  std::string name;  ///< name of a TestRobot
  std::string tool;  ///< frame C2
  std::string base;  ///< frame C1 when two bodies move
  Base stands_on = Base::Fixed;
};
const std::vector<LawRobot>& law_robots();

/// Prints the name for test output.
inline void PrintTo(const LawRobot& robot, std::ostream* out) { *out << robot.name; }

/// "local", "centered", "surface", "world"; with a third body: "third" (its axes), "elsewhere" (its
/// origin); on curved surfaces: "ball", "barrel", "saddle"; with friction: "sliding",
/// "sliding_ball".
const std::vector<std::string>& law_references();
/// Direction sets, from one direction to six.
const std::vector<Directions>& law_directions();

/// Largest errors over a group of cases.
struct LawRow {
  Directions directions;
  bool two_bodies = false;
  double autodiff = 0.0;     ///< worst relative error against automatic differentiation
  double differences = 0.0;  ///< worst relative error against central differences
  std::string worst_case;    ///< block, acceleration, gains and state of the largest error
  int states = 0;            ///< evaluated states, over all accelerations and gains
  int resampled = 0;         ///< states replaced because their contact was near singular
};

/// Returns one row per direction set and number of bodies.
std::vector<LawRow> sweep(const LawRobot& robot, const std::string& reference, int states);

/// Number of random states per case: $BURNISH_TEST_STATES, or CMake's variable of that name.
int law_states();

}  // namespace burnish::test
