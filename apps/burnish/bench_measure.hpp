// Durations of computations for one robot: per state, per solver iteration, per control tick.
#pragma once

#include <string>
#include <vector>

#include "burnish/robots/robot.hpp"

namespace burnish::app {

struct BenchSpec {
  Robot robot;
  std::string tool = {};     ///< Frame that presses on a plane; empty: default_tool().
  std::string posture = {};  ///< Named posture of the robot; empty: its default posture.
  int knots = 100;           ///< Number of knots in the horizon, at intervals of 10 ms.
  int threads = 1;
  bool pin_threads = false;
  double seconds = 0.3;  ///< Approximate time for the measurement of each line of the report [s].
};

struct BenchLine {
  std::string group;  ///< Group of measurements: "state", "iteration" or "tick".
  std::string work;
  double median = 0.0, best = 0.0, p99 = 0.0;  ///< Durations over all repetitions [s].
  /// Ratio of the measured rate of multiply-adds to the core's peak rate; 0: unknown. The number of
  /// multiply-adds is the larger of the numbers of multiplications and of additions.
  double peak_share = 0.0;
  /// Memory allocations per repetition; negative: not counted in this build.
  double allocations = 0.0;
  /// Durations of the parts of the solver iteration with the median duration [s]. Zero unless
  /// `group` is "iteration".
  double expand = 0.0, backward = 0.0, trial = 0.0;
};

struct BenchReport {
  std::string robot, tool, posture;
  int nq = 0, nv = 0, nx = 0, nu = 0;
  int knots = 0, threads = 1, pack_width = 1;
  double peak = 0.0;  ///< Peak rate of multiply-adds of one core [1/s].
  std::vector<BenchLine> lines = {};
};

/// Measures durations of computations at random states near the posture, with the tool held along
/// world z. The plans solve the standard benchmark problem: press with 30 N and draw a circle of 7
/// cm radius. Throws Error for an unknown frame or posture, and if the dynamics of the robot in
/// this contact cannot be evaluated.
BenchReport measure_speed(const BenchSpec& given);

}  // namespace burnish::app
