// Interface between an MpcController and its task. The optimal control problem defines stages; the
// task adds phases in time, events that end phases, monitored quantities, and recorded targets.
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

class Problem;

/// Phase of a task. A schedule is a sequence of phases.
/// @described mpc
/// During a phase, a controller uses one stage of its problem. Some phases end at an event, such as
/// contact, instead of after a planned time.
struct SchedulePhase {
  /// Name of the phase, such as "approach"
  std::string name = {};
  /// Name of the stage of the optimal control problem that is used in the phase
  std::string stage = {};
  /// Duration of the phase [s]
  /// @more Only the last phase may have an infinite duration
  double duration = std::numeric_limits<double>::infinity();
  /// Event that ends the phase, such as "contact"; empty: the phase ends after its duration
  /// @more If the event is early, the schedule's clock jumps to the end of the phase. If the event
  /// is late, the clock stops at the time `hold` before the end of the phase and waits. Plans made
  /// while the clock waits contain the rest of this phase and then the next phase. The last phase
  /// ignores its event
  std::string until = {};
  /// Time before the end of the phase at which the schedule's clock waits for a late event [s]
  /// @more If `hold` is longer than the phase, the clock waits at the start of the phase
  double hold = 0.05;
};

/// Clock that runs through the phases of a task. Targets of the task are functions of the clock's
/// time.
class Schedule {
 public:
  /// Throws Error if `phases` is empty, if there are more than 32 events, or if a phase waits for
  /// an event that is not in `events`. Also throws if a duration is not positive, or if a phase
  /// before the last one has an infinite duration. If a phase ends at an event, SchedulePhase::hold
  /// must be positive and finite.
  Schedule(std::vector<SchedulePhase> phases, std::vector<std::string> events);
  /// Creates a schedule whose events are the events named in `phases`, in order of first
  /// appearance.
  explicit Schedule(std::vector<SchedulePhase> phases);

  const std::vector<SchedulePhase>& phases() const { return phases_; }
  const std::vector<std::string>& events() const { return events_; }
  /// Returns the time at which `phase` starts [s].
  double start_of(int phase) const { return starts_[static_cast<std::size_t>(phase)]; }

  void reset() noexcept;
  /// Advances the clock by `dt` [s]. Bit e of `happened` is 1 while event e of events() is present.
  /// Only the event that ends the current phase matters. A phase that has ended does not resume
  /// when its event disappears. Returns true if the clock jumped or waited. In this case, the times
  /// in earlier plans are wrong.
  bool advance(double dt, unsigned happened) noexcept;
  /// Sets the clock to the start of `phase`. An index beyond the last phase means the last phase.
  void jump_to(int phase) noexcept;

  /// Returns the time of the clock [s].
  double time() const { return time_; }
  /// Returns true if the last advance() stopped the clock to wait for a late event.
  bool waits() const { return waits_; }
  int phase() const { return phase_at(time_); }
  /// Returns the index of the phase at the clock time `time` [s]. After the end of the schedule,
  /// returns the index of the last phase.
  int phase_at(double time) const noexcept;
  /// Returns true after the end of the last phase; always false if the last phase has infinite
  /// duration.
  bool finished() const noexcept;

 private:
  std::vector<SchedulePhase> phases_;
  std::vector<std::string> events_;
  std::vector<unsigned> until_;  ///< Bit of the event that ends each phase; 0: no event
  std::vector<double> starts_;
  double time_ = 0.0;
  bool waits_ = false;
  /// Index of the current phase; a phase that waits for an event ends only at this event
  int current_ = 0;
};

/// Inputs of a task at a tick with a valid measurement.
struct TaskView {
  const Measurement& measurement;
  const RigidBody& body;  ///< Kinematics of the robot at the measured q and v
  const Schedule& schedule;
  const Command& command;  ///< Command of the previous tick, with its targets
  double dt;               ///< Time since the previous valid measurement [s]; 0 at the first one
  /// Force of the surface on each tool, measured or estimated, in world axes, 3 x tools [N]
  const Eigen::Matrix3Xd& tool_forces_world;
};

/// Quantity that a task monitors. A value beyond its limit is a fault.
struct WatchedQuantity {
  /// Name of the quantity in faults of kind FaultKind::Watched, such as "slip of the tool"
  std::string name = {};
  std::string unit = {};  ///< Unit, such as "m"
  FaultKind fault = FaultKind::Watched;
  /// Part of the robot to name in a fault report, such as "hand 'left'"; empty: the tool, or the
  /// whole robot. Used if `fault` is not FaultKind::Watched
  std::string part = {};
};

