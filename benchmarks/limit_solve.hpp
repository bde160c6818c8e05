// Solves of problems with limits, limits around solutions, and an independent test of feasibility.
#pragma once

#include <memory>

#include "burnish/files/problem_file.hpp"
#include "burnish/ocp/problem.hpp"
#include "burnish/solver/ddp.hpp"
#include "limit_problem.hpp"

namespace burnish::bench {

/// Compiled problem file with its initial guess.
class Case {
 public:
  Case(const LimitProblem& problem, const TextForm& form);

  Problem& problem() { return *problem_; }
  const ProblemFile& file() const { return file_; }
  const TrajectoryGuess& guess() const { return guess_; }

 private:
  ProblemFile file_;
  std::unique_ptr<Problem> problem_;
  TrajectoryGuess guess_;
};

/// Returns the optimum without limits, or nothing if the solver needs more than 25 iterations.
std::optional<TrajectoryGuess> solve_without_limits(const LimitProblem& problem);

/// Returns the largest violation of a row along a trajectory, as a fraction of the row's scale.
/// Rows of the first knot are included.
double violation(Problem& limited, const TrajectoryGuess& at);
/// Returns the largest entry of the gaps between the knots of a trajectory.
double largest_gap(Problem& problem, const TrajectoryGuess& at);

/// Draws limits of the problem's kinds that a trajectory satisfies. The distance of the trajectory
/// to a limit is a random fraction of the row's range, from `min_margin` to `max_margin`. Returns
/// nothing if no such limits exist, for example no friction cone for a pulled tool.
std::optional<std::vector<Limit>> limits_around(Draws& draws, const LimitProblem& problem,
                                                const TrajectoryGuess& trajectory,
                                                double min_margin, double max_margin);

/// Feasibility of limits, judged by solves in which quadratic penalties of increasing weight
/// replace the limits.
struct Judgement {
  enum class Verdict { Feasible, Infeasible, Unclear };
  Verdict verdict = Verdict::Unclear;
  double start = 0.0;      ///< Violation at the first knot that depends only on the initial state.
  double violation = 0.0;  ///< Violation with the largest weight, as a fraction of a row's scale.
  double before = 0.0;     ///< Violation with the last but one weight, in the same unit.
  bool settled = false;    ///< True if the solve with the largest weight converged.
};
Judgement judge(const LimitProblem& problem, Problem& limited);

}  // namespace burnish::bench
