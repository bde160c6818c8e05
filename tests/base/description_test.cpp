// Tests of the descriptions of specifications: units, comments, ranges and merging by name.
#include "base/description.hpp"

#include <gtest/gtest.h>

#include "support/refusal.hpp"

namespace burnish {
namespace {

struct Inner {
  double fraction = 0.5;
};
struct Outer {
  int count = 3;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  std::optional<double> friction = {};
  std::vector<Inner> inner = {};
  std::map<std::string, double> fractions = {};
};

const Description& description_of(const Inner* /*of*/) {
  static const Description all = Describe<Inner>("base", "Inner", "")
                                     .field("fraction", &Inner::fraction, "of it", range::share);
  return all;
}
const Description& description_of(const Outer* /*of*/) {
  static const Description all =
      Describe<Outer>("base", "Outer", "")
          .field("count", &Outer::count, "{turns}, whole ones", range::from(1, 5))
          .more("of the crank")
          .field("axis", &Outer::axis, "[{x: 1}] in {m}; any length", range::direction)
          .field("friction", &Outer::friction, "or none", range::positive)
          .field("inner", &Outer::inner, "")
          .field("fractions", &Outer::fractions, "by name", range::share);
  return all;
}

std::string refused(const Outer& value) {
  return testing::refusal([&] {
    check_ranges(description_of(&value), &value, [](const std::string& entry) { return entry; });
  });
}

TEST(SpecDescription, UnitInBraces_IsFoundInTheComment) {
  const Description& outer = description_of(static_cast<const Outer*>(nullptr));
  EXPECT_EQ(outer.field("count").unit(), "turns");
  EXPECT_EQ(outer.field("count").comment(), "turns, whole ones");
  EXPECT_EQ(outer.field("count").text(), "turns, whole ones; of the crank");
  EXPECT_EQ(outer.field("friction").unit(), "");
  EXPECT_EQ(outer.field("axis").comment(), "[{x: 1}] in {m}; any length");
}

TEST(SpecDescription, NumberOutOfRange_IsRefusedWithItsPath) {
  EXPECT_EQ(refused({}), "");
  EXPECT_EQ(refused({.count = 6}), "count is 6; wanted 1 to 5");
  EXPECT_EQ(refused({.axis = Eigen::Vector3d::Zero()}),
            "axis has no direction; wanted a vector that is not zero");
  EXPECT_EQ(refused({.axis = {0.0, NAN, 1.0}}), "axis is nan; wanted a vector that is not zero");
  EXPECT_EQ(refused({.friction = 0.0}), "friction is 0; wanted more than 0");
  EXPECT_EQ(refused({.inner = {{}, {-1.0}}}),
            "inner[1].fraction is -1; wanted a fraction between 0 and 1");
  EXPECT_EQ(refused({.fractions = {{"a", 1.0}, {"b", 2.0}}}),
            "fractions.b is 2; wanted a fraction between 0 and 1");
}

TEST(NumberRange, Ends_AreIncludedOrExcludedAsDeclared) {
  EXPECT_TRUE(range::positive_or_infinite.holds(range::end));
  EXPECT_FALSE(range::positive_or_infinite.holds(-range::end));
  EXPECT_FALSE(range::positive.holds(range::end));
  EXPECT_FALSE(range::any.holds(NAN));
  EXPECT_FALSE(range::positive.holds(0.0));
  EXPECT_TRUE(range::not_negative.holds(0.0));
  EXPECT_FALSE(range::between(-90, 90).holds(90.0));
  EXPECT_TRUE(range::share.holds(1.0));
  EXPECT_TRUE(range::fraction.holds(0.0));
  EXPECT_FALSE(range::fraction.holds(1.0));
  EXPECT_EQ(range::fraction.text(), "at least 0 and less than 1");
  EXPECT_FALSE(range::above(1).holds(1.0));
  EXPECT_EQ(range::above(1).text(), "more than 1");
  EXPECT_TRUE(range::any_or_infinite.holds(range::end));
}

struct Named {
  std::string name;
  double value = 0.0;
};
struct Changing {
  std::optional<double> end = {};
  std::optional<std::string> word = {};
  std::vector<Named> list = {};
  std::map<std::string, Inner> map = {};
  int always = 1;
};

const Description& description_of(const Named* /*of*/) {
  static const Description all = Describe<Named>("base", "Named", "")
                                     .field("name", &Named::name)
                                     .field("value", &Named::value);
  return all;
}
const Description& description_of(const Changing* /*of*/) {
  static const Description all = Describe<Changing>("base", "Changing", "")
                                     .field("end", &Changing::end, "", range::any_or_infinite)
                                     .field("word", &Changing::word)
                                     .field("list", &Changing::list)
                                     .field("map", &Changing::map)
                                     .field("always", &Changing::always);
  return all;
}

TEST(SpecDescription, PutOver_MergesListsAndMapsByName) {
  Changing value{.end = 1.0,
                 .word = "a",
                 .list = {{"x", 1.0}, {"y", 2.0}},
                 .map = {{"p", {0.1}}, {"q", {0.2}}},
                 .always = 5};
  const Changing changes{
      .word = "b", .list = {{"z", 3.0}, {"x", 4.0}}, .map = {{"q", {0.3}}, {"r", {0.4}}}};
  put_over(description_of(&value), &value, &changes);
  EXPECT_EQ(value.end, 1.0);
  EXPECT_EQ(value.word, "b");
  ASSERT_EQ(value.list.size(), 3U);
  EXPECT_EQ(value.list[0].value, 4.0);
  EXPECT_EQ(value.list[1].name, "y");
  EXPECT_EQ(value.list[2].name, "z");
  EXPECT_EQ(value.map.size(), 3U);
  EXPECT_EQ(value.map.at("p").fraction, 0.1);
  EXPECT_EQ(value.map.at("q").fraction, 0.3);
  EXPECT_EQ(value.always, 5) << "a plain member cannot be unset, so it is not copied";
}

TEST(SpecDescription, InfiniteValue_IsCalledNeverUnlessOptional) {
  EXPECT_EQ(description_of(static_cast<const Changing*>(nullptr)).field("end").word, "");
  const Description one = Describe<Inner>("base", "Inner", "")
                              .field("fraction", &Inner::fraction, "", range::any_or_infinite);
  EXPECT_EQ(one.field("fraction").word, "never");
}

}  // namespace
}  // namespace burnish
