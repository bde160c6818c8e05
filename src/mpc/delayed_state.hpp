// Compensation of the delays of commands and measurements. It stores past torques and predicts the
// state in which the next command will act.
#pragma once

#include <span>

#include "estimate/contact_force_estimate.hpp"
#include "estimate/loop_times.hpp"
#include "estimate/sent_torques.hpp"
#include "mpc/measurement_gate.hpp"

namespace burnish {

struct Tree;

/// Prediction of the state in which the next command acts, lead() seconds after it is sent. The
/// prediction starts at the measured state and integrates the dynamics with the torques already
/// sent. Without delays, the predicted state is the measured state.
class DelayedState {
 public:
  /// `stale`: longest time without a measurement for which a state is predicted [s]. `tools`:
  /// number of tools.
  DelayedState(const ProblemSpec& problem, const LoopTimes& times, double stale, std::size_t tools);
  ~DelayedState();

  void reset() noexcept;
  /// Returns the number of ticks between a command and the first measurement that shows its effect.
  int ticks() const noexcept { return ticks_; }
  /// Returns the time from a command to its effect [s].
  double lead() const noexcept { return lead_; }
  /// Records the torque sent at the end of a tick, and the part of it that compensates joint
  /// friction; nv each [Nm or N]. For times before the first call, the torques of the first call
  /// are assumed.
  void send(const Eigen::VectorXd& tau, const Eigen::VectorXd& friction) noexcept;
  /// Returns the commanded torque that acted at the time of the measurement, without the
  /// compensation of joint friction; nv [Nm or N].
  auto acted() const noexcept { return effective_.ago(ticks_); }
  /// Returns the commanded torque that acted at the time of the measurement, including the
  /// compensation of joint friction; nv [Nm or N].
  auto sent() const noexcept { return sent_.ago(ticks_); }

  /// Inputs of a prediction at one tool.
  struct PredictionTool {
    double contact_threshold;  ///< Normal force above which the tool is in contact [N].
    /// True if the contact has a friction model. If false, the measured force along the surface is
    /// used instead.
    bool has_friction;
    Eigen::Vector3d normal_world;  ///< Unit normal of the surface, in world axes.
  };
  /// Inputs of a prediction, at the time of the last valid measurement.
  struct PredictionInput {
    int stage;                            ///< Stage whose contacts are active.
    double schedule_time;                 ///< Time of the schedule [s].
    const Eigen::VectorXd& torque_error;  ///< Estimated torque error, nv [Nm or N].
    std::span<const PredictionTool> tools;
  };
  /// Replaces the measured state x (nx) by the state in which the next command will act. Returns
  /// false and leaves x unchanged if the dynamics cannot be evaluated.
  bool predict(ContactForceEstimate& contacts, MeasurementGate& gate, const PredictionInput& input,
               Eigen::VectorXd& x) noexcept;

 private:
  void feel(const ContactForceEstimate& contacts, MeasurementGate& gate,
            const PredictionInput& input) noexcept;

  double tick_period_, lead_;  ///< Tick period and value of lead() [s].
  int ticks_;                  ///< Delay of commands plus delay of measurements [ticks].
  int per_step_;               ///< Length of an integration step [ticks].
  int max_ticks_;  ///< Longest prediction; it includes ticks with missing measurements [ticks].
  int nq_, nv_;
  std::vector<int> actuated_;
  double filter_;  ///< Decay factor per tick of the filter in the torque model; 0: no filter.
  std::unique_ptr<const Tree> tree_;
  SentTorques sent_, effective_;
  bool started_ = false;
  Eigen::VectorXd start_, tau_, total_, dq_;
  std::vector<char> holds_;  ///< Per tool: 1 if the tool is in contact.
  /// Joint torques of measured tool forces that contact models do not produce, nv [Nm or N].
  Eigen::VectorXd felt_;
};

}  // namespace burnish
