// How hard a tool presses over the time of its path.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace burnish::polishing {

/// What the wanted force does from when the path begins.
/// @described polishing
/// Times in s since then, forces in N.
struct ForceProfile {
  /// What the wanted force does from when the path begins.
  /// @described polishing.ForceProfileKind
  enum class Kind {
    Constant,
    Steps,  ///< from one point's force to the next one's at once
    Lines,  ///< straight between points
    Sine,   ///< about the task's force
  };
  Kind kind = Kind::Constant;  ///< constant, steps, lines or sine
  /// [[s since the path began, N], ...] (steps: the force from then on; lines: joined by straight
  /// lines) @more before the first one it is the task's force that holds, from which the first line
  /// leads
  std::vector<Eigen::Vector2d> points = {};
  double amplitude = 5.0;  ///< [N], about the task's force (sine), >= 0
  double frequency = 1.0;  ///< [Hz] (sine), > 0
  double start = 0.0;  ///< [s] since the path began, until which the force is constant (sine), >= 0
  /// plans know the force that is to come; false: they take that of now for all that is ahead
  bool preview = true;

  bool is_constant() const { return kind == Kind::Constant; }
  /// N at t s since the path began; before, what it begins with. `force`: the task's. No
  /// allocation.
  double at(double force, double t) const noexcept;
  /// N, the smallest and the largest that it comes to.
  double least(double force) const;
  double most(double force) const;
  /// Throws Error for points that are not in the order of their times, forces that are not
  /// positive, and steps or lines without points.
  void check(double force) const;
};

std::string name_of(ForceProfile::Kind kind);

}  // namespace burnish::polishing
