// Tests of the strict reader of values and of its error messages.
#include "document/reader.hpp"

#include <gtest/gtest.h>

#include "support/refusal.hpp"

namespace burnish::document {
namespace {

using testing::expect_words;
using testing::refusal;

TEST(Reader, UnknownKey_IsRefusedWithItsLineAndTheNearestName) {
  const Reader top = Reader::parse("weights:\n  force: 1\nweigths: 2\n", "a.yaml");
  EXPECT_EQ(refusal([&] {
              top.allow_only({"weights", "limits"});
            }),
            "a.yaml: line 3: key 'weigths' is unknown; did you mean 'weights'?");
  EXPECT_EQ(refusal([&] {
              top["weights"].allow_only({"nothing", "alike"});
            }),
            "a.yaml: line 2: weights: key 'force' is unknown; known are nothing or alike");
}

TEST(Reader, NestedErrors_NameThePlaceOnce) {
  const Reader value = Reader::parse("a: {b: x}\n", "a.yaml")["a"]["b"];
  const std::string sentence = "a.yaml: line 1: a.b: 'x' is not a number";
  EXPECT_EQ(refusal([&] { value.number(); }), sentence);
  EXPECT_EQ(refusal([&] { value.named([&] { value.named([&] { return value.number(); }); }); }),
            sentence);
  EXPECT_EQ(refusal([&] { value.named([]() -> int { throw Error("other.csv: no rows"); }); }),
            "a.yaml: line 1: a.b: other.csv: no rows");
}

TEST(Reader, NumberOutOfRange_IsRefusedWithTheRange) {
  const Reader list = Reader::parse("[2.5, -1, 3, '3', x, 1e10]", "a.yaml");
  const auto refused_at = [&](std::size_t i, const auto& read) {
    return refusal([&] { read(list.entries()[i]); });
  };
  const auto fraction = [](const Reader& x) { x.number(0.0, 1.0); };
  expect_words(refused_at(0, fraction), {"[0]: it is 2.5; wanted a number between 0 and 1"});
  const auto count = [](const Reader& x) { x.count(0, 2); };
  expect_words(refused_at(0, count), {"[0]: it is 2.5; wanted a whole number"});
  expect_words(refused_at(1, count), {"[1]: it is -1; wanted at least 0"});
  expect_words(refused_at(2, count), {"[2]: it is 3; wanted at most 2"});
  expect_words(refused_at(5, [](const Reader& x) { x.count(0); }), {"wanted at most 1000000000"});
  expect_words(refused_at(1, [](const Reader& x) { x.positive(); }), {"wanted more than 0"});
  expect_words(refused_at(3, [](const Reader& x) { x.number(); }),
               {"[3]: '3' has quotes, so it is a text; wanted a number without quotes"});
  expect_words(refusal([&] { list.numbers(7); }), {"it has 6 numbers; wanted 7"});
}

TEST(Reader, ValueOfAnotherKind_IsNamedInTheError) {
  const Reader top = Reader::parse("{a: [1], b: {}, c: , d: yes, e: 3}", "a.yaml");
  expect_words(refusal([&] { top["a"].number(); }), {"a: it is a list; wanted a number"});
  expect_words(refusal([&] { top["b"].entries(); }), {"b: it is keys with values; wanted a list"});
  expect_words(refusal([&] { top["c"].number(); }), {"c: it is nothing; wanted a number"});
  expect_words(refusal([&] { top["d"].yes_or_no(); }), {"d: it is the text 'yes'; wanted true or"});
  expect_words(refusal([&] { top["e"].items(); }), {"e: it is the number 3; wanted keys"});
  expect_words(refusal([&] { top["e"]["f"]; }),
               {"e: it is the number 3; wanted keys with values, including 'f'"});
  expect_words(refusal([&] { top["f"]; }), {"a.yaml: line 1: key 'f' is missing"});
}

TEST(Reader, ChangedMap_ReportsThePlaceOfEachChange) {
  const Reader top = Reader::parse("base: {a: 1, b: 2}\n\nmore:\n  it: {b: x, c: 3}\n", "a.yaml");
  const Reader changed = top["base"].changed_by(top["more"]["it"]);
  EXPECT_EQ(changed["a"].number(), 1.0);
  EXPECT_EQ(changed["c"].number(), 3.0);
  expect_words(refusal([&] { changed["b"].number(); }), {"a.yaml: line 4: more.it.b: 'x' is no"});
}

TEST(Reader, Override_IsReadAsItsOwnTree) {
  const auto value = [](const std::string& text) {
    return Reader::parse_override("a.b", text, "override 'x'")["a"]["b"];
  };
  EXPECT_EQ(value(" 2.5 ").number(), 2.5);
  EXPECT_TRUE(value("true").yes_or_no());
  EXPECT_EQ(value("[1, 2]").numbers(2)[1], 2.0);
  EXPECT_EQ(value("{c: {d: 1}}")["c"]["d"].path(), "a.b.c.d");
  for (const char* text : {"my arm #2", "a: b", "*x", "&x", "- 1", "a, b]", "| x", "!t 1"})
    EXPECT_EQ(value(text).text(), text);
  EXPECT_EQ(value("'5'").node().kind, Kind::Text);
  EXPECT_EQ(refusal([&] { value("[1, x]").numbers(2); }),
            "override 'x': a.b[1]: 'x' is not a number");
  expect_words(refusal([&] { value("[1"); }), {"override 'x': line ", "this is not valid YAML"});
}

TEST(Reader, Values_OutliveTheReaderOfTheFile) {
  std::optional<Reader> value;
  {
    const Reader top = Reader::parse("{a: {b: 1}, c: {d: 2}}", "a.yaml");
    value = top["a"]["b"];
    value = top["c"]["d"];
  }
  EXPECT_EQ(value->number(), 2.0);
  EXPECT_EQ(value->path(), "c.d");
}

}  // namespace
}  // namespace burnish::document
