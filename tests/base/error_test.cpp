#include "burnish/base/error.hpp"

#include <gtest/gtest.h>

#include <set>

#include "burnish/base/status.hpp"

namespace burnish {
namespace {

TEST(NearestName, finds_the_name_with_a_slip_of_the_finger) {
  const std::vector<std::string> known{"arm_left_1_joint", "arm_right_1_joint", "torso_1_joint"};
  EXPECT_EQ(nearest_name("arm_rigth_1_joint", known), "arm_right_1_joint");
  EXPECT_EQ(nearest_name("torso1_joint", known), "torso_1_joint");
}

TEST(NearestName, is_empty_when_nothing_is_close) {
  EXPECT_EQ(nearest_name("q", {"arm_left_1_joint"}), "");
  EXPECT_EQ(nearest_name("tool", {}), "");
  EXPECT_EQ(did_you_mean("tool", {}), "");
}

TEST(DidYouMean, quotes_the_nearest_name) {
  EXPECT_EQ(did_you_mean("tol", {"tool", "base"}), "; did you mean 'tool'?");
}

TEST(Status, every_value_has_a_sentence_of_its_own_and_worst_is_the_larger) {
  std::set<std::string_view> sentences;
  for (int s = 0; s <= static_cast<int>(Status::NotEvaluated); ++s)
    sentences.insert(describe(static_cast<Status>(s)));
  EXPECT_EQ(sentences.size(), 8U);
  EXPECT_EQ(worst(Status::Ok, Status::NotFinite), Status::NotFinite);
  EXPECT_EQ(worst(Status::SingularMass, Status::NotConverged), Status::SingularMass);
}

}  // namespace
}  // namespace burnish
