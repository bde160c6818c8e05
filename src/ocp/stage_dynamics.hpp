// The dynamics of one knot (or one per lane): kinematics, contact solve, what the residuals share.
#pragma once

#include <optional>
#include <vector>

#include "derivatives/constrained_derivatives.hpp"
#include "ocp/compiled_problem.hpp"

namespace burnish::ocp {

/// Workspace of one worker. Allocates when made, never afterwards.
template <class S>
class StageDynamics {
 public:
  explicit StageDynamics(const CompiledProblem& problem);

  /// Loads what a knot's targets (stage.targets entries) turn; they must outlive what follows.
  void turn(const CompiledStage& stage, const S* targets);
  /// KnotTime::per_second, pace and passing; they hold until the next call.
  void set_step(const S& per_second, const S& pace, const S& passing) {
    knot_.per_second = per_second;
    knot_.pace = pace;
    knot_.passing = passing;
    dynamics_.set_pace(pace);
  }
  /// Evaluates a stage at x (nx) and u (nu): frames, momentum, a and lambda. Needs turn().
  void values(const CompiledStage& stage, const S* x, const S* u);
  /// Their derivatives by z, at the last values().
  void derivatives(const CompiledStage& stage);
  /// The jump of an impact stage at the last values(): velocity_after, and with derivatives its
  /// derivative, nv x nz (q and v columns).
  void impact(const CompiledStage& stage, bool with_derivatives);

  /// Another mass distribution of a body, which the problem's tree has already; for what is
  /// evaluated from then on.
  void set_body_inertia(int body, const BodyInertia& inertia) {
    momentum_.set_mass(problem_->tree);
    dynamics_.set_body_inertia(body, inertia);
    if (impact_) impact_->dynamics.set_body_inertia(body, inertia);
  }

  const KnotState<S>& knot() const { return knot_; }
  const S* acceleration() const { return dynamics_.a.data(); }
  const S* velocity_after() const { return impact_->dynamics.velocity_after.data(); }
  const S* impulse() const { return impact_->dynamics.lambda.data(); }
  /// nv x nz: d(a)/dz by derivatives(), d(velocity_after)/dz by impact().
  const S* derivative() const { return stacked_.data(); }
  const ConstrainedDynamics<S>& contact_dynamics() const { return dynamics_; }
  Status status(int lane) const { return status_[static_cast<std::size_t>(lane)]; }

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
  std::vector<S> stacked_;  ///< (nv + rows) x nz: d(a, lambda)/dz
  std::vector<Status> status_;
  KnotState<S> knot_;
};

}  // namespace burnish::ocp
