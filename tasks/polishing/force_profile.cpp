#include "burnish/tasks/polishing/force_profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "polishing/descriptions.hpp"

namespace burnish::polishing {
namespace {

using Kind = ForceProfile::Kind;

bool has_points(Kind kind) { return kind == Kind::Steps || kind == Kind::Lines; }

}  // namespace

std::string name_of(ForceProfile::Kind kind) { return words_of(kind).words[to_size(kind)].word; }

double ForceProfile::at(double force, double t) const noexcept {
  if (kind == Kind::Sine)
    return force +
           amplitude * std::sin(2.0 * std::numbers::pi * frequency * std::max(0.0, t - start));
  if (!has_points(kind)) return force;
  constexpr double rounding = 1e-9;  // largest rounding error of a clock that sums periods [s]
  const auto next =
      std::upper_bound(points.begin(), points.end(), t + rounding,
                       [](double now, const Eigen::Vector2d& point) { return now < point.x(); });
  const Eigen::Vector2d before =
      next == points.begin() ? Eigen::Vector2d(0.0, force) : *std::prev(next);
  if (kind == Kind::Steps || next == points.end() || t <= before.x()) return before.y();
  const double fraction = (t - before.x()) / (next->x() - before.x());
  return before.y() + fraction * (next->y() - before.y());
}

double ForceProfile::min_force(double force) const {
  if (kind == Kind::Sine) return force - amplitude;
  double min_force = force;
  if (has_points(kind))
    for (const Eigen::Vector2d& point : points) min_force = std::min(min_force, point.y());
  return min_force;
}

double ForceProfile::max_force(double force) const {
  if (kind == Kind::Sine) return force + amplitude;
  double max_force = force;
  if (has_points(kind))
    for (const Eigen::Vector2d& point : points) max_force = std::max(max_force, point.y());
  return max_force;
}

void ForceProfile::check(double force) const {
  const auto refuse = [](const std::string& what) { throw Error("force_profile: " + what); };
  if (kind == Kind::Sine && !(min_force(force) > 0.0))
    refuse("an amplitude of " + number(amplitude) + " N about " + number(force) +
           " N makes the force zero or negative at times; wanted an amplitude below the force");
  if (!has_points(kind)) return;
  if (points.empty())
    refuse("kind " + name_of(kind) + " has no points; wanted points: [[s, N], ...]");
  double before = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string which = "points[" + std::to_string(i) + "] ";
    const double time = points[i].x();
    if (!points[i].allFinite()) refuse(which + "is not finite");
    const bool first = i == 0;
    if (first ? time < 0.0 : !(time > before))
      refuse(which + "is at " + number(time) + " s; wanted " +
             (first ? "at least 0 s, the start of the path"
                    : "more than " + number(before) + " s, the time of the previous point"));
    if (!(points[i].y() > 0.0))
      refuse(which + "is a force of " + number(points[i].y()) + " N; wanted more than 0 N");
    before = time;
  }
}

}  // namespace burnish::polishing
