// Monitors of a pressing tool (mean force, free space, approach, contact loss), one by one.
#include "pressing/tool_watch.hpp"

#include <gtest/gtest.h>

namespace burnish::pressing {
namespace {

TEST(MeanForce, PartOrFullWindow_AveragesItsSamples) {
  MeanForce mean(4);
  for (int i = 1; i <= 3; ++i) mean.add({1.0 * i, 0.0, -1.0});
  EXPECT_FALSE(mean.is_full());
  EXPECT_EQ(mean.value(), Eigen::Vector3d(2.0, 0.0, -1.0));
  for (int i = 4; i <= 6; ++i) mean.add({1.0 * i, 0.0, -1.0});
  EXPECT_TRUE(mean.is_full());
  EXPECT_DOUBLE_EQ(mean.value().x(), 4.5);
  mean.reset();
  EXPECT_FALSE(mean.is_full());
  EXPECT_TRUE(mean.value().isZero(0.0));
  EXPECT_EQ(samples_of(0.0, 1e-3), 1);
  EXPECT_EQ(samples_of(5e-3, 1e-3), 5);
}

TEST(FreeSpaceWatch, ForceInEveryPhase_CountsOnlyInFreeSpace) {
  const ToolLimits limits{.unexpected_force = 15.0, .release = 0.5};
  const ContactDetector touch(2.0, 5);
  MeanForce mean(1);
  FreeSpaceWatch watch(limits, 2.0);
  const auto beyond = [&](Touch phase, double dt, double force) {
    const Reading reading = watch.look(phase, dt, force, mean, touch);
    return reading.value > reading.limit;
  };
  EXPECT_FALSE(beyond(Touch::Free, 0.1, 20.0)) << "the mean has too few samples";
  mean.add(Eigen::Vector3d::Zero());
  EXPECT_TRUE(beyond(Touch::Free, 0.1, 15.1));
  EXPECT_FALSE(beyond(Touch::Free, 0.1, 14.9));
  for (const Touch phase : {Touch::Due, Touch::Wanted}) EXPECT_FALSE(beyond(phase, 0.1, 1000.0));
  // The phase Leaving begins under force. After the tool has left, or after `release`, a force is
  // unexpected.
  EXPECT_FALSE(beyond(Touch::Leaving, 0.2, 30.0));
  EXPECT_FALSE(beyond(Touch::Leaving, 0.2, 1.0));
  EXPECT_TRUE(beyond(Touch::Leaving, 0.01, 30.0));
  // A bouncing tool has not left yet.
  watch.reset();
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(beyond(Touch::Leaving, 0.03, 0.0));
    EXPECT_FALSE(beyond(Touch::Leaving, 0.01, 30.0));
  }
  watch.reset();
  EXPECT_FALSE(beyond(Touch::Leaving, 0.5, 30.0));
  EXPECT_TRUE(beyond(Touch::Leaving, 0.01, 30.0));
}

TEST(ApproachWatch, ContactDue_MeasuresTravelAndTimeSinceThen) {
  ApproachWatch watch({.late_contact_travel = 0.03, .late_contact_time = 1.0});
  watch.look(false, 0.1, 0.50, 9.0);
  EXPECT_EQ(watch.travel().value, 0.0);
  watch.look(true, 0.1, 0.40, 1.4);
  watch.look(true, 0.1, 0.38, 0.2);
  EXPECT_EQ(watch.felt(), 1.4);
  EXPECT_NEAR(watch.travel().value, 0.02, 1e-15);
  EXPECT_NEAR(watch.lateness().value, 0.2, 1e-15);
  EXPECT_EQ(watch.travel().limit, 0.03);
  EXPECT_EQ(watch.lateness().limit, 1.0);
  watch.look(false, 0.1, 0.30, 0.0);
  EXPECT_EQ(watch.lateness().value, 0.0);
  watch.look(true, 0.1, 0.30, 0.0);
  EXPECT_EQ(watch.travel().value, 0.0) << "the travel starts again";
}

TEST(LossWatch, NoForce_MeasuresUninterruptedTime) {
  LossWatch watch({.contact_lost = 0.15});
  watch.look(true, 0.1, 0.0);
  EXPECT_EQ(watch.look(false, 0.1, 30.0).value, 0.0);
  watch.look(true, 0.1, 1.0);
  EXPECT_NEAR(watch.look(true, 0.1, 0.5).value, 0.2, 1e-15);
  EXPECT_EQ(watch.felt(), 1.0) << "the largest force since the loss";
  EXPECT_EQ(watch.look(true, 0.1, 0.0).limit, 0.15);
  watch.reset();
  EXPECT_EQ(watch.look(false, 0.1, 0.0).value, 0.0);
}

}  // namespace
}  // namespace burnish::pressing
