#include "base/thread_pool.hpp"

#ifdef __linux__
#include <pthread.h>
#include <sched.h>
#endif

#include <string>
#include <utility>

#include "burnish/base/error.hpp"

namespace burnish {
namespace {

// Rounds follow one another within microseconds during a solve: looking this often before going to
// sleep bridges the gap without holding a core for long.
constexpr int looks_with_a_core_each = 4000;

int looks_for(int workers) {
  const int cores = allowed_cores();
  return cores > 0 && workers > cores ? 0 : looks_with_a_core_each;
}

/// While the pool is kept awake.
constexpr int times_more_awake = 100;

/// In ThreadPool::inside_.
constexpr int open = 1 << 30;

/// Between looks. Now and then the core is offered to others: whoever is waited for may be the one
/// that waits for it.
void relax(int look) {
  constexpr int between_offers = 64;
  if (look % between_offers == between_offers - 1) {
    std::this_thread::yield();
    return;
  }
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

/// Returns when the value is no longer `old`.
template <class T>
void wait_for_change(const std::atomic<T>& value, T old, int looks) {
  for (int i = 0; i < looks; ++i) {
    if (value.load(std::memory_order_acquire) != old) return;
    relax(i);
  }
  value.wait(old, std::memory_order_acquire);
}

#ifdef __linux__
std::vector<int> cores_of_this_thread() {
  std::vector<int> cores;
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof set, &set) != 0) return cores;
  for (int core = 0; core < CPU_SETSIZE; ++core)
    if (CPU_ISSET(core, &set)) cores.push_back(core);
  return cores;
}

void pin(std::thread& thread, int core) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(core, &set);
  if (pthread_setaffinity_np(thread.native_handle(), sizeof set, &set) != 0)
    throw Error("thread pool: the system does not let a thread be pinned to core " +
                std::to_string(core));
}
#else
std::vector<int> cores_of_this_thread() { return {}; }
void pin(std::thread& /*thread*/, int /*core*/) {}
#endif

std::vector<int> cores_to_pin_to(int workers) {
  std::vector<int> cores = cores_of_this_thread();
  const int count = static_cast<int>(cores.size());
  if (count == 0)
    throw Error("thread pool: this system does not say which cores there are to pin threads to");
  if (count < workers)
    throw Error("thread pool: " + std::to_string(workers) + " workers to pin and " +
                std::to_string(count) + (count == 1 ? " core" : " cores") +
                " that this thread may run on; wanted a core for each");
  return cores;
}

}  // namespace

int allowed_cores() {
  const int known = static_cast<int>(cores_of_this_thread().size());
  return known > 0 ? known : static_cast<int>(std::thread::hardware_concurrency());
}

ThreadPool::ThreadPool(int workers, Pinning pinning)
    : pinning_(pinning), looks_(looks_for(workers)), meeting_(workers, looks_) {
  if (workers < 1)
    throw Error("thread pool: " + std::to_string(workers) + " workers; wanted 1 or more");
  try {
    start(workers);
  } catch (...) {
    stop();
    throw;
  }
}

ThreadPool::~ThreadPool() { stop(); }

void ThreadPool::start(int workers) {
  const bool pinned = pinning_ == Pinning::Cores;
  const std::vector<int> cores = pinned ? cores_to_pin_to(workers) : std::vector<int>();
  threads_.reserve(static_cast<std::size_t>(workers - 1));
  for (int w = 1; w < workers; ++w) {
    threads_.emplace_back([this, w] { serve(w); });
    if (pinned) pin(threads_.back(), cores[static_cast<std::size_t>(w)]);
  }
}

void ThreadPool::stop() {
  stop_.store(true, std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

MeetingPoint::MeetingPoint(int workers, int looks)
    : workers_(workers), looks_(looks), missing_(workers) {}

void MeetingPoint::wait() {
  // Nobody meets for the next time before this worker has come.
  const std::uint32_t before = meetings_.load(std::memory_order_relaxed);
  if (missing_.fetch_sub(1, std::memory_order_acq_rel) > 1) {
    wait_for_change(meetings_, before, looks_);
    return;
  }
  missing_.store(workers_, std::memory_order_relaxed);
  meetings_.store(before + 1, std::memory_order_release);
  meetings_.notify_all();
}

void ThreadPool::take_pieces(int worker) {
  if (one_piece_each_) {
    call_(context_, worker, worker);
    return;
  }
  for (int piece = next_.fetch_add(1, std::memory_order_relaxed); piece < pieces_;
       piece = next_.fetch_add(1, std::memory_order_relaxed)) {
    try {
      call_(context_, worker, piece);
    } catch (...) {
      note_failure(piece);
    }
  }
}

/// Of the exception that is being handled.
void ThreadPool::note_failure(int piece) noexcept {
  const std::lock_guard lock(failure_mutex_);
  if (failure_ && failed_piece_ < piece) return;
  failed_piece_ = piece;
  failure_ = std::current_exception();
}

/// A thread enters a round that is open, and what the round is about is then seen by it.
bool ThreadPool::enter() {
  int seen = inside_.load(std::memory_order_acquire);
  while ((seen & open) != 0)
    if (inside_.compare_exchange_weak(seen, seen + 1, std::memory_order_acquire)) return true;
  return false;
}

void ThreadPool::leave() {
  if (inside_.fetch_sub(1, std::memory_order_acq_rel) == 1) inside_.notify_one();
}

void ThreadPool::wait_for_round(std::uint32_t seen) const {
  for (int i = 0; i < times_more_awake && awake_.load(std::memory_order_relaxed); ++i)
    for (int look = 0; look < looks_; ++look) {
      if (round_.load(std::memory_order_acquire) != seen) return;
      relax(look);
    }
  wait_for_change(round_, seen, looks_);
}

void ThreadPool::serve(int worker) {
  std::uint32_t seen = 0, done = 0;
  for (;;) {
    wait_for_round(seen);
    seen = round_.load(std::memory_order_acquire);
    if (stop_.load(std::memory_order_relaxed)) return;
    if (!enter()) continue;
    // One that woke late for a round may have entered the next, and come by here again in that.
    if (inner_round_ != done) {
      done = inner_round_;
      take_pieces(worker);
    }
    leave();
  }
}

void ThreadPool::run(int pieces, Call call, void* context) {
  call_ = call;
  context_ = context;
  pieces_ = pieces;
  next_.store(0, std::memory_order_relaxed);
  const bool shared = !threads_.empty() && pieces > 1;
  if (shared) {
    ++inner_round_;
    inside_.store(open, std::memory_order_release);
    round_.fetch_add(1, std::memory_order_release);
    round_.notify_all();
  }
  take_pieces(0);
  // Threads are done with it: their last word in `inside_` is acquired.
  if (shared)
    for (int left = inside_.fetch_and(~open, std::memory_order_acq_rel) & ~open; left > 0;
         left = inside_.load(std::memory_order_acquire))
      wait_for_change(inside_, left, looks_);
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

}  // namespace burnish
