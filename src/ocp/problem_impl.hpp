// Implementation of Problem: the compiled specification, the knots, and a workspace per thread.
#pragma once

#include <initializer_list>
#include <memory>
#include <vector>

#include "base/to_size.hpp"
#include "burnish/ocp/problem.hpp"
#include "ocp/kernels.hpp"

namespace burnish::ocp {

extern template class StageDynamics<double>;
extern template class StageDynamics<NativePack>;
extern template class NodeKernel<double>;
extern template class NodeKernel<NativePack>;

/// Workspace of one thread.
struct Worker {
  explicit Worker(const CompiledProblem& problem);
  NodeKernel<double> one;
  NodeKernel<NativePack> pack;
  std::vector<NativePack> x, u, targets;
  std::vector<double> next;
};

/// Returns the torques at rest except those of the actuators: torque bias and springs, nv entries
/// [Nm or N].
Eigen::VectorXd torque_at_rest(const CompiledProblem& problem, const ConstVectorRef& q);

}  // namespace burnish::ocp

namespace burnish {

struct Problem::Impl {
  explicit Impl(const ProblemSpec& given);

  const ocp::CompiledStage& stage(int knot) const {
    return compiled.stages[to_size(stage_of.at(to_size(knot)))];
  }
  double* targets_of(int knot) {
    return targets.data() + static_cast<std::ptrdiff_t>(knot) * compiled.largest_targets;
  }
  const double* targets_of(int knot) const {
    return targets.data() + static_cast<std::ptrdiff_t>(knot) * compiled.largest_targets;
  }
  ocp::Worker& worker(int index) { return *workers[to_size(index)]; }

  Status set_initial_state(const ConstVectorRef& x);
  /// Sets the inertia of a body in the compiled model and in all workers.
  void set_body_inertia(int body, const InertiaSpec& inertia);
  void set_knot(int knot, int stage, double time);
  void set_timing(int knot);
  ocp::KnotTime<double> when(int knot) const;
  /// Returns KnotTime::decaying of a knot.
  double decaying(int knot) const {
    return decay_time > 0.0 ? std::exp((times[0] - times[to_size(knot)]) / decay_time) : 0.0;
  }
  void advance(int stage);
  /// Evaluates inputs and signals of a knot, and writes its targets.
  void load_targets(int knot);
  /// Evaluates an input at all knots and writes the targets that use it. Other targets stay.
  void load_input(int index);
  void evaluate_input(int index, int knot);
  /// Throws Error if an input has no valid value at a knot.
  void check_inputs(int knot);
  double* inputs_of(int knot) {
    return inputs.data() + static_cast<std::ptrdiff_t>(knot) * compiled.inputs.entries();
  }
  double* signals_of(int knot) {
    return signals.data() + static_cast<std::ptrdiff_t>(knot) * compiled.largest_targets;
  }
  /// Returns an input. Throws Error("<call>: ...") if it does not exist. Also throws Error if its
  /// kind is not one of `kinds`, unless `kinds` is empty.
  ocp::InputState& input(const char* call, int index, std::initializer_list<InputKind> kinds);
  /// Updates the targets or the torque bias after a new value of an input.
  void accept_input(int index);
  /// Sets the torque bias to the value of its input.
  void load_bias(const ocp::InputState& state);
  void check_rotations(int knot);
  void cut_ranges();
  void prepare(int count);
  void check_point(int knot, const ConstVectorRef& x, const ConstVectorRef& u) const;
  /// Returns the contacts with their references at the time of the stage's first knot. If the
  /// horizon does not contain the stage, the time is that of knot 0.
  std::vector<ContactSpec> contacts_of(int stage) const;
  /// Throws Error("<call>: ...") for an invalid knot or term.
  const ocp::CompiledTerm& term(const char* call, int knot, int term) const;
  /// Throws Error("<call>: ...") for an invalid knot or contact.
  const CompiledContact& contact_at(const char* call, int knot, int contact) const;
  const ocp::StageDynamics<double>& evaluate_one(int knot, const ConstVectorRef& x,
                                                 const ConstVectorRef& u);
  KnotValue roll(int index, int knot, const double* x, const double* u, double* next, double* rows);
  /// Memory for the results of evaluate() (rows) or expand() (expansions); null: not wanted.
  struct RangeOutput {
    double* next;
    KnotValue* values;
    double* rows = nullptr;
    KnotExpansion* expansions = nullptr;
  };
  void run(int index, KnotRange range, TrajectoryView at, const RangeOutput& out);
  void gather(ocp::Worker& worker, KnotRange range, TrajectoryView at,
              ocp::KnotTime<NativePack>& time) const;
  void store_expansion(const ocp::Worker& worker, const ocp::CompiledStage& stage, KnotRange range,
                       KnotExpansion* out) const;

  ProblemSpec spec;
  ocp::CompiledProblem compiled;
  std::vector<int> stage_of;                  ///< Stage of each knot, N + 1 entries
  std::vector<double> times;                  ///< Time of each knot [s]
  std::vector<double> own_steps;              ///< Step of each knot [s]; 0: its stage's step
  double decay_time = 0.0;                    ///< Time constant of the decaying torque [s]; 0: none
  std::vector<ocp::KnotTime<double>> timing;  ///< Timing of each knot, without KnotTime::times
  std::vector<double> targets;                ///< Target entries, largest_targets for each knot
  std::vector<double> signals;                ///< Target entries before inputs are applied
  std::vector<double> inputs;                 ///< Values of inputs, Inputs::entries() for each knot
  std::vector<KnotRange> ranges;
  std::vector<double> initial_state, lower, upper;
  std::vector<double> control_scale;  ///< Effort limit of each actuator; 1: no limit
  Eigen::VectorXd signal_scratch;
  std::vector<std::unique_ptr<ocp::Worker>> workers;
};

namespace ocp {
/// Gives other files in this folder access to the implementation of a Problem.
struct ProblemInside {
  static auto& of(Problem& problem) { return *problem.impl_; }
  static const auto& of(const Problem& problem) { return *problem.impl_; }
};

inline std::vector<std::string> row_names(const Problem& problem, const CompiledTerm& term) {
  const bool is_state = std::holds_alternative<StateDifference>(term.residual);
  return is_state ? problem.state_names() : term.row_names;
}
}  // namespace ocp

}  // namespace burnish
