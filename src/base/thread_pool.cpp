#include "base/thread_pool.hpp"

#ifdef __linux__
#include <pthread.h>
#include <sched.h>
#endif

#include <string>
#include <utility>

#include "base/to_size.hpp"
#include "burnish/base/error.hpp"

namespace burnish {
namespace {

// Number of polls before a thread sleeps (about 100 us). The next loop of a solve usually starts
// within microseconds, so a thread rarely sleeps between two loops.
constexpr int looks_with_a_core_each = 4000;

int looks_for(int workers) {
  const int cores = allowed_cores();
  return cores > 0 && workers > cores ? 0 : looks_with_a_core_each;
}

/// Factor by which an idle thread polls longer while the pool is kept awake.
constexpr int times_more_awake = 100;

/// Bit of ThreadPool::inside_ that is set while further threads may enter the loop.
constexpr int open = 1 << 30;

/// Pauses between two polls. Every 64th poll yields the core, since the awaited thread may need it.
void relax(int look) {
  constexpr int polls_per_yield = 64;
  if (look % polls_per_yield == polls_per_yield - 1) {
    std::this_thread::yield();
    return;
  }
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

/// Waits until the value differs from `old`. Polls `looks` times before it sleeps.
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
    throw Error("thread pool: the system does not allow pinning a thread to core " +
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
    throw Error("thread pool: this system does not report its cores, so threads cannot be pinned");
  if (count < workers)
    throw Error("thread pool: " + std::to_string(workers) +
                " workers are to be pinned, but this thread " + "may run on " +
                std::to_string(count) + (count == 1 ? " core" : " cores") +
                "; wanted a core for each worker");
  return cores;
}

}  // namespace

int allowed_cores() {
  const int reported = static_cast<int>(cores_of_this_thread().size());
  return reported > 0 ? reported : static_cast<int>(std::thread::hardware_concurrency());
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
  threads_.reserve(to_size(workers - 1));
  for (int w = 1; w < workers; ++w) {
    threads_.emplace_back([this, w] { serve(w); });
    if (pinned) pin(threads_.back(), cores[to_size(w)]);
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
  // Until this worker arrives, the meeting is incomplete, so meetings_ cannot change.
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

/// Records the current exception unless a piece with a lower index has failed already.
void ThreadPool::note_failure(int piece) noexcept {
  const std::lock_guard lock(failure_mutex_);
  if (failure_ && failed_piece_ < piece) return;
  failed_piece_ = piece;
  failure_ = std::current_exception();
}

/// Enters the current loop if it is open. The data of the loop are then visible to this thread.
/// Returns false if the loop is closed.
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
    // A thread that woke late for the previous loop may already have run this loop. `done` prevents
    // a second run.
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
  // Waits for all threads to leave the loop. Acquiring `inside_` makes their writes visible.
  if (shared)
    for (int left = inside_.fetch_and(~open, std::memory_order_acq_rel) & ~open; left > 0;
         left = inside_.load(std::memory_order_acquire))
      wait_for_change(inside_, left, looks_);
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

}  // namespace burnish
