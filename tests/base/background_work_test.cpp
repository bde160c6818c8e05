// Tests of work on a background thread.
#include "base/background_work.hpp"

#include <gtest/gtest.h>

namespace burnish::test {
namespace {

TEST(BackgroundWork, RepeatedStart_RunsTheWorkOncePerStart) {
  int done = 0;
  BackgroundWork work([&] { ++done; });
  for (int i = 1; i <= 100; ++i) {
    work.start();
    work.wait();
    EXPECT_FALSE(work.is_busy());
    EXPECT_EQ(done, i);
  }
}

TEST(BackgroundWork, Destructor_WaitsForTheWork) {
  int done = 0;
  {
    BackgroundWork work([&] { ++done; });
    work.start();
  }
  EXPECT_EQ(done, 1);
}

}  // namespace
}  // namespace burnish::test
