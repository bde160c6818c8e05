// Tests of the JSON reader, which builds the same tree as the YAML reader.
#include <gtest/gtest.h>

#include "document/reader.hpp"
#include "document/text.hpp"
#include "support/refusal.hpp"

namespace burnish::document {
namespace {

using testing::expect_words;
using testing::refusal;

std::string refused_json(const std::string& text) {
  return refusal([&] { parse_json(text, "a.json"); });
}

TEST(Json, Scalars_KeepTextAndKind) {
  const Reader list = Reader::parse_json(
      "[1.50, \"1.50\", true, false, null, -3e-2, 18446744073709551616]", "a.json");
  std::vector<Kind> kinds;
  std::vector<std::string> texts;
  for (const Reader& entry : list.entries()) {
    kinds.push_back(entry.node().kind);
    texts.push_back(entry.node().text);
  }
  using enum Kind;
  EXPECT_EQ(kinds, (std::vector{Number, Text, Bool, Bool, Null, Number, Number}));
  EXPECT_EQ(texts, (std::vector<std::string>{"1.50", "1.50", "true", "false", "", "-3e-2",
                                             "18446744073709551616"}));
}

TEST(Json, Values_HaveLineColumnAndPath) {
  const Reader top = Reader::parse_json(
      "\xEF\xBB\xBF{\"a\": [\"x\\\"]\\u0041\" ,\r\n\t 12, {\n \"b\" : null, \"c\":{\"d\":7}}]}",
      "a.json");
  const auto at = [](const Reader& reader, std::uint32_t line, std::uint32_t column) {
    EXPECT_EQ(reader.node().place.line, line) << reader.path();
    EXPECT_EQ(reader.node().place.column, column) << reader.path();
  };
  const std::vector<Reader> list = top["a"].entries();
  at(top, 1, 1);
  at(top["a"], 1, 7);
  at(list[0], 1, 8);
  EXPECT_EQ(list[0].text(), "x\"]A");
  at(list[1], 2, 3);
  at(list[2], 2, 7);
  at(list[2]["b"], 3, 8);
  at(list[2]["c"]["d"], 3, 23);
  EXPECT_EQ(list[2]["c"]["d"].path(), "a[2].c.d");
  expect_words(refusal([&] {
                 list[1].text();
                 list[2]["b"].number();
               }),
               {"a.json: line 3: a[2].b: it is nothing; wanted a number"});
}

TEST(Json, DuplicateKey_IsRefused) {
  expect_words(refused_json("[{\"a\": 1,\n\"a\": 2}]"),
               {"a.json: line 2: [0]: key 'a' is stated twice; state it once"});
  EXPECT_EQ(refused_json(R"({"a": {"a": 1}, "b": [{"a": 1}, {"a": 1}]})"), "");
}

TEST(Json, NanAndInfinity_AreRefused) {
  for (const char* text : {"[NaN]", "[nan]", "[Infinity]", "[-Infinity]", "[inf]"})
    expect_words(refused_json(text), {"a.json: parse error at line 1"});
}

TEST(Json, SurrogatePair_IsOneCharacterAndAHalfIsRefused) {
  EXPECT_EQ(Reader::parse_json(R"("\uD83E\uDD16")", "a.json").text(), "\U0001F916");
  for (const char* text : {R"("\uD83E")", R"("\uDD16")", R"("\uD83E\uD83E")"})
    expect_words(refused_json(text), {"a.json: parse error", "surrogate"});
}

TEST(Json, NumberBeyondTheLargest_IsRefused) {
  expect_words(refused_json("[1,\n1e400]"),
               {"a.json: line 2: '1e400' is too large; wanted a magnitude below 1.8e308"});
  EXPECT_EQ(Reader::parse_json("1e-400", "a.json").node().text, "1e-400");
}

TEST(Json, Tabs_AreBlanksExceptInTexts) {
  EXPECT_EQ(Reader::parse_json("{\t\"a\"\t:\t1\t}", "a.json")["a"].number(), 1.0);
  expect_words(refused_json("\"a\tb\""), {"a.json: parse error", "control character"});
}

TEST(Json, NestingBeyond64_IsRefused) {
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
  };
  EXPECT_EQ(parse_json(nested(64), "a.json").size(), 1u);
  expect_words(refused_json(nested(65)), {"a.json: line 1: ", "nested more than 64 deep"});
}

TEST(Json, InvalidUtf8_IsRefused) {
  expect_words(refused_json("\"caf\xe9\""), {"a.json: parse error", "UTF-8"});
}

TEST(Json, NoneOrSeveralValues_AreRefused) {
  for (const char* text : {"", " \n", "1 2", "{} {}", "[1,]", "{\"a\": 1,}", "[1", "// c\n1"})
    expect_words(refused_json(text), {"a.json: parse error at line "});
}

}  // namespace
}  // namespace burnish::document
