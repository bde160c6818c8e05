#include "burnish/base/thread_pool.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <numeric>

#include "support/refusal.hpp"

namespace burnish::testing {
namespace {

TEST(ThreadPool, does_every_piece_once) {
  for (const int workers : {1, 2, 4}) {
    ThreadPool pool(workers);
    EXPECT_EQ(pool.workers(), workers);
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

TEST(ThreadPool, rounds_follow_one_another_with_and_without_pause) {
  ThreadPool pool(3);
  std::vector<long> sums(5, 0);
  for (int round = 0; round < 3000; ++round) {
    if (round % 1000 == 999) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    pool.for_each(5, [&](int, int piece) { sums[static_cast<std::size_t>(piece)] += piece; });
  }
  for (int piece = 0; piece < 5; ++piece)
    EXPECT_EQ(sums[static_cast<std::size_t>(piece)], 3000L * piece);
}

TEST(ThreadPool, work_of_one_round_is_seen_in_the_next) {
  ThreadPool pool(2);
  std::vector<double> values(64, 1.0);
  for (int round = 0; round < 200; ++round)
    pool.for_each(64, [&](int, int piece) {
      const auto i = static_cast<std::size_t>(piece);
      values[i] += 1.0;
    });
  EXPECT_EQ(std::accumulate(values.begin(), values.end(), 0.0), 64 * 201.0);
}

TEST(ThreadPool, passes_on_what_the_lowest_piece_throws_when_all_are_done) {
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
      // The next round knows nothing of it.
      pool.for_each(5, work);
      EXPECT_EQ(std::accumulate(done.begin(), done.end(), 0), 25);
    }
  }
}

TEST(ThreadPool, refuses_to_have_no_worker) {
  expect_words(refusal([] { ThreadPool pool(0); }), {"0 workers", "1 or more"});
}

}  // namespace
}  // namespace burnish::testing
