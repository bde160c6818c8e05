// Paths on a surface: where the tool's centre shall be over time.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace burnish::polishing {

/// Shapes of paths.
/// @described polishing
enum class PathKind {
  Circle,
  Spiral,
  ZigZag,  ///< @word zigzag
  Points,
};

/// A path in the plane of a surface, in its two tangents (u, w), from its centre at rest.
/// @described polishing
/// Lengths in m, rates in rad/s, speeds in m/s.
struct PathSpec {
  PathKind kind = PathKind::Circle;  ///< circle, spiral, zigzag or points
  double radius = 0.07;              ///< [m] (circle, and the largest of a spiral), > 0
  double rate = 1.0;                 ///< [rad/s] (circle, spiral)
  double start_up = 2.0;  ///< [s] until the full radius (circle), the full growth (spiral), > 0
  double pitch = 0.01;    ///< [m] between two turns (spiral), > 0 @more mean over the way out
  double width = 0.14;    ///< [m] along the first tangent (zigzag), > 0
  double height = 0.10;   ///< [m] along the second tangent (zigzag), > 0
  int rows = 6;           ///< lines (zigzag), >= 2
  double speed = 0.07;    ///< [m/s], the highest along a line (zigzag, points), > 0
  /// [[u, w], ...] in the surface's tangents, {m}, or a CSV file with columns u and w (points)
  /// @code in the surface's tangents, m (points); followed by lines from the centre, at rest at
  /// each
  std::vector<Eigen::Vector2d> points = {};
};

std::string name_of(PathKind kind);
/// "circle", "spiral", "zigzag" or "points". Throws Error with the nearest known name.
PathKind parse_path(const std::string& name);

/// (u, w) of a path and their first two derivatives at a time.
/// @described polishing
struct PlanarPoint {
  Eigen::Vector2d p = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d v = Eigen::Vector2d::Zero();  ///< [m/s]
  Eigen::Vector2d a = Eigen::Vector2d::Zero();  ///< [m/s^2]
};

/// The path compiled. Throws Error for numbers that make no path.
class Path {
 public:
  explicit Path(const PathSpec& spec);
  /// t s after its start; before, the start. No allocation.
  PlanarPoint at(double t) const noexcept;
  /// s until its last point is reached; infinite for paths that go on.
  double duration() const { return duration_; }
  /// m, the largest |u| or |w| that it comes to, however long it goes on.
  double reach() const;

 private:
  PlanarPoint circle(double t) const noexcept;
  PlanarPoint spiral(double t) const noexcept;
  PlanarPoint along_points(double t) const noexcept;

  PathSpec spec_;
  double duration_;
  std::vector<Eigen::Vector2d> corners_;
  std::vector<double> times_;  ///< s, when each corner is reached
};

}  // namespace burnish::polishing
