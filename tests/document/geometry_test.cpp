// Tests of rotations and placements that are read from YAML.
#include "document/geometry.hpp"

#include <gtest/gtest.h>

#include "support/refusal.hpp"

namespace burnish::document {
namespace {

using testing::expect_words;
using testing::refusal;

Eigen::Isometry3d placement(const std::string& text) {
  return read_placement(Reader::parse(text, "a.yaml"));
}

TEST(Placement, AnglesQuaternionAndMatrix_GiveTheSamePlacement) {
  const Eigen::Isometry3d by_rpy = placement("{xyz: [1, 2, 3], rpy: [0, 0, 1.5707963267948966]}");
  const Eigen::Isometry3d by_matrix =
      placement("{xyz: [1, 2, 3], matrix: [[0, -1, 0], [1, 0, 0], [0, 0, 1]]}");
  const Eigen::Isometry3d by_quaternion =
      placement("{xyz: [1, 2, 3], quaternion: [0, 0, 0.7071067811865476, 0.7071067811865476]}");
  EXPECT_LT((by_rpy.matrix() - by_matrix.matrix()).norm(), 1e-15);
  EXPECT_LT((by_rpy.matrix() - by_quaternion.matrix()).norm(), 1e-15);
  EXPECT_EQ(by_matrix(0, 1), -1.0) << "a matrix is not rounded";
  EXPECT_EQ(placement("{}").matrix(), Eigen::Matrix4d::Identity());
}

TEST(Placement, InvalidRotationOrKey_IsRefused) {
  const auto refused = [](const char* text) { return refusal([&] { placement(text); }); };
  expect_words(refused("{matrix: [[1, 0, 0], [0, 1, 0], [0, 0, -1]]}"), {"matrix: it is not a"});
  expect_words(refused("{matrix: [[1, 0, 0], [0, 1, 0]]}"), {"matrix: it has 2 rows; wanted 3"});
  expect_words(refused("{quaternion: [0, 0, 0, 2]}"), {"quaternion: ", "length 2; wanted 1"});
  expect_words(refused("{rpy: [0, 0, 0], quaternion: [0, 0, 0, 1]}"), {"several of the keys"});
  expect_words(refused("{xzy: [0, 0, 0]}"), {"key 'xzy' is unknown; did you mean 'xyz'?"});
}

}  // namespace
}  // namespace burnish::document
