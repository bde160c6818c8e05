// Tests of the YAML and JSON writers: written trees read back unchanged.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "document/text.hpp"

namespace burnish::document {
namespace {

std::string special_text(std::mt19937& random) {
  static const std::vector<std::string> texts{"my arm #2",
                                              "plain",
                                              "null",
                                              "~",
                                              "true",
                                              "5",
                                              "-1e3",
                                              "inf",
                                              ".inf",
                                              "nan",
                                              "",
                                              " ",
                                              "- x",
                                              "a: b",
                                              "a:b",
                                              "ends:",
                                              "{a, b}",
                                              "[",
                                              "it's \"so\" \\ \n\t\r\x01\x7f",
                                              "r\xc3\xbc",
                                              "\U0001F916",
                                              "<<",
                                              "*x",
                                              "&x",
                                              "!t",
                                              "|",
                                              "%",
                                              "@",
                                              "`",
                                              "? x",
                                              "talos:right_arm",
                                              "/a/../b",
                                              "../a b/c.urdf",
                                              "a #b",
                                              "#",
                                              ",",
                                              "=",
                                              "yes",
                                              "0x10",
                                              "1_000",
                                              "2026-01-01",
                                              "---",
                                              "..."};
  return texts[random() % texts.size()];
}

Node random_tree(std::mt19937& random, int depth) {
  switch (random() % (depth > 0 ? 6 : 4)) {
    case 0:
      return {};
    case 1:
      return {.kind = Kind::Bool, .text = random() % 2 == 0 ? "true" : "false"};
    case 2:
      return {.kind = Kind::Number,
              .text = number_text(std::ldexp(static_cast<double>(random()) - 2e9,
                                             static_cast<int>(random() % 400) - 200))};
    case 3:
      return {.kind = Kind::Text, .text = special_text(random)};
    case 4: {
      Node list{.kind = Kind::List};
      for (std::size_t i = random() % 4; i > 0; --i)
        list.values.push_back(random_tree(random, depth - 1));
      return list;
    }
    default: {
      Node map{.kind = Kind::Map};
      for (std::size_t i = random() % 4; i > 0; --i) {
        const std::string key = special_text(random) + (i == 1 ? "" : std::to_string(i));
        map.values.push_back({.kind = Kind::Text, .text = key});
        map.values.push_back(random_tree(random, depth - 1));
      }
      return map;
    }
  }
}

bool same(const Node& a, const Node& b, bool is_key = false) {
  if ((a.kind != b.kind && !is_key) || a.text != b.text || a.values.size() != b.values.size())
    return false;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    if (!same(a.values[i], b.values[i], a.kind == Kind::Map && i % 2 == 0)) return false;
  return true;
}

TEST(DocumentWriter, RandomTree_ReadsBackUnchangedFromYamlAndJson) {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const Node tree = random_tree(random, 3);
    const std::string yaml = yaml_text(tree), json = json_text(tree);
    EXPECT_TRUE(same(parse_yaml(yaml, "a.yaml"), tree)) << yaml;
    EXPECT_TRUE(same(parse_json(json, "a.json"), tree)) << json;
    EXPECT_TRUE(same(parse_yaml(json, "a.json"), tree)) << json;
    EXPECT_EQ(yaml.find('\n'), std::string::npos);
  }
}

TEST(DocumentWriter, Text_IsQuotedOnlyWhereNecessary) {
  const auto text = [](const char* word) { return yaml_text({.kind = Kind::Text, .text = word}); };
  EXPECT_EQ(text("talos:right_arm"), "talos:right_arm");
  EXPECT_EQ(text("../robots/arm.urdf"), "../robots/arm.urdf");
  EXPECT_EQ(text("my arm #2"), "\"my arm #2\"");
  EXPECT_EQ(text("5"), "\"5\"");
  EXPECT_EQ(text("caf\xe9"), "\"caf\xe9\"");
  EXPECT_EQ(parse_yaml(text("caf\xe9"), "a.yaml").text, "caf\xe9");
}

TEST(DocumentWriter, Number_IsShortAndReadsBack) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(-0.0), "-0");
  EXPECT_EQ(number_text(30.0), "30");
  EXPECT_EQ(number_text(1e-5), "1e-05");
  EXPECT_EQ(number_text(std::numeric_limits<double>::denorm_min()), "5e-324");
}

}  // namespace
}  // namespace burnish::document
