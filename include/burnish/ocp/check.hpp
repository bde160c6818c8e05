// Is a problem right, and can it be solved? Derivatives of every stage and cost term against
// differences of the values alone, and sentences about what no solver can do.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "burnish/derivatives/check.hpp"
#include "burnish/ocp/problem.hpp"

namespace burnish {

/// How check_problem() looks.
/// @described ocp
struct ProblemCheckOptions {
  int states = 3;           ///< random states per stage, at least 1
  std::uint64_t seed = 1;   ///< the same seed gives the same states on every machine
  double tolerance = 1e-6;  ///< on |derivative - difference| over the block's largest entry

  /// Trajectory to draw around: N + 1 states (nx) and N controls (nu; those of impacts are not
  /// read). Empty: the initial state, and the control that holds it at rest.
  std::vector<Eigen::VectorXd> x = {};
  std::vector<Eigen::VectorXd> u = {};
  /// How far states are drawn from it, uniformly, for a robot of 1 m and 20 kg: lengths grow with
  /// its size, torques and forces with its weight. rad, m
  double position = 0.2;
  double velocity = 0.5;  ///< [rad/s], m/s
  double torque = 5.0;    ///< [Nm], N: controls, and torques in the state

  /// Called after each stage with the number of stages done and the number of all stages.
  std::function<void(int done, int total)> progress = {};
};

/// The next state, one cost term or the costs together, of one stage at all its states.
/// @described ocp @result
struct ProblemCheckRow {
  std::string stage;
  std::string term;  ///< name of a cost term or a constraint, "next state" or "all costs"
  int states = 0;
  double worst_error = 0.0;  ///< relative to the block's largest entry; infinite after a NaN
  CheckEntry worst = {};     ///< blocks: such as "dnext_dq", "dr_du", "dcost_dv"
  bool pass = false;         ///< worst_error <= tolerance
};

/// What check_problem() found.
/// @described ocp @result
struct ProblemReport {
  std::string robot;
  std::vector<ProblemCheckRow> rows;
  double tolerance = 0.0;
  bool pass = false;  ///< there are rows, and all of them pass

  /// A table of all rows, the worst entries of those that fail, and the verdict.
  std::string text() const;
};

/// Compares at random states, for every stage of the specification and the terminal state,
///  - the next state by z = (u, q, v, tau), as expand() gives it,
///  - every residual by z, and the gradient of its cost; of a constraint the rows as expand() gives
///    them,
///  - the gradient of all costs together, as expand() gives it,
/// with differences of what roll() and residual() say: central differences at three steps,
/// extrapolated (Richardson), again at smaller steps where the three disagree.
///
/// States are spread over the knots of a stage, so that targets over time take part. A stage that
/// is on no knot borrows knot 0, whose targets are then those of its signals again. States are
/// passed over where rigid contacts are close to singular (condition of J M^-1 J^T above 1e5), or
/// a rotation residual is within 0.1 rad of half a turn. Gradients are passed over where a barrier
/// has its seam: they are continuous there, but their differences are not exact.
///
/// Throws Error with one sentence for options that cannot be used, and when the states of a stage
/// cannot be evaluated.
ProblemReport check_problem(Problem& problem, const ProblemCheckOptions& options = {});

/// Sentences about what will not go well; empty when nothing was found:
///  - targets that are not finite, quaternions over time that are not of unit length;
///  - positions that a frame cannot reach: further from the first joint than the joints' origins
///    are apart (never said of robots that fly, drive or slide without limit);
///  - an initial state outside the limits of joints: position, velocity, torque;
///  - control bounds that cannot hold the initial posture at rest;
///  - joints that move no mass at the initial posture;
///  - contacts of a stage that are redundant at the initial posture while the solver has mu = 0, or
///    that contradict each other at the initial state while it has mu > 0;
///  - what the steps of a stage are too long for: step_complaints().
/// Targets are those of the present horizon.
std::vector<std::string> complaints(const Problem& problem);

}  // namespace burnish
