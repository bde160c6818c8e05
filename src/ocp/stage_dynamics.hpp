// Dynamics of one knot, or of one knot per lane: kinematics and contact solution.
#pragma once

#include <optional>
#include <vector>

#include "base/to_size.hpp"
#include "derivatives/constrained_derivatives.hpp"
#include "ocp/compiled_problem.hpp"

namespace burnish::ocp {

/// Computes the KnotState of knots. Workspace of one thread; only the constructor allocates.
template <class S>
class StageDynamics {
 public:
  explicit StageDynamics(const CompiledProblem& problem);

  /// Sets rotations, surfaces and friction coefficients from a knot's targets (stage.targets
  /// entries). The targets must stay valid until the next call.
  void turn(const CompiledStage& stage, const S* targets);
  /// Sets KnotTime::per_second, step_ratio and decaying, until the next call.
  void set_step(const S& per_second, const S& step_ratio, const S& decaying) {
    knot_.per_second = per_second;
    knot_.step_ratio = step_ratio;
    knot_.decaying = decaying;
    dynamics_.set_step_ratio(step_ratio);
  }
  /// Evaluates a stage at x (nx) and u (nu): frames, momentum, a and lambda. Call turn() first.
  void values(const CompiledStage& stage, const S* x, const S* u);
  /// Computes derivatives by z at the last values().
  void derivatives(const CompiledStage& stage);
  /// Computes velocity_after() of an impact stage at the last values() and, with derivatives,
  /// derivative() (nv x nz, nonzero in the columns of q and v).
  void impact(const CompiledStage& stage, bool with_derivatives);

  /// Sets the mass distribution of a body for the next evaluations. The problem's tree must already
  /// have the new distribution.
  void set_body_inertia(int body, const BodyInertia& inertia) {
    momentum_.set_mass(problem_->tree);
    dynamics_.set_body_inertia(body, inertia);
    if (impact_) impact_->dynamics.set_body_inertia(body, inertia);
  }

  const KnotState<S>& knot() const { return knot_; }
  const S* acceleration() const { return dynamics_.a.data(); }
  const S* velocity_after() const { return impact_->dynamics.velocity_after.data(); }
  const S* impulse() const { return impact_->dynamics.lambda.data(); }
  /// Returns d(a)/dz after derivatives(), or d(velocity_after)/dz after impact(), nv x nz.
  const S* derivative() const { return stacked_.data(); }
  const ConstrainedDynamics<S>& contact_dynamics() const { return dynamics_; }
  Status status(int lane) const { return status_[to_size(lane)]; }

 private:
  struct Impact {
    Impact(const CompiledProblem& problem);
    ConstrainedDynamics<S> dynamics;
    ConstrainedDerivatives<S> derivatives;
  };
  static void activate(const std::vector<char>& wanted, std::vector<char>& now,
                       ConstrainedDynamics<S>& dynamics);
  void apply_torques(const CompiledStage& stage);
  void stack_by_z(const CompiledStage& stage);

  const CompiledProblem* problem_;
  ConstrainedDynamics<S> dynamics_;
  ConstrainedDerivatives<S> derivatives_;
  std::optional<Impact> impact_;
  std::vector<char> active_, impact_active_;
  std::vector<FrameState<S>> frames_;
  Momentum<S> momentum_;
  MomentumDerivatives<S> momentum_derivatives_;
  std::vector<S> x_, u_, tau_, total_, passive_, dpassive_, slopes_, scratch_;
  std::vector<S> stacked_;  ///< d(a, lambda)/dz, (nv + rows) x nz
  std::vector<Status> status_;
  KnotState<S> knot_;
};

}  // namespace burnish::ocp
