// A friction cone's inscribed pyramid: how many sides it may have, and what they are called.
#pragma once

#include <string>
#include <vector>

#include "ocp/compiled_residual.hpp"

namespace burnish::ocp {

/// Throws Error with one sentence unless `sides` are 0, for the cone itself, or 3 to 32.
void check_sides(int sides);

/// Of a pyramid of so many sides (3 or more) within the cone: how far they are from its middle, of
/// the cone's radius.
double pyramid_reach(int sides);
/// Those sides, evenly spread; side 0 looks along the first axis after the normal.
std::vector<PyramidMargin::Side> pyramid_sides(int sides);

/// Names of the rows of a cone of so many sides: where each side looks, such as "side_90deg", and
/// of the cone itself (0) "cone" and "normal".
std::vector<std::string> cone_row_names(int sides);

/// Of the moment about a sole's normal within what its corners bear: "turn_right_1" to
/// "turn_right_4", then to the left.
std::vector<std::string> turning_row_names();

}  // namespace burnish::ocp
