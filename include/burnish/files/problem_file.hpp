// An optimal control problem in a YAML file: what docs/optimal_control.md describes.
#pragma once

#include <filesystem>
#include <string>

#include "burnish/ocp/problem.hpp"
#include "burnish/robots/robot.hpp"
#include "burnish/solver/options.hpp"

namespace burnish {

/// Where the solver starts from.
/// @described files
struct WarmStart {
  /// Where the solver starts from.
  /// @described files.WarmStartKind
  enum class Kind {
    Hold,   ///< the initial state at every knot, with the controls that hold it in the knot's stage
    Still,  ///< the initial state at every knot, zero controls
    File,   ///< a trajectory.csv of an earlier solve
  };
  Kind kind = Kind::Hold;
  std::filesystem::path file = {};  ///< File: where it is
};

/// What a problem file says.
/// @described files
struct ProblemFile {
  std::string description = {};  ///< @required
  Robot robot;                   ///< @required
  /// as load_robot() takes it; with :variant where one is stated @undescribed
  std::string robot_name = {};
  ProblemSpec spec;  ///< compiles: it has been tried @required
  DdpOptions solver = {};
  WarmStart guess = {};
};

/// Reads a problem file. Relative names in it are looked up in its folder. Throws Error with one
/// sentence that names the file, the line, the keys that lead to the place, and what was wanted.
ProblemFile read_problem_file(const std::filesystem::path& file);

/// States and controls to start from.
/// @described files @result
struct TrajectoryGuess {
  RowMatrix xs;  ///< (N + 1) x nx
  RowMatrix us;  ///< N x max_controls
};

/// Throws Error where a file cannot be read, has not the problem's columns, or not its number of
/// knots.
TrajectoryGuess make_guess(const Problem& problem, const WarmStart& start);

}  // namespace burnish
