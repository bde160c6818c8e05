// Initial guesses of a solver: constant, holding torques, or a trajectory from a file.
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/files/problem_file.hpp"
#include "files/csv_table.hpp"
#include "files/problem_scope.hpp"

namespace burnish {
namespace {

/// Control and force states that keep the robot at rest in a stage. The control of an impact is
/// zero.
struct StageHolding {
  Eigen::VectorXd control, forces;  ///< Controls (nu); force states
};

/// Returns the controls and force states of each stage. A stage with the same contacts as the first
/// stage gets the torques and forces of the initial state, if the state has torques.
std::vector<StageHolding> holding_controls(const Problem& problem) {
  const ProblemSpec& spec = problem.spec();
  const StateLayout& layout = problem.layout();
  const Eigen::Map<const Eigen::VectorXd> x(problem.initial_state(), layout.nx());
  const std::vector<std::string>& first = spec.stages[to_size(problem.stage_of(0))].contacts;
  std::vector<StageHolding> result;
  for (const Stage& stage : spec.stages) {
    if (stage.impact) {
      result.push_back({Eigen::VectorXd::Zero(layout.nu), x.tail(layout.force_states)});
      continue;
    }
    const files::Holding held = files::hold(spec, stage.contacts, x.head(layout.nq), {});
    result.push_back({held.control, files::force_states_of(spec, held.forces)});
    if (layout.filtered > 0 && stage.contacts == first)
      result.back() = {x.segment(layout.nq + layout.nv, layout.filtered),
                       x.tail(layout.force_states)};
  }
  return result;
}

void read_trajectory(const Problem& problem, const std::filesystem::path& file,
                     TrajectoryGuess& guess) {
  const files::CsvTable table = files::read_csv(file);
  if (table.values.rows() != problem.knots() + 1)
    throw Error(file.string() + ": the table has " + std::to_string(table.values.rows()) +
                " rows; wanted " + std::to_string(problem.knots() + 1) +
                ", one for each state of the problem");
  const StateLayout& layout = problem.layout();
  const Model& model = problem.model();
  for (int i = 0; i < layout.nq; ++i) guess.xs.col(i) = table.column("q_" + model.q_name(i));
  for (int i = 0; i < layout.nv; ++i)
    guess.xs.col(layout.nq + i) = table.column("v_" + model.v_name(i));
  for (int i = 0; i < layout.nu; ++i) {
    const std::string name = model.v_name(layout.actuated[to_size(i)]);
    if (layout.filtered > 0) guess.xs.col(layout.nq + layout.nv + i) = table.column("tau_" + name);
    guess.us.col(i) = table.column("u_" + name, problem.knots());
  }
  // Force states are the contact forces of the previous knot. At the first knot, they are initial
  // values.
  int entry = layout.nx() - layout.force_states;
  for (const std::string& column : files::force_state_columns(problem.spec())) {
    guess.xs(0, entry) = problem.initial_state()[entry];
    guess.xs.col(entry).tail(problem.knots()) = table.column(column, problem.knots());
    ++entry;
  }
}

}  // namespace

TrajectoryGuess make_guess(const Problem& problem, const WarmStart& start) {
  const int knots = problem.knots(), nx = problem.state().nx;
  TrajectoryGuess guess;
  guess.xs.resize(knots + 1, nx);
  guess.us.setZero(knots, problem.max_controls());
  if (start.kind == WarmStart::Kind::File) {
    read_trajectory(problem, start.file, guess);
    return guess;
  }
  guess.xs.rowwise() = Eigen::Map<const Eigen::RowVectorXd>(problem.initial_state(), nx);
  if (start.kind == WarmStart::Kind::Still) return guess;
  const std::vector<StageHolding> held = holding_controls(problem);
  const StateLayout& layout = problem.layout();
  for (int k = 0; k < knots; ++k) {
    const StageHolding& at = held[to_size(problem.stage_of(k))];
    guess.us.row(k) = at.control.transpose();
    if (problem.controls(k) == 0) continue;
    guess.xs.row(k + 1).segment(layout.nq + layout.nv, layout.filtered) =
        at.control.head(layout.filtered);
    guess.xs.row(k + 1).tail(layout.force_states) = at.forces;
  }
  return guess;
}

}  // namespace burnish
