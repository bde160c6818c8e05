// Check of the time steps of a plan. A solver sees the discretized problem only. It converges to a
// feasible plan for any step, even for a step that is too long.
#pragma once

#include <string>
#include <vector>

#include "burnish/ocp/problem.hpp"

namespace burnish {

/// Discretization error of one step of a plan: the difference between the end of this step and the
/// end of an integration with small steps.
/// @described ocp @result
struct StepError {
  int knot = -1;           ///< Knot at which the step begins; -1: no step was examined
  std::string place = {};  ///< Name of the knot, such as "press, knot 3"
  double time = 0.0;       ///< Time at which the step begins [s]
  double step = 0.0;       ///< Duration of the step [s]
  std::string entry = {};  ///< Name of the entry of v that has the error
  std::string unit = {};   ///< Unit of the error: "rad" or "m"; for velocities "rad/s" or "m/s"
  double error = 0.0;      ///< Largest absolute error, in the unit of the entry

  /// Limit of the error, in the unit of the error; a larger error causes a warning
  double limit = 0.0;
};

/// Result of check_steps(): the worst position error and the worst velocity error. Any error above
/// its limit is worse than any error within its limit; other errors are compared by size.
/// @described ocp @result
struct StepReport {
  /// Status ok, or the reason why the errors of `knot` cannot be computed
  /// @more Not converged: the results of the smallest steps still differ. Other reasons: a number
  /// is not finite, or the contacts cannot be solved
  Status status = Status::Ok;
  int knot = -1;            ///< First knot whose errors cannot be computed; -1: none
  StepError position = {};  ///< Worst position error, as a difference of configurations
  StepError velocity = {};
  bool coarse = false;  ///< True if an error exceeds its limit or cannot be computed

  /// Sufficient step at the worst knot (0: all steps are short enough, or none was found) [s]
  double sufficient_step = 0.0;

  /// Returns one sentence with both errors.
  std::string text() const;
  /// Returns one sentence that says where and by how much the steps are too long. Empty if the
  /// steps are short enough.
  std::string warning() const;
};

/// Estimates the discretization errors of a trajectory (xs: (N + 1) x nx, us: N x max_controls).
/// Each knot is integrated again from its state, with constant control, by a fourth-order method
/// with small steps. The final state is compared with the final state of the problem's own step.
/// Contacts, friction, springs and the torque filter are as in the knot's stage. The small steps
/// are halved until the final state no longer changes by more than a fiftieth of the error or of
/// its limit. Impacts take no time and are not compared.
///
/// The limit of an error depends on the largest speed that the entry of v reaches in the
/// trajectory:
///  - position: 0.01 rad (m) or, if larger, the distance travelled in 25 ms at this largest speed.
///    Delays in control loops of robots are about 25 ms, too. Semi-implicit steps of up to 50 ms
///    satisfy the limit, since their position error is about half a step of motion;
///  - velocity: 0.1 rad/s (m/s) or, if larger, a tenth of this largest speed.
/// Throws Error for matrices of other sizes.
StepReport check_steps(const Problem& problem, const MatrixView& xs, const MatrixView& us);

/// Returns sentences about explicit time steps that are unstable or overshoot at the initial state,
/// one for each stage and cause; empty if there are none. complaints() contains the sentences.
/// Possible causes are
///  - contact gains with which a contact error grows from step to step;
///  - tool friction that slows the tool by more than the fade speed of the friction in one step;
///  - joint friction that slows a joint by more than the slip velocity in one step, if joint
///    friction acts;
///  - joint damping and springs with which the oscillation of a joint grows.
std::vector<std::string> step_complaints(const Problem& problem);

}  // namespace burnish
