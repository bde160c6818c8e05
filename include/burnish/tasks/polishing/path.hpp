// Paths on a surface: target positions of the tip's centre as functions of time.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace burnish::polishing {

/// Shape of a path.
/// @described polishing
enum class PathKind {
  Circle,
  Spiral,
  ZigZag,  ///< @word zigzag
  Points,
};

/// Path in the plane of a surface. Coordinates (u, w) are along the two tangents of the surface.
/// The path begins at rest at its centre (0, 0).
/// @described polishing
struct PathSpec {
  PathKind kind = PathKind::Circle;  ///< Shape of the path: circle, spiral, zigzag or points
  double radius = 0.07;  ///< Radius of the circle, or largest radius of the spiral [m], > 0
  double rate = 1.0;     ///< Angular rate of the circle or spiral [rad/s]
  /// Time until a circle reaches its full radius, or a spiral its full rate of growth [s], > 0
  double start_up = 2.0;
  /// Mean distance between two turns of the spiral [m], > 0
  /// @more The mean is computed over all turns from the centre to the largest radius.
  double pitch = 0.01;
  double width = 0.14;   ///< Length of the zigzag along the first tangent [m], > 0
  double height = 0.10;  ///< Length of the zigzag along the second tangent [m], > 0
  int rows = 6;          ///< Number of lines of the zigzag, >= 2
  /// Highest speed along a straight line of the zigzag or between points [m/s], > 0
  double speed = 0.07;
  /// Points [[u, w], ...] along the two tangents [m]; in files also a CSV file with columns u and w
  /// @more The path leads from the centre through the points in straight lines, and stops at each
  /// point.
  std::vector<Eigen::Vector2d> points = {};
};

std::string name_of(PathKind kind);
/// Returns the shape named "circle", "spiral", "zigzag" or "points". For another name, throws Error
/// that suggests the nearest one.
PathKind parse_path(const std::string& name);

/// Coordinates (u, w) of a path at one time, with their first two time derivatives.
/// @described polishing
struct PlanarPoint {
  Eigen::Vector2d p = Eigen::Vector2d::Zero();  ///< Position (u, w) [m]
  Eigen::Vector2d v = Eigen::Vector2d::Zero();  ///< Velocity of (u, w) [m/s]
  Eigen::Vector2d a = Eigen::Vector2d::Zero();  ///< Acceleration of (u, w) [m/s^2]
};

/// Path of a PathSpec as a function of time. The constructor throws Error if the numbers do not
/// describe a path.
class Path {
 public:
  explicit Path(const PathSpec& spec);
  /// Returns the point of the path at time `t` after the start [s]. For t < 0, returns the start.
  /// Does not allocate.
  PlanarPoint at(double t) const noexcept;
  /// Returns the time when the path ends [s]. For circle and spiral, which do not end, returns
  /// infinity.
  double duration() const { return duration_; }
  /// Returns the largest |u| or |w| on the whole path [m].
  double reach() const;

 private:
  PlanarPoint circle(double t) const noexcept;
  PlanarPoint spiral(double t) const noexcept;
  PlanarPoint along_points(double t) const noexcept;

  PathSpec spec_;
  double duration_;
  std::vector<Eigen::Vector2d> corners_;
  std::vector<double> times_;  ///< Time when each corner is reached [s].
};

}  // namespace burnish::polishing
