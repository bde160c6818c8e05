#include "base/background_work.hpp"

#include <gtest/gtest.h>

namespace burnish::test {
namespace {

TEST(BackgroundWork, is_done_each_time_that_it_is_started_and_seen_when_it_is_not_busy) {
  int done = 0;
  BackgroundWork work([&] { ++done; });
  for (int i = 1; i <= 100; ++i) {
    work.start();
    work.wait();
    EXPECT_FALSE(work.is_busy());
    EXPECT_EQ(done, i);
  }
}

TEST(BackgroundWork, is_waited_for_at_its_end) {
  int done = 0;
  {
    BackgroundWork work([&] { ++done; });
    work.start();
  }
  EXPECT_EQ(done, 1);
}

}  // namespace
}  // namespace burnish::test
