// Whether a run did what its task is for: its figures beside those that the task asks for.
#pragma once

#include <string>

#include "burnish/tasks/polishing/run.hpp"

namespace burnish::polishing {

/// s that the path takes: until its last point, or for as long as the task polishes where it has no
/// end.
double path_time(const Task& task);

/// Of a trace of ClosedLoop, its rows from `begin` to `end` (s), which are of Phase::Track.
/// `normal` is the surface's as it is. Throws Error where there are no rows.
VerdictFigures verdict_figures(const Task& task, const Setting& setting, const Trace& trace,
                               double begin, double end);

/// "joint 'a' was 0.12 rad beyond its limit at 3 s": the farthest in a trace, from its first row to
/// `end` (s), by more than a milliradian (millimetre), which no stop of a joint allows. Empty:
/// none.
std::string beyond_limits(const Model& model, const Trace& trace, double end);
/// Whether the time on the path ends before the path.
bool is_cut_short(const Task& task);
/// "cut short: 3 % of the path in 1.5 s, and all of it takes 30.9 s"; empty if it is not.
std::string cut_short_text(const Task& task, const VerdictFigures& figures);

/// Empty where the figures are what the task asks for; otherwise a sentence that begins with "not
/// polished: " and has every figure that is not. A run that is cut short is judged by as much of
/// the path as its time allows.
std::string verdict_failure(const Task& task, const VerdictFigures& figures);

}  // namespace burnish::polishing
