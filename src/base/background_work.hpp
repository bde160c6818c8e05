// Thread that repeats one piece of work on request, while the caller goes on.
#pragma once

#include <atomic>
#include <functional>
#include <thread>

namespace burnish {

/// Thread that runs a given function at each start(). It does not allocate after construction. Only
/// one thread, the caller, may call start(), is_busy() and wait(). The work sees the writes of the
/// caller before start(). The caller sees the writes of the work once is_busy() returns false.
class BackgroundWork {
 public:
  /// `work` must not throw. Throws std::system_error if the system cannot create a thread.
  explicit BackgroundWork(std::function<void()> work);
  /// Waits until the started work is done.
  ~BackgroundWork();
  BackgroundWork(const BackgroundWork&) = delete;
  BackgroundWork& operator=(const BackgroundWork&) = delete;

  /// Starts the work. Must not be called while is_busy().
  void start() noexcept;
  bool is_busy() const noexcept { return state_.load(std::memory_order_acquire) == State::Busy; }
  void wait() const noexcept { state_.wait(State::Busy, std::memory_order_acquire); }

 private:
  enum class State : int { Idle, Busy, Ending };
  void run() noexcept;

  std::function<void()> work_;
  std::atomic<State> state_{State::Idle};
  std::thread thread_;  // last member: starts when all other members exist
};

}  // namespace burnish
