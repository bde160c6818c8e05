// Why a solve ended and what it reached.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "burnish/base/status.hpp"
#include "burnish/solver/options.hpp"
#include "burnish/solver/shooting_problem.hpp"

namespace burnish {

enum class StopReason {
  Converged,            ///< feasible, and the expected improvement is below stop_tolerance
  MaxIterations,        ///< max_iterations were made
  TimeBudget,           ///< time_budget was spent
  NotEvaluated,         ///< a knot of the iterate cannot be evaluated: see status, knot, term
  NotPositiveDefinite,  ///< Quu of a knot, with the largest regularisation
  NoStep,               ///< no step length was acceptable, with the largest regularisation
  Callback,             ///< the callback asked for it
};

/// Seconds of a solve by phase.
struct PhaseTimes {
  double expand = 0.0;    ///< values and derivatives
  double backward = 0.0;  ///< Riccati recursion
  double trial = 0.0;     ///< rollouts and evaluations of the line search
  double total = 0.0;
};

struct DdpSummary {
  StopReason reason = StopReason::MaxIterations;
  int iterations = 0;  ///< line searches made
  double cost = 0.0;   ///< of the trajectory that is returned
  bool feasible = false;
  double expected_improvement = 0.0;  ///< the last one computed
  double regularization = 0.0;        ///< the last one used
  double largest_gap = 0.0;           ///< of the trajectory that is returned
  int gap_knot = 0;   ///< where: the state that the gap leads to, 0 for the initial one
  int gap_entry = 0;  ///< entry of dx
  /// NotEvaluated, NotPositiveDefinite, and NoStep where the last trial could not be evaluated:
  /// where and what.
  Status status = Status::Ok;
  int knot = -1;
  int term = -1;                ///< cost term that is not finite, -1: none, a row or the dynamics
  int row = -1;                 ///< row of a constraint that is not finite, -1: none
  bool in_derivatives = false;  ///< NotEvaluated: values are finite, derivatives are not
  int control = -1;             ///< NotPositiveDefinite: the first one whose pivot is not positive
  DdpOptions options;           ///< those it was solved with, without callback
  PhaseTimes seconds;
  std::vector<DdpProgress> log;  ///< an entry per iteration

  /// One sentence that says why the solver stopped, with names from the problem.
  std::string text(const ShootingProblem& problem) const;
};

/// Where a cost comes from.
struct CostReport {
  struct Entry {
    std::string name;
    double cost;
  };
  struct Knot {
    std::string name;
    double cost;
    std::vector<Entry> terms;
  };
  /// A row with limits, where it is furthest outside them, or nearest to one of them from inside.
  struct Row {
    std::string name;  ///< as the problem's row_names
    std::string knot;  ///< as the problem's knot_name
    double value, lower, upper;
    double outside;  ///< how far; negative: the least distance to a limit from inside
  };
  double total = 0.0;
  std::vector<Entry> terms;  ///< summed over knots, in order of appearance
  std::vector<Knot> knots;   ///< N + 1
  std::vector<Row> rows;     ///< over all knots, in order of appearance

  /// A table for people: terms from the largest down, the five most expensive knots, and the five
  /// rows that are furthest outside their limits.
  std::string text() const;
};

}  // namespace burnish
