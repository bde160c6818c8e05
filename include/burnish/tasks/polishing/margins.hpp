// Stability margins of a polishing task's control loop against delay and wrong joint torques, and
// a choice of controller gains that meets required margins.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "burnish/mpc/margins.hpp"
#include "burnish/tasks/polishing/stages.hpp"

namespace burnish::polishing {

/// Margins that every arm must have beyond the delays and filters of its loop.
/// @described polishing
struct RequiredMargins {
  double delay = 2e-3;  ///< [s], extra delay of the commands, >= 0
  double gain = 2.0;    ///< factor on one joint's torque; also its inverse, > 0
};

/// Stability margins of a polishing task's loop at its starting posture.
/// @described polishing @result
struct TaskMargins {
  LoopMargins air = {};      ///< in free air
  LoopMargins contact = {};  ///< with the tool on the surface

  /// The smaller delay margin of both situations [s].
  double delay() const { return std::min(air.delay, contact.delay); }
  /// Text such as "2.3 ms of extra delay (in free air), gains of 0.31 (joint 'wrist_3') to 3.4
  /// (joint 'wrist_3')".
  std::string text() const;
};

/// Returns the chain with the delays and filters of `disturbances`, and a surface of `stiffness`
/// [N/m] and `damping` [Ns/m].
LoopChain chain_of(const Disturbances& disturbances, double stiffness, double damping);
/// Returns the chain for which gains are fitted: delays and filters of the disturbance preset
/// `sensors`, the task's surface, and the motor lag that its plans model. Fitted gains therefore
/// do not depend on the task's disturbances, which the controller does not know.
LoopChain usual_chain(const Task& task);
/// Returns the chain with the delays and filters of the task's own disturbances.
LoopChain loop_chain(const Task& task);

/// Returns the margins with usual_chain() or with `chain`. Gains that the task does not state are
/// fitted first. Returns nullopt if margins cannot be computed (without_margins() gives the reason)
/// or if no plan is found from the start. Throws Error as make_mpc() does.
std::optional<TaskMargins> margins(const Task& task, const Setting& setting);
std::optional<TaskMargins> margins(const Task& task, const Setting& setting,
                                   const LoopChain& chain);

/// Result of fit_gains().
/// @described polishing @result
struct FittedGains {
  bool meets = true;         ///< true if the required margins are met, or cannot be computed
  std::string changes = {};  ///< sentence that names the fitted gains; empty if none was fitted
};

/// Sets model_error.boost, model_error.bandwidth, weights.position, model_error.lag and
/// model_error.force_gain where the task does not state them. The initial values of the first three
/// are 6, 120 rad/s (50 rad/s with model_error.kind force) and 1e4 /m^2.
/// The first choice that meets the required margins is kept, in this order: weights.position times
/// 10, 3 and 1, each with the boost from its initial value down to 1; then lower bandwidths; then
/// lower weights.position.
/// model_error.lag is the delay from commands to velocities in usual_chain(), without the motor
/// lag. With the other gains fixed, model_error.force_gain is the largest of 0.5, 0.35, 0.25 and 0
/// with which the contact loop meets the margins, on the stated surface and on one three times as
/// stiff. Both are 0 with model_error.kind force, if the first three are stated, and if margins()
/// returns nullopt. In the last case the first three keep their initial values. Stated values are
/// never changed. Throws Error as make_mpc() does.
FittedGains fit_gains(Task& task, const Setting& setting, const RequiredMargins& required = {});

}  // namespace burnish::polishing
