// Observer of the torque error that reads a RobotState. TorqueErrorObserver is its public form.
#pragma once

#include <algorithm>

#include "burnish/estimate/model_error.hpp"
#include "estimate/robot_state.hpp"

namespace burnish {

/// Detects changes of the torque error that exceed its noise, and computes a factor on the
/// observer's bandwidth from them.
class ChangeDetector {
 public:
  ChangeDetector(const Model& model, const ModelErrorOptions& options);
  void reset() noexcept;
  /// Processes the change of the torque error over the last `dt` [s], during which the bandwidth
  /// was scaled by factor(). Measurement noise changes the torque error in proportion to the square
  /// of the bandwidth. Rates are therefore divided by the square of factor().
  void see(const Eigen::VectorXd& change, double dt) noexcept;
  /// Returns the factor on the observer's bandwidth.
  double factor() const {
    return quiescent_scale_ + (1.0 - quiescent_scale_) * std::max(busy_, level_) +
           (transient_scale_ - 1.0) * level_;
  }

 private:
  void detect_jumps(const Eigen::VectorXd& change, double rate, double dt, double weight) noexcept;
  void detect_drift(const Eigen::VectorXd& change, double rate, double dt, double weight) noexcept;

  double transient_scale_, quiescent_scale_;
  Eigen::VectorXd rate_;                  ///< Smoothed rate of the torque error [Nm/s].
  Eigen::VectorXd usual_, floor_;         ///< Usual squared rate and its lower bound [Nm^2/s^2].
  Eigen::VectorXd slow_;                  ///< Low-pass filtered rate, for detect_drift() [Nm/s].
  Eigen::VectorXd slow_square_, square_;  ///< Mean squares of slow_ and of the rate [Nm^2/s^2].
  double level_ = 0.0;                    ///< Strength of a transient, 0 to 1.
  double seen_ = 0.0;                     ///< Time for which rates have been observed [s].
  double busy_ = 1.0;                     ///< Strength of a drift, 0 to 1.
};

class ErrorObserver {
 public:
  /// Arguments as those of TorqueErrorObserver. `state`: a state with `supports` among its
  /// contacts. Throws Error for an unknown frame and for options out of range.
  ErrorObserver(const Model& model, const ModelErrorOptions& options, const RobotState& state,
                const std::vector<ContactSpec>& supports, const std::vector<std::string>& measured);

  void reset() noexcept;
  /// Updates the estimate at `state`, as TorqueErrorObserver::update() does. `forces_world`: force
  /// on each tool of `state`, in world axes, 3 x tools [N].
  Status update(RobotState& state, const ConstVectorRef& tau, const Eigen::Matrix3Xd& forces_world,
                double dt, const Wrenches& supports) noexcept;
  const Eigen::VectorXd& torque_error() const { return error_; }
  double bandwidth() const { return bandwidth_; }

 private:
  bool remove_balanced_part(ContactDynamics& closed) noexcept;
  void delay(const RigidBody& body, const ConstVectorRef& tau, double dt) noexcept;

  ModelErrorOptions options_;
  RobotState::ActiveContacts closed_;  ///< Supports and loops, if no wrenches are measured.
  /// Closed loops of the robot and supports without a sensor; used if other supports have sensors.
  RobotState::ActiveContacts unmeasured_;
  std::vector<int> sensors_;  ///< Frames at which wrenches are measured.
  Reference local_ = Reference::local();
  RowMatrix jacobian_;
  bool started_ = false;
  Eigen::VectorXd velocity_, error_, total_, innovation_, change_;
  Eigen::VectorXd late_;   ///< Torque minus gravity torque, delayed; nv [Nm or N].
  Eigen::VectorXd limit_;  ///< Largest magnitude of `error_`, nv [Nm or N].
  ChangeDetector change_detector_;
  double bandwidth_;  ///< Bandwidth that the last update used [rad/s].
};

}  // namespace burnish
