// The articulated-body factorization of the mass matrix: its factor equals the sparse one on every
// tree, and its solutions match the mass matrix.
#include "dynamics/articulated.tpp"

#include "base/decomposition.hpp"
#include "dynamics/kinematics.tpp"
#include "dynamics/mass_matrix.tpp"
#include "support/kernel_law.hpp"

namespace burnish::test {
namespace {

template <class S>
struct Factored {
  Factored(const Tree& tree, const std::vector<S>& q, const std::vector<S>& v)
      : kinematics(tree), mass(tree) {
    update_kinematics(tree, q.data(), v.data(), kinematics);
    update_mass_and_bias(tree, kinematics, mass);
    bad = any(factorize(tree, kinematics, mass));
  }
  Kinematics<S> kinematics;
  MassMatrix<S> mass;
  bool bad = true;
};

class ArticulatedFactor : public OnRobots {
 protected:
  ArticulatedFactor() {
    deep.deep = true;
    sparse.deep = false;
    for (int l = 0; l < native_lanes; ++l) {
      const KernelState s = random_kernel_state(model, generator);
      q.push_back(s.q);
      v.push_back(s.v);
    }
  }
  template <class S>
  Factored<S> factored(const Tree& tree) const {
    return {tree, packed<S>(q), packed<S>(v)};
  }
  Eigen::MatrixXd mass_matrix(int lane) const {
    const std::vector<double> entries = lane_values(factored<NativePack>(sparse).mass.mass, lane);
    return as_matrix(entries, model.nv).selfadjointView<Eigen::Lower>();
  }

  std::mt19937_64 generator{31};
  Tree deep{model}, sparse{model};
  std::vector<Eigen::VectorXd> q, v;
};

TEST_P(ArticulatedFactor, EveryTree_EqualsTheSparseFactor) {
  const Factored<NativePack> a = factored<NativePack>(deep), b = factored<NativePack>(sparse);
  EXPECT_FALSE(a.bad);
  for (int l = 0; l < native_lanes; ++l) {
    EXPECT_LE(relative_error(as_vector(lane_values(a.mass.inverse_diagonal, l)),
                             as_vector(lane_values(b.mass.inverse_diagonal, l))),
              1e-11);
    for (int i = 0; i < model.nv; ++i)
      for (int j = deep.parent_of_v[static_cast<std::size_t>(i)]; j >= 0;
           j = deep.parent_of_v[static_cast<std::size_t>(j)]) {
        const auto at = static_cast<std::size_t>(i * model.nv + j);
        const double wanted = b.mass.factor[at].lane(l);
        EXPECT_NEAR(a.mass.factor[at].lane(l), wanted, 1e-11 * std::max(1.0, std::abs(wanted)));
      }
  }
}

TEST_P(ArticulatedFactor, InverseAndSolutions_MatchTheMassMatrix) {
  const Factored<NativePack> run = factored<NativePack>(deep);
  const int n = model.nv, columns = n + 3;
  ArticulatedSolver<NativePack> solver(deep);
  const std::vector<NativePack> unwritten(static_cast<std::size_t>(n * columns), NativePack(7.0));
  std::vector<NativePack> inverse = unwritten, solved = unwritten;
  std::vector<Eigen::VectorXd> sides;
  for (int l = 0; l < native_lanes; ++l)
    sides.push_back(random_vector(n * columns, 1.0, generator));
  solver.invert(run.kinematics, run.mass, inverse.data());
  solver.solve_negative(run.kinematics, run.mass, packed<NativePack>(sides).data(), solved.data(),
                        columns - 1, columns);
  inverse.resize(static_cast<std::size_t>(n * n));
  for (int l = 0; l < native_lanes; ++l) {
    const Eigen::MatrixXd M = mass_matrix(l);
    const Eigen::MatrixXd wanted = solve_positive(M, Eigen::MatrixXd::Identity(n, n));
    EXPECT_LE(relative_error(as_matrix(lane_values(inverse, l), n), wanted), 1e-9);
    const auto& side = sides[static_cast<std::size_t>(l)];
    const Eigen::MatrixXd right =
        as_matrix({side.data(), side.data() + side.size()}, columns).leftCols(columns - 1);
    const Eigen::MatrixXd got = as_matrix(lane_values(solved, l), columns);
    EXPECT_LE(relative_error(got.leftCols(columns - 1), -solve_positive(M, right)), 1e-9);
    EXPECT_EQ(got.col(columns - 1), Eigen::VectorXd::Constant(n, 7.0))
        << "the last column must stay unwritten";
  }
}

TEST_P(ArticulatedFactor, MasslessBody_IsDetectedByBothFactorizations) {
  Tree massless = deep;
  TreeJoint& last = massless.joints.back();
  last.mass = 0.0;
  last.inertia = {};
  for (int k = last.v; k < last.v + last.nv; ++k)
    massless.armature[static_cast<std::size_t>(k)] = 0.0;
  EXPECT_TRUE(factored<NativePack>(massless).bad);
  massless.deep = false;
  EXPECT_TRUE(factored<NativePack>(massless).bad);
}

// Followers couple branches, which the articulated-body factorization does not support.
INSTANTIATE_TEST_SUITE_P(robots, ArticulatedFactor, ::testing::ValuesIn(robots_without_followers()),
                         robot_label);

TEST(DeepTree, Chain_IsDeepFrom22Joints) {
  for (const int joints : {1, 21, 22, 40}) {
    TreeSpec tree;
    tree.name = "chain";
    tree.links.push_back(testing::link("link_0"));
    for (int k = 1; k <= joints; ++k) {
      const std::string name = "link_" + std::to_string(k);
      tree.links.push_back(testing::link(name));
      tree.joints.push_back(
          testing::joint("to_" + name, JointType::Revolute, "link_" + std::to_string(k - 1), name));
    }
    EXPECT_EQ(Tree(build_model(tree)).deep, joints >= 22) << joints;
  }
}

TEST(DeepTree, TestRobots_AreShallowExceptTheDeepOne) {
  for (const TestRobot& robot : test_robots())
    EXPECT_EQ(Tree(robot.model()).deep, robot.name == "deep") << robot.label();
}

}  // namespace
}  // namespace burnish::test
