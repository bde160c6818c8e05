// Estimate of the force at the tool without a force sensor, from torques, positions and velocities.
#pragma once

#include "estimate/error_observer.hpp"

namespace burnish {

/// Estimate that separates the force f at the tool from the model error d in M a + b = tau + d +
/// J^T f. An observer estimates the sum s = d + J^T f. In free air, f is zero, and the mean of s is
/// stored. During contact, f minimizes |J^T f - (s - mean)|. model_error() is s - J^T f.
class FeltForce {
 public:
  /// `state`: a state with one tool. `supports`: contacts of `state` that always hold the robot.
  /// `touch`: force above which the mean of s is not updated, although the stage has no contact
  /// [N].
  FeltForce(const Model& model, const ModelErrorOptions& options, const RobotState& state,
            const std::vector<ContactSpec>& supports, double touch);

  void reset() noexcept;
  /// Updates the estimate, `dt` [s] after the previous call. If the dynamics cannot be evaluated,
  /// the estimate stays unchanged. `acted`: torques that act according to the torque model (nv).
  /// `free`: true if the tool has no contact in the stage.
  void update(RobotState& state, const Eigen::VectorXd& acted, double dt, bool free) noexcept;

  /// Returns the force at the tool, in world axes, 3 x 1 [N].
  const Eigen::Matrix3Xd& forces_world() const { return force_; }
  /// Model error d, nv [Nm or N].
  const Eigen::VectorXd& model_error() const { return model_error_; }
  double bandwidth() const { return observer_.bandwidth(); }  ///< Observer bandwidth [rad/s].

 private:
  ErrorObserver observer_;
  double touch_;  ///< Force above which the mean of s is not updated [N].
  Eigen::VectorXd air_, rest_, model_error_;
  Eigen::Matrix3Xd force_ = Eigen::Matrix3Xd::Zero(3, 1);
  const Eigen::Matrix3Xd no_force_ = force_;
  double learned_for_ = 0.0;  ///< Averaging time of the mean of s so far [s].
};

}  // namespace burnish
