// Estimate of the force at the tool without a force sensor, from torques, positions and velocities.
#pragma once

#include "mpc/measurement_gate.hpp"
#include "mpc/tool_motion.hpp"

namespace burnish {

/// Estimate that separates the force f at the tool from the model error d in M a + b = tau + d +
/// J^T f. An observer estimates the sum d + J^T f. In free air, f is zero and the sum is d. During
/// contact, the last d from free air is kept. The force f then minimizes |J^T f - rest|, where rest
/// is the sum minus the kept d. The part of rest that J^T f does not explain counts as model error.
class FeltForce {
 public:
  explicit FeltForce(const MpcSpec& spec);

  void reset() noexcept;
  /// Updates the estimate. If the dynamics cannot be evaluated, the estimate stays unchanged.
  /// `acted`: torques that act according to the torque model (nv). `free`: true if the tool has no
  /// contact in the stage.
  void update(const MeasurementGate& gate, const Eigen::VectorXd& acted, bool free) noexcept;

  /// Sets the payload at a frame, see TorqueErrorObserver::set_payload().
  void set_payload(std::string_view frame, const InertiaSpec& payload) {
    (void)observer_.set_payload(frame, payload);
  }
  const Eigen::Vector3d& force_world() const { return force_; }  ///< Force at the tool [N].
  /// Model error d, nv [Nm or N].
  const Eigen::VectorXd& model_error() const { return model_error_; }
  double bandwidth() const { return observer_.bandwidth(); }  ///< Observer bandwidth [rad/s].

 private:
  TorqueErrorObserver observer_;
  double touch_;  ///< Force above which d is not updated, although the stage is in free air [N].
  ToolMotion motion_;
  Eigen::VectorXd air_, rest_, model_error_;
  Eigen::Vector3d force_ = Eigen::Vector3d::Zero();
  double learned_for_ = 0.0;  ///< Averaging time of d so far [s].
};

}  // namespace burnish
