// Tests of anchors and references as values: texts, names and refusals.
#include <gtest/gtest.h>

#include "burnish/dynamics/reference.hpp"
#include "dynamics/reference.hpp"
#include "support/refusal.hpp"
#include "support/robots.hpp"

namespace burnish::test {
namespace {

TEST(Anchor, Text_ParsesBackToTheAnchor) {
  for (const Anchor& anchor : {Anchor(Anchor::Tool), Anchor(Anchor::Base), Anchor(Anchor::World),
                               Anchor("torso"), Anchor("tool"), Anchor("frame tool")})
    EXPECT_EQ(Anchor::parse(anchor.text()), anchor) << anchor.text();
  EXPECT_EQ(Anchor::parse("tool"), Anchor(Anchor::Tool));
  EXPECT_EQ(Anchor("tool").text(), "frame tool");
  EXPECT_EQ(Anchor("torso").text(), "torso");
}

TEST(ReferenceName, AnyReference_NamesItsKindOrItsFrames) {
  for (const std::string name : {"local", "centered", "surface", "world"})
    EXPECT_EQ(Reference::parse(name).name(), name);
  EXPECT_EQ((Reference{Anchor::Tool, "torso"}.name()), "axes of torso at the tool");
  EXPECT_EQ((Reference{"elbow", Anchor::Base}.name()), "axes of the base at elbow");
  testing::expect_words(testing::refusal([] { Reference::parse("centred"); }),
                        {"'centred'", "did you mean 'centered'?"});
}

TEST(CompileReference, FrameOfTheTool_IsRecognizedAsTheTool) {
  const std::string name = built_robots().front().tool;
  const Model model = named_robot(built_robots().front().name);
  const CompiledFrame tool = compile_frame(model, name);
  const auto compiled = [&](const Reference& reference) {
    return compile_reference(model, reference, tool, world_frame());
  };
  const CompiledReference named = compiled({name, name});
  EXPECT_TRUE(named.at_tool);
  EXPECT_EQ(named.axes_body, tool.body);
  EXPECT_TRUE(compiled(Reference::world()).at_world);
  EXPECT_TRUE(compiled(Reference::centered()).is_aligned);
  EXPECT_FALSE(compiled(Reference::local()).is_aligned);
  testing::expect_words(testing::refusal([&] {
                          (void)compiled({Anchor::Tool, name + "x"});
                        }),
                        {name + "x", "did you mean"});
}

}  // namespace
}  // namespace burnish::test
