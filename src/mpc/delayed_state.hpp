// What delays that are known mean for a controller: which torque has acted, and the state in which
// the next one will act.
#pragma once

#include "mpc/contact_force_estimate.hpp"
#include "mpc/measurement_gate.hpp"
#include "mpc/sent_torques.hpp"
#include "mpc/tool_motion.hpp"

namespace burnish {

struct Tree;

/// Predicts the state at which the next command acts, `lead()` after it is sent. Integrates the
/// torques that were sent already from the measured state. Without delays that state is returned.
class DelayedState {
 public:
  explicit DelayedState(const MpcSpec& spec);
  ~DelayedState();

  void reset() noexcept;
  /// Ticks between a command and the measurement that shows what it did.
  int ticks() const noexcept { return ticks_; }
  /// s from a command to its effect.
  double lead() const noexcept { return lead_; }
  /// Records the torque that was sent at the end of a tick, and its part that compensates joint
  /// friction; nv each [Nm or N]. Earlier torques are taken to equal the first.
  void send(const Eigen::VectorXd& tau, const Eigen::VectorXd& friction) noexcept;
  /// Commanded torque that acted when the measurement was taken, without its part that compensates
  /// joint friction; nv [Nm or N].
  auto acted() const noexcept { return effective_.ago(ticks_); }
  /// nv, Nm (N), the whole command that acted then.
  auto sent() const noexcept { return sent_.ago(ticks_); }

  /// What a prediction is made with, at the last good measurement.
  struct Known {
    int stage;                            ///< whose contacts hold
    double schedule_time;                 ///< s
    bool touches;                         ///< the tool, as its stage has it
    const Eigen::VectorXd& torque_error;  ///< estimated, nv [Nm or N]
    bool has_friction;             ///< of the contact's model; else the measured force has it
    Eigen::Vector3d normal_world;  ///< of length one, that contacts hold
  };
  /// Moves x (nx), the state that was measured, to the one in which the next command will act.
  /// False, and x as it was, where the dynamics cannot be evaluated.
  bool predict(ContactForceEstimate& dynamics, const MeasurementGate& gate, const Known& known,
               Eigen::VectorXd& x) noexcept;

 private:
  double tick_period_, lead_;  ///< s
  int ticks_, per_step_;       ///< of both delays together; of a step of the prediction
  int most_;                   ///< longest prediction, missing measurements included [ticks]
  int nq_, nv_;
  std::vector<int> actuated_;
  double filter_;  ///< of the torque model, what is left after a tick; 0: none
  std::unique_ptr<const Tree> tree_;
  ToolMotion tool_;
  SentTorques sent_, effective_;
  bool started_ = false;
  Eigen::VectorXd start_, tau_, total_, dq_;
};

}  // namespace burnish
