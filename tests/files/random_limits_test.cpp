// Tests of a few of the random problems with limits of benchmarks/limit_problems.cpp.
#include <gtest/gtest.h>

#include "limit_outcome.hpp"

namespace burnish::bench {
namespace {

TEST(RandomLimits, FeasibleProblems_ConvergeWithin50Iterations) {
  for (std::uint64_t seed = 2; seed <= 20; seed += 2) {
    const Outcome o = run_seed(seed, {.iterations = 50});
    SCOPED_TRACE(o.text_of_problem());
    EXPECT_EQ(o.reason, StopReason::Converged) << o.text;
    EXPECT_FALSE(o.is_wrong()) << "violation " << o.violation << ", gap " << o.gap;
  }
}

TEST(RandomLimits, UnrestrictedDraws_EndWithACorrectVerdict) {
  int infeasible = 0;
  for (std::uint64_t seed = 1; seed <= 19; seed += 2) {
    const Outcome o = run_seed(seed, {.iterations = 50});
    SCOPED_TRACE(o.text_of_problem());
    EXPECT_FALSE(o.is_wrong()) << o.text;
    infeasible += o.sort == Sort::Infeasible;
  }
  EXPECT_GT(infeasible, 0) << "no infeasible problem was drawn";
}

TEST(RandomLimits, SameSeed_DrawsTheSameProblem) {
  Draws first(7), second(7), other(8);
  const std::string text = text_of(draw_problem(first, {}), {});
  EXPECT_EQ(text, text_of(draw_problem(second, {}), {}));
  EXPECT_NE(text, text_of(draw_problem(other, {}), {}));
}

}  // namespace
}  // namespace burnish::bench
