// Part of a surface as a grid of points, so that a page draws all shapes in the same way.
#include <algorithm>
#include <cmath>

#include "burnish/dynamics/reference.hpp"
#include "report/run_page.hpp"

namespace burnish {
namespace {

// Points along a side of the grid, chosen by hand.
constexpr int patch_side = 33;
// Maximum angle between the normals in the middle and at the rim, chosen by hand [rad].
constexpr double max_turn = 2.0;
// Minimum cosine of the angle between the normal in the middle and any other normal. With a smaller
// cosine, the projection of a square does not show the surface. Chosen by hand.
constexpr double min_cosine = 0.3;

/// Point on a surface, with two tangents that are transported along the surface without spin.
struct Walker {
  Eigen::Vector3d x, ahead, aside;

  void settle(const Surface& surface) {
    SurfaceDistance here = surface.at(x);
    for (int i = 0; i < 4 && std::abs(here.distance) > 1e-12; ++i) {
      x -= here.distance * here.normal;
      here = surface.at(x);
    }
    const Eigen::Vector3d& n = here.normal;
    ahead = (ahead - n.dot(ahead) * n).normalized();
    const Eigen::Vector3d across = n.cross(ahead);
    aside = across.dot(aside) < 0.0 ? Eigen::Vector3d(-across) : across;
  }
  Walker walked(const Surface& surface, double length) const {
    constexpr int steps = 4;
    Walker result = *this;
    for (int i = 0; i < steps; ++i) {
      result.x += length / steps * result.ahead;
      result.settle(surface);
    }
    return result;
  }
  Walker turned() const { return {x, aside, ahead}; }
};

/// Returns patch_side points at equal distances along the surface, with `middle` in their middle.
std::vector<Walker> row_through(const Surface& surface, const Walker& middle, double half) {
  std::vector<Walker> row(patch_side, middle);
  const int centre = patch_side / 2;
  const double step = 2.0 * half / (patch_side - 1);
  for (int i = 1; i <= centre; ++i) {
    row[centre + i] = row[centre + i - 1].walked(surface, step);
    row[centre - i] = row[centre - i + 1].walked(surface, -step);
  }
  return row;
}

/// Returns the intersection of the surface with the line through p along `direction`.
Eigen::Vector3d along(const Surface& surface, Eigen::Vector3d p, const Eigen::Vector3d& direction) {
  constexpr int max_iterations = 50;  // chosen by hand
  for (int i = 0; i < max_iterations; ++i) {
    const SurfaceDistance here = surface.at(p);
    if (std::abs(here.distance) < 1e-12) break;
    p -= here.distance / std::max(here.normal.dot(direction), 0.1) * direction;
  }
  return p;
}

}  // namespace

PagePatch surface_patch(const Surface& surface, const Eigen::Vector3d& middle, double half) {
  const Eigen::Vector3d n = surface.at(middle).normal;
  const Eigen::Matrix3d axes = Reference::surface_with_normal(n).rotation;
  Walker here{middle, axes.col(0), axes.col(1)};
  here.settle(surface);
  PagePatch patch{patch_side, {}};
  const auto add = [&](const Eigen::Vector3d& p) {
    for (const double entry : p) patch.points.push_back(static_cast<float>(entry));
  };
  bool is_over_the_square = true;
  for (int i = 0; i < patch_side; ++i)
    for (int k = 0; k < patch_side; ++k) {
      const auto place = [&](int step) { return half * (2.0 * step / (patch_side - 1) - 1.0); };
      const Eigen::Vector3d p =
          along(surface, here.x + place(i) * here.ahead + place(k) * here.aside, n);
      const SurfaceDistance at = surface.at(p);
      is_over_the_square =
          is_over_the_square && std::abs(at.distance) < 1e-9 && at.normal.dot(n) > min_cosine;
      add(p);
    }
  if (is_over_the_square) return patch;
  patch.points.clear();
  const double curvature = surface.at(here.x).hessian.norm();
  const double reach = std::min(half, max_turn / std::max(curvature, 1e-9));
  for (const Walker& start : row_through(surface, here, reach))
    for (const Walker& place : row_through(surface, start.turned(), reach)) add(place.x);
  return patch;
}

void add_curved_surface(RunPage& page, const Surface& surface) {
  double reach = 0.05;  // minimum, chosen by hand [m]
  for (const Eigen::VectorXd* path : {&page.path_u, &page.path_w})
    for (const double x : *path)
      if (std::isfinite(x)) reach = std::max(reach, std::abs(x));
  constexpr double rim = 0.11;  // width of the drawn rim around the path, chosen by hand [m]
  const double half = std::isfinite(page.surface.extent) ? page.surface.extent : reach + rim;
  page.surface.patch = surface_patch(surface, page.path_origin_world, half);
  const Eigen::Vector3d n = page.surface.axes.col(2);
  const Eigen::Vector3d origin = page.path_origin_world - page.tip_radius * n;
  page.path_h.resize(page.path_u.size());
  for (Eigen::Index i = 0; i < page.path_u.size(); ++i) {
    const Eigen::Vector3d p = origin + page.path_u[i] * page.surface.axes.col(0) +
                              page.path_w[i] * page.surface.axes.col(1);
    page.path_h[i] = n.dot(along(surface, p, n) - p);
  }
}

}  // namespace burnish
