// A support polygon as the kernels read it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "ocp/compiled_residual.hpp"

namespace burnish::ocp {

/// Edge i leads from point i to the next one, the last back to the first. Throws Error with one
/// sentence for fewer than three points, a point that is not finite, and points that are not the
/// corners of a convex polygon, counter-clockwise as seen from above: each has to be more than
/// 1e-6 m to the left of every edge that it is no end of.
std::vector<SupportMargin::Edge> support_edges(const std::vector<Eigen::Vector2d>& points);

}  // namespace burnish::ocp
