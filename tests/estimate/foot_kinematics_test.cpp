// Tests of the poses of feet seen from the IMU, and of their derivatives with respect to joints, on
// robots.
#include "estimate/foot_kinematics.hpp"

#include <gtest/gtest.h>

#include <random>

#include "burnish/dynamics/placement.hpp"
#include "dynamics/kinematics.tpp"
#include "estimate/truth.hpp"
#include "support/autodiff.hpp"
#include "support/refusal.hpp"
#include "support/robots.hpp"
#include "support/special_numbers.hpp"

namespace burnish::test {
namespace {

/// Robot with a floating base, the frame of its IMU ("": the base) and its feet.
struct Case {
  std::string robot, imu;
  std::vector<std::string> feet;
};

std::vector<Case> cases() {
  std::vector<Case> result = {{"every_joint", "", {"tip", "d_side"}},
                              {"every_joint", "b", {"tip", "root_ball", "b"}},
                              {"followers", "z_2", {"tip", "z_5"}},
                              {"in_a_row", "", {"tip", "side"}}};
  if (has_robot_files) {
    result.push_back({"talos", "torso_2_link", {"left_sole_link", "right_sole_link"}});
    result.push_back({"quadruped", "", {"fl_foot", "fr_foot", "rl_foot", "rr_foot"}});
  } else {
    result.push_back({"biped", "arm_1_link", {"left_sole_link", "right_sole_link"}});
  }
  return result;
}

Eigen::VectorXd random_q(const Model& model, std::mt19937_64& generator) {
  return random_configuration(model, generator);
}

TEST(FootKinematics, FootPoses_EqualTheFramePlacements) {
  std::mt19937_64 generator(1);
  for (const Case& c : cases()) {
    const Model model = named_robot(c.robot, Base::FreeFlyer);
    FootKinematics kinematics(model, c.imu, c.feet);
    const Eigen::VectorXd q = random_q(model, generator);
    ASSERT_EQ(kinematics.update(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
    const std::string imu = c.imu.empty() ? "root" : c.imu;
    if (!model.has_frame(imu)) continue;
    const Eigen::Isometry3d at = frame_placement(model, q, imu);
    for (std::size_t k = 0; k < c.feet.size(); ++k) {
      const Eigen::Isometry3d wanted = at.inverse() * frame_placement(model, q, c.feet[k]);
      const SeenFoot& seen = kinematics.seen(static_cast<int>(k));
      EXPECT_LT((to_eigen(seen.p) - wanted.translation()).norm(), 1e-12) << c.robot << c.feet[k];
      EXPECT_LT((to_eigen(seen.R) - wanted.linear()).norm(), 1e-12) << c.robot << c.feet[k];
    }
  }
}

/// Pose of the foot in the IMU's frame: position, and the axial vector of dR R^T at dR = R - R_0.
template <class S>
std::vector<S> seen_of(const Tree& tree, const CompiledFrame& imu, const CompiledFrame& foot,
                       const Mat3<double>& R_0, const S* q) {
  Kinematics<S> kinematics(tree);
  const std::vector<S> v(static_cast<std::size_t>(tree.nv), S(0.0));
  update_kinematics(tree, q, v.data(), kinematics);
  const FramePose<S> seen = seen_from(pose_of(imu, kinematics), pose_of(foot, kinematics));
  const Mat3<S> turn = seen.R * transposed(lift<S>(R_0));
  const S half(0.5);
  return {seen.p.x,
          seen.p.y,
          seen.p.z,
          (turn.c1.z - turn.c2.y) * half,
          (turn.c2.x - turn.c0.z) * half,
          (turn.c0.y - turn.c1.x) * half};
}

TEST(FootKinematics, JacobiansAndVelocities_AreExact) {
  std::mt19937_64 generator(2);
  for (const Case& c : cases()) {
    const Model model = named_robot(c.robot, Base::FreeFlyer);
    const Tree tree(model);
    FootKinematics kinematics(model, c.imu, c.feet);
    const CompiledFrame imu = c.imu.empty()
                                  ? CompiledFrame{0, Mat3<double>::identity(), Vec3<double>::zero(),
                                                  moving_axes(model, 0)}
                                  : compile_frame(model, c.imu);
    for (int trial = 0; trial < 3; ++trial) {
      Eigen::VectorXd q = random_q(model, generator);
      q.head<7>() << 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0;
      const Eigen::VectorXd v = random_vector(model.nv, 1.0, generator);
      ASSERT_EQ(kinematics.update(q, v), Status::Ok);
      for (std::size_t k = 0; k < c.feet.size(); ++k) {
        const CompiledFrame foot = compile_frame(model, c.feet[k]);
        const Mat3<double> R_0 = kinematics.seen(static_cast<int>(k)).R;
        const Eigen::MatrixXd exact =
            differentiate(model, q, v, [&](const Duals& at, const Duals& /*v*/) {
              return seen_of<Dual>(tree, imu, foot, R_0, at.data());
            }).dq;
        const Eigen::MatrixXd J = kinematics.jacobian(static_cast<int>(k));
        Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(6, model.nv);
        for (std::size_t i = 0; i < kinematics.columns().size(); ++i)
          whole.col(kinematics.columns()[i]) = J.col(static_cast<Eigen::Index>(i));
        EXPECT_LT((whole - exact).rightCols(model.nv - 6).norm(), 1e-10) << c.robot << c.feet[k];
        // The motion of the base has no effect on poses seen from the IMU.
        EXPECT_LT(exact.leftCols(6).norm(), 1e-10);
        constexpr double h = 1e-6;
        Eigen::VectorXd step = Eigen::VectorXd::Zero(model.nv);
        for (int i = 6; i < model.nv; ++i) {
          step[i] = h;
          const Eigen::VectorXd up = integrate(model, q, step), down = integrate(model, q, -step);
          const std::vector<double> a = seen_of<double>(tree, imu, foot, R_0, up.data()),
                                    b = seen_of<double>(tree, imu, foot, R_0, down.data());
          for (int row = 0; row < 6; ++row)
            EXPECT_NEAR(
                whole(row, i),
                (a[static_cast<std::size_t>(row)] - b[static_cast<std::size_t>(row)]) / (2 * h),
                1e-7);
          step[i] = 0.0;
        }
        const Eigen::Vector3d speed =
            exact.topRows(3).rightCols(model.nv - 6) * v.tail(model.nv - 6);
        EXPECT_LT((to_eigen(kinematics.velocity(static_cast<int>(k))) - speed).norm(), 1e-10);
        const Eigen::Vector3d turning =
            exact.bottomRows(3).rightCols(model.nv - 6) * v.tail(model.nv - 6);
        EXPECT_LT((to_eigen(kinematics.turning(static_cast<int>(k))) - turning).norm(), 1e-10);
      }
    }
  }
}

TEST(FootKinematics, InvalidState_ReturnsAStatus) {
  const Model model = named_robot("every_joint", Base::FreeFlyer);
  FootKinematics kinematics(model, "", {"tip"});
  Eigen::VectorXd q = model.q_neutral, v = Eigen::VectorXd::Zero(model.nv);
  const Vec3<double> seen = kinematics.seen(0).p;
  EXPECT_EQ(kinematics.update(q.head(model.nq - 1), v), Status::WrongSize);
  EXPECT_EQ(kinematics.update(q, v.head(3)), Status::WrongSize);
  q[0] = nan;  // position of the base, which is not used
  EXPECT_EQ(kinematics.update(q, v), Status::Ok);
  q[8] = nan;
  EXPECT_EQ(kinematics.update(q, v), Status::NotFinite);
  q = model.q_neutral;
  q.tail(model.nq - 7).setConstant(0.7);
  EXPECT_EQ(kinematics.update(q, v), Status::NotNormalized);
  EXPECT_EQ(kinematics.seen(0).p.x, seen.x);
}

TEST(FootKinematics, UnknownFrameOrFixedBase_IsRefused) {
  using burnish::testing::expect_words;
  using burnish::testing::refusal;
  const Model model = named_robot("every_joint", Base::FreeFlyer);
  expect_words(refusal([&] { FootKinematics(model, "", {"tap"}); }), {"'tap'", "'tip'"});
  expect_words(refusal([&] { FootKinematics(model, "world", {"tip"}); }), {"'world'", "fixed"});
  expect_words(
      refusal([&] { FootKinematics(named_robot("every_joint", Base::Fixed), "", {"tip"}); }),
      {"every_joint", "free-flying"});
}

}  // namespace
}  // namespace burnish::test
