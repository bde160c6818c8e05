// Tests of knot times with even and uneven steps.
#include "burnish/mpc/knot_times.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/refusal.hpp"

namespace burnish {
namespace {

TEST(KnotTimes, EvenSteps_GiveMultiplesOfTheStep) {
  const KnotTimes times(std::vector<double>(50, 0.01));
  EXPECT_TRUE(times.is_even());
  for (int k = 0; k <= 50; ++k) EXPECT_EQ(times.after(k), k * 0.01);
  for (const double after : {0.0, 0.0123, 0.37, 0.499}) EXPECT_EQ(times.place(after), after / 0.01);
}

TEST(KnotTimes, UnevenSteps_PlaceATimeBetweenItsKnots) {
  const KnotTimes times(std::vector<double>{0.01, 0.02, 0.04});
  EXPECT_FALSE(times.is_even());
  EXPECT_DOUBLE_EQ(times.after(3), 0.07);
  EXPECT_DOUBLE_EQ(times.step(2), 0.04);
  const double wanted[][2] = {{-1.0, 0.0}, {0.0, 0.0},   {0.005, 0.5}, {0.01, 1.0},
                              {0.02, 1.5}, {0.04, 2.25}, {0.07, 3.0},  {9.0, 3.0}};
  for (const auto& [after, place] : wanted) EXPECT_NEAR(times.place(after), place, 1e-12) << after;
}

TEST(KnotTimes, MovedKnot_ChangesBothStepsAndIsCopied) {
  KnotTimes times(std::vector<double>(4, 0.1)), first(std::vector<double>(2, 0.3));
  times.move(1, 0.12);
  EXPECT_FALSE(times.is_even());
  EXPECT_DOUBLE_EQ(times.step(0), 0.12);
  EXPECT_DOUBLE_EQ(times.step(1), 0.08);
  EXPECT_NEAR(times.place(0.16), 1.5, 1e-12);
  first.copy_first(times);
  EXPECT_EQ(first.knots(), 2);
  EXPECT_DOUBLE_EQ(first.after(2), 0.2);
  EXPECT_FALSE(first.is_even());
}

TEST(KnotTimes, StepsThatAreNotPositive_AreRefused) {
  testing::expect_words(testing::refusal([] { KnotTimes(std::vector<double>()); }), {"no steps"});
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL})
    testing::expect_words(testing::refusal([&] {
                            KnotTimes(std::vector<double>{0.1, bad});
                          }),
                          {"knot 1", "positive"});
}

}  // namespace
}  // namespace burnish
