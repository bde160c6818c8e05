// Tests of penalties: values, slopes and curvatures, breakpoints, infinite limits, and packs.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "math/pack.hpp"
#include "ocp/penalty_kernel.hpp"
#include "support/refusal.hpp"
#include "support/special_numbers.hpp"

namespace burnish::test {
namespace {

/// A penalty of one row.
struct PenaltyCase {
  std::string name;
  Penalty::Kind kind;
  double lower = -infinity, upper = infinity, width = 1.0;
  std::vector<double> breakpoints = {};
  template <class S>
  PenaltyValue<S> at(const S& r) const {
    return evaluate_penalty(kind, lower, upper, width, r);
  }
};
void PrintTo(const PenaltyCase& test, std::ostream* out) { *out << test.name; }

std::vector<PenaltyCase> penalty_cases() {
  using enum Penalty::Kind;
  return {
      {"quadratic", Quadratic},
      {"barrier", Barrier, -0.4, 0.7, 1.0, {-0.4, 0.7}},
      {"barrier_below", Barrier, -0.4, infinity, 1.0, {-0.4}},
      {"barrier_above", Barrier, -infinity, 0.7, 1.0, {0.7}},
      {"barrier_nowhere", Barrier},
      {"smooth_absolute", SmoothAbsolute, -infinity, infinity, 0.05},
      {"log_barrier", LogBarrier, -1.0, 2.0, 0.2, {-0.8, 1.8}},
      {"log_barrier_narrow", LogBarrier, -0.1, 0.1, 0.5, {0.4, -0.4}},
      {"log_barrier_below", LogBarrier, -1.0, infinity, 0.2, {-0.8}},
      {"log_barrier_above", LogBarrier, -infinity, 2.0, 0.2, {1.8}},
  };
}

class PenaltyLaw : public ::testing::TestWithParam<PenaltyCase> {};

TEST_P(PenaltyLaw, SlopeAndCurvature_EqualDifferences) {
  const PenaltyCase& penalty = GetParam();
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> draw(-4.0, 4.0);
  const double h = 1e-5;
  for (int i = 0; i < 500; ++i) {
    const double r = draw(generator);
    bool at_breakpoint = false;
    for (const double breakpoint : penalty.breakpoints)
      at_breakpoint = at_breakpoint || std::abs(r - breakpoint) < 2.0 * h;
    if (at_breakpoint) continue;
    const PenaltyValue<double> here = penalty.at(r);
    const PenaltyValue<double> above = penalty.at(r + h), below = penalty.at(r - h);
    EXPECT_NEAR(here.slope, (above.value - below.value) / (2.0 * h),
                1e-6 * std::max(1.0, std::abs(here.slope)))
        << r;
    EXPECT_NEAR(here.curvature, (above.slope - below.slope) / (2.0 * h),
                1e-5 * std::max(1.0, here.curvature))
        << r;
  }
}

TEST_P(PenaltyLaw, Penalty_IsConvex) {
  const PenaltyCase& penalty = GetParam();
  double slope = -infinity;
  for (double r = -5.0; r < 5.0; r += 1e-3) {
    const PenaltyValue<double> here = penalty.at(r);
    EXPECT_GE(here.curvature, 0.0) << r;
    EXPECT_GE(here.slope, slope - 1e-12) << r;
    slope = here.slope;
  }
}

TEST_P(PenaltyLaw, Breakpoints_AreSmooth) {
  for (const double breakpoint : GetParam().breakpoints) {
    const double h = 1e-9;
    const PenaltyValue<double> above = GetParam().at(breakpoint + h),
                               below = GetParam().at(breakpoint - h);
    EXPECT_NEAR(above.value, below.value, 1e-7) << breakpoint;
    EXPECT_NEAR(above.slope, below.slope, 1e-6) << breakpoint;
    if (GetParam().kind == Penalty::Kind::LogBarrier) {
      EXPECT_NEAR(above.curvature, below.curvature, 1e-5) << breakpoint;
    }
  }
}

TEST_P(PenaltyLaw, NanResidual_GivesNan) { EXPECT_TRUE(std::isnan(GetParam().at(nan).value)); }

TEST_P(PenaltyLaw, Lanes_EqualScalarValues) {
  std::mt19937_64 generator(2);
  std::uniform_real_distribution<double> draw(-3.0, 3.0);
  for (int i = 0; i < 100; ++i) {
    NativePack r(0.0);
    for (int l = 0; l < native_lanes; ++l) r.v[l] = draw(generator);
    const PenaltyValue<NativePack> pack = GetParam().at(r);
    for (int l = 0; l < native_lanes; ++l) {
      const PenaltyValue<double> alone = GetParam().at(r.lane(l));
      EXPECT_NEAR(pack.value.lane(l), alone.value, 1e-14 * std::max(1.0, std::abs(alone.value)));
      EXPECT_NEAR(pack.slope.lane(l), alone.slope, 1e-14 * std::max(1.0, std::abs(alone.slope)));
      EXPECT_NEAR(pack.curvature.lane(l), alone.curvature, 1e-14 * std::max(1.0, alone.curvature));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Penalties, PenaltyLaw, ::testing::ValuesIn(penalty_cases()),
                         [](const auto& test) { return test.param.name; });

TEST(Penalty, Values_FollowTheirFormulas) {
  using enum Penalty::Kind;
  EXPECT_DOUBLE_EQ(evaluate_penalty(Quadratic, 0.0, 0.0, 1.0, 3.0).value, 4.5);
  EXPECT_DOUBLE_EQ(evaluate_penalty(Barrier, -1.0, 2.0, 1.0, 2.5).value, 0.125);
  EXPECT_DOUBLE_EQ(evaluate_penalty(Barrier, -1.0, 2.0, 1.0, -3.0).value, 2.0);
  EXPECT_DOUBLE_EQ(evaluate_penalty(Barrier, -1.0, 2.0, 1.0, 1.9).value, 0.0);
  EXPECT_DOUBLE_EQ(evaluate_penalty(SmoothAbsolute, 0.0, 0.0, 3.0, 4.0).value, 2.0);
  EXPECT_NEAR(evaluate_penalty(SmoothAbsolute, 0.0, 0.0, 0.1, 1e3).value, 1e3 - 0.1, 1e-4);
  EXPECT_DOUBLE_EQ(evaluate_penalty(LogBarrier, 0.0, infinity, 0.5, 1.0).value, -std::log(2.0));
  EXPECT_DOUBLE_EQ(evaluate_penalty(LogBarrier, 0.0, infinity, 0.5, 0.0).value, 1.5);
}

TEST(Penalty, Names_AreParsedAndUnknownOnesRefused) {
  using enum Penalty::Kind;
  for (const Penalty::Kind kind : {Quadratic, Barrier, SmoothAbsolute, LogBarrier})
    EXPECT_EQ(parse_penalty(name_of(kind)), kind);
  testing::expect_words(testing::refusal([] { parse_penalty("barier"); }),
                        {"'barier'", "log_barrier", "did you mean 'barrier'?"});
}

}  // namespace
}  // namespace burnish::test
