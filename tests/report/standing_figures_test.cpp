// Tests of the figures of standing, on traces whose figures follow by hand.
#include "burnish/report/standing_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "report/figures.hpp"
#include "support/refusal.hpp"
#include "support/standing_trace.hpp"

namespace burnish::testing {
namespace {

StandingFigures figures_of(const StandingTrace::Change& change = {}, double radius = 0.0) {
  const StandingTrace standing(radius);
  return measure_standing(standing.trace(change), standing.model, standing.supports);
}

TEST(StandingFigures, RobotAtRest_HasNoSlipTiltOrFriction) {
  const StandingFigures f = figures_of();
  EXPECT_EQ(f.friction_used, 0.0);
  ASSERT_TRUE(f.pressure_margin.has_value());
  EXPECT_NEAR(*f.pressure_margin, 0.05, 1e-12);  // half_y: the pressure is in the sole's middle
  EXPECT_EQ(f.min_load, 100.0);
  EXPECT_NEAR(f.slip, 0.0, 1e-12);
  EXPECT_NEAR(f.base_tilt, 0.0, 1e-7);
  EXPECT_NEAR(f.com_moved, 0.0, 1e-12);
}

TEST(StandingFigures, TangentialForce_GivesTheFractionOfTheCone) {
  const StandingFigures f = figures_of([](int row, const StandingTrace::Set& set) {
    if (row != 5) return;
    set("support_left_fx", 30.0);
    set("support_left_fy", -40.0);
  });
  EXPECT_NEAR(f.friction_used, 50.0 / (0.8 * 100.0), 1e-12);
}

TEST(StandingFigures, CenterOfPressure_GivesTheDistanceFromTheNearestEdge) {
  // First 8 cm ahead of the middle, whose edge is at 10 cm; then outside the sole of an unloaded
  // foot, which does not count.
  const StandingFigures ahead = figures_of([](int row, const StandingTrace::Set& set) {
    if (row == 5) set("support_left_my", -100.0 * 0.08);
    if (row != 6) return;
    set("support_left_fz", 1.0);
    set("support_left_my", -100.0);
  });
  EXPECT_NEAR(ahead.pressure_margin.value_or(1.0), 0.02, 1e-12);
  EXPECT_EQ(ahead.min_load, 1.0);
  const StandingFigures aside = figures_of([](int row, const StandingTrace::Set& set) {
    if (row == 5) set("support_right_mx", 100.0 * -0.06);
  });
  EXPECT_NEAR(aside.pressure_margin.value_or(1.0), -0.01, 1e-12);
}

TEST(StandingFigures, InitialGroundContact_IsIgnoredInForceFigures) {
  const StandingFigures f = figures_of([](int row, const StandingTrace::Set& set) {
    if (row > 0) return;
    set("support_left_fz", 30.0);
    set("support_left_fx", 24.0);
    set("support_left_my", -3.0);
  });
  EXPECT_EQ(f.friction_used, 0.0);
  EXPECT_EQ(f.min_load, 100.0);
  EXPECT_NEAR(f.pressure_margin.value_or(0.0), 0.05, 1e-12);
}

TEST(StandingFigures, PointFeet_HaveNoPressureMargin) {
  const StandingFigures f = figures_of({}, 0.02);
  EXPECT_FALSE(f.pressure_margin.has_value());
  EXPECT_EQ(f.min_load, 100.0);
}

TEST(StandingFigures, Slip_IsTheLargestHorizontalPathOfACorner) {
  // The robot moves 3 cm aside, which is slip, and 1 cm up, which is not.
  const StandingFigures moved = figures_of([](int row, const StandingTrace::Set& set) {
    if (row != 7) return;
    set("q_root_joint.x", 0.03);
    set("q_root_joint.z", 0.51);
  });
  EXPECT_NEAR(moved.slip, 0.03, 1e-12);
  EXPECT_NEAR(moved.com_moved, std::hypot(0.03, 0.01), 1e-12);
  EXPECT_NEAR(moved.base_tilt, 0.0, 1e-7);
  // In a rotation about the vertical, the farthest corner of a sole slips the most.
  constexpr double angle = 0.1;
  const StandingFigures turned = figures_of([](int row, const StandingTrace::Set& set) {
    if (row != 7) return;
    set("q_root_joint.qz", std::sin(0.5 * angle));
    set("q_root_joint.qw", std::cos(0.5 * angle));
  });
  EXPECT_NEAR(turned.slip, 2.0 * std::sin(0.5 * angle) * std::hypot(0.1, 0.15 + 0.05), 1e-9);
  EXPECT_NEAR(turned.base_tilt, 0.0, 1e-7);
  const StandingFigures point_foot = figures_of(
      [](int row, const StandingTrace::Set& set) {
        if (row != 7) return;
        set("q_root_joint.qz", std::sin(0.5 * angle));
        set("q_root_joint.qw", std::cos(0.5 * angle));
      },
      0.02);
  EXPECT_NEAR(point_foot.slip, 2.0 * std::sin(0.5 * angle) * 0.15, 1e-9);
}

TEST(StandingFigures, Tilt_IsTheAngleFromTheVertical) {
  constexpr double angle = 0.2;
  const StandingFigures f = figures_of([](int row, const StandingTrace::Set& set) {
    if (row != 7) return;
    set("q_root_joint.qx", std::sin(0.5 * angle));
    set("q_root_joint.qw", std::cos(0.5 * angle));
  });
  EXPECT_NEAR(f.base_tilt, angle, 1e-9);
}

TEST(StandingFigures, TiltedSole_UsesTheNormalOfTheGround) {
  // A vertical force on a tilted sole has no component along the ground.
  constexpr double angle = 0.2;
  const StandingFigures f = figures_of([](int row, const StandingTrace::Set& set) {
    if (row != 7) return;
    set("q_root_joint.qx", std::sin(0.5 * angle));
    set("q_root_joint.qw", std::cos(0.5 * angle));
    for (const char* foot : {"support_left_", "support_right_"}) {
      set(foot + std::string("fy"), 100.0 * std::sin(angle));
      set(foot + std::string("fz"), 100.0 * std::cos(angle));
    }
  });
  EXPECT_NEAR(f.friction_used, 0.0, 1e-12);
  EXPECT_NEAR(f.min_load, 100.0, 1e-9);
}

TEST(StandingFigures, RowsFromANanState_AreIgnored) {
  const StandingFigures f = figures_of([](int row, const StandingTrace::Set& set) {
    if (row == 4) set("q_root_joint.x", std::numeric_limits<double>::quiet_NaN());
    if (row == 5) set("support_left_fz", 0.0);
  });
  EXPECT_EQ(f.min_load, 100.0);
  EXPECT_NEAR(f.slip, 0.0, 1e-12);
}

TEST(StandingFigures, BadSupportsOrTrace_AreRefused) {
  const StandingTrace standing;
  const Trace trace = standing.trace();
  expect_words(refusal([&] { (void)measure_standing(trace, standing.model, {}); }),
               {"no supports"});
  expect_words(refusal([&] {
                 (void)measure_standing(Trace(trace.columns(), 1), standing.model,
                                        standing.supports);
               }),
               {"no rows"});
  std::vector<TouchSpec> supports = standing.supports;
  supports[0].frame = "lefd";
  expect_words(refusal([&] { (void)measure_standing(trace, standing.model, supports); }),
               {"lefd", "left"});
  supports = standing.supports;
  supports[1].surface.normal.setZero();
  expect_words(refusal([&] { (void)measure_standing(trace, standing.model, supports); }),
               {"right", "no direction"});
}

TEST(StandingFigures, Table_HasAColumnPerRun) {
  EXPECT_EQ(standing_table({}), "");
  StandingFigures figures;
  figures.slip = 2e-3;
  const std::string table = standing_table({{"first", figures}, {"second", figures}});
  EXPECT_NE(table.find("standing.slip"), std::string::npos);
  EXPECT_NE(table.find("2.000"), std::string::npos);
  EXPECT_NE(table.find("standing.pressure_margin  mm       -       -\n"), std::string::npos)
      << table;
}

}  // namespace
}  // namespace burnish::testing
