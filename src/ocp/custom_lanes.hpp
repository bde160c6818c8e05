// Evaluation of a user's own residual (residual::Custom) in the kernels, one lane at a time.
#pragma once

#include <vector>

#include "ocp/stage_dynamics.hpp"

namespace burnish::ocp {

/// NodeView of one lane of a knot. load() copies the lane's values.
template <class S>
class LaneView final : public NodeView {
 public:
  explicit LaneView(const CompiledProblem& problem);
  void load(const KnotState<S>& knot, const CustomResidual& residual, int lane, double time);

  const StateLayout& layout() const override { return *layout_; }
  double time() const override { return time_; }
  VectorView q() const override { return {q_.data(), q_.size()}; }
  VectorView v() const override { return {v_.data(), v_.size()}; }
  VectorView u() const override { return {u_.data(), u_.size()}; }
  VectorView tau() const override { return {tau_.data(), tau_.size()}; }
  VectorView acceleration() const override { return {a_.data(), a_.size()}; }
  Eigen::Isometry3d placement(int frame) const override;
  Vector6 velocity(int frame, const Reference& reference) const override;
  VectorView force(int contact) const override;
  MatrixView jacobian(int frame, const Reference& reference) const override;
  MatrixView force_derivative(int contact) const override;

 private:
  CompiledReference compiled(int frame, const Reference& reference) const;

  const Model* model_;
  const StateLayout* layout_;
  const KnotState<S>* knot_ = nullptr;
  const CustomResidual* residual_ = nullptr;
  int lane_ = 0;
  double time_ = 0.0;
  Eigen::VectorXd q_, v_, u_, tau_, a_, lambda_;
  mutable std::vector<S> columns_;
  mutable RowMatrix jacobian_, force_derivative_;
};

/// Evaluates custom residuals and their derivatives. Without a user's jacobian function,
/// derivatives are finite differences.
template <class S>
class CustomLanes {
 public:
  explicit CustomLanes(const CompiledProblem& problem);
  /// Writes the residual r (rows) and, unless J is null, its derivative J (rows x nz).
  void evaluate(const CompiledStage& stage, const CustomResidual& residual,
                const KnotState<S>& knot, const double* times, S* r, S* J);

 private:
  void differences(const CompiledStage& stage, const CustomResidual& residual, double time);
  /// Evaluates the residual after entry `z` of (u, dx) has changed by `by`.
  void moved_value(const CompiledStage& stage, const CustomResidual& residual, double time, int z,
                   double by, Eigen::VectorXd& out);

  const CompiledProblem* problem_;
  LaneView<S> view_;
  StageDynamics<double> moved_;  ///< Dynamics at the states of finite differences
  LaneView<double> moved_view_;
  Eigen::VectorXd value_, plus_, minus_;
  RowMatrix jacobian_;
  std::vector<double> x_, x_moved_, u_, targets_, dx_;
};

}  // namespace burnish::ocp
