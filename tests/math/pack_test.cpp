// Tests of packs of numbers: arithmetic, selection, transposition, sine and cosine in each lane.
#include "math/pack.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace burnish {
namespace {

template <class P>
class PackLaw : public ::testing::Test {};
using Widths = ::testing::Types<Pack<1>, Pack<2>, Pack<4>, Pack<8>>;
TYPED_TEST_SUITE(PackLaw, Widths);

template <class P>
P numbered(double first, double step) {
  P p;
  for (int l = 0; l < Lanes<P>::count; ++l) Lanes<P>::set(p, l, first + step * l);
  return p;
}

/// Distance of two doubles in units in the last place of the second.
double ulps(double got, double want) {
  const double next = std::nextafter(std::abs(want), std::numeric_limits<double>::infinity());
  return std::abs(got - want) / (next - std::abs(want));
}

TYPED_TEST(PackLaw, Arithmetic_ActsLaneByLane) {
  const auto a = numbered<TypeParam>(1.5, 0.25), b = numbered<TypeParam>(-2.0, 3.0);
  const TypeParam sum = a + b, product = a * b, quotient = b / a, negative = -a;
  for (int l = 0; l < Lanes<TypeParam>::count; ++l) {
    EXPECT_EQ(sum.lane(l), a.lane(l) + b.lane(l));
    EXPECT_EQ(product.lane(l), a.lane(l) * b.lane(l));
    EXPECT_EQ(quotient.lane(l), b.lane(l) / a.lane(l));
    EXPECT_EQ(negative.lane(l), -a.lane(l));
  }
}

TYPED_TEST(PackLaw, Select_ChoosesInEachLaneByItsMask) {
  const auto a = numbered<TypeParam>(-1.0, 1.0);
  const TypeParam chosen = select(less(a, TypeParam(1.0)), TypeParam(10.0), TypeParam(20.0));
  for (int l = 0; l < Lanes<TypeParam>::count; ++l)
    EXPECT_EQ(chosen.lane(l), a.lane(l) < 1.0 ? 10.0 : 20.0);
  EXPECT_TRUE(any(less(a, TypeParam(0.0))));
  EXPECT_FALSE(any(less(a, TypeParam(-5.0))));
}

TYPED_TEST(PackLaw, Nan_IsNeverLessInItsLane) {
  auto a = numbered<TypeParam>(1.0, 1.0);
  Lanes<TypeParam>::set(a, Lanes<TypeParam>::count - 1, std::nan(""));
  const auto finite = less(TypeParam(a * TypeParam(0.0)), TypeParam(1.0));
  for (int l = 0; l + 1 < Lanes<TypeParam>::count; ++l) EXPECT_TRUE(lane_of(finite, l));
  EXPECT_FALSE(lane_of(finite, Lanes<TypeParam>::count - 1));
}

TYPED_TEST(PackLaw, Transpose_ExchangesPacksAndLanes) {
  constexpr int n = Lanes<TypeParam>::count;
  TypeParam rows[n];
  for (int i = 0; i < n; ++i) rows[i] = numbered<TypeParam>(100.0 * i, 1.0);
  transpose(rows);
  for (int i = 0; i < n; ++i)
    for (int l = 0; l < n; ++l) EXPECT_EQ(rows[i].lane(l), 100.0 * l + i);
}

TYPED_TEST(PackLaw, Unpack_WritesOnlyTheChosenLanes) {
  constexpr int n = Lanes<TypeParam>::count;
  TypeParam rows[n];
  for (int i = 0; i < n; ++i) rows[i] = numbered<TypeParam>(100.0 * i, 1.0);
  for (int lanes = 0; lanes <= n; ++lanes) {
    double out[n][n + 2];
    std::fill(&out[0][0], &out[0][0] + n * (n + 2), -1.0);
    unpack(rows, lanes, [&](int l) { return &out[l][1]; });
    for (int l = 0; l < n; ++l) {
      EXPECT_EQ(out[l][0], -1.0);
      EXPECT_EQ(out[l][n + 1], -1.0);
      for (int i = 0; i < n; ++i) EXPECT_EQ(out[l][1 + i], l < lanes ? 100.0 * i + l : -1.0);
    }
  }
}

TYPED_TEST(PackLaw, SineAndCosine_AreWithinTwoUnitsInTheLastPlace) {
  std::mt19937_64 generator(7);
  double worst = 0.0;
  for (const double range : {1e-3, 1.0, 10.0, 1e3, 1e5}) {
    std::uniform_real_distribution<double> draw(-range, range);
    for (int i = 0; i < 20000; ++i) {
      TypeParam x, s, c;
      for (int l = 0; l < Lanes<TypeParam>::count; ++l)
        Lanes<TypeParam>::set(x, l, draw(generator));
      sine_cosine(x, s, c);
      for (int l = 0; l < Lanes<TypeParam>::count; ++l) {
        const double want_s = std::sin(x.lane(l)), want_c = std::cos(x.lane(l));
        // Near a zero, only the absolute error is bounded.
        if (std::abs(want_s) > 1e-3) worst = std::max(worst, ulps(s.lane(l), want_s));
        if (std::abs(want_c) > 1e-3) worst = std::max(worst, ulps(c.lane(l), want_c));
        EXPECT_NEAR(s.lane(l), want_s, 3e-16);
        EXPECT_NEAR(c.lane(l), want_c, 3e-16);
      }
    }
  }
  EXPECT_LE(worst, 2.0);
}

TYPED_TEST(PackLaw, SineAndCosineOfALargeAngle_EqualTheStandardLibrary) {
  const auto x = numbered<TypeParam>(1e5 - 0.5, 1e6);
  TypeParam s, c;
  sine_cosine(x, s, c);
  for (int l = 0; l < Lanes<TypeParam>::count; ++l) {
    EXPECT_NEAR(s.lane(l), std::sin(x.lane(l)), 3e-16);
    EXPECT_NEAR(c.lane(l), std::cos(x.lane(l)), 3e-16);
  }
}

TYPED_TEST(PackLaw, SineAndCosine_DoNotDependOnTheOtherLanes) {
  constexpr int n = Lanes<TypeParam>::count;
  auto x = numbered<TypeParam>(0.1, 0.7);
  TypeParam s, c, far_s, far_c;
  sine_cosine(x, s, c);
  Lanes<TypeParam>::set(x, n - 1, 3e7);
  sine_cosine(x, far_s, far_c);
  for (int l = 0; l + 1 < n; ++l) {
    EXPECT_EQ(s.lane(l), far_s.lane(l));
    EXPECT_EQ(c.lane(l), far_c.lane(l));
  }
}

TEST(NativePack, Width_MatchesTheInstructionSet) {
#if defined(__AVX512F__)
  EXPECT_EQ(native_lanes, 8);
#elif defined(__AVX2__)
  EXPECT_EQ(native_lanes, 4);
#elif defined(__SSE2__) || defined(__ARM_NEON)
  EXPECT_EQ(native_lanes, 2);
#endif
  EXPECT_EQ(sizeof(NativePack), native_lanes * sizeof(double));
  EXPECT_EQ(alignof(NativePack), sizeof(NativePack));
}

}  // namespace
}  // namespace burnish
