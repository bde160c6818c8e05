// How long the library takes on one robot: per state, per iteration of the solver, per control
// tick.
#pragma once

#include <string>
#include <vector>

#include "burnish/robots/robot.hpp"

namespace burnish::app {

struct BenchSpec {
  Robot robot;
  std::string tool = {};     ///< frame that touches a plane; empty: default_tool()
  std::string posture = {};  ///< of the robot's settings; empty: its default
  int knots = 100;           ///< of the horizon, 10 ms each
  int threads = 1;
  bool pin_threads = false;
  double seconds = 0.3;  ///< s, about, that each line is measured
};

struct BenchLine {
  std::string group;  ///< "state", "iteration" or "tick"
  std::string work;
  double median = 0.0, best = 0.0, p99 = 0.0;  ///< s, of all repetitions
  /// Of the core's peak of multiply-adds, if every multiplication went with an addition; 0:
  /// unknown.
  double peak_share = 0.0;
  double allocations = 0.0;  ///< per repetition; negative: not counted in this build
  /// s, of the iteration of median length; zero for other groups.
  double expand = 0.0, backward = 0.0, trial = 0.0;
};

struct BenchReport {
  std::string robot, tool, posture;
  int nq = 0, nv = 0, nx = 0, nu = 0;
  int knots = 0, threads = 1, pack_width = 1;
  double peak = 0.0;  ///< multiply-adds per second of one core
  std::vector<BenchLine> lines = {};
};

/// States are drawn near the posture; one direction of the tool is held along world z. The horizon
/// is the problem that solvers are compared on: press with 30 N, draw a circle of 7 cm radius.
/// Throws Error for a frame or posture that there is not, and where the robot cannot be evaluated
/// so.
BenchReport measure_speed(const BenchSpec& given);

}  // namespace burnish::app
