// Team of threads that work on parts of one task at the same time and synchronise in between.
#pragma once

#include <atomic>
#include <cstdint>

namespace burnish {

/// Barrier at which the workers of a team wait for each other. It does not allocate.
class MeetingPoint {
 public:
  /// `looks` is the number of times that a waiting worker polls before it sleeps.
  MeetingPoint(int workers, int looks);
  MeetingPoint(const MeetingPoint&) = delete;
  MeetingPoint& operator=(const MeetingPoint&) = delete;

  /// Returns when all workers have called wait(). Writes of any worker before the call are then
  /// visible to all workers.
  void wait();

 private:
  int workers_, looks_;
  // Separate cache lines: arriving workers write missing_, waiting workers read meetings_.
  alignas(64) std::atomic<int> missing_;
  alignas(64) std::atomic<std::uint32_t> meetings_{0};
};

/// Position of one worker in a team. Default: a team of one worker.
struct ThreadTeam {
  int worker = 0;
  int workers = 1;
  MeetingPoint* meeting = nullptr;

  bool alone() const { return workers == 1; }
  /// Returns true for one worker of the team. This worker does the work that cannot be divided.
  bool leads() const { return worker == workers - 1; }
  /// Waits for all workers of the team. Every worker must call meet() equally often.
  void meet() const {
    if (meeting != nullptr) meeting->wait();
  }
};

}  // namespace burnish
