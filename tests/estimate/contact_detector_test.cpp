// Detection of touch and contact loss with a noisy force sensor: no false alarms, and the delay of
// true detections.
#include "estimate/contact_detector.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace burnish::test {
namespace {

constexpr double threshold = 2.0;  // [N]
constexpr int window = 10;         // samples: 5 ms at 2 kHz

/// White noise, low-pass filtered if the gain of the filter per sample is below 1.
class Noise {
 public:
  Noise(double deviation, double gain, unsigned seed)
      : normal_(0.0, deviation), gain_(gain), random_(seed) {}
  double operator()() { return value_ += gain_ * (normal_(random_) - value_); }

 private:
  std::normal_distribution<double> normal_;
  double gain_, value_ = 0.0;
  std::mt19937_64 random_;
};

/// Adds samples of force and noise until a condition holds. Returns their number, else -1.
template <class Condition>
int samples_until(ContactDetector& detector, Noise& noise, double force, int max_samples,
                  const Condition& holds) {
  for (int i = 1; i <= max_samples; ++i) {
    detector.add(force + noise(), false);
    if (holds(detector)) return i;
  }
  return -1;
}

const auto touching = [](const ContactDetector& d) { return d.touches(); };
const auto lost = [](const ContactDetector& d) { return d.is_lost(30.0); };

TEST(ContactDetector, QuietSensor_DetectsATouchInOneSample) {
  ContactDetector detector(threshold, window);
  Noise noise(0.1, 1.0, 1);
  for (int i = 0; i < 1000; ++i) detector.add(noise(), true);
  EXPECT_FALSE(detector.touches());
  detector.add(2.5, false);
  EXPECT_TRUE(detector.touches());
  detector.add(0.5, false);
  EXPECT_FALSE(detector.touches());
  EXPECT_TRUE(detector.is_lost(30.0));
  EXPECT_EQ(detector.above_noise(15.0, window), 15.0);
}

TEST(ContactDetector, NoiseAlone_IsNeitherTouchNorPressing) {
  for (const double deviation : {0.5, 2.0, 10.0})
    for (const double gain : {1.0, 0.15})
      for (unsigned seed = 0; seed < 20; ++seed) {
        ContactDetector detector(threshold, window);
        Noise noise(deviation, gain, seed);
        for (int i = 0; i < 1000; ++i) detector.add(noise(), true);
        // Five seconds in the air: the detector reports neither a touch nor a pressing tool.
        EXPECT_EQ(samples_until(detector, noise, 0.0, 10000, touching), -1)
            << deviation << " N, " << gain << ", seed " << seed;
        for (int i = 0; i < 2000; ++i) {
          detector.add(noise(), false);
          ASSERT_TRUE(detector.is_lost(deviation < 5.0 ? 30.0 : 200.0)) << deviation << " " << gain;
        }
      }
}

TEST(ContactDetector, NoisySensor_FindsTouchAndLossWithinAWindow) {
  for (const double gain : {1.0, 0.15})
    for (unsigned seed = 0; seed < 20; ++seed) {
      ContactDetector detector(threshold, window);
      Noise noise(2.0, gain, seed);
      for (int i = 0; i < 1000; ++i) detector.add(noise(), true);
      const int touch_samples = samples_until(detector, noise, 12.0, 50, touching);
      EXPECT_GT(touch_samples, 0) << seed;
      EXPECT_LE(touch_samples, window) << seed;
      // The detector reports a loss after the force has vanished, not before.
      for (int i = 0; i < 2000; ++i) {
        detector.add(30.0 + noise(), false);
        ASSERT_FALSE(i > window && detector.is_lost(30.0)) << seed;
      }
      const int loss_samples = samples_until(detector, noise, 0.0, 50, lost);
      EXPECT_GT(loss_samples, 0) << seed;
      EXPECT_LE(loss_samples, window + 5) << seed;
    }
}

TEST(ContactDetector, NoiseNotEstimatedYet_NeedsAWholeWindow) {
  ContactDetector detector(threshold, window);
  for (int i = 0; i < window - 1; ++i) {
    detector.add(5.0, true);
    EXPECT_FALSE(detector.touches()) << i;
  }
  detector.add(5.0, true);
  EXPECT_TRUE(detector.touches());
  EXPECT_FALSE(detector.knows_noise());
  detector.reset();
  EXPECT_FALSE(detector.touches());
}

TEST(ContactDetector, OffsetOrTouchInTraining_LeavesTheNoiseEstimate) {
  Noise noise(0.1, 1.0, 3);
  ContactDetector detector(threshold, window);
  for (int i = 0; i < 400; ++i)
    detector.add(1.2 + noise(), true);  // weight of a tool that the sensor does not compensate
  EXPECT_FALSE(detector.touches());
  EXPECT_LT(detector.above_noise(0.0, window), 0.5);
  // A collision during the training does not raise the noise estimate.
  for (int i = 0; i < 40; ++i) detector.add(30.0 + noise(), true);
  EXPECT_LT(detector.above_noise(0.0, window), 0.5);
}

TEST(ContactDetector, NoisySensor_GivesSixStandardErrors) {
  ContactDetector detector(threshold, window);
  Noise noise(10.0, 1.0, 5);
  for (int i = 0; i < 2500; ++i) detector.add(noise(), true);
  EXPECT_NEAR(detector.above_noise(0.0, window), 6.0 * 10.0 / std::sqrt(10.0), 4.0);
  EXPECT_GT(detector.above_noise(0.0, 1), 50.0);
}

TEST(RunningMedian, FullBuffer_IgnoresFurtherSamples) {
  RunningMedian median(5);
  EXPECT_EQ(median.value(), 0.0);
  for (const double x : {5.0, 1.0, 3.0}) median.add(x);
  EXPECT_EQ(median.value(), 3.0);
  median.add(std::nan(""));
  for (const double x : {100.0, 2.0, -50.0, -60.0}) median.add(x);
  EXPECT_EQ(median.count(), 5U);
  EXPECT_EQ(median.value(), 3.0);
}

}  // namespace
}  // namespace burnish::test
