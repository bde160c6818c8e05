#include "burnish/solver/options.hpp"

#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

#include "burnish/base/error.hpp"
#include "solver/descriptions.hpp"

namespace burnish {
namespace {

void require(bool holds, std::string_view name, double value, std::string_view wanted) {
  if (holds) return;
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  throw Error("solver options: " + std::string(name) + " is " + text + "; wanted " +
              std::string(wanted));
}

void require_positive(double value, std::string_view name) {
  require(std::isfinite(value) && value > 0.0, name, value, "a number > 0");
}

void require_nonnegative(double value, std::string_view name) {
  require(std::isfinite(value) && value >= 0.0, name, value, "a number >= 0");
}

void require_fraction(double value, std::string_view name) {
  require(value >= 0.0 && value < 1.0, name, value, "a number from 0 to below 1");
}

}  // namespace

void DdpOptions::check() const {
  require(max_iterations >= 0, "max_iterations", max_iterations, "0 or more");
  require(time_budget >= 0.0, "time_budget", time_budget, "seconds >= 0");
  require(threads >= 1 && threads <= 1024, "threads", threads, "1 to 1024");
  require(segments >= 1 && segments <= 1024, "segments", segments, "1 to 1024");
  require_nonnegative(stop_tolerance, "stop_tolerance");
  require_nonnegative(gap_tolerance, "gap_tolerance");
  require(line_search.halvings >= 0 && line_search.halvings <= 60, "line_search.halvings",
          line_search.halvings, "0 to 60");
  require_fraction(line_search.sufficient_decrease, "line_search.sufficient_decrease");
  require_nonnegative(line_search.allowed_increase, "line_search.allowed_increase");
  require_fraction(line_search.merit_decrease, "line_search.merit_decrease");
  require_fraction(line_search.merit_share, "line_search.merit_share");
  require_nonnegative(line_search.rounding, "line_search.rounding");
  require_nonnegative(regularization.initial, "regularization.initial");
  require_positive(regularization.smallest, "regularization.smallest");
  require(
      std::isfinite(regularization.largest) && regularization.largest >= regularization.smallest,
      "regularization.largest", regularization.largest,
      "a number that is at least regularization.smallest");
  require(std::isfinite(regularization.factor) && regularization.factor > 1.0,
          "regularization.factor", regularization.factor, "a number > 1");
}

const Words& words_of(StepUpdate /*of*/) {
  static const Words all{
      "solver",
      "StepUpdate",
      "How a direction becomes the next iterate.",
      {{"rollout",
        "The controls' policy is rolled out through the dynamics; gaps shrink by 1 - alpha. After "
        "a "
        "step of length 1 the trajectory is feasible and stays so (feasibility-driven DDP)."},
       {"multiple_shooting",
        "States and controls move along the solution of the linear-quadratic problem; every knot "
        "is "
        "evaluated on its own, in packs and threads. Gaps vanish with convergence."}}};
  return all;
}

}  // namespace burnish
