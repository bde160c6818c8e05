// What a task is to an MpcController beside the stages of its problem: events that end phases,
// quantities that are watched, and what is aimed at, for the record. mpc itself knows no task.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/mpc/controller.hpp"
#include "burnish/mpc/fault.hpp"
#include "burnish/mpc/schedule.hpp"

namespace burnish {

/// A tick whose measurement is a state, as a task sees it.
struct TaskView {
  const Measurement& measurement;
  const RigidBody& body;  ///< at that q and v
  const Schedule& schedule;
  const Command& command;  ///< of the tick before: what was aimed at then
  double dt;               ///< s since the measurement before; 0 at the first
};

/// A quantity that a task watches.
struct WatchedQuantity {
  std::string name = {};  ///< for FaultKind::Watched, such as "slip of the tool"
  std::string unit = {};  ///< such as "m"
  FaultKind fault = FaultKind::Watched;
};

/// A quantity now, and the most that it may be; NaN and what is not to be watched now are within.
struct Reading {
  double value = 0.0;
  double limit = std::numeric_limits<double>::infinity();
};

/// A task's own state while it is controlled: each controller has one of its own. What is called in
/// ticks allocates nothing and, but for aim(), throws nothing.
class MpcTask {
 public:
  virtual ~MpcTask() = default;

  /// Names that SchedulePhase::until may say; at most 32.
  virtual std::vector<std::string> events() const { return {}; }
  /// In the order in which watch() reads them: of several beyond their limits the first is the
  /// fault.
  virtual std::vector<WatchedQuantity> watched() const { return {}; }

  /// Forgets all ticks before.
  virtual void reset() noexcept {}
  /// First in every tick, before the schedule's clock goes on. The events that have come: bit e for
  /// entry e of events().
  virtual unsigned sense(const TaskView& /*view*/) noexcept { return 0; }
  /// After the clock went on: one reading for each of watched().
  virtual void watch(const TaskView& /*view*/, std::span<Reading> /*readings*/) noexcept {}
  /// Writes what is aimed at into `p_target_world` and `target_force` of the command: for the
  /// record, and for friction, which goes with the force. `time` is the schedule's, s. What it
  /// throws is kept for take_exception().
  virtual void aim(double /*time*/, Command& /*command*/) {}

 protected:
  MpcTask() = default;
  MpcTask(const MpcTask&) = default;
  MpcTask& operator=(const MpcTask&) = default;
};

struct MpcSpec;
/// Makes the state of a task for a controller of this specification. Throws Error where the two do
/// not fit together.
using MakeTask = std::function<std::unique_ptr<MpcTask>(const MpcSpec& spec)>;

}  // namespace burnish
