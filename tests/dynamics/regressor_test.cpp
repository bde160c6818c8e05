// The regressor times the inertial parameters of all bodies equals inverse dynamics without
// armature, in value and derivatives.
#include "dynamics/regressor.tpp"

#include "burnish/model/inertia.hpp"
#include "derivatives/inverse_dynamics.tpp"
#include "dynamics/kinematics.tpp"
#include "dynamics/mass_matrix.tpp"
#include "support/kernel_law.hpp"

namespace burnish::test {
namespace {

/// Torques Y theta (nv entries); inverse dynamics supplies their derivatives.
struct RegressorKernel {
  template <class S>
  std::vector<S> values(const S* q, const S* v, const S* a) const {
    Kinematics<S> kinematics(tree);
    InverseDynamics<S> id(tree);
    update_kinematics(tree, q, v, kinematics);
    accelerate(tree, kinematics, a, id);
    const int stride = 10 * tree.bodies();
    std::vector<S> Y(static_cast<std::size_t>(tree.nv * stride), S(0.0));
    for (int body = 0; body < tree.bodies(); ++body)
      body_regressor(tree, kinematics, id, body, Y.data() + 10 * body, stride);
    std::vector<S> tau(static_cast<std::size_t>(tree.nv), S(0.0));
    for (int k = 0; k < tree.nv; ++k)
      for (int p = 0; p < stride; ++p)
        tau[k] += Y[static_cast<std::size_t>(k * stride + p)] * S(theta[p]);
    return tau;
  }
  template <class S>
  Blocks<S> derivatives(const S* q, const S* v, const S* a) const {
    Kinematics<S> kinematics(tree);
    InverseDynamics<S> id(tree);
    MassMatrix<S> mass(tree);
    update_kinematics(tree, q, v, kinematics);
    update_mass_and_bias(tree, kinematics, mass);
    accelerate(tree, kinematics, a, id);
    const std::vector<S> zeros(static_cast<std::size_t>(tree.nv * tree.nv), S(0.0));
    Blocks<S> out{zeros, zeros};
    inverse_dynamics_derivatives(tree, kinematics, mass, id, out.dq.data(), out.dv.data());
    return out;
  }
  const Tree& tree;
  Eigen::VectorXd theta;
};

class Regressor : public OnRobots {
 protected:
  Eigen::VectorXd parameters() const {
    Eigen::VectorXd theta(10 * tree.bodies());
    for (int body = 0; body < tree.bodies(); ++body)
      theta.segment<10>(10 * body) = inertia_parameters(inertia_of_body(model, body));
    return theta;
  }
  Tree tree{model};
};

TEST_P(Regressor, TimesParameters_EqualsInverseDynamics) {
  const RegressorKernel kernel{tree, parameters()};
  std::mt19937_64 generator(61);
  for (int i = 0; i < 20; ++i) {
    const KernelState s = random_kernel_state(model, generator);
    Kinematics<double> kinematics(tree);
    MassMatrix<double> mass(tree);
    InverseDynamics<double> id(tree);
    update_kinematics(tree, s.q.data(), s.v.data(), kinematics);
    update_mass_and_bias(tree, kinematics, mass);
    accelerate(tree, kinematics, s.a.data(), id);
    inverse_dynamics_sweep(tree, kinematics, mass, s.a.data(), id);
    Eigen::VectorXd wanted = as_vector(id.tau);
    for (int k = 0; k < tree.axes; ++k)
      wanted[tree.v_of_axis[k]] -= tree.armature[k] * s.a[tree.v_of_axis[k]];
    EXPECT_LE(relative_error(as_vector(kernel.values<double>(s.q.data(), s.v.data(), s.a.data())),
                             wanted),
              1e-12);
  }
}

TEST_P(Regressor, Derivatives_EqualInverseDynamicsDerivatives) {
  expect_kernel_law(model, RegressorKernel{tree, parameters()}, 3);
  expect_lanes_alike(model, RegressorKernel{tree, parameters()});
}

INSTANTIATE_TEST_SUITE_P(Robots, Regressor, ::testing::ValuesIn(test_robots()), robot_label);

}  // namespace
}  // namespace burnish::test
