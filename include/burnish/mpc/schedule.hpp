// What a controller does when: phases that follow each other in time, some of which end when
// something happens, such as contact, rather than when planned.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace burnish {

struct SchedulePhase {
  std::string name = {};                                      ///< such as "approach"
  std::string stage = {};                                     ///< of the optimal control problem
  double duration = std::numeric_limits<double>::infinity();  ///< s; infinite for the last one only
  /// Event, such as "contact", that ends it, and not before; empty: its duration does. When the
  /// event is early, the clock jumps to the end; when it is late, the clock stands still `hold` s
  /// before it, so that the horizon goes on with the phase and plans the next one soon. Of the last
  /// phase it means nothing.
  std::string until = {};
  double hold = 0.05;  ///< s; longer than the phase: the clock stands still at its start
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

}  // namespace burnish
