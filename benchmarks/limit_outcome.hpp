// A random problem with limits by its seed, solved, and how that ended.
#pragma once

#include "limit_solve.hpp"

namespace burnish::bench {

/// What is known of a problem before it is solved.
enum class Sort {
  Near,        ///< limits around the optimum that there is without them
  Beyond,      ///< limits around another trajectory, which leave that optimum outside
  Feasible,    ///< a free draw, judged, or solved
  Infeasible,  ///< a free draw, judged
  Unclear,     ///< a free draw that judgement says nothing of
};
inline constexpr Sort sorts[] = {Sort::Near, Sort::Beyond, Sort::Feasible, Sort::Infeasible,
                                 Sort::Unclear};
std::string_view name_of(Sort sort);

struct OutcomeOptions {
  int iterations = 50;
  bool shooting = false;   ///< multiple shooting in the place of rollouts
  bool verbose = false;    ///< prints every iteration
  std::string write = {};  ///< leaves the problem in this file
  RobotChoice choice = {};
};

struct Outcome {
  std::uint64_t seed = 0;
  LimitProblem problem = {};
  Sort sort = Sort::Near;
  StopReason reason = StopReason::MaxIterations;
  int iterations = 0;
  double seconds = 0.0;
  double violation = 0.0;       ///< of the end, the largest as a share of a row's scale
  double gap = 0.0;             ///< of the end
  int cut_short = 0;            ///< iterations whose linear-quadratic problem spent its recursions
  int zero_steps = 0;           ///< iterations without an acceptable step
  double regularization = 0.0;  ///< the largest
  Judgement judgement = {};
  std::string text = {};  ///< the solver's sentence

  bool by_construction() const { return sort == Sort::Near || sort == Sort::Beyond; }
  bool can_be_kept() const { return by_construction() || sort == Sort::Feasible; }
  bool converged() const { return reason == StopReason::Converged; }
  bool called_infeasible() const { return reason == StopReason::Infeasible; }
  bool ended() const { return converged() || called_infeasible(); }
  bool is_wrongly_converged() const;  ///< outside its limits, or no trajectory
  bool is_wrong() const { return is_wrongly_converged() || (can_be_kept() && called_infeasible()); }
  bool failed() const { return is_wrong() || !ended(); }
  std::string text_of_problem() const;  ///< one line
};

/// Even seeds make problems that are feasible by construction, odd ones free draws.
Outcome run_seed(std::uint64_t seed, const OutcomeOptions& options);

}  // namespace burnish::bench
