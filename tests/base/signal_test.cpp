// Tests of signals, which are empty, constant or a function of time.
#include "burnish/base/signal.hpp"

#include <gtest/gtest.h>

#include "support/refusal.hpp"

namespace burnish::test {
namespace {

struct Ramp {
  double slope;
  void operator()(double time, Eigen::Ref<Eigen::VectorXd> out) const {
    out.setConstant(slope * time);
  }
};

TEST(Signal, DefaultConstructed_IsEmpty) {
  EXPECT_TRUE(Signal().empty());
  EXPECT_TRUE(Signal().is_constant());
  EXPECT_EQ(Signal().size(), 0);
  EXPECT_FALSE(Signal(2.0).empty());
  EXPECT_FALSE(Signal::over_time(2, Ramp{1.0}).empty());
}

TEST(Signal, At_GivesTheValueAtTheTime) {
  Eigen::VectorXd out(3);
  Signal(Eigen::Vector3d(1.0, 2.0, 3.0)).at(7.0, out);
  EXPECT_EQ(out, Eigen::Vector3d(1.0, 2.0, 3.0));
  const Signal ramp = Signal::over_time(3, Ramp{0.5});
  EXPECT_EQ(ramp.size(), 3);
  ramp.at(4.0, out);
  EXPECT_EQ(out, Eigen::Vector3d::Constant(2.0));
}

TEST(Signal, Function_ReturnsTheStoredFunction) {
  EXPECT_FALSE(Signal(1.0).function());
  const Signal ramp = Signal::over_time(1, Ramp{0.25});
  ASSERT_NE(ramp.function().target<Ramp>(), nullptr);
  EXPECT_EQ(ramp.function().target<Ramp>()->slope, 0.25);
}

TEST(Signal, NoEntriesOrNoFunction_IsRefused) {
  EXPECT_EQ(testing::refusal([] { Signal::over_time(0, Ramp{1.0}); }),
            "a signal over time has 0 entries; wanted at least 1");
  EXPECT_EQ(testing::refusal([] { Signal::over_time(1, nullptr); }),
            "a signal over time has no function; wanted a function of time");
}

}  // namespace
}  // namespace burnish::test
