// Verdict on a run: comparison of its metrics with the limits of the task.
#pragma once

#include <string>

#include "burnish/tasks/polishing/run.hpp"

namespace burnish::polishing {

/// Returns the duration of the path up to its last point [s]. For a path that never ends, this is
/// Task::polish_duration.
double path_time(const Task& task);

/// Computes the metrics from the rows of a ClosedLoop trace between `begin` and `end` [s], all in
/// Phase::Track. Throws Error if there are no such rows.
VerdictFigures verdict_figures(const Task& task, const Setting& setting, const Trace& trace,
                               double begin, double end);

/// Returns the largest violation of a joint limit until `end` [s], as "joint 'a' was 0.12 rad
/// beyond its limit at 3 s". Empty if all violations are below 1 mrad or 1 mm. A real robot would
/// hit the mechanical stop of the joint.
std::string beyond_limits(const Model& model, const Trace& trace, double end);
/// Returns whether Task::polish_duration is shorter than the path.
bool is_cut_short(const Task& task);
/// Returns "cut short: 3 % of the path in 1.5 s; the whole path takes 30.9 s"; empty if the path is
/// not cut short.
std::string cut_short_text(const Task& task, const VerdictFigures& figures);

/// Returns an empty text if all metrics are within the limits of the task. Otherwise returns "not
/// polished: " with each metric outside its limit. If the run is cut short, only the part of the
/// path within Task::polish_duration counts.
std::string verdict_failure(const Task& task, const VerdictFigures& figures);

}  // namespace burnish::polishing
