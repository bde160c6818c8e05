// Edges of a support polygon, as the kernels read them.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "ocp/compiled_residual.hpp"

namespace burnish::ocp {

/// Returns the edges of a support polygon. Edge i leads from point i to the next point; the last
/// edge leads back to point 0. Throws Error
///  - for fewer than three points,
///  - for a point that is not finite,
///  - if the points are not the corners of a convex polygon, counter-clockwise as seen from above.
///    Every point must be more than 1e-6 m to the left of each edge of which it is not an end.
std::vector<SupportMargin::Edge> support_edges(const std::vector<Eigen::Vector2d>& points);

}  // namespace burnish::ocp
