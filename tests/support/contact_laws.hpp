// The sweep over everything a contact can be: every reference x directions x one or two moving
// bodies x acceleration x stabilisation, on a robot, over random states; each derivative block
// compared with automatic differentiation through the same kernels and with central differences.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "burnish/contact/contact.hpp"
#include "burnish/contact/contact_set.hpp"
#include "burnish/model/model.hpp"

namespace burnish::test {

/// A robot of the sweep: where a single contact sits, and which two bodies touch each other.
struct LawRobot {
  std::string name;  ///< as TestRobot takes it
  std::string tool;  ///< frame C2
  std::string base;  ///< frame C1 when two bodies move
  Base stands_on = Base::Fixed;
};
const std::vector<LawRobot>& law_robots();

/// How a test names it.
inline void PrintTo(const LawRobot& robot, std::ostream* out) { *out << robot.name; }

/// "local", "centered", "surface", "world", and with a third body: "third", whose axes are its,
/// "elsewhere", whose origin is; and what follows a surface: "ball", "barrel", "saddle".
const std::vector<std::string>& law_references();
/// Direction sets by name, from one direction to six.
const std::vector<Directions>& law_directions();

/// Worst of a group of cases.
struct LawRow {
  Directions directions;
  bool two_bodies = false;
  double autodiff = 0.0;     ///< worst relative error against automatic differentiation
  double differences = 0.0;  ///< against central differences
  std::string worst_case;    ///< names block, acceleration, gains and state of the worst
  int states = 0;            ///< evaluated, over all accelerations and gains
  int resampled = 0;         ///< states replaced because their contact was near singular
};

/// One row per direction set and number of bodies.
std::vector<LawRow> sweep(const LawRobot& robot, const std::string& reference, int states);

/// Number of random states per case: $BURNISH_TEST_STATES, or what CMake was told under that name.
int law_states();

}  // namespace burnish::test
