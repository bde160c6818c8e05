#include "polishing/experiments/run_curves.hpp"

#include <algorithm>
#include <cmath>

#include "report/moving_mean.hpp"
#include "report/trace_curves.hpp"

namespace burnish::polishing {
namespace {

/// Returns a curve with about `count` evenly chosen points.
Curve sampled(const Eigen::VectorXd& x, const Eigen::VectorXd& y, Eigen::Index count) {
  const Eigen::Index n = x.size(), every = std::max<Eigen::Index>(1, n / count);
  const Eigen::Index size = (n + every - 1) / every;
  return {.x = x(Eigen::seqN(0, size, every)), .y = y(Eigen::seqN(0, size, every))};
}

}  // namespace

RunCurves curves_of(const RunResult& result, const std::string& name) {
  RunCurves curves;
  const Trace& trace = result.trace;
  const Eigen::VectorXd time = trace.column("time");
  const auto [begin, end] = rows_of_phase(trace, static_cast<double>(Phase::Track));
  const Eigen::Index first = begin, size = end - begin;
  if (size < 10) return curves;
  const double dt = time[first + 1] - time[first];
  const Eigen::VectorXd since = time.segment(first, size).array() - time[first];
  const Eigen::Matrix3d& axes = result.setting.surface_axes;
  const Eigen::VectorXd force =
      moving_mean(along_normal(trace, "tool_force"), samples_in(MetricsSpec{}.average, dt));
  // Excludes the start, in which the force settles, and the last averaging window, which extends
  // into the retreat.
  const Eigen::Index from = size > 2 * std::lround(0.5 / dt) ? std::lround(0.5 / dt) : 0;
  const Eigen::Index kept = size - from - std::min<Eigen::Index>(size / 4, std::lround(0.02 / dt));
  curves.force = extremes(since.segment(from, kept), force.segment(first + from, kept), 500);
  curves.force.name = name;
  const auto millimetres = [&](const std::string& what, int tangent) -> Eigen::VectorXd {
    const Eigen::Vector3d t = axes.col(tangent);
    const double origin = t.dot(result.setting.p_center);
    return 1e3 * (along(trace, what, t).segment(first, size).array() - origin);
  };
  const Eigen::VectorXd u = millimetres("tool", 0), w = millimetres("tool", 1);
  const Eigen::VectorXd u_target = millimetres("target", 0), w_target = millimetres("target", 1);
  curves.path = sampled(u, w, 600);
  curves.path.name = name;
  curves.target = sampled(u_target, w_target, 300);
  curves.target.name = "target";
  curves.target.dashed = true;
  curves.target.color = 6;
  const Eigen::VectorXd distance =
      ((u - u_target).array().square() + (w - w_target).array().square()).sqrt();
  curves.distance = sampled(since, distance, 600);
  curves.distance.name = name;
  return curves;
}

}  // namespace burnish::polishing
