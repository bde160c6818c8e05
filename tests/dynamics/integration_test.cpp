// Integration q (+) dq and difference q1 (-) q0 for every kind of joint. They are compared with the
// arithmetic on Eigen vectors, their derivatives with differences and automatic differentiation.
#include "dynamics/integration.tpp"

#include <cmath>
#include <numbers>

#include "support/allocation_guard.hpp"
#include "support/kernel_law.hpp"

namespace burnish::test {
namespace {

constexpr double scales[] = {0.0, 1e-12, 1e-6, 1e-3, 0.1, 0.55, 1.0, 1.7};

class Integration : public OnRobots {
 protected:
  Eigen::VectorXd plus(const Eigen::VectorXd& q, const Eigen::VectorXd& dq) const {
    Eigen::VectorXd out(model.nq);
    integrate_configuration(tree, q.data(), dq.data(), out.data());
    return out;
  }
  Eigen::VectorXd minus(const Eigen::VectorXd& q1, const Eigen::VectorXd& q0) const {
    Eigen::VectorXd dq(model.nv);
    difference_configuration(tree, q0.data(), q1.data(), dq.data());
    return dq;
  }

  /// Complete nv x nv matrices: identities, with the tangent blocks filled in.
  struct Pair {
    Eigen::MatrixXd first, second;
  };
  Pair assembled(double first, double second, const auto& jacobians,
                 const Eigen::VectorXd& dq) const {
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Pair whole{first * Eigen::MatrixXd::Identity(model.nv, model.nv),
               second * Eigen::MatrixXd::Identity(model.nv, model.nv)};
    for (const TangentBlock& block : tangent_blocks(tree)) {
      Rows a(block.size, block.size), b(block.size, block.size);
      jacobians(block, dq.data() + block.first, a.data(), b.data());
      whole.first.block(block.first, block.first, block.size, block.size) = a;
      whole.second.block(block.first, block.first, block.size, block.size) = b;
    }
    return whole;
  }
  Pair of_plus(const Eigen::VectorXd& dq) const {
    return assembled(1.0, 1.0, integrate_jacobians<double>, dq);
  }
  Pair of_minus(const Eigen::VectorXd& dq) const {
    return assembled(-1.0, 1.0, difference_jacobians<double>, dq);
  }

