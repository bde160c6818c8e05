#include "burnish/base/thread_pool.hpp"

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

void relax() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

/// Returns when the value is no longer `old`.
template <class T>
void wait_for_change(const std::atomic<T>& value, T old, int looks) {
  for (int i = 0; i < looks; ++i) {
    if (value.load(std::memory_order_acquire) != old) return;
    relax();
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
    : pinning_(pinning), looks_(looks_with_a_core_each) {
  if (workers < 1)
    throw Error("thread pool: " + std::to_string(workers) + " workers; wanted 1 or more");
  const int cores = allowed_cores();
  if (cores > 0 && workers > cores) looks_ = 0;
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

void ThreadPool::take_pieces(int worker) {
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

void ThreadPool::serve(int worker) {
  std::uint32_t seen = 0;
  for (;;) {
    wait_for_change(round_, seen, looks_);
    seen = round_.load(std::memory_order_acquire);
    if (stop_.load(std::memory_order_relaxed)) return;
    take_pieces(worker);
    if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_one();
  }
}

void ThreadPool::run(int pieces, Call call, void* context) {
  call_ = call;
  context_ = context;
  pieces_ = pieces;
  next_.store(0, std::memory_order_relaxed);
  const bool shared = !threads_.empty() && pieces > 1;
  if (shared) {
    busy_.store(static_cast<int>(threads_.size()), std::memory_order_relaxed);
    round_.fetch_add(1, std::memory_order_release);
    round_.notify_all();
  }
  take_pieces(0);
  if (shared)
    for (int left = busy_.load(std::memory_order_acquire); left > 0;
         left = busy_.load(std::memory_order_acquire))
      wait_for_change(busy_, left, looks_);
  // Threads are done with it: their last word in `busy_` was acquired.
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

}  // namespace burnish
