// Checks of an optimal control problem. The derivatives are compared with finite differences.
// Conditions that no solver can cope with are reported as sentences.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "burnish/derivatives/check.hpp"
#include "burnish/ocp/problem.hpp"

namespace burnish {

/// Options of check_problem(): the random states, and the largest accepted error of a derivative.
/// @described ocp
struct ProblemCheckOptions {
  int states = 3;  ///< Number of random states per stage, at least 1

  /// Seed of the random states; equal seeds give equal states on every machine
  std::uint64_t seed = 1;
  /// Largest accepted error of a derivative, relative to the largest entry of its block
  /// @more The error is |derivative - finite difference|. An example of a block is dnext_dq
  double tolerance = 1e-6;

  /// States around which random states are drawn; empty: the initial state at every knot
  /// @more One state per knot: N + 1 vectors of nx entries
  std::vector<Eigen::VectorXd> x = {};
  /// Controls around which random controls are drawn; empty: controls that hold the robot at rest
  /// @more N vectors of nu entries. Vectors for impacts are ignored
  std::vector<Eigen::VectorXd> u = {};
  /// Largest random change of a position, uniformly distributed [rad, m]
  /// @more For lengths, the value is multiplied by the robot's size in m, rounded to a power of ten
  double position = 0.2;
  double velocity = 0.5;  ///< Largest random change of a velocity [rad/s], or in m/s

  /// Largest random change of a control or of a torque in the state [Nm], or in N
  /// @more The value is for a robot of 20 kg and 1 m. For other robots, it is scaled with the
  /// robot's weight. In Nm, it is also scaled with the robot's size
  double torque = 5.0;

  /// Function called after each stage, with the number of finished stages and the number of all
  /// stages.
  std::function<void(int done, int total)> progress = {};
};

/// Result of check_problem() for one function of one stage, over all random states of the stage.
/// The function is the next state, one term, or the sum of the costs.
/// @described ocp @result
struct ProblemCheckRow {
  std::string stage;
  std::string term;  ///< "next state", "all costs", or the name of a cost term or a constraint
  int states = 0;    ///< Number of states at which the derivatives were compared

  /// Largest error, relative to the largest entry of the derivative block; infinite if a NaN
  /// occurred
  double worst_error = 0.0;
  /// Entry with the largest error, in a derivative block such as "dnext_dq", "dr_du" or "dcost_dv"
  CheckEntry worst = {};
  bool pass = false;  ///< True if worst_error <= tolerance
};

/// Result of check_problem().
/// @described ocp @result
struct ProblemReport {
  std::string robot;
  std::vector<ProblemCheckRow> rows;
  double tolerance = 0.0;
  bool pass = false;  ///< True if there is at least one row and every row passes

  /// Returns a table of all rows, the worst entry of each row that fails, and the verdict.
  std::string text() const;
};

/// Compares the derivatives of a problem with finite differences of its values, at random states.
/// The check covers every stage of the specification and the terminal knot. It covers the
/// derivatives with respect to z = (du, dq, dv, dtau, dforce) of
///  - the next state, as expand() returns it,
///  - every residual of a cost or a constraint, and every constraint row as expand() returns it,
///  - every cost term, and the sum of the costs as expand() returns it.
/// The values come from roll() and residual(). Differences are central differences at three step
/// lengths, extrapolated (Richardson). If the three results disagree, differences with smaller
/// steps follow.
///
/// The random states of a stage are distributed over the stage's knots, so that targets over time
/// are checked, too. A stage that the horizon does not contain is checked at knot 0. Afterwards
/// knot 0 has its own stage again, with targets from the signals of the stage. A state is skipped
/// if rigid contacts are close to singular (condition of J M^-1 J^T above 1e5). A state is also
/// skipped if a rotation residual is within 0.1 rad of half a turn. Gradients of a cost are skipped
/// near a breakpoint of a barrier. There they are continuous, but finite differences are not exact.
///
/// Throws Error with one sentence if an option is invalid, or if no state of a stage can be
/// evaluated.
ProblemReport check_problem(Problem& problem, const ProblemCheckOptions& options = {});

/// Returns sentences about obstacles to a good solution of the problem; empty if there are none.
/// Targets are examined for the current horizon. Each sentence reports one of these obstacles:
///  - targets that are not finite, and quaternions over time that are not of unit length;
///  - target positions out of reach of a frame: further from the first joint than the sum of the
///    distances between the joints (not checked for robots that fly, drive or slide without limit);
///  - an initial state outside the joint limits of position, velocity or torque;
///  - control bounds that are too narrow to hold the initial posture at rest;
///  - springs and tendons of the robot that the actuation omits;
///  - a contact of the first stage that starts more than 1 mm away from the surface that its axes
///    follow;
///  - joints that move no mass at the initial posture;
///  - contacts of a stage that are redundant at the initial posture, if mu of the contact solver is
///    zero;
///  - contacts of a stage that contradict each other at the initial state, if mu > 0;
///  - explicit time steps of a stage that are too long: see step_complaints().
std::vector<std::string> complaints(const Problem& problem);

}  // namespace burnish
