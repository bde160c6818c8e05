// Stability margins of a polishing task's control loop against delay and wrong joint torques, and
// a choice of controller gains that meets required margins.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "burnish/mpc/margins.hpp"
#include "burnish/tasks/polishing/stages.hpp"

namespace burnish::polishing {

/// Stability margins that fit_gains() requires, in addition to the delays and filters of the loop.
/// @described polishing
struct RequiredMargins {
  double delay = 2e-3;  ///< Delay of the commands that the loop must tolerate [s], >= 0
  /// Factor on the torque of any single joint that the loop must tolerate, > 0
  /// @more The loop must also tolerate the inverse of the factor.
  double gain = 2.0;
};

/// Stability margins of the control loop of a polishing task at its starting posture.
/// @described polishing @result
struct TaskMargins {
  LoopMargins air = {};      ///< Margins with the tool in free air
  LoopMargins contact = {};  ///< Margins with the tool on the surface

  /// Returns the smaller of the delay margins in free air and in contact [s].
  double delay() const { return std::min(air.delay, contact.delay); }
  /// Returns the margins as a text, such as "2.3 ms of extra delay (in free air), gains of 0.31
  /// (joint 'wrist_3') to 3.4 (joint 'wrist_3')".
  std::string text() const;
};

/// Returns the delays and filters of a control loop that result from `disturbances`. `stiffness`
/// [N/m] and `damping` [Ns/m] describe the surface.
LoopChain chain_of(const Disturbances& disturbances, double stiffness, double damping);
/// Returns the delays and filters for which gains are fitted. They come from the disturbance preset
/// `sensors`, with the surface of the task and the motor lag that plans model. Fitted gains do not
/// depend on the disturbances of the task, because the controller does not know them.
LoopChain usual_chain(const Task& task);
/// Returns the delays and filters of the control loop that result from the disturbances of the
/// task.
LoopChain loop_chain(const Task& task);

/// Returns the stability margins of the task's control loop with the delays and filters of
/// usual_chain(). First fits the gains that the task does not state. Returns nullopt if no plan is
/// found from the start, or if margins cannot be computed (without_margins() gives the reason).
/// Throws Error in the same cases as make_mpc().
std::optional<TaskMargins> margins(const Task& task, const Setting& setting);
/// Returns the stability margins of the task's control loop with the delays and filters of `chain`.
/// First fits the gains that the task does not state, with usual_chain(). Returns nullopt if no
/// plan is found from the start, or if margins cannot be computed. Throws Error in the same cases
/// as make_mpc().
std::optional<TaskMargins> margins(const Task& task, const Setting& setting,
                                   const LoopChain& chain);

/// Result of fit_gains().
/// @described polishing @result
struct FittedGains {
  bool meets = true;  ///< True if the required margins are met or cannot be computed
  /// Gains that differ from their initial values, as a text; empty if there are none
  std::string changes = {};
};

/// Fits five gains of the task to the required margins. Gains that the task states are not changed.
/// Throws Error in the same cases as make_mpc().
///
/// Three gains are searched: model_error.boost, model_error.bandwidth and weights.position. Their
/// initial values are 6, 120 rad/s (50 rad/s with model_error.kind force) and 1e4 1/m^2. The search
/// tries values in this order and takes the first that meet `required`:
/// - weights.position times 10, 3 and 1, each with the boost from its initial value down to 1,
/// - lower bandwidths,
/// - lower weights.position.
///
/// model_error.lag is the delay from commands to velocities in usual_chain(), without the motor
/// lag. model_error.force_gain is chosen last. It is the largest of 0.5, 0.35, 0.25 and 0 with
/// which the loop in contact meets `required`. The loop must also meet `required` on a surface that
/// is three times as stiff.
///
/// The lag and the force gain are 0 in three cases:
/// - model_error.kind is force,
/// - the task states all three searched gains,
/// - margins() returns nullopt. Then the searched gains have their initial values.
FittedGains fit_gains(Task& task, const Setting& setting, const RequiredMargins& required = {});

}  // namespace burnish::polishing
