// The mass matrix, inverse dynamics and its derivatives, without contacts.
#include "derivatives/inverse_dynamics.tpp"

#include "base/decomposition.hpp"
#include "dynamics/inverse_dynamics.tpp"
#include "dynamics/kinematics.tpp"
#include "dynamics/mass_matrix.tpp"
#include "support/kernel_law.hpp"

namespace burnish::test {
namespace {

template <class S>
struct Evaluation {
  Evaluation(const Tree& t, const S* q, const S* v, const S* a) : kinematics(t), mass(t), id(t) {
    update_kinematics(t, q, v, kinematics);
    update_mass_and_bias(t, kinematics, mass);
    accelerate(t, kinematics, a, id);
  }
  Kinematics<S> kinematics;
  MassMatrix<S> mass;
  InverseDynamics<S> id;
};

struct InverseDynamicsKernel {
  template <class S>
  std::vector<S> values(const S* q, const S* v, const S* a) const {
    Evaluation<S> run(tree, q, v, a);
    inverse_dynamics_sweep(tree, run.kinematics, run.mass, a, run.id);
    return run.id.tau;
  }
  template <class S>
  Blocks<S> derivatives(const S* q, const S* v, const S* a) const {
    Evaluation<S> run(tree, q, v, a);
    const std::vector<S> zeros(run.mass.mass.size(), S(0.0));
    Blocks<S> out{zeros, zeros};
    inverse_dynamics_derivatives(tree, run.kinematics, run.mass, run.id, out.dq.data(),
                                 out.dv.data());
    return out;
  }
  const Tree& tree;
};

class FreeDynamics : public OnRobots {
 protected:
  Eigen::MatrixXd mass_matrix(const Eigen::VectorXd& q) const {
    const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.nv);
    const Evaluation<double> run(tree, q.data(), rest.data(), rest.data());
    return as_matrix(run.mass.mass, model.nv).selfadjointView<Eigen::Lower>();
  }
  Tree tree{model};
};

class FloatingDynamics : public FreeDynamics {};

TEST_P(FreeDynamics, InverseDynamicsDerivatives_EqualAutodiffAndDifferences) {
  expect_kernel_law(model, InverseDynamicsKernel{tree});
  expect_lanes_alike(model, InverseDynamicsKernel{tree});
}

TEST_P(FreeDynamics, Torque_EqualsMassTimesAccelerationPlusBias) {
  std::mt19937_64 generator(21);
  const KernelState s = random_kernel_state(model, generator);
  const Evaluation<double> run(tree, s.q.data(), s.v.data(), s.a.data());
  const auto tau = InverseDynamicsKernel{tree}.values(s.q.data(), s.v.data(), s.a.data());
  const Eigen::VectorXd wanted = mass_matrix(s.q) * s.a + as_vector(run.mass.bias);
  EXPECT_LE(relative_error(as_vector(tau), wanted), 1e-12);
}

TEST_P(FreeDynamics, MassMatrix_IsPositiveDefiniteAndMatchesItsFactor) {
  std::mt19937_64 generator(22);
  for (int i = 0; i < 10; ++i) {
    const KernelState s = random_kernel_state(model, generator);
    const Eigen::MatrixXd M = mass_matrix(s.q);
    EXPECT_GT(symmetric_eigen(M).values[0], 0.0);
    Evaluation<double> run(tree, s.q.data(), s.v.data(), s.a.data());
    EXPECT_FALSE(factorize(tree, run.kinematics, run.mass));
    Eigen::MatrixXd L = Eigen::MatrixXd::Zero(model.nv, model.nv);
    for (int r = 0; r < model.nv; ++r) {
      L(r, r) = 1.0 / run.mass.inverse_diagonal[static_cast<std::size_t>(r)];
      for (int c = tree.parent_of_v[static_cast<std::size_t>(r)]; c >= 0;
           c = tree.parent_of_v[static_cast<std::size_t>(c)])
        L(r, c) = run.mass.factor[static_cast<std::size_t>(r * model.nv + c)];
    }
    EXPECT_LE(relative_error(L.transpose() * L, M), 1e-13);
  }
}

TEST_P(FreeDynamics, ForwardDynamics_UndoesInverseDynamics) {
  std::mt19937_64 generator(23);
  const KernelState s = random_kernel_state(model, generator);
  const auto tau = InverseDynamicsKernel{tree}.values(s.q.data(), s.v.data(), s.a.data());
  Evaluation<double> run(tree, s.q.data(), s.v.data(), s.a.data());
  ASSERT_FALSE(factorize(tree, run.kinematics, run.mass));
  Eigen::VectorXd x = as_vector(tau) - as_vector(run.mass.bias);
  solve_transposed(tree, run.mass, x.data());
  solve_factor(tree, run.mass, x.data());
  EXPECT_LE(relative_error(x, s.a), 1e-9);
}

TEST_P(FloatingDynamics, MovedBase_LeavesTheMassMatrixUnchanged) {
  std::mt19937_64 generator(24);
  const KernelState s = random_kernel_state(model, generator);
  Eigen::VectorXd moved = s.q;
  moved.head(7) = random_configuration(model, generator).head(7);
  EXPECT_LE(relative_error(mass_matrix(moved), mass_matrix(s.q)), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(robots, FreeDynamics, ::testing::ValuesIn(test_robots()), robot_label);
INSTANTIATE_TEST_SUITE_P(robots, FloatingDynamics, ::testing::ValuesIn(floating_robots()),
                         robot_label);

}  // namespace
}  // namespace burnish::test
