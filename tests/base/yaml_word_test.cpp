// Tests of the quoting of words in YAML.
#include "base/yaml_word.hpp"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

namespace burnish::testing {
namespace {

TEST(YamlWord, AnyText_ReadsBackUnchanged) {
  for (const std::string& word :
       {std::string("plain"), std::string("../a b/c.urdf"), std::string("null"), std::string(""),
        std::string("a: b"), std::string("talos:right_arm"), std::string("- x"), std::string("#1"),
        std::string("it's \"so\" \\ \n\t"), std::string("r\xc3\xbc"), std::string("{a, b}"),
        std::string("ends:")}) {
    EXPECT_EQ(YAML::Load(yaml_word(word)).as<std::string>(), word);
    EXPECT_EQ(YAML::Load("key: " + yaml_word(word) + "\n")["key"].as<std::string>(), word);
    EXPECT_EQ(YAML::Load(yaml_word(word) + ": 1\n").begin()->first.as<std::string>(), word);
  }
}

}  // namespace
}  // namespace burnish::testing
