#include "burnish/tasks/polishing/force_profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/sentence.hpp"
#include "burnish/base/error.hpp"
#include "polishing/descriptions.hpp"

namespace burnish::polishing {
namespace {

using Kind = ForceProfile::Kind;

bool has_points(Kind kind) { return kind == Kind::Steps || kind == Kind::Lines; }

}  // namespace

std::string name_of(ForceProfile::Kind kind) {
  return words_of(kind).words[static_cast<std::size_t>(kind)].word;
}

double ForceProfile::at(double force, double t) const noexcept {
  if (kind == Kind::Sine)
    return force +
           amplitude * std::sin(2.0 * std::numbers::pi * frequency * std::max(0.0, t - start));
  if (!has_points(kind)) return force;
  constexpr double rounding = 1e-9;  // s: a clock is a sum of many periods
  const auto next =
      std::upper_bound(points.begin(), points.end(), t + rounding,
                       [](double now, const Eigen::Vector2d& point) { return now < point.x(); });
  const Eigen::Vector2d before =
      next == points.begin() ? Eigen::Vector2d(0.0, force) : *std::prev(next);
  if (kind == Kind::Steps || next == points.end() || t <= before.x()) return before.y();
  const double share = (t - before.x()) / (next->x() - before.x());
  return before.y() + share * (next->y() - before.y());
}

double ForceProfile::least(double force) const {
  if (kind == Kind::Sine) return force - amplitude;
  double least = force;
  if (has_points(kind))
    for (const Eigen::Vector2d& point : points) least = std::min(least, point.y());
  return least;
}

double ForceProfile::most(double force) const {
  if (kind == Kind::Sine) return force + amplitude;
  double most = force;
  if (has_points(kind))
    for (const Eigen::Vector2d& point : points) most = std::max(most, point.y());
  return most;
}

void ForceProfile::check(double force) const {
  const auto refuse = [](const std::string& what) { throw Error("force_profile: " + what); };
  if (kind == Kind::Sine && !(least(force) > 0.0))
    refuse("an amplitude of " + number(amplitude) + " N about " + number(force) +
           " N pulls at times; wanted less than the force");
  if (!has_points(kind)) return;
  if (points.empty()) refuse("it is " + name_of(kind) + " without points; wanted [[s, N], ...]");
  double before = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string which = "points[" + std::to_string(i) + "] ";
    const double time = points[i].x();
    if (!points[i].allFinite()) refuse(which + "is not finite");
    const bool first = i == 0;
    if (first ? time < 0.0 : !(time > before))
      refuse(which + "is at " + number(time) + " s; wanted " +
             (first ? "no time below 0, when the path begins"
                    : "more than the " + number(before) + " s of the one before"));
    if (!(points[i].y() > 0.0))
      refuse(which + "is a force of " + number(points[i].y()) + " N; wanted more than 0");
    before = time;
  }
}

}  // namespace burnish::polishing
