// Workers made once, that share the pieces of a loop and sleep in between.
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <type_traits>
#include <vector>

#include "base/crew.hpp"

namespace burnish {

/// Whether the threads of a pool stay where they are put.
enum class Pinning {
  None,  ///< the system places them and moves them as it likes
  /// Worker i, a thread of the pool, runs on the i-th of the cores that the calling thread was
  /// allowed when the pool was made, and nowhere else. Worker 0, the calling thread, is left as it
  /// is: the first of these cores is kept free for it, and it is the caller's to pin it there.
  /// Linux alone.
  Cores,
};

/// Cores that the calling thread may run on; 0 where the system does not say.
int allowed_cores();

/// A fixed number of workers; the thread that calls is worker 0. Which worker takes which piece is
/// left to chance, so that results are the same for any number of workers if each piece writes only
/// what is its own. Nothing is allocated after construction. One call at a time.
///
/// Between rounds of work a thread looks for the next one for some 100 us before it sleeps, and
/// some 10 ms while the pool is kept awake. With more workers than allowed cores it sleeps at once
/// and leaves its core to a worker with work. Nobody waits for a thread that wakes too late for a
/// loop.
class ThreadPool {
 public:
  /// Starts workers - 1 threads. Throws Error for less than one worker, and for pinning to fewer
  /// allowed cores than workers or on a system that cannot pin.
  explicit ThreadPool(int workers, Pinning pinning = Pinning::None);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int workers() const { return static_cast<int>(threads_.size()) + 1; }
  Pinning pinning() const { return pinning_; }
  /// Whether there were as many allowed cores as workers when the pool was made.
  bool has_a_core_each() const { return looks_ > 0; }

  /// While it lives, threads that wait for work look for it longer: to wake one can take as long as
  /// the work that it would share.
  class Awake {
   public:
    explicit Awake(ThreadPool& pool) : pool_(pool) { pool_.awake_.store(true); }
    ~Awake() { pool_.awake_.store(false); }
    Awake(const Awake&) = delete;
    Awake& operator=(const Awake&) = delete;

   private:
    ThreadPool& pool_;
  };

  /// Calls body(worker, piece) once for each piece from 0 to pieces - 1 and returns when all are
  /// done. What `body` throws does not keep other pieces from being done; then the exception of the
  /// lowest piece is thrown on to the caller, whatever the number of workers.
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

  /// Calls body(crew) once in every worker, all at the same time, so that they can meet: for work
  /// whose shares depend on one another. `body` throws nothing: a worker that left would be waited
  /// for.
  template <class Body>
  void together(Body&& body) {
    using Target = std::remove_reference_t<Body>;
    static_assert(std::is_nothrow_invocable_v<Target&, const Crew&>);
    const auto share = [&](int worker, int) {
      const Crew crew{worker, workers(), workers() > 1 ? &meeting_ : nullptr};
      crew.meet();  // no round ends before all have come
      body(crew);
    };
    one_piece_each_ = true;
    for_each(workers(), share);
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
  int looks_;  ///< at what is waited for, before going to sleep
  MeetingPoint meeting_;
  std::vector<std::thread> threads_;
  Call call_ = nullptr;
  void* context_ = nullptr;
  int pieces_ = 0;
  bool one_piece_each_ = false;  ///< worker i takes piece i
  std::atomic<int> next_{0};
  std::atomic<int> inside_{0};           ///< threads at work, and a bit while more may come
  std::atomic<std::uint32_t> round_{0};  ///< of work; threads wait for the next
  std::uint32_t inner_round_ = 0;        ///< the one that a thread inside is in
  std::atomic<bool> stop_{false};
  std::atomic<bool> awake_{false};
  std::mutex failure_mutex_;
  int failed_piece_ = 0;
  std::exception_ptr failure_;  ///< of failed_piece_, until the round is over
};

}  // namespace burnish
