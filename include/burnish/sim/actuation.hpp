// Simulated motors: delay, lag, errors, limits and failures between a controller's torque command
// and the torque in the joint.
#pragma once

#include <memory>
#include <vector>

#include "burnish/base/views.hpp"
#include "burnish/sim/disturbances.hpp"

namespace burnish {

/// Returns the standard deviation of each motor's torque noise, nv entries [Nm or N]. If
/// Disturbances::torque_loop is true, the noise of the torque sensor is included. Entries without a
/// motor are zero.
Eigen::VectorXd torque_noise(const Model& model, const Disturbances& disturbances);

/// Torques after each stage of the simulated motors, in one plant step. Every vector has nv
/// entries, in Nm or N.
/// @described sim @result
struct ActuationStep {
  /// Last valid torque command
  Eigen::VectorXd command;
  /// Torque after the delay
  Eigen::VectorXd delayed;
  /// Torque after the first-order lag
  Eigen::VectorXd tracked;
  /// Noise added to the torque after scale and bias
  Eigen::VectorXd noise;
  /// Torque that acts on the plant, after scale, bias, noise, limits and motor failures
  Eigen::VectorXd applied;
  /// Number of joints whose torque was clipped to the effort limit
  int limited = 0;
  /// Whether the previous command was used in place of an invalid command
  /// @more A command is invalid if it is not finite or has the wrong size
  bool held = false;
};

/// Simulates the motors, which turn a torque command into joint torques. The stages are, in this
/// order: delay; lag; scale and bias (unless a torque control loop cancels them); noise; effort
/// limits; motor failures. Call apply() once per plant step. After construction nothing is
/// allocated or thrown.
class Actuation {
 public:
  /// Creates the motors for plant steps of `dt` [s]. Throws Error in the same cases as
  /// check_disturbances().
  Actuation(const Model& model, const Disturbances& disturbances, double dt);
  ~Actuation();
  /// Copies the motors, including the state of the random number generators.
  Actuation(const Actuation& other);
  Actuation(Actuation&&) noexcept;
  Actuation& operator=(const Actuation& other);
  Actuation& operator=(Actuation&&) noexcept;

  /// Restarts the motors and their sequence of random numbers. Delay and lag start with the torque
  /// `tau` (nv entries), or with zero torque if `tau` is not given. If `tau` has the wrong size,
  /// nothing is reset.
  void reset() noexcept;
  void reset(const ConstVectorRef& tau) noexcept;

  /// Simulates one plant step and returns the torque that acts on the plant, step().applied.
  /// `command` has nv entries. If `command` is not finite or has the wrong size, the previous
  /// command is used.
  const Eigen::VectorXd& apply(const ConstVectorRef& command) noexcept;

  const ActuationStep& step() const { return step_; }
  /// Returns the torque scale of each entry of v, as stated in Disturbances or drawn at random.
  const Eigen::VectorXd& scale() const { return scale_; }
  /// Returns the torque bias of each entry of v, as stated in Disturbances or drawn at random [Nm
  /// or N].
  const Eigen::VectorXd& bias() const { return bias_; }
  int delay_steps() const { return delay_steps_; }

 private:
  struct Random;
  void delay() noexcept;
  void distort() noexcept;
  void fail() noexcept;

  /// A motor failure and the entries of v that fail: `count` entries from `first` on.
  struct Loss {
    MotorLoss when;
    Eigen::Index first, count;
  };

  Disturbances disturbances_;
  std::vector<char> motor_;  ///< Whether each entry of v has a motor
  Eigen::VectorXd limit_, scale_, bias_, at_rest_;
  /// Standard deviation of each motor's torque noise, without the torque sensor's noise.
  Eigen::VectorXd noise_;
  Eigen::MatrixXd queue_;  ///< Ring buffer of delayed commands, nv x delay_steps
  int delay_steps_ = 0, next_ = 0;
  std::vector<Loss> losses_;
  double dt_;
  long steps_ = 0;         ///< Plant steps since reset()
  double tracking_ = 1.0;  ///< Gain of the lag filter per plant step: 1 - exp(-cutoff dt)
  std::unique_ptr<Random> random_;
  ActuationStep step_;
};

}  // namespace burnish
