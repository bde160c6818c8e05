// What a controller does when: phases that follow each other in time, some of which end when
// contact is made rather than when planned.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "burnish/mpc/controller.hpp"

namespace burnish {

struct SchedulePhase {
  Phase phase = Phase::Reach;
  std::string stage = {};                                     ///< of the optimal control problem
  double duration = std::numeric_limits<double>::infinity();  ///< s; infinite for the last one only
  /// Ends when contact is made and not before. When it is made early, the clock jumps to the end;
  /// when it is late, the clock stands still `hold` s before it, so that the horizon goes on
  /// approaching and plans the contact soon. Of the last phase it means nothing.
  bool until_contact = false;
  double hold = 0.05;  ///< s; longer than the phase: the clock stands still at its start
};

/// A clock that runs along the phases. Its time is the time of a task's targets.
class Schedule {
 public:
  /// Throws Error for no phases, durations that are not positive, an infinite one before the last,
  /// and a hold that is not a positive time where contact is waited for.
  explicit Schedule(std::vector<SchedulePhase> phases);

  const std::vector<SchedulePhase>& phases() const { return phases_; }
  double start_of(int phase) const { return starts_[static_cast<std::size_t>(phase)]; }  ///< s

  void reset() noexcept;
  /// Lets dt s pass. True if the clock jumped or stood still: plans made before are then off.
  /// Contact in phases that do not wait for it means nothing, and that it is lost again neither.
  bool advance(double dt, bool contact) noexcept;
  /// Goes to the start of a phase, such as the retreat; past the last one, to the last one.
  void jump_to(int phase) noexcept;

  double time() const { return time_; }  ///< s
  /// Contact is due and was not made: the last advance() found the clock standing still for it.
  bool waits() const { return waits_; }
  int phase() const { return phase_at(time_); }
  /// Index of the phase at a time of the clock; the last one after the end.
  int phase_at(double time) const noexcept;
  /// All phases of finite duration are over.
  bool finished() const noexcept;

 private:
  std::vector<SchedulePhase> phases_;
  std::vector<double> starts_;
  double time_ = 0.0;
  bool waits_ = false;
  int current_ = 0;  ///< an until_contact phase is left by contact alone
};

}  // namespace burnish
