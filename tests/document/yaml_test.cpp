// Tests of the YAML reader: values, their places, and refused texts.
#include <gtest/gtest.h>

#include "document/reader.hpp"
#include "document/text.hpp"
#include "support/refusal.hpp"

namespace burnish::document {
namespace {

using testing::expect_words;
using testing::refusal;

std::string refused_yaml(const std::string& text) {
  return refusal([&] { parse_yaml(text, "a.yaml"); });
}

TEST(Yaml, Scalars_KeepTextAndHaveTheKindOfTheirSpelling) {
  const Reader list =
      Reader::parse("[1.50, '1.50', true, 'true', word, ~, 'null', !!str 3, .5, 1e400]", "a.yaml");
  std::vector<Kind> kinds;
  std::vector<std::string> texts;
  for (const Reader& entry : list.entries()) {
    kinds.push_back(entry.node().kind);
    texts.push_back(entry.node().text);
  }
  using enum Kind;
  EXPECT_EQ(kinds, (std::vector{Number, Text, Bool, Text, Text, Null, Text, Text, Number, Text}));
  EXPECT_EQ(texts, (std::vector<std::string>{"1.50", "1.50", "true", "true", "word", "", "null",
                                             "3", ".5", "1e400"}));
}

TEST(Yaml, Values_HaveLineColumnAndPath) {
  const Reader top = Reader::parse("a:\n  - b: 1\n  -   c: {d: [1, 2]}\n", "a.yaml");
  const Reader second = top["a"].entries()[1]["c"]["d"].entries()[1];
  EXPECT_EQ(second.path(), "a[1].c.d[1]");
  EXPECT_EQ(second.node().place.line, 3u);
  EXPECT_EQ(second.node().place.column, 18u);
}

TEST(Yaml, DuplicateKey_IsRefused) {
  expect_words(refused_yaml("a: {b: 1, c: 2, b: 3}\n"),
               {"a.yaml: line 1: a: key 'b' is stated twice; state it once"});
  expect_words(refused_yaml("a: 1\n'a': 2\n"), {"line 2: key 'a' is stated twice"});
}

TEST(Yaml, KeyThatIsNotAName_IsRefused) {
  for (const char* text : {"{[1, 2]: 3}", "{{a: 1}: 3}", "~: 3", "a:\n  ? [1]\n  : 2\n"})
    expect_words(refused_yaml(text), {"a key is not a name; wanted a name"});
}

TEST(Yaml, ErrorInsideAKey_NamesTheLineOfTheKey) {
  expect_words(refused_yaml("&a [*a]b: 1"),
               {"a.yaml: line 1: an alias refers to a value that contains it"});
  expect_words(refused_yaml("x: {&a [*a]: 1}"),
               {"line 1: x: an alias refers to a value that contains it"});
  expect_words(refused_yaml("{x: 1, ? {y: &a [*a]} : 3}"), {"line 1: an alias refers to a value"});
}

TEST(Yaml, InfinityAndNan_AreRefusedAsNumbers) {
  const Reader top = Reader::parse("[nan, -inf, .inf, .nan]", "a.yaml");
  expect_words(refusal([&] { top.entries()[0].number(); }), {"[0]: nan is not finite"});
  expect_words(refusal([&] { top.entries()[1].number(); }), {"[1]: -inf is not finite"});
  expect_words(refusal([&] { top.entries()[2].number(); }), {"[2]: '.inf' is not a number"});
  expect_words(refusal([&] { top.entries()[3].number(); }), {"[3]: '.nan' is not a number"});
}

TEST(Yaml, NumberBeyondTheLargest_IsRefused) {
  const Reader top = Reader::parse("a: 1e400\nb: -1e400\n", "a.yaml");
  expect_words(refusal([&] { top["a"].number(); }), {"line 1: a: '1e400' is not a number"});
  expect_words(refusal([&] { top["b"].number(); }), {"line 2: b: '-1e400' is not a number"});
}

TEST(Yaml, EscapedSurrogatePair_IsRefused) {
  EXPECT_EQ(Reader::parse(R"("\U0001F916")", "a.yaml").text(), "\U0001F916");
  expect_words(refused_yaml(R"("\uD83E\uDD16")"), {"a.yaml: line 1: this is not valid YAML"});
}

TEST(Yaml, Tabs_SeparateButDoNotIndent) {
  EXPECT_EQ(Reader::parse("a:\t1\nb: [1,\t2]\t# c\n", "a.yaml")["a"].number(), 1.0);
  expect_words(refused_yaml("a:\n\tb: 1\n"), {"a.yaml: line 2: this is not valid YAML"});
}

TEST(Yaml, Aliases_HaveTheValuesOfTheirAnchors) {
  const Reader top = Reader::parse("a: &x {k: [1, 2]}\nb: *x\nc: &y 3\nd: [*y, *x]\n", "a.yaml");
  EXPECT_EQ(top["b"]["k"].numbers(2)[1], 2.0);
  EXPECT_EQ(top["d"].entries()[0].number(), 3.0);
  EXPECT_EQ(top["d"].entries()[1]["k"].path(), "d[1].k");
  expect_words(refusal([&] { top["b"]["k"].numbers(3); }), {"line 1: b.k: it has 2 numbers"});
}

TEST(Yaml, AliasInsideItsAnchor_IsRefused) {
  expect_words(refused_yaml("a: &x [1, *x]\n"),
               {"line 1: a: an alias refers to a value that contains it"});
  expect_words(refused_yaml("a: *x\n"), {"this is not valid YAML"});
}

TEST(Yaml, ExcessiveAliasExpansion_IsRefused) {
  std::string text = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 9; ++i) {
    const std::string last = "*a" + std::to_string(i - 1);
    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + last;
    for (int k = 1; k < 10; ++k) text += ", " + last;
    text += "]\n";
  }
  expect_words(refused_yaml(text), {"anchors and aliases expand to more than 200000 values"});
  const std::string name(100'000, 'n');
  std::string repeated = "[&x " + name;
  for (int i = 0; i < 1000; ++i) repeated += ", *x";
  expect_words(refused_yaml(repeated + "]"),
               {"anchors and aliases expand to more than 200000 values"});
}

TEST(Yaml, MergeKey_IsRefused) {
  expect_words(refused_yaml("a: &x {k: 1}\nb:\n  <<: *x\n  l: 2\n"),
               {"line 3: b: the merge key '<<' is not supported; wanted the keys themselves"});
  EXPECT_TRUE(Reader::parse("{'<<': 1}", "a.yaml").has("<<"));
}

TEST(Yaml, NestingBeyond64_IsRefused) {
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
  };
  EXPECT_EQ(parse_yaml(nested(64), "a.yaml").size(), 1u);
  expect_words(refused_yaml(nested(65)), {"line 1: ", "nested more than 64 deep"});
  expect_words(refused_yaml(nested(32000)), {"nested more than 64 deep"});
  expect_words(refused_yaml("a: &x " + nested(40) + "\nb: " + std::string(30, '[') + "*x" +
                            std::string(30, ']')),
               {"line 1: ", "nested more than 64 deep"});
}

TEST(Yaml, InvalidUtf8_IsKept) {
  EXPECT_EQ(Reader::parse("a: caf\xe9\n", "a.yaml")["a"].text(), "caf\xe9");
  EXPECT_EQ(Reader::parse("\"caf\xe9\"", "a.yaml").text(), "caf\xe9");
}

TEST(Yaml, EmptyText_IsNull) {
  for (const char* text : {"", "\n", "# only this\n", "---\n", "~"}) {
    const Reader top = Reader::parse(text, "a.yaml");
    EXPECT_TRUE(top.is_null()) << text;
    expect_words(refusal([&] { top.allow_only({"a"}); }),
                 {"it is nothing; wanted keys with values"});
  }
}

TEST(Yaml, SecondDocument_IsRefused) {
  expect_words(refused_yaml("a: 1\n---\nb: 2\n"),
               {"a.yaml: line 2: a second document begins here"});
  EXPECT_EQ(Reader::parse("---\na: 1\n...\n", "a.yaml")["a"].number(), 1.0);
}

TEST(Yaml, InvalidYaml_IsRefusedWithItsLine) {
  expect_words(refused_yaml("a: 1\nb: [1, 2\n"), {"a.yaml: line 3: this is not valid YAML: "});
  expect_words(refused_yaml("a: b: c\n"), {"a.yaml: line 1: this is not valid YAML: "});
}

}  // namespace
}  // namespace burnish::document
