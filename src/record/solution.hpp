// Solution of a problem as named columns, as JSON and as plots.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "burnish/base/trace.hpp"
#include "burnish/files/problem_file.hpp"
#include "burnish/ocp/step_check.hpp"
#include "burnish/solver/ddp.hpp"
#include "report/run_page.hpp"

namespace burnish {

/// Signals of a problem that the plots show.
struct PlotSignals {
  /// Frames with a cost on their position, then frames with only a constraint on it.
  std::vector<std::string> frames;
  std::vector<std::string> forces;  ///< Columns of contact forces, such as "table_force_z_centered"
};
PlotSignals followed(const ProblemSpec& spec);

/// Returns one row per state: time, stage, q, v, tau, u, contact forces and their targets, frame
/// positions and their targets. Forces are in the reference of their contact. Values that do not
/// exist are NaN.
Trace solution_trace(Problem& problem, const MatrixView& xs, const MatrixView& us);

/// Returns the policy u = u_k + feedforward + gain (x (-) x_k) of each knot k as its feedforward,
/// gain, x_k and u_k, with the names of rows and columns. If the solver did not converge, its last
/// policy belongs to an earlier trajectory. In this case, computes the policy of the current
/// trajectory.
nlohmann::ordered_json gains_json(Problem& problem, DdpSolver& solver);

/// Text of limits.csv: one line per constraint row and knot at which the row is active or violated.
/// `value`, `lower` and `upper` are in the unit of the row; a missing limit is infinite.
/// `multiplier` is in cost per unit of the row.
std::string limits_csv(const Problem& problem, const CostReport& report);

/// Returns the time intervals in which each constraint row is active, by the name of the row:
/// [[from, to], ...] [s]. An interval lasts from the first to the last of consecutive knots.
std::map<std::string, nlohmann::ordered_json> active_times(const Problem& problem,
                                                           const CostReport& report);

/// Content of summary.json. `steps`: result of check_steps() for the solver's trajectory.
nlohmann::ordered_json summary_json(const std::string& file, Problem& problem,
                                    const DdpSolver& solver, const StepReport& steps);

/// Problem that was solved, and the name of its file.
struct SolvedFile {
  std::string file;
  const ProblemFile& problem;
};
/// Returns the page of a planned motion: its replay, paths and forces with their targets, stages,
/// and constraint rows with their multipliers. Times count from the first knot.
RunPage solution_page(const SolvedFile& solved, Problem& problem, const DdpSolver& solver,
                      const StepReport& steps);

/// Writes trajectory.csv, gains.json, summary.json (`summary`) and the plots, and limits.csv if the
/// problem has constraints. Returns the names of the files. Throws Error if a file cannot be
/// written.
std::vector<std::string> write_solution(Problem& problem, DdpSolver& solver,
                                        const nlohmann::ordered_json& summary,
                                        const std::filesystem::path& folder);

/// Writes states.svg, torques.svg and cost.svg, and forces.svg, path.svg and limits.svg unless they
/// would be empty. Returns the names of the files.
std::vector<std::string> write_plots(const Problem& problem, const Trace& trace,
                                     const DdpSummary& summary, const CostReport& report,
                                     const std::filesystem::path& folder);

}  // namespace burnish
