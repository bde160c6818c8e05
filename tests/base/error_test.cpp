// Tests of error messages, of suggestions for misspelled names, and of statuses.
#include "burnish/base/error.hpp"

#include <gtest/gtest.h>

#include <set>

#include "burnish/base/status.hpp"

namespace burnish {
namespace {

TEST(NearestName, MisspelledName_GivesTheClosestName) {
  const std::vector<std::string> names{"arm_left_1_joint", "arm_right_1_joint", "torso_1_joint"};
  EXPECT_EQ(nearest_name("arm_rigth_1_joint", names), "arm_right_1_joint");
  EXPECT_EQ(nearest_name("torso1_joint", names), "torso_1_joint");
  EXPECT_EQ(nearest_name("weigths", {"weight", "weights", "limits"}), "weights");
}

TEST(NearestName, NoCloseName_GivesAnEmptyText) {
  EXPECT_EQ(nearest_name("q", {"arm_left_1_joint"}), "");
  EXPECT_EQ(nearest_name("tool", {}), "");
  EXPECT_EQ(did_you_mean("tool", {}), "");
  EXPECT_EQ(nearest_name("nope", {"base", "tool", "link_1"}), "");
}

TEST(DidYouMean, MisspelledName_QuotesTheNearestName) {
  EXPECT_EQ(did_you_mean("tol", {"tool", "base"}), "; did you mean 'tool'?");
}

TEST(NearestName, VeryLongText_IsIgnored) {
  const std::string text(1'000'000, 'a');
  EXPECT_EQ(nearest_name(text, {text}), "");
  EXPECT_EQ(nearest_name("tol", {text, "tool"}), "tool");
}

TEST(Error, ControlCharactersAndInvalidUtf8_AreReplaced) {
  EXPECT_STREQ(Error("a 'b\n\x01\tc' d\x7F").what(), "a 'b   c' d ");
  EXPECT_STREQ(Error("Gr\u00f6\u00dfe, \u20ac, \U0001F916").what(),
               "Gr\u00f6\u00dfe, \u20ac, \U0001F916");
  // Invalid UTF-8: a lone continuation byte, truncated and overlong characters, a surrogate, and
  // codes above the largest.
  EXPECT_STREQ(Error("\x80 \xC3( \xC3").what(), "? ?( ?");
  EXPECT_STREQ(Error("\xC0\xAF \xE0\x80\xAF \xF0\x80\x80\xAF").what(), "?? ??? ????");
  EXPECT_STREQ(Error("\xED\xA0\x80 \xF4\x90\x80\x80 \xF5").what(), "??? ???? ?");
}

TEST(Error, VeryLongMessage_IsCut) {
  const std::string sentence = Error(std::string(1'000'000, 'a')).what();
  EXPECT_LT(sentence.size(), 5000U);
  EXPECT_TRUE(sentence.ends_with("..."));
}

TEST(Status, EveryValue_HasItsOwnSentenceAndWorstIsTheLarger) {
  std::set<std::string_view> sentences;
  for (int s = 0; s <= static_cast<int>(Status::NotEvaluated); ++s)
    sentences.insert(describe(static_cast<Status>(s)));
  EXPECT_EQ(sentences.size(), 9U);
  EXPECT_EQ(worst(Status::Ok, Status::NotFinite), Status::NotFinite);
  EXPECT_EQ(worst(Status::SingularMass, Status::NotConverged), Status::SingularMass);
}

TEST(Error, SeveralProblems_AreNumberedAndListed) {
  const Error one("r.urdf", std::vector<std::string>{"no links"});
  EXPECT_STREQ(one.what(), "r.urdf: no links");
  EXPECT_EQ(one.sentences(), std::vector<std::string>{"r.urdf: no links"});
  const Error two("r.urdf", {"no\nlinks", "no name"});
  EXPECT_STREQ(two.what(), "r.urdf: 2 problems: (1) no links (2) no name");
  EXPECT_EQ(two.sentences(), (std::vector<std::string>{"r.urdf: no links", "r.urdf: no name"}));
  EXPECT_STREQ(Error("", {"a: b", "c: d"}).what(), "2 problems: (1) a: b (2) c: d");
  EXPECT_EQ(Error("one").sentences(), std::vector<std::string>{"one"});
  const Error many("r", std::vector<std::string>(73, "bad"));
  EXPECT_EQ(many.sentences().size(), 51u);
  EXPECT_EQ(many.sentences().back(), "r: and 23 more");
}

}  // namespace
}  // namespace burnish
