// Value and expansion of one knot, or of one per lane: next state, costs, and their derivatives.
#pragma once

#include <optional>
#include <vector>

#include "ocp/custom_lanes.hpp"
#include "ocp/knot_time.hpp"
#include "ocp/stage_dynamics.hpp"

namespace burnish::ocp {

/// Workspace of one worker. Allocates when made, never afterwards.
template <class S>
class NodeKernel {
 public:
  explicit NodeKernel(const CompiledProblem& problem);

  /// Evaluates a stage at x (nx), u (nu), targets (stage.targets entries) and the time and step of
  /// each lane. Fills next, cost, term_costs, row_values.
  void values(const CompiledStage& stage, const S* x, const S* u, const S* targets,
              const KnotTime<S>& when);
  /// The same, and gradient, hessian, rows, dynamics, lead.
  void expand(const CompiledStage& stage, const S* x, const S* u, const S* targets,
              const KnotTime<S>& when);

  /// Another mass distribution of a body, for what is evaluated from then on.
  void set_body_inertia(int body, const BodyInertia& inertia) {
    dynamics_.set_body_inertia(body, inertia);
  }

  Status status(int lane) const { return status_[static_cast<std::size_t>(lane)]; }
  /// Outcome of a lane, and what is to blame where it is not finite.
  KnotValue outcome(const CompiledStage& stage, int lane) const;
  /// r and J (its blocks; may be null) of one term at x and u.
  void residual_at(const CompiledStage& stage, const CompiledTerm& term, const S* x, const S* u,
                   const S* targets, const KnotTime<S>& when, S* r, S* J);
  /// Accelerations and forces alone, into dynamics().
  void look(const CompiledStage& stage, const S* x, const S* u, const S* targets,
            const KnotTime<S>& when) {
    load(stage, targets, when);
    dynamics_.values(stage, x, u);
  }
  const StageDynamics<S>& dynamics() const { return dynamics_; }

  std::vector<S> next;  ///< nx
  S cost;
  std::vector<S> term_costs;     ///< of the stage's costs
  std::vector<S> row_values;     ///< of the stage's constraints, one after the other
  std::vector<S> rows;           ///< their derivative by z, nz each; only what expand() fills
  std::vector<S> bends;          ///< KnotExpansion::bends, nz each; only what expand() fills
  std::vector<S> gradient;       ///< nz
  std::vector<S> hessian;        ///< nz x nz, lower triangle
  std::vector<S> dynamics_by_z;  ///< P (nv x nz), or F (ndx x nz) of dense stages
  std::vector<S> lead;           ///< per block A, then B

 private:
  void residual(const CompiledStage& stage, const CompiledTerm& term, const S* targets,
                const double* times, S* r, S* J, S* bends = nullptr);
  void load(const CompiledStage& stage, const S* targets, const KnotTime<S>& when);
  void add_costs(const CompiledStage& stage, const S* targets, const KnotTime<S>& when,
                 bool expand);
  void add_constraints(const CompiledStage& stage, const S* targets, const double* times,
                       bool expand);
  void store_rows(const CompiledTerm& term);
  void store_bends(const CompiledTerm& term);
  void add_block(const JacobianBlock& block, const S* J, const S* slope, const S* curvature);
  void euler(const KnotTime<S>& when, const S* x, const S* u);
  void euler_derivative(const S& h);
  void euler_dense_derivative(const KnotTime<S>& when);
  /// The rows of the next state that remember the forces of this knot, and their derivatives;
  /// before other points of a step are evaluated.
  void remember_forces(const CompiledStage& stage);
  void remember_derivatives(const CompiledStage& stage);
  void jump(const CompiledStage& stage, const S* x, bool with_derivatives);
  void filter_torque(const S* x, const S* u, const S& decay, S* out) const;
  void runge_kutta(const CompiledStage& stage, const KnotTime<S>& when, const S* x, const S* u,
                   bool with_derivatives);
  void runge_kutta_derivative(const KnotTime<S>& when, int i);
  /// From derivatives of the offsets to those of the point x (+) offset, in place.
  void close_point(const S& decay, const S* offset, S* by_z);
  bool in_block(int k) const;
  void check_finite(const CompiledStage& stage, bool expanded);
  void load_status();

  const CompiledProblem* problem_;
  StageDynamics<S> dynamics_;
  std::optional<CustomLanes<S>> custom_;
  std::vector<S> step_;  ///< nv: dq of the step
  std::vector<S> r_, jacobian_, bends_, weighted_, slope_, curvature_, product_;
  std::vector<int> row_list_;
  std::vector<Status> status_;
  // Runge-Kutta: the four stages' velocity and acceleration, the point of the next one, and by z.
  std::vector<S> rates_, point_, offset_, rates_by_z_, point_by_z_;
};

}  // namespace burnish::ocp
