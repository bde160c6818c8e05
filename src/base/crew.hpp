// Workers that do one piece of work together, each its own share, and wait for one another in
// between.
#pragma once

#include <atomic>
#include <cstdint>

namespace burnish {

/// Where the workers of a crew wait for one another. Nothing is allocated.
class MeetingPoint {
 public:
  /// Looks so many times for the others to arrive before it sleeps.
  MeetingPoint(int workers, int looks);
  MeetingPoint(const MeetingPoint&) = delete;
  MeetingPoint& operator=(const MeetingPoint&) = delete;

  /// Returns when all workers have called it. What each wrote before is then seen by all.
  void wait();

 private:
  int workers_, looks_;
  // On cache lines of their own: one is written by all who arrive, the other read by all who wait.
  alignas(64) std::atomic<int> missing_;
  alignas(64) std::atomic<std::uint32_t> meetings_{0};
};

/// What a worker knows of the crew that it belongs to. As it stands: a worker alone.
struct Crew {
  int worker = 0;
  int workers = 1;
  MeetingPoint* meeting = nullptr;

  bool alone() const { return workers == 1; }
  /// One of them does what cannot be shared.
  bool leads() const { return worker == workers - 1; }
  /// Every worker of the crew must call it equally often.
  void meet() const {
    if (meeting != nullptr) meeting->wait();
  }
};

}  // namespace burnish
