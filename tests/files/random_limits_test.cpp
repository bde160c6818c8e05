// Random problems with limits of benchmarks/limit_problems.cpp, a few of them.
#include <gtest/gtest.h>

#include "limit_outcome.hpp"

namespace burnish::bench {
namespace {

TEST(RandomLimits, FeasibleByConstruction_ConvergeWithin50Iterations) {
  for (std::uint64_t seed = 2; seed <= 20; seed += 2) {
    const Outcome o = run_seed(seed, {.iterations = 50});
    SCOPED_TRACE(o.text_of_problem());
    EXPECT_EQ(o.reason, StopReason::Converged) << o.text;
    EXPECT_FALSE(o.is_wrong()) << "outside by " << o.violation << ", gap " << o.gap;
  }
}

TEST(RandomLimits, FreeDraws_AreNotJudgedWrongly) {
  int infeasible = 0;
  for (std::uint64_t seed = 1; seed <= 19; seed += 2) {
    const Outcome o = run_seed(seed, {.iterations = 50});
    SCOPED_TRACE(o.text_of_problem());
    EXPECT_FALSE(o.is_wrong()) << o.text;
    infeasible += o.sort == Sort::Infeasible;
  }
  EXPECT_GT(infeasible, 0) << "nothing was drawn that cannot be kept";
}

TEST(RandomLimits, SameSeed_SameProblem) {
  Draws first(7), second(7), other(8);
  const std::string text = text_of(draw_problem(first, {}), {});
  EXPECT_EQ(text, text_of(draw_problem(second, {}), {}));
  EXPECT_NE(text, text_of(draw_problem(other, {}), {}));
}

}  // namespace
}  // namespace burnish::bench
