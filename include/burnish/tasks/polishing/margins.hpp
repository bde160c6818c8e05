// Stability margins of a polishing task's control loop, against extra delay and against wrong joint
// torques. Functions that choose controller gains with sufficient margins.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "burnish/mpc/margins.hpp"
#include "burnish/tasks/polishing/stages.hpp"

namespace burnish::polishing {

/// Stability margins that a control loop must have with the gains from fit_gains(). The loop
/// already contains the usual delays and filters.
/// @described polishing
struct RequiredMargins {
  double delay = 2e-3;  ///< Extra delay of commands that the control loop must tolerate [s], >= 0
  /// Factor on the torque of any one joint that the control loop must tolerate, > 0
  /// @more The control loop must also tolerate the inverse of the factor.
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

/// Returns the delays and filters that `disturbances` cause in a control loop. `stiffness` [N/m]
/// and `damping` [Ns/m] describe the surface.
LoopChain chain_of(const Disturbances& disturbances, double stiffness, double damping);
/// Returns the control loop that fit_gains() assumes. Delays and filters are those of the
/// disturbance preset `sensors`. Surface and motor lag are those that the task's plans assume. The
/// disturbances of the task are not used, because the controller does not know them.
LoopChain usual_chain(const Task& task);
/// Returns the delays and filters that the task's disturbances cause in the control loop.
LoopChain loop_chain(const Task& task);

/// Returns the stability margins of the task's control loop with the delays and filters of
/// usual_chain(). Gains without a value in the task are first chosen by fit_gains(). Returns
/// nullopt if no plan is found from the start, or if margins cannot be computed (without_margins()
/// returns the reason). Throws Error in the same cases as make_mpc().
std::optional<TaskMargins> margins(const Task& task, const Setting& setting);
/// Returns the stability margins of the task's control loop with the delays and filters of `chain`.
/// Gains without a value in the task are first chosen by fit_gains(), which uses usual_chain()
/// instead of `chain`. Returns nullopt if no plan is found from the start, or if margins cannot be
/// computed. Throws Error in the same cases as make_mpc().
std::optional<TaskMargins> margins(const Task& task, const Setting& setting,
                                   const LoopChain& chain);

/// Result of fit_gains().
/// @described polishing @result
struct FittedGains {
  bool meets = true;  ///< True if the required margins are met or cannot be computed
  /// Gains that differ from their initial values, as a text; empty if there are none
  std::string changes = {};
};

/// Chooses five gains of the task such that the control loop has the margins `required`. Gains with
/// a value in the task are not changed. Throws Error in the same cases as make_mpc().
///
/// Three gains are searched: model_error.transient_scale, model_error.bandwidth and
/// weights.position. Their initial values are 6, 120 rad/s (50 rad/s with model_error.kind force)
/// and 1e4 1/m^2. The search tries values in the following order and takes the first values that
/// meet `required`:
/// - weights.position times 10, 3 and 1, each with transient_scale decreasing to 1,
/// - lower bandwidths,
/// - lower weights.position.
///
/// model_error.lag is set to the delay from commands to velocities in usual_chain(), without the
/// motor lag. model_error.force_gain is chosen last, as the largest of 0.5, 0.35, 0.25 and 0 with
/// which the control loop in contact has the margins `required`. The control loop must also have
/// these margins on a surface that is three times as stiff.
///
/// The lag and the force gain are 0 in three cases:
/// - model_error.kind is force,
/// - all three searched gains have values in the task,
/// - margins() returns nullopt. In this case the three searched gains have their initial values.
FittedGains fit_gains(Task& task, const Setting& setting, const RequiredMargins& required = {});

}  // namespace burnish::polishing