  Tree tree{model};
  std::mt19937_64 generator{91};
};

TEST_P(Integration, Integrate_EqualsTheVectorArithmetic) {
  for (const double scale : {0.0, 1e-12, 1e-5, 1e-3, 0.2, 1.0, 3.0, 10.0})
    for (int i = 0; i < 20; ++i) {
      const Eigen::VectorXd q = random_configuration(model, generator);
      const Eigen::VectorXd dq = random_vector(model.nv, scale, generator);
      const Eigen::VectorXd want = integrate(model, q, dq);
      EXPECT_LE(relative_error(plus(q, dq), want), 1e-13) << scale;
      Eigen::VectorXd in_place = q;
      integrate_configuration(tree, in_place.data(), dq.data(), in_place.data());
      EXPECT_EQ(in_place, plus(q, dq));
    }
}

TEST_P(Integration, Difference_EqualsTheVectorArithmetic) {
  for (const double scale : {0.0, 1e-12, 1e-7, 1e-5, 1e-3, 0.2, 1.0, 3.0, 10.0})
    for (int i = 0; i < 20; ++i) {
      const Eigen::VectorXd q0 = random_configuration(model, generator);
      const Eigen::VectorXd q1 = integrate(model, q0, random_vector(model.nv, scale, generator));
      EXPECT_LE(relative_error(minus(q1, q0), difference(model, q0, q1)), 1e-13) << scale;
    }
}

TEST_P(Integration, DifferenceWithinHalfATurn_UndoesIntegration) {
  for (const double scale : scales)
    for (int i = 0; i < 20; ++i) {
      const Eigen::VectorXd q = random_configuration(model, generator);
      const Eigen::VectorXd dq = random_vector(model.nv, scale, generator);
      EXPECT_LE(relative_error(minus(plus(q, dq), q), dq), 1e-13) << scale;
    }
}

TEST_P(Integration, ManySteps_KeepRotationsAtUnitLength) {
  Eigen::VectorXd q = random_configuration(model, generator);
  const Eigen::VectorXd dq = random_vector(model.nv, 0.3, generator);
  for (const Joint& joint : model.joints) {
    if (joint.kind == JointKind::FreeFlyer) q.segment(joint.q_index + 3, 4) *= 1.0 + 5e-7;
    if (joint.kind == JointKind::Ball) q.segment(joint.q_index, 4) *= 1.0 - 4e-7;
    if (joint.kind == JointKind::Continuous) q.segment(joint.q_index, 2) *= 1.0 - 5e-7;
    if (joint.kind == JointKind::Planar) q.segment(joint.q_index + 2, 2) *= 1.0 + 5e-7;
  }
  for (int step = 0; step < 1000; ++step)
    integrate_configuration(tree, q.data(), dq.data(), q.data());
  EXPECT_LE((q - normalized(model, q)).cwiseAbs().maxCoeff(), 1e-15);
}

TEST_P(Integration, TangentBlocks_AreTheJointsOfSeveralEntries) {
  std::vector<TangentBlock> blocks = tangent_blocks(tree);
  std::size_t found = 0;
  for (const Joint& joint : model.joints) {
    if (joint.nv <= 1) continue;
    ASSERT_LT(found, blocks.size());
    EXPECT_EQ(blocks[found].first, joint.v_index);
    EXPECT_EQ(blocks[found].size, joint.nv);
    EXPECT_EQ(blocks[found].kind, joint.kind);
    EXPECT_EQ(blocks[found++].q, joint.q_index);
  }
  EXPECT_EQ(found, blocks.size());
}

TEST_P(Integration, Jacobians_EqualAutomaticDifferentiation) {
  const Tree& t = tree;
  for (const double scale : scales)
    for (int i = 0; i < 5; ++i) {
      const Eigen::VectorXd q = random_configuration(model, generator);
      const Eigen::VectorXd dq = random_vector(model.nv, scale, generator);
      Eigen::VectorXd q1;
      const ByState plus_by = differentiate(model, q, dq, [&](const Duals& at, const Duals& along) {
        Duals out(static_cast<std::size_t>(model.nq));
        integrate_configuration(t, at.data(), along.data(), out.data());
        q1 = values_of(out);
        return out;
      });
      // tangent_map turns right increments of the result into rates of its entries.
      const Eigen::MatrixXd map = tangent_map(model, q1);
      const Pair by = of_plus(dq);
      EXPECT_LE(relative_error(map * by.first, plus_by.dq), 1e-13) << "by q, " << scale;
      EXPECT_LE(relative_error(map * by.second, plus_by.dv), 1e-13) << "by dq, " << scale;

      q1 = plus(q, dq);
      const Pair minus_by = of_minus(dq);
      const Duals fixed = constant_duals(q), fixed_1 = constant_duals(q1);
      const auto apart = [&](const Duals& q_from, const Duals& q_to) {
        Duals between(static_cast<std::size_t>(model.nv));
        difference_configuration(t, q_from.data(), q_to.data(), between.data());
        return between;
      };
      const ByState from = differentiate(
          model, q, dq, [&](const Duals& at, const Duals&) { return apart(at, fixed_1); });
      EXPECT_LE(relative_error(minus_by.first, from.dq), 1e-12) << "q0, " << scale;
      const ByState to = differentiate(
          model, q1, dq, [&](const Duals& at, const Duals&) { return apart(fixed, at); });
      EXPECT_LE(relative_error(minus_by.second, to.dq), 1e-12) << "q1, " << scale;
    }
}

TEST_P(Integration, Jacobians_EqualCentralDifferences) {
  const double h = 1e-5;
  for (const double scale : scales) {
    const Eigen::VectorXd q = random_configuration(model, generator);
    const Eigen::VectorXd dq = random_vector(model.nv, scale, generator);
    const Eigen::VectorXd q1 = integrate(model, q, dq);
    Pair plus_by{Eigen::MatrixXd(model.nv, model.nv), Eigen::MatrixXd(model.nv, model.nv)};
    Pair minus_by = plus_by;
    const auto increment = [&](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
      return Eigen::VectorXd((difference(model, q1, a) - difference(model, q1, b)) / (2.0 * h));
    };
    for (int k = 0; k < model.nv; ++k) {
      const Eigen::VectorXd e = h * Eigen::VectorXd::Unit(model.nv, k);
      const Eigen::VectorXd forth = integrate(model, q, e), back = integrate(model, q, -e);
      plus_by.first.col(k) = increment(plus(forth, dq), plus(back, dq));
      plus_by.second.col(k) = increment(plus(q, dq + e), plus(q, dq - e));
      minus_by.first.col(k) = (minus(q1, forth) - minus(q1, back)) / (2.0 * h);
      minus_by.second.col(k) =
          (minus(integrate(model, q1, e), q) - minus(integrate(model, q1, -e), q)) / (2.0 * h);
    }
    EXPECT_LE(relative_error(of_plus(dq).first, plus_by.first), 1e-8) << scale;
    EXPECT_LE(relative_error(of_plus(dq).second, plus_by.second), 1e-8) << scale;
    EXPECT_LE(relative_error(of_minus(dq).first, minus_by.first), 1e-8) << scale;
    EXPECT_LE(relative_error(of_minus(dq).second, minus_by.second), 1e-8) << scale;
  }
}

TEST_P(Integration, PackLanes_EqualSingleStates) {
  using S = NativePack;
  const auto nq = static_cast<std::size_t>(model.nq), nv = static_cast<std::size_t>(model.nv);
  for (int round = 0; round < 5; ++round) {
    std::vector<Eigen::VectorXd> q, dq;
    for (int l = 0; l < native_lanes; ++l) {
      q.push_back(random_configuration(model, generator));
      dq.push_back(random_vector(model.nv, scales[(round + l) % 8], generator));
    }
    const std::vector<S> packed_q = packed<S>(q), packed_dq = packed<S>(dq);
    std::vector<S> out(nq), apart(nv);
    integrate_configuration(tree, packed_q.data(), packed_dq.data(), out.data());
    difference_configuration(tree, packed_q.data(), out.data(), apart.data());
    for (int l = 0; l < native_lanes; ++l) {
      const Eigen::VectorXd one =
          plus(q[static_cast<std::size_t>(l)], dq[static_cast<std::size_t>(l)]);
      EXPECT_LE(relative_error(as_vector(lane_values(out, l)), one), 1e-14);
      EXPECT_LE(relative_error(as_vector(lane_values(apart, l)),
                               minus(one, q[static_cast<std::size_t>(l)])),
                1e-13);
    }
    for (const TangentBlock& block : tangent_blocks(tree)) {
      const auto entries = static_cast<std::size_t>(block.size * block.size);
      std::vector<S> packs[4];
      std::vector<double> ones[4];
      for (auto& matrix : packs) matrix.resize(entries);
      for (auto& matrix : ones) matrix.resize(entries);
      integrate_jacobians(block, &packed_dq[static_cast<std::size_t>(block.first)], packs[0].data(),
                          packs[1].data());
      difference_jacobians(block, &packed_dq[static_cast<std::size_t>(block.first)],
                           packs[2].data(), packs[3].data());
      for (int l = 0; l < native_lanes; ++l) {
        const double* const step = dq[static_cast<std::size_t>(l)].data() + block.first;
        integrate_jacobians(block, step, ones[0].data(), ones[1].data());
        difference_jacobians(block, step, ones[2].data(), ones[3].data());
        for (int i = 0; i < 4; ++i)
          EXPECT_LE(relative_error(as_vector(lane_values(packs[i], l)), as_vector(ones[i])), 1e-14);
      }
    }
  }
}

TEST_P(Integration, Evaluation_AllocatesNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  const Eigen::VectorXd q = random_configuration(model, generator);
  Eigen::VectorXd out(model.nq), dq = random_vector(model.nv, 1.0, generator);
  double a[36], b[36];
  const std::vector<TangentBlock> blocks = tangent_blocks(tree);
  const AllocationGuard guard;
  integrate_configuration(tree, q.data(), dq.data(), out.data());
  difference_configuration(tree, q.data(), out.data(), dq.data());
  for (const TangentBlock& block : blocks) {
    integrate_jacobians(block, dq.data() + block.first, a, b);
    difference_jacobians(block, dq.data() + block.first, a, b);
  }
  EXPECT_EQ(guard.count(), 0);
}

INSTANTIATE_TEST_SUITE_P(robots, Integration, ::testing::ValuesIn(test_robots()), robot_label);

TEST(ConfigurationDifference, HalfATurn_IsFiniteAndOfLengthPi) {
  const Model model = TestRobot{"every_joint", Base::FreeFlyer, "tip"}.model();
  const Tree tree(model);
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::VectorXd q0 = model.q_neutral;
    const Eigen::VectorXd turn = std::numbers::pi * Eigen::VectorXd::Unit(model.nv, 3 + axis);
    Eigen::VectorXd q1(model.nq), dq(model.nv);
    integrate_configuration(tree, q0.data(), turn.data(), q1.data());
    difference_configuration(tree, q0.data(), q1.data(), dq.data());
    EXPECT_NEAR(std::abs(dq[3 + axis]), std::numbers::pi, 1e-12);
    EXPECT_NEAR(dq.norm(), std::numbers::pi, 1e-12);
  }
}

TEST(IntegrationJacobians, ZeroIncrement_GivesExactIdentities) {
  const Model model = TestRobot{"every_joint", Base::FreeFlyer, "tip"}.model();
  for (const TangentBlock& block : tangent_blocks(Tree(model))) {
    const double zero[6] = {};
    double by[4][36];
    integrate_jacobians(block, zero, by[0], by[1]);
    difference_jacobians(block, zero, by[2], by[3]);
    for (int i = 0; i < block.size; ++i)
      for (int j = 0; j < block.size; ++j) {
        const double unit = i == j ? 1.0 : 0.0;
        const int at = i * block.size + j;
        EXPECT_EQ(by[0][at], unit);
        EXPECT_EQ(by[1][at], unit);
        EXPECT_EQ(by[2][at], -unit);
        EXPECT_EQ(by[3][at], unit);
      }
  }
}

}  // namespace
}  // namespace burnish::test
