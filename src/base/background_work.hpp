// A thread that does one piece of work at a time, so that whoever asks for it need not wait.
#pragma once

#include <atomic>
#include <functional>
#include <thread>

namespace burnish {

/// Nothing is allocated after construction. One thread asks: start(), is_busy() and wait() are its
/// alone. What it wrote before start() the work sees, and what the work wrote is seen once it is
/// not busy any more.
class BackgroundWork {
 public:
  /// `work` throws nothing. Throws std::system_error where there is no thread to be had.
  explicit BackgroundWork(std::function<void()> work);
  /// Waits for the work that was started.
  ~BackgroundWork();
  BackgroundWork(const BackgroundWork&) = delete;
  BackgroundWork& operator=(const BackgroundWork&) = delete;

  /// Not while it is busy.
  void start() noexcept;
  bool is_busy() const noexcept { return state_.load(std::memory_order_acquire) == State::Busy; }
  void wait() const noexcept { state_.wait(State::Busy, std::memory_order_acquire); }

 private:
  enum class State : int { Idle, Busy, Ending };
  void run() noexcept;

  std::function<void()> work_;
  std::atomic<State> state_{State::Idle};
  std::thread thread_;  // the last: it begins when all else is there
};

}  // namespace burnish
