// Problems with limits solved, limits laid around solutions, and what is independently known of
// whether limits can be kept.
#pragma once

#include <memory>

#include "burnish/files/problem_file.hpp"
#include "burnish/ocp/problem.hpp"
#include "burnish/solver/ddp.hpp"
#include "limit_problem.hpp"

namespace burnish::bench {

/// A problem file, compiled, with the trajectory to start from.
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

/// The optimum without limits; nothing where the solver does not find it within 25 iterations.
std::optional<TrajectoryGuess> solve_without_limits(const LimitProblem& problem);

/// The largest violation of a row along a trajectory, as a share of its scale, the first knot's
/// rows included.
double violation(Problem& limited, const TrajectoryGuess& at);
/// The largest entry by which a trajectory is not one of the problem.
double largest_gap(Problem& problem, const TrajectoryGuess& at);

/// Limits of these kinds that a trajectory keeps, by shares of each row's range that `margin`
/// draws. Nothing where there are none, as of a cone where the tool is pulled.
std::optional<std::vector<Limit>> limits_around(Draws& draws, const LimitProblem& problem,
                                                const TrajectoryGuess& trajectory,
                                                double least_margin, double most_margin);

/// Whether limits can be kept, from costs in their place: squares of violations, of growing weight.
struct Judgement {
  enum class Verdict { Feasible, Infeasible, Unclear };
  Verdict verdict = Verdict::Unclear;
  double start = 0.0;      ///< violation that the initial state alone decides
  double violation = 0.0;  ///< with the largest weight, as a share of a row's scale
  double before = 0.0;     ///< with a weight of a hundredth of that
  bool settled = false;    ///< the solve with the largest weight converged
};
Judgement judge(const LimitProblem& problem, Problem& limited);

}  // namespace burnish::bench
