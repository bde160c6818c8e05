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
  double delay = 2e-3;  ///< s, extra delay of the commands
  double gain = 2.0;    ///< factor of one joint's torque, and its inverse
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
/// there is no plan from the start. Gains that the task has not are fitted first. Throws Error as
/// make_mpc() does.
std::optional<TaskMargins> margins(const Task& task, const Setting& setting);
std::optional<TaskMargins> margins(const Task& task, const Setting& setting,
                                   const LoopChain& chain);

/// What fit_gains() did.
struct FittedGains {
  bool meets = true;         ///< the required margins, or none are computed
  std::string changes = {};  ///< a sentence; empty where nothing is fitted
};

/// Gives model_error.boost, model_error.bandwidth and weights.position values where the task has
/// none: 6, 120 rad/s and 1e4 /m^2 at first. Raises weights.position to at most ten times that, as
/// far as the required margins allow. Where they are missed it lowers the boost, then the
/// bandwidth, then weights.position. The first values stay where margins() has none; of the kind
/// force the bandwidth is then 50 rad/s. Throws Error as make_mpc() does.
FittedGains fit_gains(Task& task, const Setting& setting, const RequiredMargins& required = {});

}  // namespace burnish::polishing
