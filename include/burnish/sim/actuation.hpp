// What happens to a torque between the controller and the joint.
#pragma once

#include <memory>
#include <vector>

#include "burnish/base/views.hpp"
#include "burnish/sim/disturbances.hpp"

namespace burnish {

/// Deviation of the torque noise of each motor, that of a torque loop's sensor included: nv, zero
/// where there is no motor [Nm or N].
Eigen::VectorXd torque_noise(const Model& model, const Disturbances& disturbances);

/// One plant step of the actuation: the torque after each part, nv each, Nm or N.
/// @described sim @result
struct ActuationStep {
  Eigen::VectorXd command;  ///< as it came
  Eigen::VectorXd delayed;
  Eigen::VectorXd tracked;  ///< behind the first-order lag
  Eigen::VectorXd noise;    ///< added to what follows scale and bias
  Eigen::VectorXd applied;  ///< to the plant: scaled, biased, noisy, within the limits
  int limited = 0;          ///< joints at their effort limit
  bool held = false;        ///< the command was not finite: the one before it was taken
};

/// The chain delay, lag, scale and bias (or torque loop), noise, limits, and motors that fail.
/// Called once per plant step; allocates nothing after construction and throws nothing.
class Actuation {
 public:
  /// dt: the plant's step, s. Throws Error as check_disturbances() does.
  Actuation(const Model& model, const Disturbances& disturbances, double dt);
  ~Actuation();
  /// With the state of the random numbers.
  Actuation(const Actuation& other);
  Actuation(Actuation&&) noexcept;
  Actuation& operator=(const Actuation& other);
  Actuation& operator=(Actuation&&) noexcept;

  /// Back to the start, with the same random numbers to come. The lag starts at zero torque, and
  /// so does the delay unless `tau` (nv) says what was applied before.
  void reset() noexcept;
  void reset(const ConstVectorRef& tau) noexcept;

  /// The torque for the plant's next step; `command` has nv entries. It is step().applied.
  const Eigen::VectorXd& apply(const ConstVectorRef& command) noexcept;

  const ActuationStep& step() const { return step_; }
  const Eigen::VectorXd& scale() const { return scale_; }  ///< nv, as drawn or given
  const Eigen::VectorXd& bias() const { return bias_; }    ///< nv, as drawn or given
  int delay_steps() const { return delay_steps_; }

 private:
  struct Random;
  void delay() noexcept;
  void distort() noexcept;
  void fail() noexcept;

  /// A motor that fails, by its entries of v.
  struct Loss {
    MotorLoss when;
    Eigen::Index first, count;
  };

  Disturbances disturbances_;
  std::vector<char> motor_;  ///< nv: whether the entry has one
  Eigen::VectorXd limit_, scale_, bias_, at_rest_;
  Eigen::VectorXd noise_;  ///< nv, deviation of what is added to the torque, without the loop's
  Eigen::MatrixXd queue_;  ///< nv x delay_steps, a ring
  int delay_steps_ = 0, next_ = 0;
  std::vector<Loss> losses_;
  double dt_;
  long steps_ = 0;         ///< since reset()
  double tracking_ = 1.0;  ///< part of the distance to the command that the lag covers in a step
  std::unique_ptr<Random> random_;
  ActuationStep step_;
};

}  // namespace burnish
