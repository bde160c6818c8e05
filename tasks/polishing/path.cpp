#include "burnish/tasks/polishing/path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "polishing/descriptions.hpp"

namespace burnish::polishing {
namespace {

constexpr int max_rows = 10'000;  // largest number of rows of a zigzag; chosen by hand

/// Smooth motion from 0 to 1 in unit time. Speed and acceleration are zero at both ends.
struct Blend {
  double value, rate, curvature;
};
Blend blend(double s) {
  if (s <= 0.0) return {0.0, 0.0, 0.0};
  if (s >= 1.0) return {1.0, 0.0, 0.0};
  return {s * s * s * (10.0 + s * (-15.0 + 6.0 * s)), 30.0 * s * s * (1.0 - s) * (1.0 - s),
          60.0 * s * (1.0 - s) * (1.0 - 2.0 * s)};
}

/// Limits of lengths, speeds and rates. With larger values, a path has too many points or takes too
/// long to check. Chosen by hand.
constexpr double max_length = 100.0, min_length = 1e-6;  // lengths [m] and speeds [m/s]
constexpr double max_rate = 1e4;                         // angular rate of circles [rad/s]

void positive(double value, const char* name) {
  if (!(value > 0.0) || !std::isfinite(value))
    throw Error("path: " + std::string(name) + " is " + number(value) +
                "; wanted a positive number");
}

/// Throws Error for a length or speed that is out of range.
void within_reason(double value, const char* name) {
  positive(value, name);
  if (value < min_length || value > max_length)
    throw Error("path: " + std::string(name) + " is " + number(value) + "; wanted a number from " +
                number(min_length) + " to " + number(max_length));
}

/// Returns the point with polar coordinates r(t) and angle(t), and its time derivatives.
PlanarPoint polar(double r, double dr, double ddr, double angle, double w, double dw) {
  const Eigen::Vector2d e(std::cos(angle), std::sin(angle)), n(-e.y(), e.x());
  return {r * e, dr * e + r * w * n, (ddr - r * w * w) * e + (2.0 * dr * w + r * dw) * n};
}

}  // namespace

std::string name_of(PathKind kind) { return words_of(kind).words[to_size(kind)].word; }

PathKind parse_path(const std::string& name) {
  return static_cast<PathKind>(words_of(PathKind{}).value_of(name));
}

Path::Path(const PathSpec& spec) : spec_(spec), duration_(std::numeric_limits<double>::infinity()) {
  switch (spec.kind) {
    case PathKind::Circle:
      within_reason(spec.radius, "radius");
      positive(spec.start_up, "start_up");
      if (!(std::abs(spec.rate) <= max_rate))
        throw Error("path: rate is " + number(spec.rate) + "; wanted a finite number of at most " +
                    number(max_rate));
      break;
    case PathKind::Spiral:
      positive(spec.start_up, "start_up");
      within_reason(spec.radius, "radius");
      within_reason(spec.pitch, "pitch");
      positive(spec.rate, "rate");
      if (spec.rate > max_rate)
        throw Error("path: rate is " + number(spec.rate) + "; wanted a finite number of at most " +
                    number(max_rate));
      break;
    case PathKind::ZigZag: {
      within_reason(spec.width, "width");
      within_reason(spec.height, "height");
      within_reason(spec.speed, "speed");
      if (spec.rows < 2)
        throw Error("path: rows is " + std::to_string(spec.rows) + "; wanted at least 2");
      if (spec.rows > max_rows)
        throw Error("path: rows is " + std::to_string(spec.rows) + "; wanted at most " +
                    std::to_string(max_rows));
      corners_.emplace_back(0.0, 0.0);
      for (int row = 0; row < spec.rows; ++row) {
        const double w = spec.height * (static_cast<double>(row) / (spec.rows - 1) - 0.5);
        const double u = 0.5 * spec.width * (row % 2 == 0 ? -1.0 : 1.0);
        corners_.emplace_back(u, w);
        corners_.emplace_back(-u, w);
      }
      break;
    }
    case PathKind::Points:
      within_reason(spec.speed, "speed");
      if (spec.points.empty()) throw Error("path: points is empty; wanted at least one point");
      corners_ = spec.points;
      for (const Eigen::Vector2d& p : corners_) {
        if (!p.allFinite()) throw Error("path: a point is not finite");
        if (p.norm() > max_length)
          throw Error("path: a point is " + number(p.norm()) +
                      " m from the centre; wanted at most " + number(max_length) + " m");
      }
      corners_.insert(corners_.begin(), Eigen::Vector2d::Zero());
      break;
  }
  if (corners_.empty()) return;
  // The peak speed of a segment is 15/8 of its mean speed, and must not exceed spec.speed.
  double time = 0.0;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    if (i > 0) time += std::max(0.05, (corners_[i] - corners_[i - 1]).norm() / spec.speed * 1.875);
    times_.push_back(time);
  }
  duration_ = time;
}

double Path::reach() const {
  if (corners_.empty()) return spec_.radius;
  double largest = 0.0;
  for (const Eigen::Vector2d& corner : corners_)
    largest = std::max(largest, corner.cwiseAbs().maxCoeff());
  return largest;
}

PlanarPoint Path::circle(double t) const noexcept {
  const Blend grown = blend(t / spec_.start_up);
  const double T = spec_.start_up;
  return polar(spec_.radius * grown.value, spec_.radius * grown.rate / T,
               spec_.radius * grown.curvature / (T * T), spec_.rate * t, spec_.rate, 0.0);
}

PlanarPoint Path::spiral(double t) const noexcept {
  // The radius grows and shrinks as 1 - cos(phase). The rate of the phase starts at zero.
  const double T = spec_.start_up;
  const double turns = spec_.radius / spec_.pitch;
  const double w = spec_.rate / (2.0 * turns);
  const Blend begun = blend(t / T);
  const double s = std::min(t / T, 1.0);
  const double lasted = T * s * s * s * s * (2.5 + s * (-3.0 + s)) + std::max(0.0, t - T);
  const double phase = w * lasted, dphase = w * begun.value, ddphase = w * begun.rate / T;
  const double half = 0.5 * spec_.radius, c = std::cos(phase), sine = std::sin(phase);
  return polar(half * (1.0 - c), half * dphase * sine,
               half * (dphase * dphase * c + ddphase * sine), spec_.rate * t, spec_.rate, 0.0);
}

PlanarPoint Path::along_points(double t) const noexcept {
  if (t >= times_.back())
    return {corners_.back(), Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  const auto next = to_size(std::upper_bound(times_.begin(), times_.end(), t) - times_.begin());
  const double T = times_[next] - times_[next - 1];
  const Blend s = blend((t - times_[next - 1]) / T);
  const Eigen::Vector2d step = corners_[next] - corners_[next - 1];
  return {corners_[next - 1] + s.value * step, s.rate / T * step, s.curvature / (T * T) * step};
}

PlanarPoint Path::at(double t) const noexcept {
  if (!(t > 0.0))
    return {corners_.empty() ? Eigen::Vector2d(0.0, 0.0) : corners_[0], {0.0, 0.0}, {0.0, 0.0}};
  switch (spec_.kind) {
    case PathKind::Circle:
      return circle(t);
    case PathKind::Spiral:
      return spiral(t);
    case PathKind::ZigZag:
    case PathKind::Points:
      break;
  }
  return along_points(t);
}

}  // namespace burnish::polishing
