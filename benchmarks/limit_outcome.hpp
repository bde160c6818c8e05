// Random problems with limits by their seeds, and the outcomes of their solves.
#pragma once

#include "limit_solve.hpp"

namespace burnish::bench {

/// Feasibility of a problem, by construction or by judge().
enum class Sort {
  Near,        ///< Feasible by construction: limits around the optimum without limits.
  Beyond,      ///< Feasible by construction: limits that the optimum without limits violates.
  Feasible,    ///< Free limits, found feasible by judge() or by the solve.
  Infeasible,  ///< Free limits, found infeasible by judge().
  Unclear,     ///< Free limits of undecided feasibility.
};
inline constexpr Sort sorts[] = {Sort::Near, Sort::Beyond, Sort::Feasible, Sort::Infeasible,
                                 Sort::Unclear};
std::string_view name_of(Sort sort);

struct OutcomeOptions {
  int iterations = 50;
  bool shooting = false;   ///< True for multiple shooting, false for rollouts.
  bool verbose = false;    ///< True to print every iteration.
  std::string write = {};  ///< File to write the problem to; empty: none.
  RobotChoice choice = {};
};

struct Outcome {
  std::uint64_t seed = 0;
  LimitProblem problem = {};
  Sort sort = Sort::Near;
  StopReason reason = StopReason::MaxIterations;
  int iterations = 0;
  double seconds = 0.0;
  double violation = 0.0;       ///< Largest final violation, as a fraction of the row's scale.
  double gap = 0.0;             ///< Largest final gap.
  int cut_short = 0;            ///< Number of iterations whose LQ problem used up its recursions.
  int zero_steps = 0;           ///< Number of iterations without an acceptable step.
  double regularization = 0.0;  ///< Largest regularization over all iterations.
  Judgement judgement = {};
  std::string text = {};  ///< Result of the solver in one sentence.

  bool by_construction() const { return sort == Sort::Near || sort == Sort::Beyond; }
  bool can_be_kept() const { return by_construction() || sort == Sort::Feasible; }
  bool converged() const { return reason == StopReason::Converged; }
  bool called_infeasible() const { return reason == StopReason::Infeasible; }
  bool ended() const { return converged() || called_infeasible(); }
  bool is_wrongly_converged() const;  ///< True if converged with a violation or a gap.
  bool is_wrong() const { return is_wrongly_converged() || (can_be_kept() && called_infeasible()); }
  bool failed() const { return is_wrong() || !ended(); }
  std::string text_of_problem() const;  ///< Description of the problem in one line.
};

/// Solves the problem of a seed. Even seeds give problems that are feasible by construction, odd
/// seeds problems with free limits.
Outcome run_seed(std::uint64_t seed, const OutcomeOptions& options);

}  // namespace burnish::bench
