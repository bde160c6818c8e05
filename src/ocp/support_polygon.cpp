#include "ocp/support_polygon.hpp"

#include <algorithm>
#include <string>

#include "base/sentence.hpp"
#include "burnish/base/error.hpp"

namespace burnish::ocp {
namespace {
std::string text(std::size_t index, const Eigen::Vector2d& point) {
  return std::to_string(index) + " [" + number(point.x()) + ", " + number(point.y()) + "]";
}
}  // namespace

std::vector<SupportMargin::Edge> support_edges(const std::vector<Eigen::Vector2d>& points) {
  const std::size_t count = points.size();
  if (count < 3)
    throw Error("has " + std::to_string(count) +
                " points; wanted the corners of a support polygon, at least 3");
  for (std::size_t i = 0; i < count; ++i)
    if (!points[i].allFinite())
      throw Error("point " + text(i, points[i]) + " is not finite; wanted x and y in m");
  std::vector<SupportMargin::Edge> edges;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    const Eigen::Vector2d along = (points[next] - points[i]).normalized();
    const Eigen::Vector2d inward(-along.y(), along.x());
    const double offset = inward.dot(points[i]);
    double width = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      if (k == i || k == next) continue;
      const double inside = inward.dot(points[k]) - offset;
      if (!(inside > 1e-6))
        throw Error("point " + text(k, points[k]) + " is not to the left of the edge from point " +
                    text(i, points[i]) + " to " + text(next, points[next]) +
                    "; wanted the corners of a convex polygon, counter-clockwise from above");
      width = std::max(width, inside);
    }
    edges.push_back({inward.x(), inward.y(), offset, 0.5 * width});
  }
  return edges;
}

}  // namespace burnish::ocp
