// A solved problem as a record of named columns, as JSON, and as plots.
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

/// What the costs of a problem follow, and the frames whose positions it limits, for plots.
struct Followed {
  std::vector<std::string> frames;  ///< of costs first, whose target positions there are
  std::vector<std::string> forces;  ///< rows such as "table_force_z_centered", of all contacts
};
Followed followed(const ProblemSpec& spec);

/// One row per state: time, stage, q, v, tau, u, forces of each contact in its own reference with
/// their targets, positions of frames with theirs. NaN where there is none.
Trace solution_trace(Problem& problem, const MatrixView& xs, const MatrixView& us);

/// Feedforward and gains of each knot with the names of rows and columns, and the state and control
/// that they are about: u = u_k + feedforward + gain (x (-) x_k). Where the solver did not
/// converge, its last policy belongs to an earlier trajectory, and a policy of this one is made.
nlohmann::ordered_json gains_json(Problem& problem, DdpSolver& solver);

/// limits.csv: a line for each row at each knot where its limit pushes or is broken. `value`,
/// `lower` and `upper` are in the row's unit, infinite where there is no limit, `multiplier` is in
/// cost per unit of the row.
std::string limits_csv(const Problem& problem, const CostReport& report);

/// Per name of a row that pushes anywhere: [[from, to], ...], s, the times of the first and the
/// last one of the consecutive knots at which it does.
std::map<std::string, nlohmann::ordered_json> active_times(const Problem& problem,
                                                           const CostReport& report);

/// `steps`: what check_steps() says of the solver's trajectory.
nlohmann::ordered_json summary_json(const std::string& file, Problem& problem,
                                    const DdpSolver& solver, const StepReport& steps);

/// A problem that was solved and the file that it is from.
struct SolvedFile {
  std::string file;
  const ProblemFile& problem;
};
/// The page of a planned motion: its replay, the paths and forces that it follows, its stages, and
/// its constraint rows with their multipliers. Times are from the first knot.
RunPage solution_page(const SolvedFile& solved, Problem& problem, const DdpSolver& solver,
                      const StepReport& steps);

/// Writes trajectory.csv, gains.json, summary.json (`summary`), the plots, and where the problem
/// has constraints limits.csv; their names. Throws Error if a file cannot be written.
std::vector<std::string> write_solution(Problem& problem, DdpSolver& solver,
                                        const nlohmann::ordered_json& summary,
                                        const std::filesystem::path& folder);

/// states.svg, torques.svg, cost.svg, and where there is something in them forces.svg, path.svg and
/// limits.svg. Returns the names of the files.
std::vector<std::string> write_plots(const Problem& problem, const Trace& trace,
                                     const DdpSummary& summary, const CostReport& report,
                                     const std::filesystem::path& folder);

}  // namespace burnish
