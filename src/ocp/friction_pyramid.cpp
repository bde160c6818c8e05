#include "ocp/friction_pyramid.hpp"

#include <cmath>
#include <numbers>

#include "base/sentence.hpp"
#include "burnish/base/error.hpp"

namespace burnish::ocp {

void check_sides(int sides) {
  // With 32 sides, at most 0.5 % of the friction is unused. More sides would cost computing time.
  constexpr int max_sides = 32;
  if (sides != 0 && (sides < 3 || sides > max_sides))
    throw Error("sides is " + std::to_string(sides) + "; wanted 3 to " + std::to_string(max_sides) +
                ", or 0 for the cone itself");
}

double pyramid_inradius(int sides) { return std::cos(std::numbers::pi / sides); }

std::vector<PyramidMargin::Side> pyramid_sides(int sides) {
  std::vector<PyramidMargin::Side> result;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / sides;
    result.push_back({std::cos(angle), std::sin(angle)});
  }
  return result;
}

std::vector<std::string> cone_row_names(int sides) {
  if (sides == 0) return {"cone", "normal"};
  std::vector<std::string> names;
  for (int i = 0; i < sides; ++i) names.push_back("side_" + number(360.0 * i / sides) + "deg");
  return names;
}

std::vector<std::string> turning_row_names() {
  std::vector<std::string> names;
  for (const char* prefix : {"turn_right_", "turn_left_"})
    for (int i = 1; i <= 4; ++i) names.push_back(prefix + std::to_string(i));
  return names;
}

}  // namespace burnish::ocp
