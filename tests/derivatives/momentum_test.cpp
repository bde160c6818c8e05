// Tests of centre of mass, momentum and energy, and of their derivatives.
#include "derivatives/momentum.tpp"

#include "burnish/base/views.hpp"
#include "dynamics/inverse_dynamics.tpp"
#include "dynamics/kinematics.tpp"
#include "dynamics/mass_matrix.tpp"
#include "support/kernel_law.hpp"

namespace burnish::test {
namespace {

/// Centre of mass (3), its velocity (3), momentum about the origin (6) and about the centre of mass
/// (6), kinetic (1) and potential energy (1).
struct MomentumKernel {
  template <class S>
  std::vector<S> values(const S* q, const S* v, const S* /*a*/) const {
    Kinematics<S> kinematics(tree);
    Momentum<S> m(tree);
    update_kinematics(tree, q, v, kinematics);
    update_momentum(tree, kinematics, v, m);
    std::vector<S> out;
    for (const Vec3<S>& x : {m.com, m.com_velocity, m.total.linear, m.total.angular,
                             m.centroidal.linear, m.centroidal.angular})
      out.insert(out.end(), {x.x, x.y, x.z});
    out.insert(out.end(), {m.kinetic, m.potential});
    return out;
  }

  template <class S>
  Blocks<S> derivatives(const S* q, const S* v, const S* /*a*/) const {
    Kinematics<S> kinematics(tree);
    Momentum<S> m(tree);
    MomentumDerivatives<S> d(tree);
    update_kinematics(tree, q, v, kinematics);
    update_momentum(tree, kinematics, v, m);
    momentum_derivatives(tree, kinematics, m, v, d);
    std::vector<S> none(d.com_dq.size(), S(0.0));
    std::vector<S> no_row(d.kinetic_dq.size(), S(0.0));
    Blocks<S> out;
    for (const auto* rows : {&d.com_dq, &d.com_velocity_dq, &d.total_dq, &d.centroidal_dq,
                             &d.kinetic_dq, &d.potential_dq})
      out.dq.insert(out.dq.end(), rows->begin(), rows->end());
    for (const auto* rows :
         {&none, &d.com_dq, &d.total_dv, &d.centroidal_dv, &d.kinetic_dv, &no_row})
      out.dv.insert(out.dv.end(), rows->begin(), rows->end());
    return out;
  }
  const Tree& tree;
};

class RobotMomentum : public OnRobots {
 protected:
  Tree tree{model};
};

TEST_P(RobotMomentum, Derivatives_EqualAutodiffAndDifferences) {
  expect_kernel_law(model, MomentumKernel{tree});
  expect_lanes_alike(model, MomentumKernel{tree});
}

/// Robots with a floating base, where tau contains the wrench on the base.
class FloatingRobotMomentum : public RobotMomentum {};

/// All quantities at one state.
struct Evaluation {
  Evaluation(const Tree& t, const KernelState& s)
      : kinematics(t), mass(t), id(t), momentum(t), derivatives(t) {
    update_kinematics(t, s.q.data(), s.v.data(), kinematics);
    update_mass_and_bias(t, kinematics, mass);
    update_momentum(t, kinematics, s.v.data(), momentum);
    momentum_derivatives(t, kinematics, momentum, s.v.data(), derivatives);
    accelerate(t, kinematics, s.a.data(), id);
    inverse_dynamics_sweep(t, kinematics, mass, s.a.data(), id);
  }
  Kinematics<double> kinematics;
  MassMatrix<double> mass;
  InverseDynamics<double> id;
  Momentum<double> momentum;
  MomentumDerivatives<double> derivatives;
};

TEST_P(RobotMomentum, ComJacobian_IsLinearMomentumOverMass) {
  std::mt19937_64 generator(8);
  const Evaluation run(tree, random_kernel_state(model, generator));
  const Eigen::MatrixXd com = as_matrix(run.derivatives.com_dq, model.nv);
  const Eigen::MatrixXd linear = as_matrix(run.derivatives.total_dv, model.nv).topRows(3);
  EXPECT_NEAR(run.momentum.mass, model.total_mass(), 1e-12 * model.total_mass());
  EXPECT_LE(relative_error(com * model.total_mass(), linear), 1e-13);
}

TEST_P(RobotMomentum, KineticEnergy_EqualsTheFormWithTheMassMatrix) {
  std::mt19937_64 generator(9);
  const KernelState s = random_kernel_state(model, generator);
  const Evaluation run(tree, s);
  Eigen::MatrixXd M = as_matrix(run.mass.mass, model.nv);
  M = Eigen::MatrixXd(M.selfadjointView<Eigen::Lower>());
  EXPECT_NEAR(run.momentum.kinetic, 0.5 * s.v.dot(M * s.v),
              1e-12 * std::max(1.0, run.momentum.kinetic));
  EXPECT_LE(relative_error(as_vector(run.derivatives.kinetic_dv), M * s.v), 1e-12);
}

TEST_P(RobotMomentum, EnergyRate_EqualsThePowerOfTheTorques) {
  // dE/dt = tau . v along any acceleration.
  std::mt19937_64 generator(10);
  for (int i = 0; i < 10; ++i) {
    const KernelState s = random_kernel_state(model, generator);
    const Evaluation run(tree, s);
    const Eigen::VectorXd by_q =
        as_vector(run.derivatives.kinetic_dq) + as_vector(run.derivatives.potential_dq);
    const double rate = by_q.dot(s.v) + as_vector(run.derivatives.kinetic_dv).dot(s.a);
    const double power = as_vector(run.id.tau).dot(s.v);
    EXPECT_NEAR(rate, power, 1e-11 * std::max(1.0, std::abs(power)));
  }
}

TEST_P(RobotMomentum, GravityTorque_IsTheBiasAtRest) {
  std::mt19937_64 generator(11);
  KernelState s = random_kernel_state(model, generator);
  s.v.setZero();
  const Evaluation run(tree, s);
  std::vector<double> torque(static_cast<std::size_t>(model.nv), 0.0);
  gravity_torque(tree, run.kinematics, run.momentum, torque.data());
  EXPECT_LE(relative_error(as_vector(torque), as_vector(run.mass.bias)), 1e-12);
  EXPECT_EQ(torque, run.derivatives.potential_dq);
}

TEST_P(FloatingRobotMomentum, MomentumRate_EqualsGravityPlusTheBaseWrench) {
  // tau of the free-flyer is the wrench on the base in its axes: S_k . w = tau_k for its six axes.
  std::mt19937_64 generator(12);
  for (int i = 0; i < 10; ++i) {
    const KernelState s = random_kernel_state(model, generator);
    const Evaluation run(tree, s);
    const Eigen::VectorXd rate = as_matrix(run.derivatives.total_dq, model.nv) * s.v +
                                 as_matrix(run.derivatives.total_dv, model.nv) * s.a;
    const BodyState<double>& base = run.kinematics.bodies[0];
    const Eigen::Matrix3d R = to_eigen(base.R);
    const Eigen::VectorXd tau = as_vector(run.id.tau);
    const Eigen::Vector3d force = R * tau.segment<3>(0);
    const Eigen::Vector3d moment =
        R * tau.segment<3>(3) + Eigen::Vector3d(to_eigen(base.p)).cross(force);
    const Eigen::Vector3d weight = model.total_mass() * model.gravity;
    Vector6 wanted;
    wanted << force + weight, moment + Eigen::Vector3d(to_eigen(run.momentum.com)).cross(weight);
    EXPECT_LE(relative_error(rate, wanted), 1e-11);
  }
}

TEST_P(RobotMomentum, CentroidalMomentumRate_EqualsMomentsAboutTheCom) {
  // Gravity has no moment about the centre of mass, so only the moment of the total force differs.
  std::mt19937_64 generator(13);
  const KernelState s = random_kernel_state(model, generator);
  const Evaluation run(tree, s);
  const Eigen::VectorXd total = as_matrix(run.derivatives.total_dq, model.nv) * s.v +
                                as_matrix(run.derivatives.total_dv, model.nv) * s.a;
  const Eigen::VectorXd centroidal = as_matrix(run.derivatives.centroidal_dq, model.nv) * s.v +
                                     as_matrix(run.derivatives.centroidal_dv, model.nv) * s.a;
  const Eigen::Vector3d com = to_eigen(run.momentum.com);
  const Eigen::Vector3d force = total.head<3>();
  Vector6 wanted;
  const Eigen::Vector3d moment = total.tail<3>();
  wanted << force, moment - com.cross(force);
  EXPECT_LE(relative_error(centroidal, wanted), 1e-11);
}

INSTANTIATE_TEST_SUITE_P(robots, RobotMomentum, ::testing::ValuesIn(test_robots()), robot_label);
INSTANTIATE_TEST_SUITE_P(robots, FloatingRobotMomentum, ::testing::ValuesIn(floating_robots()),
                         robot_label);

}  // namespace
}  // namespace burnish::test
