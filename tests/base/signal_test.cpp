// Signals: nothing, numbers or a function of time, and what they say of themselves.
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

TEST(Signal, is_empty_until_it_is_given_something) {
  EXPECT_TRUE(Signal().empty());
  EXPECT_TRUE(Signal().is_constant());
  EXPECT_EQ(Signal().size(), 0);
  EXPECT_FALSE(Signal(2.0).empty());
  EXPECT_FALSE(Signal::over_time(2, Ramp{1.0}).empty());
}

TEST(Signal, gives_its_numbers_at_a_time) {
  Eigen::VectorXd out(3);
  Signal(Eigen::Vector3d(1.0, 2.0, 3.0)).at(7.0, out);
  EXPECT_EQ(out, Eigen::Vector3d(1.0, 2.0, 3.0));
  const Signal ramp = Signal::over_time(3, Ramp{0.5});
  EXPECT_EQ(ramp.size(), 3);
  ramp.at(4.0, out);
  EXPECT_EQ(out, Eigen::Vector3d::Constant(2.0));
}

TEST(Signal, tells_the_function_that_it_was_given) {
  EXPECT_FALSE(Signal(1.0).function());
  const Signal ramp = Signal::over_time(1, Ramp{0.25});
  ASSERT_NE(ramp.function().target<Ramp>(), nullptr);
  EXPECT_EQ(ramp.function().target<Ramp>()->slope, 0.25);
}

TEST(Signal, refuses_functions_of_no_entries_and_no_functions) {
  EXPECT_EQ(testing::refusal([] { Signal::over_time(0, Ramp{1.0}); }),
            "a signal over time has 0 entries; wanted at least 1");
  EXPECT_EQ(testing::refusal([] { Signal::over_time(1, nullptr); }),
            "a signal over time has no function");
}

}  // namespace
}  // namespace burnish::test
