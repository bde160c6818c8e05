#include "polishing/verdict.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "burnish/report/metrics.hpp"

namespace burnish::polishing {
namespace {

/// Returns the length of the tip's path until `time` [s], projected along the normal at the origin
/// of the path [m]. The length is computed from points every `step` seconds.
double path_length(const Task& task, const Setting& setting, double time, double step) {
  const Path path(task.path);
  const auto place = [&](double t) {
    return Eigen::Vector2d(setting.surface_axes.leftCols<2>().transpose() *
                           point_on(task, setting, path.at(t)).p_world);
  };
  double length = 0.0;
  Eigen::Vector2d before = place(0.0);
  constexpr double max_points = 1e6;
  const long count = std::lround(std::clamp(time / step, 1.0, max_points));
  for (long i = 1; i <= count; ++i) {
    const Eigen::Vector2d p = place(time * static_cast<double>(i) / static_cast<double>(count));
    length += (p - before).norm();
    before = p;
  }
  return length;
}

/// Returns the position in three successive columns of a row.
Eigen::Vector3d place(const Trace& trace, int first_column, int row) {
  return {trace.at(row, first_column), trace.at(row, first_column + 1),
          trace.at(row, first_column + 2)};
}

/// Returns the length of the target's path on which the tool was at most its tip radius away from
/// the target [m]. Length and distance are measured perpendicular to the normal.
double covered_length(const Task& task, const Setting& setting, const Trace& trace, double begin,
                      double end) {
  const int tool = trace.index("tool_x_world"), target = trace.index("target_x_world");
  const int phase = trace.index("phase"), time = trace.index("time");
  const auto tangents = setting.surface_axes.leftCols<2>();
  const auto counts = [&](int row) {
    return trace.at(row, phase) == static_cast<double>(Phase::Track) &&
           trace.at(row, time) >= begin - 1e-9 && trace.at(row, time) <= end + 1e-9;
  };
  double length = 0.0;
  for (int row = 1; row < trace.rows(); ++row) {
    if (!counts(row - 1) || !counts(row)) continue;
    const Eigen::Vector3d p = place(trace, target, row);
    const double off = (tangents.transpose() * (place(trace, tool, row) - p)).norm();
    if (off <= task.tip_radius)
      length += (tangents.transpose() * (p - place(trace, target, row - 1))).norm();
  }
  return length;
}

std::string percent(double fraction) { return number(std::round(1e4 * fraction) / 1e2) + " %"; }

}  // namespace

double path_time(const Task& task) {
  const double duration = Path(task.path).duration();
  return std::isfinite(duration) ? duration : task.polish_duration;
}

VerdictFigures verdict_figures(const Task& task, const Setting& setting, const Trace& trace,
                               double begin, double end) {
  MetricsSpec spec;
  spec.start = begin;
  const Trace::Column time = trace.column("time");
  const double whole = path_time(task);
  const double step = trace.rows() > 1 ? time[1] - time[0] : whole;
  // Ends half an averaging window before `end`, because later windows reach into the retreat.
  spec.end = std::max(std::min(begin + step, end), end - 0.5 * spec.average);
  const Metrics metrics = measure(trace, setting.robot.model, spec);
  VerdictFigures figures;
  figures.contact_share = 1.0 - metrics.without_contact;
  figures.force_rmse = metrics.force_rmse;
  const double length = path_length(task, setting, whole, step);
  // For a path of zero length, path_share is the fraction of the path's time instead.
  figures.path_share = length > 0.0 ? covered_length(task, setting, trace, begin, end) / length
                                    : (whole > 0.0 ? (end - begin) / whole : 1.0);
  figures.path_share = std::clamp(figures.path_share, 0.0, 1.0);
  if (length > 0.0 && is_cut_short(task))
    figures.path_allowed = path_length(task, setting, task.polish_duration, step) / length;
  return figures;
}

std::string beyond_limits(const Model& model, const Trace& trace, double end) {
  double largest = 1e-3;  // largest violation so far; starts at the tolerance [rad or m]
  std::string text;
  const int time = trace.index("time");
  for (const Joint& joint : model.joints) {
    if (joint.nq != 1) continue;
    const int k = joint.q_index, column = trace.index("q_" + model.q_name(k));
    for (int row = 0; row < trace.rows() && trace.at(row, time) <= end; ++row) {
      const double q = trace.at(row, column);
      const double beyond = std::max(model.q_lower[k] - q, q - model.q_upper[k]);
      if (!(beyond > largest)) continue;
      largest = beyond;
      text = "joint " + in_quotes(joint.name) + " was " + number(std::round(1e4 * beyond) / 1e4) +
             (joint.kind == JointKind::Prismatic ? " m" : " rad") + " beyond its limit at " +
             number(trace.at(row, time)) + " s";
    }
  }
  return text;
}

bool is_cut_short(const Task& task) { return path_time(task) > task.polish_duration + 1e-9; }

std::string cut_short_text(const Task& task, const VerdictFigures& figures) {
  if (!is_cut_short(task)) return "";
  return "cut short: " + percent(figures.path_share) + " of the path in " +
         number(task.polish_duration) + " s; the whole path takes " +
         number(std::round(10.0 * path_time(task)) / 10.0) + " s";
}

std::string verdict_failure(const Task& task, const VerdictFigures& figures) {
  const Verdict& wanted = task.verdict;
  std::string text;
  const auto add = [&](const std::string& what) { text += (text.empty() ? "" : "; ") + what; };
  const std::string cut_short = cut_short_text(task, figures);
  if (!(figures.contact_share >= wanted.contact_share))
    add("in contact for " + percent(figures.contact_share) +
        " of the time on the path (verdict.contact_share requires " +
        percent(wanted.contact_share) + ")");
  if (!(figures.force_rmse <= wanted.force_rmse * task.force))
    add("the force was off by " + number(std::round(1e3 * figures.force_rmse) / 1e3) + " N rms, " +
        percent(figures.force_rmse / task.force) + " of " + number(task.force) +
        " N (verdict.force_rmse allows " + percent(wanted.force_rmse) + ")");
  if (!(figures.path_share >= wanted.path_share * figures.path_allowed))
    add("the tool followed " + percent(figures.path_share) + " of the path" +
        (cut_short.empty() ? ""
                           : ", while its time is enough for " + percent(figures.path_allowed)) +
        " (verdict.path_share requires " + percent(wanted.path_share) + ")");
  if (text.empty()) return text;
  return "not polished: " + text + (cut_short.empty() ? "" : "; " + cut_short);
}

}  // namespace burnish::polishing
