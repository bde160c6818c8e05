// Pool of threads that run the iterations of a loop in parallel and sleep between loops.
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <type_traits>
#include <vector>

#include "base/thread_team.hpp"

namespace burnish {

/// Assignment of the threads of a pool to processor cores.
enum class Pinning {
  None,  ///< The system chooses the cores
  /// Worker i > 0 runs only on core i of the cores that the calling thread may use at construction.
  /// Worker 0 is the calling thread. The pool does not pin it, but keeps core 0 free, so that the
  /// caller can pin it there. Linux only.
  Cores,
};

/// Number of cores that the calling thread may run on; 0: unknown.
int allowed_cores();

/// Pool with a fixed number of workers; the calling thread is worker 0. The assignment of pieces of
/// work to workers is not deterministic. Results do not depend on the number of workers if each
/// piece writes only its own data. The pool does not allocate after construction and supports one
/// call at a time.
///
/// Between two loops, a thread polls for about 100 us before it sleeps, or for about 10 ms while
/// the pool is kept awake. With more workers than allowed cores, the thread sleeps immediately. A
/// loop does not wait for threads that wake up too late to take a piece.
class ThreadPool {
 public:
  /// Starts workers - 1 threads. Throws Error for less than one worker. With pinning, also throws
  /// Error if there are fewer allowed cores than workers, or if the system cannot pin threads.
  explicit ThreadPool(int workers, Pinning pinning = Pinning::None);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int workers() const { return static_cast<int>(threads_.size()) + 1; }
  Pinning pinning() const { return pinning_; }
  /// Returns true if there were at least as many allowed cores as workers at construction.
  bool has_a_core_each() const { return looks_ > 0; }

  /// Guard that makes idle threads poll longer before they sleep, because waking a thread can take
  /// as long as the work itself.
  class Awake {
   public:
    explicit Awake(ThreadPool& pool) : pool_(pool) { pool_.awake_.store(true); }
    ~Awake() { pool_.awake_.store(false); }
    Awake(const Awake&) = delete;
    Awake& operator=(const Awake&) = delete;

   private:
    ThreadPool& pool_;
  };

  /// Calls body(worker, piece) once for each piece from 0 to pieces - 1 and returns when all pieces
  /// are done. An exception does not stop the other pieces. At the end, the exception of the failed
  /// piece with the lowest index is rethrown, whatever the number of workers.
  template <class Body>
  void for_each(int pieces, Body&& body) {
    using Target = std::remove_reference_t<Body>;
    run(
        pieces,
        [](void* context, int worker, int piece) {
          (*static_cast<Target*>(context))(worker, piece);
        },
        const_cast<void*>(static_cast<const void*>(&body)));  // NOLINT(*-const-cast)
  }

  /// Calls body(team) once in every worker at the same time, so that the workers can synchronise by
  /// team.meet(). `body` must not throw: the other workers would wait forever.
  template <class Body>
  void together(Body&& body) {
    using Target = std::remove_reference_t<Body>;
    static_assert(std::is_nothrow_invocable_v<Target&, const ThreadTeam&>);
    const auto work = [&](int worker, int) {
      const ThreadTeam team{worker, workers(), workers() > 1 ? &meeting_ : nullptr};
      team.meet();  // the loop must not end before every worker has started
      body(team);
    };
    one_piece_each_ = true;
    for_each(workers(), work);
    one_piece_each_ = false;
  }

 private:
  using Call = void (*)(void* context, int worker, int piece);
  void run(int pieces, Call call, void* context);
  void take_pieces(int worker);
  bool enter();
  void leave();
  void wait_for_round(std::uint32_t seen) const;
  void note_failure(int piece) noexcept;
  void serve(int worker);
  void start(int workers);
  void stop();

  Pinning pinning_;
  int looks_;  ///< Number of polls before a waiting thread sleeps
  MeetingPoint meeting_;
  std::vector<std::thread> threads_;
  Call call_ = nullptr;
  void* context_ = nullptr;
  int pieces_ = 0;
  bool one_piece_each_ = false;  ///< Whether each worker i takes exactly piece i
  std::atomic<int> next_{0};
  std::atomic<int> inside_{0};           ///< Number of threads at work, plus the bit `open`
  std::atomic<std::uint32_t> round_{0};  ///< Number of the loop; idle threads wait for a change
  std::uint32_t inner_round_ = 0;        ///< Number of the loop in which threads are at work
  std::atomic<bool> stop_{false};
  std::atomic<bool> awake_{false};
  std::mutex failure_mutex_;
  int failed_piece_ = 0;
  std::exception_ptr failure_;  ///< Exception of failed_piece_, until the end of the loop
};

}  // namespace burnish
