// What a polishing task's loop tolerates of delay and wrong gains, and settings of the controller
// that make it tolerate enough.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "burnish/mpc/margins.hpp"
#include "burnish/tasks/polishing/stages.hpp"

namespace burnish::polishing {

/// What every arm must tolerate beyond what the chain of its loop has.
struct RequiredMargins {
  double delay = 2e-3;  ///< Extra delay of the commands [s].
  double gain = 2.0;    ///< Factor of one joint's torque, and its inverse.
};

/// Margins in free air and with the tool on the surface, at the starting posture.
struct TaskMargins {
  LoopMargins air = {}, contact = {};

  /// The smaller one of both.
  double delay() const { return std::min(air.delay, contact.delay); }
  /// "2.3 ms of extra delay (in free air), gains of 0.31 (joint 'wrist_3') to 3.4 (joint
  /// 'wrist_3')"
  std::string text() const;
};

/// Chain that gains are fitted to: always that of the disturbances `sensors`, with the task's
/// surface and the motors' lag that its plans know. So the gains do not depend on its disturbances.
LoopChain usual_chain(const Task& task);
/// The chain of a task's own disturbances.
LoopChain loop_chain(const Task& task);

/// Margins with the usual chain or another one; none where without_margins() says why, and where
/// there is no plan from the start. Throws Error as make_mpc() does.
std::optional<TaskMargins> margins(const Task& task, const Setting& setting);
std::optional<TaskMargins> margins(const Task& task, const Setting& setting,
                                   const LoopChain& chain);

/// Keys that fit_gains() may change.
struct FreeKeys {
  bool boost = true;      ///< model_error.boost
  bool bandwidth = true;  ///< model_error.bandwidth
  bool position = true;   ///< weights.position
};

/// What fit_gains() did.
struct FittedGains {
  bool meets = true;         ///< The required margins; true where none are computed.
  std::string changes = {};  ///< A sentence for the user; empty where nothing was changed.
};

/// Raises weights.position to at most ten times the task's value, as far as the required margins
/// allow. Where they are missed it lowers the boost, then the bandwidth, then weights.position.
/// Changes nothing where margins() has none. Throws Error as make_mpc() does.
FittedGains fit_gains(Task& task, const Setting& setting, const FreeKeys& free,
                      const RequiredMargins& required = {});

}  // namespace burnish::polishing
