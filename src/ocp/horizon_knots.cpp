#include "ocp/horizon_knots.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"

namespace burnish {
namespace ocp {
namespace {

/// Largest ratio of consecutive steps; its inverse is the smallest ratio. Chosen by hand.
constexpr double max_growth = 2.0;

/// Returns 1 + r + ... + r^(n - 1).
double geometric_sum(double r, int n) {
  double sum = 0.0;
  for (int i = 0; i < n; ++i) sum = sum * r + 1.0;
  return sum;
}

/// Returns the ratio r for which geometric_sum(r, n) is `sum`, by bisection.
double growth_for(double sum, int n) {
  double low = 1.0 / max_growth, high = max_growth;
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) return middle;
    (geometric_sum(middle, n) < sum ? low : high) = middle;
  }
}

[[noreturn]] void refuse(const HorizonSegment& segment, const std::string& what) {
  throw Error("horizon: stage " + in_quotes(segment.stage) + what);
}

/// Appends the steps of a segment with its own steps.
void append_steps(const HorizonSegment& segment, const Stage& stage, std::vector<double>& steps) {
  if (stage.impact)
    refuse(segment, " is an impact, in which no time passes; wanted no step and no duration");
  const auto check = [&](const char* what, double value) {
    if (!(value >= 0.0) || !std::isfinite(value))
      refuse(segment,
             std::string(" has a ") + what + " of " + number(value) + " s; wanted a positive time");
  };
  check("step", segment.step);
  check("duration", segment.duration);
  const double first = segment.step > 0.0 ? segment.step : stage.step;
  const auto n = to_size(segment.knots);
  const double even = segment.knots * first;
  constexpr double rounding = 1e-9;
  if (segment.duration == 0.0 || std::abs(segment.duration - even) <= rounding * even) {
    steps.insert(steps.end(), n, first);
    return;
  }
  const double sum = segment.duration / first;
  const double min_duration = geometric_sum(1.0 / max_growth, segment.knots) * first;
  const double max_duration = geometric_sum(max_growth, segment.knots) * first;
  if (!(segment.duration >= min_duration) || !(segment.duration <= max_duration))
    refuse(segment, " has a duration of " + number(segment.duration) + " s with " +
                        std::to_string(segment.knots) + " knots and a first step of " +
                        number(first) + " s; wanted " + number(min_duration) + " to " +
                        number(max_duration) +
                        " s, so that each step is between half and twice the step before");
  const double growth = growth_for(sum, segment.knots);
  double step = first;
  for (std::size_t i = 0; i < n; ++i, step *= growth) steps.push_back(step);
}

}  // namespace

HorizonKnots knots_of(const ProblemSpec& spec) {
  std::vector<std::string> names;
  std::unordered_map<std::string, int> index;
  for (const Stage& stage : spec.stages) {
    index.emplace(stage.name, static_cast<int>(names.size()));
    names.push_back(stage.name);
  }
  HorizonKnots result;
  for (const HorizonSegment& segment : spec.horizon) {
    const auto found = index.find(segment.stage);
    if (found == index.end())
      throw Error("horizon: unknown stage " + in_quotes(segment.stage) +
                  did_you_mean(segment.stage, names));
    if (segment.knots < 1)
      refuse(segment, " has " + std::to_string(segment.knots) + " knots; wanted at least 1");
    const auto count = to_size(segment.knots);
    if (count > max_knots - result.stages.size())
      throw Error("the horizon has more than " + std::to_string(max_knots) +
                  " knots, the maximum number");
    result.stages.insert(result.stages.end(), count, found->second);
    if (segment.has_own_steps())
      append_steps(segment, spec.stages[to_size(found->second)], result.own_steps);
    else
      result.own_steps.insert(result.own_steps.end(), count, 0.0);
  }
  if (result.stages.empty()) throw Error("the horizon has no knots; wanted at least one");
  return result;
}

}  // namespace ocp

std::vector<double> knot_steps(const ProblemSpec& spec) {
  const ocp::HorizonKnots knots = ocp::knots_of(spec);
  std::vector<double> steps = knots.own_steps;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const Stage& stage = spec.stages[to_size(knots.stages[k])];
    if (steps[k] == 0.0 && !stage.impact) steps[k] = stage.step;
  }
  return steps;
}

}  // namespace burnish