/// Current value of a monitored quantity, and upper limit of the quantity. If the value is NaN or
/// the limit is infinite, the quantity is not monitored in this tick.
struct Reading {
  double value = 0.0;
  double limit = std::numeric_limits<double>::infinity();
};

/// Interface for the state of a task during control. Each controller has a task object of its own.
/// Functions that are called in ticks must not allocate and, except aim(), must not throw.
class MpcTask {
 public:
  virtual ~MpcTask() = default;

  /// Returns the names of the events that SchedulePhase::until may use, at most 32.
  virtual std::vector<std::string> events() const { return {}; }
  /// Returns the monitored quantities, in the order in which watch() writes their readings. If
  /// several quantities exceed their limits, the first one is reported as the fault.
  virtual std::vector<WatchedQuantity> watched() const { return {}; }

  /// Forgets all previous ticks.
  virtual void reset() noexcept {}
  /// Returns the events that are present now: bit e stands for entry e of events(). Called first in
  /// every tick with a valid measurement, before the schedule's clock advances. Not called while
  /// the estimators settle (MpcSpec::settle) and after a fault.
  virtual unsigned sense(const TaskView& /*view*/) noexcept { return 0; }
  /// Returns the estimated surface that a tool touches or approaches. `tool`: index in
  /// MpcSpec::tools. If the result is null, plans keep the last surface that was not null. After
  /// reset(), plans use the surfaces of the specification until a result is not null. Called after
  /// sense(). The quadric is a function of the tool's position in the frame ToolSpec::base (in the
  /// world if `base` is empty). The function is zero where the tool touches the surface.
  ///
  /// The returned surface is the value of the input `TOOL/surface` (docs/tasks.md). It replaces the
  /// surfaces of contacts that use this input, at all knots. The normal of the returned surface at
  /// the tool becomes the controller's surface normal.
  virtual const Quadric* surface(int /*tool*/) const noexcept { return nullptr; }
  /// Returns the depth by which the surface yields under a tool [m], at least 0. `tool`: index in
  /// MpcSpec::tools. Plans shift target positions of the tool into the surface by this depth, along
  /// the surface normal.
  virtual double surface_depth(int /*tool*/) const noexcept { return 0.0; }
  /// Sets inputs of the plan's problem with Problem::set_input(). The index of an input is its
  /// position in MpcSpec::problem.inputs. Called in the tick that prepares a plan, after the
  /// controller has set its own inputs. The plan uses these values, even if a thread computes it
  /// during later ticks. An input keeps its value until it is set again, or until
  /// MpcController::reset(). Payloads are set with MpcController::set_payload() instead.
  virtual void set_inputs(Problem& /*problem*/) noexcept {}
  /// Writes one reading for each quantity of watched(). Called after the schedule's clock has
  /// advanced.
  virtual void watch(const TaskView& /*view*/, std::span<Reading> /*readings*/) noexcept {}
  /// Writes the cause of a fault into `clause`, as a zero-terminated text such as "the largest
  /// force was 1.4 N; 2 N count as contact". Called right after watch() if entry `quantity` of
  /// watched() exceeds its limit.
  virtual void explain(std::size_t /*quantity*/, std::span<char> /*clause*/) const noexcept {}
  /// Returns names and units of the values that the task publishes in traces and on pages, in
  /// addition to the signals of the controller. Names must differ from those of
  /// MpcController::signals().
  virtual std::vector<TraceColumn> signals() const { return {}; }
  /// Writes the current values of signals(). `values` has one entry per signal of the task; entries
  /// that are not written count as unknown (NaN). Called once per row of a trace. Must not
  /// allocate.
  virtual void write_signals(std::span<double> /*values*/) const noexcept {}
  /// Writes the current targets of each tool into Command::tools, as ToolCommand::p_target_world
  /// and ToolCommand::target_force. `time` is the schedule's time [s]. Both targets are recorded in
  /// traces. The estimate of the model error also uses the target force, to compute friction and
  /// force feedback. If aim() throws, MpcController::take_exception() returns the exception.
  virtual void aim(double /*time*/, Command& /*command*/) {}

 protected:
  MpcTask() = default;
  MpcTask(const MpcTask&) = default;
  MpcTask& operator=(const MpcTask&) = default;
};

struct MpcSpec;
/// Function that creates the task of a controller with the specification `spec`. Throws Error if
/// task and specification do not fit together.
using MakeTask = std::function<std::unique_ptr<MpcTask>(const MpcSpec& spec)>;

}  // namespace burnish
