#include "burnish/mpc/plan_check.hpp"

#include <limits>

#include "burnish/ocp/step_check.hpp"
#include "burnish/solver/ddp.hpp"
#include "mpc/horizon.hpp"
#include "mpc/mpc_check.hpp"
#include "mpc/plan_inputs.hpp"

namespace burnish {
namespace {

/// Returns the solver options with which the controller computes its first plan.
DdpOptions first_options(const MpcSpec& spec) {
  DdpOptions options = spec.solver;
  options.limits.max_l1_weight = 0.0;
  options.max_iterations = spec.first_iterations;
  options.limits.max_factorizations = options.limits.max_sweeps = spec.first_max_factorizations;
  options.time_budget = std::numeric_limits<double>::infinity();
  return options;
}

}  // namespace

std::vector<std::string> step_complaints(const MpcSpec& spec) {
  (void)checked_ticks_per_update(spec);
  const MpcSpec filled = completed(spec);
  Problem problem(filled.problem);
  std::vector<std::string> sentences = step_complaints(problem);
  Horizon horizon(problem, Schedule(filled.schedule));
  horizon.place(0.0);
  const Eigen::VectorXd& x = filled.problem.initial_state;
  horizon.guess_rest(x, problem.quasi_static(problem.stage_of(0), x).control);
  DdpSolver solver(problem, first_options(filled));
  solver.set_guess({horizon.guess_x().data(), horizon.guess_u().data()});
  solver.solve();
  const StepReport report = check_steps(problem, solver.xs(), solver.us());
  if (report.coarse) sentences.push_back("the first plan: " + report.warning());
  return sentences;
}

}  // namespace burnish
