// Tests of the thread pool: loops, teams, exceptions and pinning to cores.
#include "base/thread_pool.hpp"

#include <gtest/gtest.h>
#ifdef __linux__
#include <sched.h>
#endif

#include <algorithm>
#include <chrono>
#include <numeric>

#include "support/refusal.hpp"

namespace burnish::testing {
namespace {

TEST(ThreadPool, EveryPiece_IsDoneOnce) {
  for (const int workers : {1, 2, 4}) {
    ThreadPool pool(workers);
    EXPECT_EQ(pool.workers(), workers);
    EXPECT_EQ(pool.has_a_core_each(), allowed_cores() == 0 || workers <= allowed_cores());
    for (const int pieces : {0, 1, 2, 7, 100}) {
      std::vector<int> done(static_cast<std::size_t>(pieces), 0);
      std::atomic<bool> worker_in_range = true;
      pool.for_each(pieces, [&](int worker, int piece) {
        ++done[static_cast<std::size_t>(piece)];
        if (worker < 0 || worker >= workers) worker_in_range = false;
      });
      for (const int count : done) EXPECT_EQ(count, 1);
      EXPECT_TRUE(worker_in_range);
    }
  }
}

TEST(ThreadPool, ConsecutiveRounds_CompleteWithAndWithoutPause) {
  ThreadPool pool(3);
  std::vector<long> sums(5, 0);
  for (int round = 0; round < 3000; ++round) {
    if (round % 1000 == 999) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    pool.for_each(5, [&](int, int piece) { sums[static_cast<std::size_t>(piece)] += piece; });
  }
  for (int piece = 0; piece < 5; ++piece)
    EXPECT_EQ(sums[static_cast<std::size_t>(piece)], 3000L * piece);
}

TEST(ThreadPool, WorkOfOneRound_IsVisibleInTheNext) {
  ThreadPool pool(2);
  std::vector<double> values(64, 1.0);
  for (int round = 0; round < 200; ++round)
    pool.for_each(64, [&](int, int piece) {
      const auto i = static_cast<std::size_t>(piece);
      values[i] += 1.0;
    });
  EXPECT_EQ(std::accumulate(values.begin(), values.end(), 0.0), 64 * 201.0);
}

TEST(ThreadPool, ThrowingPieces_RethrowTheLowestAfterAllAreDone) {
  for (const int workers : {1, 2, 4}) {
    ThreadPool pool(workers);
    for (int round = 0; round < 50; ++round) {
      std::vector<int> done(20, 0);
      const auto work = [&](int, int piece) {
        ++done[static_cast<std::size_t>(piece)];
        if (piece == 5 || piece == 6 || piece == 19) throw Error("piece " + std::to_string(piece));
      };
      EXPECT_EQ(refusal([&] { pool.for_each(20, work); }), "piece 5");
      EXPECT_EQ(std::count(done.begin(), done.end(), 1), 20);
      // The exception does not affect the next round.
      pool.for_each(5, work);
      EXPECT_EQ(std::accumulate(done.begin(), done.end(), 0), 25);
    }
  }
}

TEST(ThreadPool, ZeroWorkers_AreRefused) {
  expect_words(refusal([] { ThreadPool pool(0); }), {"0 workers", "1 or more"});
}

TEST(ThreadPool, Team_SynchronizesAtEveryMeeting) {
  for (const int workers : {1, 2, 3, 5}) {
    ThreadPool pool(workers);
    const ThreadPool::Awake awake(pool);
    std::vector<int> steps(static_cast<std::size_t>(workers), 0);
    std::atomic<int> wrong = 0;
    for (int round = 0; round < 20; ++round) {
      std::fill(steps.begin(), steps.end(), 0);
      pool.together([&](const ThreadTeam& team) noexcept {
        if (team.workers != workers || team.leads() != (team.worker == workers - 1)) ++wrong;
        for (int step = 1; step <= 50; ++step) {
          steps[static_cast<std::size_t>(team.worker)] = step;
          team.meet();
          for (const int other_step : steps)
            if (other_step != step) ++wrong;
          team.meet();
        }
      });
      // for_each still works after together().
      int sum = 0;
      std::mutex mutex;
      pool.for_each(3, [&](int, int piece) {
        const std::lock_guard lock(mutex);
        sum += piece;
      });
      EXPECT_EQ(sum, 3);
    }
    EXPECT_EQ(wrong, 0);
  }
}

TEST(ThreadPool, LateWakingThread_JoinsEachTeamOnce) {
  ThreadPool pool(2);
  std::atomic<int> came{0};
  constexpr int rounds = 15000;
  for (int round = 0; round < rounds; ++round) {
    // This round may end before the other worker wakes; that worker must still join the team once.
    pool.for_each(2, [](int, int) {});
    pool.together([&](const ThreadTeam& team) noexcept {
      ++came;
      team.meet();
    });
  }
  EXPECT_EQ(came, 2 * rounds);
}

TEST(ThreadPool, MoreWorkersThanCores_DoAllPieces) {
  const int workers = std::min(64, 2 * std::max(1, allowed_cores()) + 1);
  ThreadPool pool(workers);
  std::vector<long> sums(100, 0);
  for (int round = 0; round < 300; ++round)
    pool.for_each(100, [&](int, int piece) { sums[static_cast<std::size_t>(piece)] += piece; });
  for (int piece = 0; piece < 100; ++piece)
    EXPECT_EQ(sums[static_cast<std::size_t>(piece)], 300L * piece);
}

#ifdef __linux__

cpu_set_t cores_of_this_thread() {
  cpu_set_t set;
  CPU_ZERO(&set);
  EXPECT_EQ(sched_getaffinity(0, sizeof set, &set), 0);
  return set;
}

/// Restores the cores of the thread after each test.
class PinnedThreads : public ::testing::Test {
 protected:
  void TearDown() override { sched_setaffinity(0, sizeof before_, &before_); }
  std::vector<int> allowed() const {
    std::vector<int> cores;
    for (int core = 0; core < CPU_SETSIZE; ++core)
      if (CPU_ISSET(core, &before_)) cores.push_back(core);
    return cores;
  }
  const cpu_set_t before_ = cores_of_this_thread();
};

TEST_F(PinnedThreads, Workers_RunOnTheirOwnCoresAndTheCallerIsNotPinned) {
  const std::vector<int> cores = allowed();
  EXPECT_EQ(allowed_cores(), static_cast<int>(cores.size()));
  const int workers = std::min<int>(4, static_cast<int>(cores.size()));
  ThreadPool pool(workers, Pinning::Cores);
  EXPECT_EQ(pool.pinning(), Pinning::Cores);
  std::vector<cpu_set_t> seen(static_cast<std::size_t>(workers), before_);
  std::atomic<int> arrived = 0;
  pool.for_each(workers, [&](int worker, int) {
    seen[static_cast<std::size_t>(worker)] = cores_of_this_thread();
    // Waits until every worker has one piece, so that no worker takes a second one.
    ++arrived;
    while (arrived < workers) std::this_thread::yield();
  });
  for (int w = 1; w < workers; ++w) {
    const cpu_set_t& set = seen[static_cast<std::size_t>(w)];
    EXPECT_EQ(CPU_COUNT(&set), 1) << w;
    EXPECT_TRUE(CPU_ISSET(cores[static_cast<std::size_t>(w)], &set)) << w;
  }
  const cpu_set_t caller = cores_of_this_thread();
  EXPECT_TRUE(CPU_EQUAL(&caller, &before_));
}

TEST_F(PinnedThreads, MoreThreadsThanCores_AreRefused) {
  const int cores = allowed_cores();
  expect_words(refusal([&] { ThreadPool pool(cores + 1, Pinning::Cores); }),
               {std::to_string(cores + 1) + " workers", std::to_string(cores) + " core"});
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(allowed().back(), &one);
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(allowed_cores(), 1);
  expect_words(refusal([] { ThreadPool pool(2, Pinning::Cores); }), {"2 workers", "1 core;"});
  ThreadPool alone(1, Pinning::Cores);
  EXPECT_EQ(alone.workers(), 1);
  // Without pinning, two threads run on one core.
  ThreadPool pool(2);
  int sum = 0;
  std::mutex mutex;
  pool.for_each(10, [&](int, int piece) {
    const std::lock_guard lock(mutex);
    sum += piece;
  });
  EXPECT_EQ(sum, 45);
}

#endif

}  // namespace
}  // namespace burnish::testing
