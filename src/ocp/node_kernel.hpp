// Next state, costs and constraints of one knot, or of one knot per lane, and their derivatives.
#pragma once

#include <optional>
#include <vector>

#include "base/to_size.hpp"
#include "ocp/custom_lanes.hpp"
#include "ocp/knot_time.hpp"
#include "ocp/stage_dynamics.hpp"

namespace burnish::ocp {

/// Memory for a residual r, its Jacobian blocks J and its curvature vectors. Null: not computed.
template <class S>
struct ResidualOutput {
  S *r, *J = nullptr, *curvatures = nullptr;
};

/// Evaluates knots. Workspace of one thread; only the constructor allocates.
template <class S>
class NodeKernel {
 public:
  explicit NodeKernel(const CompiledProblem& problem);

  /// Evaluates a stage at x (nx), u (nu), targets (stage.targets entries) and the timing `when`.
  /// Fills next, cost, term_costs and row_values.
  void values(const CompiledStage& stage, const S* x, const S* u, const S* targets,
              const KnotTime<S>& when);
  /// Evaluates a stage like values(), and also fills rows, curvatures, gradient, hessian,
  /// dynamics_by_z and tangent_blocks.
  void expand(const CompiledStage& stage, const S* x, const S* u, const S* targets,
              const KnotTime<S>& when);

  /// Sets the mass distribution of a body for the next evaluations.
  void set_body_inertia(int body, const BodyInertia& inertia) {
    dynamics_.set_body_inertia(body, inertia);
  }

  Status status(int lane) const { return status_[to_size(lane)]; }
  /// Returns the cost and status of a lane. If a value is not finite, also the first term or row
  /// that is not finite.
  KnotValue outcome(const CompiledStage& stage, int lane) const;
  /// Computes only accelerations and contact forces, in dynamics().
  void evaluate_dynamics(const CompiledStage& stage, const S* x, const S* u, const S* targets,
                         const KnotTime<S>& when) {
    load(stage, targets, when);
    dynamics_.values(stage, x, u);
  }
  /// Evaluates one term at the point of the last evaluate_dynamics(), with the same targets.
  /// `times` is KnotTime::times.
  void residual_at(const CompiledStage& stage, const CompiledTerm& term, const S* targets,
                   const double* times, const ResidualOutput<S>& out) {
    if (out.J != nullptr) dynamics_.derivatives(stage);
    residual(stage, term, targets, times, out);
  }
  const StageDynamics<S>& dynamics() const { return dynamics_; }

  std::vector<S> next;            ///< Next state, nx entries
  S cost;                         ///< Sum of all costs
  std::vector<S> term_costs;      ///< Cost of each term
  std::vector<S> row_values;      ///< Values of all constraint rows
  std::vector<S> rows;            ///< KnotExpansion::rows, nz entries each
  std::vector<S> curvatures;      ///< KnotExpansion::curvatures, nz entries each
  std::vector<S> gradient;        ///< Gradient of the cost, nz entries
  std::vector<S> hessian;         ///< Hessian of the cost, nz x nz, lower triangle
  std::vector<S> dynamics_by_z;   ///< P (nv x nz) or F (ndx x nz), see DynamicsForm
  std::vector<S> tangent_blocks;  ///< A, then B, of each non-Euclidean tangent block

 private:
  void residual(const CompiledStage& stage, const CompiledTerm& term, const S* targets,
                const double* times, const ResidualOutput<S>& out);
  void load(const CompiledStage& stage, const S* targets, const KnotTime<S>& when);
  void add_costs(const CompiledStage& stage, const S* targets, const KnotTime<S>& when,
                 bool expand);
  void add_constraints(const CompiledStage& stage, const S* targets, const double* times,
                       bool expand);
  void store_rows(const CompiledTerm& term);
  void store_curvatures(const CompiledTerm& term);
  void add_block(const JacobianBlock& block, const S* J, const S* slope, const S* curvature);
  void euler(const KnotTime<S>& when, const S* x, const S* u);
  void euler_derivative(const S& h);
  void euler_dense_derivative(const KnotTime<S>& when);
  /// These functions write the contact forces of this knot, and their derivatives, to the force
  /// states of the next state. Call them before runge_kutta(), which evaluates the dynamics at
  /// other points.
  void store_force_states(const CompiledStage& stage);
  void store_force_state_derivatives(const CompiledStage& stage);
  void jump(const CompiledStage& stage, const S* x, bool with_derivatives);
  void filter_torque(const S* x, const S* u, const S& decay, S* out) const;
  void runge_kutta(const CompiledStage& stage, const KnotTime<S>& when, const S* x, const S* u,
                   bool with_derivatives);
  void runge_kutta_derivative(const KnotTime<S>& when, int i);
  /// Replaces the derivatives of an offset by the derivatives of the point x (+) offset.
  void close_point(const S& decay, const S* offset, S* by_z);
  bool in_block(int k) const;
  void check_finite(const CompiledStage& stage, bool expanded);
  void load_status();

  const CompiledProblem* problem_;
  StageDynamics<S> dynamics_;
  std::optional<CustomLanes<S>> custom_;
  std::vector<S> step_;  ///< Increment dq of the step, nv entries
  std::vector<S> r_, jacobian_, curvatures_, weighted_, slope_, curvature_, product_;
  std::vector<int> row_list_;
  std::vector<Status> status_;
  // For Runge-Kutta steps: rates (velocity, acceleration) at the four points of a step, the current
  // point, its offset from x, and the derivatives of the rates and of the point by z.
  std::vector<S> rates_, point_, offset_, rates_by_z_, point_by_z_;
};

}  // namespace burnish::ocp
