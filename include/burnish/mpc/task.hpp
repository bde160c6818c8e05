// What a task is to an MpcController beside the stages of its problem: phases that follow each
// other in time, events that end some of them, quantities that are watched, and what is aimed at,
// for the record. mpc itself knows no task.
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

namespace burnish {

/// One of the phases that follow each other in a schedule.
/// @described mpc
/// What a controller does for a while; some phases end when something happens, such as contact,
/// rather than when planned.
struct SchedulePhase {
  std::string name = {};   ///< such as "approach"
  std::string stage = {};  ///< of the optimal control problem
  /// [s]; infinite for the last one only
  double duration = std::numeric_limits<double>::infinity();
  /// Event, such as "contact", that ends it, and not before; empty: its duration does. When the
  /// event is early, the clock jumps to the end; when it is late, the clock stands still `hold` s
  /// before it, so that the horizon goes on with the phase and plans the next one soon. Of the last
  /// phase it means nothing.
  std::string until = {};
  double hold = 0.05;  ///< [s]; longer than the phase: the clock stands still at its start
};

/// A clock that runs along the phases. Its time is the time of a task's targets.
class Schedule {
 public:
  /// Throws Error for no phases, durations that are not positive, an infinite one before the last,
  /// a hold that is not a positive time where an event is waited for, and an event that is not
  /// among `events`.
  Schedule(std::vector<SchedulePhase> phases, std::vector<std::string> events);
  /// The events are those that the phases name, in their order.
  explicit Schedule(std::vector<SchedulePhase> phases);

  const std::vector<SchedulePhase>& phases() const { return phases_; }
  const std::vector<std::string>& events() const { return events_; }
  double start_of(int phase) const { return starts_[static_cast<std::size_t>(phase)]; }  ///< s

  void reset() noexcept;
  /// Lets dt s pass. happened: bit e for entry e of events(), as if it were now. True if the clock
  /// jumped or stood still: plans made before are then off. An event in phases that do not wait for
  /// it means nothing, and that it is over again neither.
  bool advance(double dt, unsigned happened) noexcept;
  /// Goes to the start of a phase, such as the retreat; past the last one, to the last one.
  void jump_to(int phase) noexcept;

  double time() const { return time_; }  ///< s
  /// An event is due and did not come: the last advance() found the clock standing still for it.
  bool waits() const { return waits_; }
  int phase() const { return phase_at(time_); }
  /// Index of the phase at a time of the clock; the last one after the end.
  int phase_at(double time) const noexcept;
  /// All phases of finite duration are over.
  bool finished() const noexcept;

 private:
  std::vector<SchedulePhase> phases_;
  std::vector<std::string> events_;
  std::vector<unsigned> until_;  ///< per phase: the bit that it waits for, 0: none
  std::vector<double> starts_;
  double time_ = 0.0;
  bool waits_ = false;
  int current_ = 0;  ///< a phase that waits for an event is left by it alone
};

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
  /// of other kinds: what of the robot it is about, such as "hand 'left'"; empty: the tool, or all
  std::string part = {};
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
  /// The surface that the tool is on or comes to, as known after sense(): a function of the tool's
  /// point in the world, zero where it touches. Contacts at MpcSpec::tool that hold the world
  /// (MpcSpec::base, in whose axes the function then is) and whose references follow a surface
  /// (Reference::on) are given it along the whole horizon, and its normal at the tool is the
  /// controller's from then on. Null: those of the specification.
  virtual const Quadric* surface() const noexcept { return nullptr; }
  /// How far that gives way under the tool, m, at least 0. Costs that bring the tool to a point of
  /// the world, made for a surface that stands, bring it there across the normal of this one.
  virtual double surface_depth() const noexcept { return 0.0; }
  /// After the clock went on: one reading for each of watched().
  virtual void watch(const TaskView& /*view*/, std::span<Reading> /*readings*/) noexcept {}
  /// What led to the fault of a quantity, right after watch() found it: at most so many characters
  /// and a zero, such as "the force came to 1.4 N at most; 2 N count as contact".
  virtual void explain(std::size_t /*quantity*/, std::span<char> /*clause*/) const noexcept {}
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
