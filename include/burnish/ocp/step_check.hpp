// Are the steps of a plan short enough? A solver sees the discretised problem alone, and finds it
// converged and feasible whatever the step.
#pragma once

#include <string>
#include <vector>

#include "burnish/ocp/problem.hpp"

namespace burnish {

/// How far the end of one step of a plan is from the motion that small steps lead to.
/// @described ocp @result
struct StepError {
  int knot = -1;           ///< at which the step begins; -1: no time passes in the problem
  std::string place = {};  ///< the knot's name, such as "press, knot 3"
  double time = 0.0;       ///< [s], of that knot
  double step = 0.0;       ///< [s]
  std::string entry = {};  ///< the entry of v, as the model names it
  std::string unit = {};   ///< "rad" or "m"; of velocities "rad/s" or "m/s"
  double error = 0.0;      ///< size, in that unit
  double limit = 0.0;      ///< largest error that is no warning, in that unit
};

/// What check_steps() found: the largest error of a position and of a velocity, of those above
/// their limits where there are any.
/// @described ocp @result
struct StepReport {
  /// ok, or why the errors of `knot` cannot be computed: the smallest steps do not agree, a number
  /// is not finite, or what the contacts say
  Status status = Status::Ok;
  int knot = -1;            ///< the first one with that status; -1: none
  StepError position = {};  ///< by the model's difference
  StepError velocity = {};
  bool coarse = false;  ///< an error is above its limit, or cannot be computed
  /// [s], a step that would do at the worst knot; 0: not coarse, or none was found
  double step_enough = 0.0;

  /// One sentence with both errors.
  std::string text() const;
  /// One sentence that says where and by how much the steps are too coarse; empty: they are not.
  std::string warning() const;
};

/// Integrates every knot of a trajectory (xs: (N + 1) x nx, us: N x max_controls) again in small
/// steps, from its state, with its control held, and its contacts, friction, springs and torque
/// filter as the stage has them, and compares with the problem's own step. The small steps are of
/// fourth order; they are halved until halving changes the end by less than a fiftieth of the error
/// or of its limit. Impacts take no time and are not compared.
///
/// Limits, with the largest speed of the same entry of v in the trajectory:
///  - position: 0.01 rad (m), or the distance in 25 ms at that speed if that is larger. A smaller
///    delay is within those of a robot's own control loops, and semi-implicit steps of up to 50 ms
///    keep it: the velocity that they move with is half a step ahead;
///  - velocity: 0.1 rad/s (m/s), or a tenth of that speed if that is larger.
/// Throws Error for other sizes.
StepReport check_steps(const Problem& problem, const MatrixView& xs, const MatrixView& us);

/// Returns a sentence for each stage whose explicit steps are unstable or overshoot at the initial
/// state; empty if there is none. complaints() contains them.
///  - gains of contacts with which an error of the contact grows from step to step;
///  - friction of a tool that fades below the speed that it takes from the tool in one step;
///  - friction of joints, where it acts, whose slip velocity is below what it takes in one step;
///  - damping and springs of joints that make a joint swing more and more.
std::vector<std::string> step_complaints(const Problem& problem);

}  // namespace burnish
