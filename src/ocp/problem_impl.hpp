// What a Problem holds: the compiled specification, the knots, a workspace per worker.
#pragma once

#include <memory>
#include <vector>

#include "burnish/ocp/problem.hpp"
#include "ocp/kernels.hpp"

namespace burnish::ocp {

extern template class StageDynamics<double>;
extern template class StageDynamics<NativePack>;
extern template class NodeKernel<double>;
extern template class NodeKernel<NativePack>;

struct Worker {
  explicit Worker(const CompiledProblem& problem);
  NodeKernel<double> one;
  NodeKernel<NativePack> pack;
  std::vector<NativePack> x, u, targets;
  std::vector<double> next;
};

/// What acts beside the actuators at rest: the torque bias, and springs where they act; nv, Nm (N).
Eigen::VectorXd torque_at_rest(const CompiledProblem& problem, const ConstVectorRef& q);

}  // namespace burnish::ocp

namespace burnish {

struct Problem::Impl {
  explicit Impl(const ProblemSpec& given);

  const ocp::CompiledStage& stage(int knot) const {
    return compiled.stages[static_cast<std::size_t>(stage_of.at(static_cast<std::size_t>(knot)))];
  }
  double* targets_of(int knot) {
    return targets.data() + static_cast<std::ptrdiff_t>(knot) * compiled.largest_targets;
  }
  const double* targets_of(int knot) const {
    return targets.data() + static_cast<std::ptrdiff_t>(knot) * compiled.largest_targets;
  }
  ocp::Worker& worker(int index) { return *workers[static_cast<std::size_t>(index)]; }

  Status set_initial_state(const ConstVectorRef& x);
  /// Of the compiled model, and of what workers have made of it; those to come make it anew.
  void set_body_inertia(int body, const InertiaSpec& inertia);
  void set_knot(int knot, int stage, double time);
  void set_timing(int knot);
  ocp::KnotTime<double> when(int knot) const;
  /// KnotTime::passing.
  double passing(int knot) const {
    return fading > 0.0 ? std::exp((times[0] - times[static_cast<std::size_t>(knot)]) / fading)
                        : 0.0;
  }
  void advance(int stage);
  void load_targets(int knot);
  void check_rotations(int knot);
  void cut_ranges();
  void prepare(int count);
  void check_point(int knot, const ConstVectorRef& x, const ConstVectorRef& u) const;
  /// Their references as they are at the first knot of a stage, or of the horizon.
  std::vector<ContactSpec> contacts_of(int stage) const;
  /// Throws Error("<call>: ...") for a knot or a term that there is not.
  const ocp::CompiledTerm& term(const char* call, int knot, int term) const;
  /// Likewise for a knot or a contact that there is not.
  const CompiledContact& contact_at(const char* call, int knot, int contact) const;
  const ocp::StageDynamics<double>& evaluate_one(int knot, const ConstVectorRef& x,
                                                 const ConstVectorRef& u);
  KnotValue roll(int index, int knot, const double* x, const double* u, double* next, double* rows);
  void run(int index, KnotRange range, TrajectoryView at, double* next, KnotValue* values,
           double* rows, KnotExpansion* out);
  void gather(ocp::Worker& worker, KnotRange range, TrajectoryView at,
              ocp::KnotTime<NativePack>& time) const;
  void store_expansion(const ocp::Worker& worker, const ocp::CompiledStage& stage, KnotRange range,
                       KnotExpansion* out) const;

  ProblemSpec spec;
  ocp::CompiledProblem compiled;
  std::vector<int> stage_of;                  ///< per knot, N + 1
  std::vector<double> times;                  ///< per knot, s
  std::vector<double> own_steps;              ///< per knot, s; 0: its stage's
  double fading = 0.0;                        ///< s, of the torque that passes; 0: there is none
  std::vector<ocp::KnotTime<double>> timing;  ///< per knot, without its time
  std::vector<double> targets;                ///< per knot, largest_targets each
  std::vector<KnotRange> ranges;
  std::vector<double> initial_state, lower, upper;
  std::vector<double> control_scale;  ///< the robot's effort limits, 1 where it has none
  Eigen::VectorXd signal_scratch;
  std::vector<std::unique_ptr<ocp::Worker>> workers;
};

namespace ocp {
/// For the checker: what a Problem holds.
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
