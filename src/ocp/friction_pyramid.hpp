// The pyramid inscribed in a friction cone: its sides and the names of its rows.
#pragma once

#include <string>
#include <vector>

#include "ocp/compiled_residual.hpp"

namespace burnish::ocp {

/// Throws Error unless `sides` is 3 to 32, or 0 for the cone itself.
void check_sides(int sides);

/// Returns the distance of a pyramid's sides from its axis, as a fraction of the cone's radius.
/// `sides` must be at least 3.
double pyramid_inradius(int sides);
/// Returns the sides of the pyramid, evenly spread. Side 0 faces the first axis after the normal.
std::vector<PyramidMargin::Side> pyramid_sides(int sides);

/// Returns the row names of a pyramid: the direction of each side, such as "side_90deg". Without
/// sides (0), the rows are those of the cone: "cone" and "normal".
std::vector<std::string> cone_row_names(int sides);

/// Returns the row names of the friction limits of a planar foot's moment about its normal:
/// "turn_right_1" to "turn_right_4", then "turn_left_1" to "turn_left_4".
std::vector<std::string> turning_row_names();

}  // namespace burnish::ocp
