// Tests of the placements of frames, against published values and against each other.
#include "burnish/dynamics/placement.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/refusal.hpp"
#include "support/robots.hpp"

namespace burnish {
namespace {

#if BURNISH_HAS_ROBOTS
TEST(FramePlacement, PublishedPosture_GivesThePublishedToolPosition) {
  const Robot arm = load_robot(BURNISH_ROBOTS_DIR "/talos:right_arm");
  const auto tool = [&](const char* posture) {
    return Eigen::Vector3d(frame_placement(arm.model, arm.posture(posture), "tool").translation());
  };
  EXPECT_LT((tool("table") - Eigen::Vector3d(0.431, -0.330, 1.021)).norm(), 1e-3);
  EXPECT_LT((tool("board_y") - Eigen::Vector3d(0.116, -0.764, 1.412)).norm(), 1e-3);
}

#endif

TEST(FramePlacement, ListOfAll_IsInTheOrderOfFrames) {
  const Model model = test::named_robot(test::has_robot_files ? "crane" : "every_joint");
  std::mt19937_64 generator(2);
  const Eigen::VectorXd q = random_configuration(model, generator);
  const std::vector<Eigen::Isometry3d> all = frame_placements(model, q);
  ASSERT_EQ(all.size(), model.frames.size());
  for (const Frame& frame : model.frames) {
    const auto index = static_cast<std::size_t>(model.frame_index(frame.name));
    EXPECT_TRUE(all[index].isApprox(frame_placement(model, q, frame.name)));
  }
}

TEST(FramePlacement, FreeFlyer_PlacesItsLinkAsInQ) {
  const Model model = test::named_robot("arm7:floating");
  Eigen::VectorXd q = model.q_neutral;
  q.head<7>() << 1.0, 2.0, 3.0, 0.0, 0.0, std::sin(0.4), std::cos(0.4);
  for (const Frame& frame : model.frames) {
    if (frame.body != 0 || frame.kind != FrameKind::Link) continue;
    const Eigen::Isometry3d placement = frame_placement(model, q, frame.name);
    EXPECT_LT((placement.translation() - Eigen::Vector3d(1.0, 2.0, 3.0)).norm(), 1e-12);
    EXPECT_NEAR(placement.linear()(1, 0), std::sin(0.8), 1e-12);
    return;
  }
  FAIL() << "no link on the free-flyer";
}

TEST(FramePlacement, World_IsIdentityAndUnknownFramesAreRefused) {
  const Model model = test::named_robot("arm7");
  const Eigen::VectorXd q = model.q_neutral;
  EXPECT_TRUE(frame_placement(model, q, "world").isApprox(Eigen::Isometry3d::Identity()));
  testing::expect_words(testing::refusal([&] { frame_placement(model, q, "tol"); }),
                        {"'tol'", "did you mean 'tool'?"});
  testing::expect_words(
      testing::refusal([&] { frame_placements(model, Eigen::VectorXd::Zero(3)); }),
      {"'q'", "3 entries", "wanted 7"});
}

}  // namespace
}  // namespace burnish
