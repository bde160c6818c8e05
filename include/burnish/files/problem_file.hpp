// Reader of optimal control problems in YAML files. docs/optimal_control.md describes the format.
#pragma once

#include <filesystem>
#include <string>

#include "burnish/ocp/problem.hpp"
#include "burnish/robots/robot.hpp"
#include "burnish/solver/options.hpp"

namespace burnish {

/// Trajectory that the solver starts from (warm start).
/// @described files
struct WarmStart {
  /// Kind of warm start.
  /// @described files.WarmStartKind
  enum class Kind {
    /// Initial state at every knot; the controls hold the robot at rest in the contacts of each
    /// knot
    Hold,
    Still,  ///< Initial state at every knot, with zero controls
    File,   ///< Trajectory from a file trajectory.csv of an earlier solve
  };
  Kind kind = Kind::Hold;
  std::filesystem::path file = {};  ///< Path of the trajectory file, if `kind` is file
};

/// Content of a problem file.
/// @described files
struct ProblemFile {
  std::string description = {};  ///< @required
  Robot robot;                   ///< @required

  /// Name of the robot for load_robot(), followed by :variant if the file states a variant
  /// @undescribed
  std::string robot_name = {};

  /// Specification of the problem; read_problem_file() has checked that a Problem can be built
  /// @required
  ProblemSpec spec;
  DdpOptions solver = {};
  WarmStart guess = {};
};

/// Reads a problem file. Relative paths in the file start at the folder of the file. Throws Error
/// if the file is not valid. The message is one sentence with the file, the line, the nested keys
/// and the requirement.
ProblemFile read_problem_file(const std::filesystem::path& file);

/// Trajectory of states and controls that the solver starts from.
/// @described files @result
struct TrajectoryGuess {
  RowMatrix xs;  ///< States, (N + 1) x nx for N knots
  RowMatrix us;  ///< Controls, N x max_controls for N knots
};

/// Returns the trajectory that `start` describes. Throws Error if the trajectory file cannot be
/// read, lacks a column, or has another number of knots than the problem.
TrajectoryGuess make_guess(const Problem& problem, const WarmStart& start);

}  // namespace burnish
