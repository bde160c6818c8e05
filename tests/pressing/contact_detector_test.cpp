// Touch and loss beside the noise of a force sensor: what noise is not taken for, and how late what
// is none is found.
#include "pressing/contact_detector.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace burnish::test {
namespace {

constexpr double threshold = 2.0;  // N
constexpr int window = 10;         // samples, 5 ms at 2 kHz

/// White noise, behind a low-pass (part of the way per sample) if it is below 1.
class Noise {
 public:
  Noise(double deviation, double part, unsigned seed)
      : normal_(0.0, deviation), part_(part), random_(seed) {}
  double operator()() { return value_ += part_ * (normal_(random_) - value_); }

 private:
  std::normal_distribution<double> normal_;
  double part_, value_ = 0.0;
  std::mt19937_64 random_;
};

/// Samples of force and noise until a condition holds; -1: it did not within so many.
template <class Condition>
int samples_until(ContactDetector& detector, Noise& noise, double force, int most,
                  const Condition& holds) {
  for (int i = 1; i <= most; ++i) {
    detector.add(force + noise(), false);
    if (holds(detector)) return i;
  }
  return -1;
}

const auto touching = [](const ContactDetector& d) { return d.touches(); };
const auto lost = [](const ContactDetector& d) { return d.is_lost(30.0); };

TEST(ContactDetector, with_a_quiet_sensor_takes_one_sample) {
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

TEST(ContactDetector, takes_no_noise_for_a_touch_nor_for_a_hold) {
  for (const double deviation : {0.5, 2.0, 10.0})
    for (const double part : {1.0, 0.15})
      for (unsigned seed = 0; seed < 20; ++seed) {
        ContactDetector detector(threshold, window);
        Noise noise(deviation, part, seed);
        for (int i = 0; i < 1000; ++i) detector.add(noise(), true);
        // Five seconds in the air: neither a touch nor what would be taken for a pressed tool.
        EXPECT_EQ(samples_until(detector, noise, 0.0, 10000, touching), -1)
            << deviation << " N, " << part << ", seed " << seed;
        for (int i = 0; i < 2000; ++i) {
          detector.add(noise(), false);
          ASSERT_TRUE(detector.is_lost(deviation < 5.0 ? 30.0 : 200.0)) << deviation << " " << part;
        }
      }
}

TEST(ContactDetector, finds_touch_and_loss_within_a_window) {
  for (const double part : {1.0, 0.15})
    for (unsigned seed = 0; seed < 20; ++seed) {
      ContactDetector detector(threshold, window);
      Noise noise(2.0, part, seed);
      for (int i = 0; i < 1000; ++i) detector.add(noise(), true);
      const int touched = samples_until(detector, noise, 12.0, 50, touching);
      EXPECT_GT(touched, 0) << seed;
      EXPECT_LE(touched, window) << seed;
      // Pressed it is not lost, and let go it is.
      for (int i = 0; i < 2000; ++i) {
        detector.add(30.0 + noise(), false);
        ASSERT_FALSE(i > window && detector.is_lost(30.0)) << seed;
      }
      const int gone = samples_until(detector, noise, 0.0, 50, lost);
      EXPECT_GT(gone, 0) << seed;
      EXPECT_LE(gone, window + 5) << seed;
    }
}

TEST(ContactDetector, before_it_knows_the_noise_wants_a_whole_window) {
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

TEST(ContactDetector, is_not_misled_by_offsets_and_touches_in_what_it_learns_from) {
  Noise noise(0.1, 1.0, 3);
  ContactDetector detector(threshold, window);
  for (int i = 0; i < 400; ++i)
    detector.add(1.2 + noise(), true);  // a tool that is not weighed off
  EXPECT_FALSE(detector.touches());
  EXPECT_LT(detector.above_noise(0.0, window), 0.5);
  // Something that is hit on the way stays as far above the noise as it is.
  for (int i = 0; i < 40; ++i) detector.add(30.0 + noise(), true);
  EXPECT_LT(detector.above_noise(0.0, window), 0.5);
}

TEST(ContactDetector, says_how_far_noise_reaches) {
  ContactDetector detector(threshold, window);
  Noise noise(10.0, 1.0, 5);
  for (int i = 0; i < 2500; ++i) detector.add(noise(), true);
  EXPECT_NEAR(detector.above_noise(0.0, window), 6.0 * 10.0 / std::sqrt(10.0), 4.0);
  EXPECT_GT(detector.above_noise(0.0, 1), 50.0);
}

TEST(RunningMedian, is_the_middle_and_stops_when_it_is_full) {
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
