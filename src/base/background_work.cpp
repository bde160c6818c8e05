#include "base/background_work.hpp"

namespace burnish {

BackgroundWork::BackgroundWork(std::function<void()> work)
    : work_(std::move(work)), thread_([this] { run(); }) {}

BackgroundWork::~BackgroundWork() {
  wait();
  state_.store(State::Ending, std::memory_order_release);
  state_.notify_all();
  thread_.join();
}

void BackgroundWork::start() noexcept {
  state_.store(State::Busy, std::memory_order_release);
  state_.notify_all();
}

void BackgroundWork::run() noexcept {
  while (true) {
    state_.wait(State::Idle, std::memory_order_acquire);
    if (state_.load(std::memory_order_acquire) == State::Ending) return;
    work_();
    state_.store(State::Idle, std::memory_order_release);
    state_.notify_all();
  }
}

}  // namespace burnish
