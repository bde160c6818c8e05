// Target force of a tool over the time on its path.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace burnish::polishing {

/// Target of the normal force as a function of the time on the path.
/// @described polishing
/// Times count from the beginning of the path [s]. Forces are in N.
struct ForceProfile {
  /// Shape of the target force over the time on the path.
  /// @described polishing.ForceProfileKind
  enum class Kind {
    Constant,
    Steps,  ///< At the time of each point, the force jumps to the force of the point
    Lines,  ///< Straight lines between points
    Sine,   ///< Sine about the force of the task
  };
  Kind kind = Kind::Constant;  ///< Shape of the force over time: constant, steps, lines or sine
  /// Points of steps and lines: [[time on the path in s, force in N], ...]
  /// @more The kind `steps` uses the task's force until the first point. The kind `lines` starts
  /// with a straight line from the task's force at time 0 to the first point.
  std::vector<Eigen::Vector2d> points = {};
  double amplitude = 5.0;  ///< Amplitude of the sine about the force of the task [N], >= 0
  double frequency = 1.0;  ///< Frequency of the sine [Hz], > 0
  /// Time on the path when the sine begins [s], >= 0
  /// @more Before this time the force is constant.
  double start = 0.0;
  /// Whether plans use the future target force; false: plans assume a constant target force
  /// @more The assumed constant is the target force at the present time.
  bool preview = true;

  bool is_constant() const { return kind == Kind::Constant; }
  /// Returns the target force [N] at time `t` [s] after the beginning of the path. For t < 0,
  /// returns `force`, which is the force of the task. Does not allocate.
  double at(double force, double t) const noexcept;
  /// Returns the smallest target force of the profile [N]. `force` is the force of the task [N].
  double min_force(double force) const;
  /// Returns the largest target force of the profile [N]. `force` is the force of the task [N].
  double max_force(double force) const;
  /// Throws Error if steps or lines have no points, if the times of the points do not increase or
  /// begin below 0, or if a target force is not positive. `force` is the force of the task [N].
  void check(double force) const;
};

std::string name_of(ForceProfile::Kind kind);

}  // namespace burnish::polishing
