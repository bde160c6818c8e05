// Tests of the integration of a step: orders of convergence, derivatives on fixed and floating
// bases, the torque filter, impacts, force states.
#include <gtest/gtest.h>

#include "base/decomposition.hpp"
#include "derivatives/check_differences.hpp"
#include "support/ocp_autodiff.hpp"
#include "support/ocp_cases.hpp"

namespace burnish::test {
namespace {

/// Returns a problem of one stage with a dummy cost.
ProblemSpec one_stage(ProblemSpec spec, Stage stage) {
  stage.name = "go";
  stage.costs = {{.residual = residual::JointVelocity{}}};
  spec.stages = {stage};
  spec.horizon = {{"go", 1}};
  return spec;
}

/// Returns the state of arm7 after 0.2 s of free motion under a constant torque, in n steps.
Eigen::VectorXd free_motion(Integrator integrator, int n, bool torque_model,
                            Base base = Base::Fixed) {
  const OcpCase test{{"arm7", base, "tool"}, torque_model};
  const Model model = test.robot.model();
  ProblemSpec spec = bare_problem(test, model);
  spec.actuation.passive_torques = false;
  Problem problem(one_stage(spec, {.step = 0.2 / n, .integrator = integrator}));
  std::mt19937_64 generator(3);
  const Eigen::VectorXd u = uniform(problem.layout().nu, 3.0, generator);
  Eigen::VectorXd x = spec.initial_state, next = x;
  for (int k = 0; k < n; ++k) {
    EXPECT_EQ(problem.roll(0, 0, x.data(), u.data(), next.data()).status, Status::Ok);
    x = next;
  }
  return x;
}

class IntegrationOrder : public ::testing::TestWithParam<bool> {};

TEST_P(IntegrationOrder, EulerError_HalvesWithTheStep) {
  const Eigen::VectorXd exact = free_motion(Integrator::RungeKutta4, 800, GetParam());
  const double coarse =
      (free_motion(Integrator::SemiImplicitEuler, 200, GetParam()) - exact).norm();
  const double fine = (free_motion(Integrator::SemiImplicitEuler, 400, GetParam()) - exact).norm();
  EXPECT_GT(coarse, 1e-6);
  EXPECT_NEAR(coarse / fine, 2.0, 0.2);
}

TEST_P(IntegrationOrder, RungeKuttaError_FallsSixteenfold) {
  const Eigen::VectorXd exact = free_motion(Integrator::RungeKutta4, 1600, GetParam());
  const double coarse = (free_motion(Integrator::RungeKutta4, 50, GetParam()) - exact).norm();
  const double fine = (free_motion(Integrator::RungeKutta4, 100, GetParam()) - exact).norm();
  EXPECT_GT(fine, 1e-12);
  EXPECT_NEAR(coarse / fine, 16.0, 3.0);
}

TEST(FloatingBaseOrder, RungeKuttaError_FallsSixteenfold) {
  const auto at = [](int n) {
    return free_motion(Integrator::RungeKutta4, n, false, Base::FreeFlyer);
  };
  const Eigen::VectorXd exact = at(1600);
  const double coarse = (at(50) - exact).norm(), fine = (at(100) - exact).norm();
  EXPECT_GT(fine, 1e-12);
  EXPECT_NEAR(coarse / fine, 16.0, 3.0);
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutFilter, IntegrationOrder, ::testing::Bool());

class StepDerivatives : public ::testing::TestWithParam<OcpCase> {
 protected:
  /// Returns the derivative F of knot 0, ndx x nz, from the result of expand().
  Eigen::MatrixXd expanded(Problem& problem, OcpHorizon& horizon) {
    horizon.expand(problem);
    const StateShape& shape = problem.state();
    const int nv = shape.nv, nu = problem.controls(0), nz = nu + shape.ndx;
    const RowMatrix given = horizon.dynamics[0].leftCols(nz);
    if (horizon.out[0].form == DynamicsForm::Dense) return given.topRows(shape.ndx);
    const double step = horizon.out[0].step;
    Eigen::MatrixXd A = Eigen::MatrixXd::Identity(nv, nv), B = A;
    const double* lead = horizon.tangent_blocks[0].data();
    for (const NonEuclideanBlock& block : shape.blocks) {
      const int n = block.size;
      A.block(block.first, block.first, n, n) = Eigen::Map<const RowMatrix>(lead, n, n);
      B.block(block.first, block.first, n, n) = Eigen::Map<const RowMatrix>(lead + n * n, n, n);
      lead += 2 * n * n;
    }
    Eigen::MatrixXd F = Eigen::MatrixXd::Zero(shape.ndx, nz);
    F.middleRows(nv, nv) = given.topRows(nv);
    F.topRows(nv) = step * B * given.topRows(nv);
    F.block(0, nu, nv, nv) += A;
    for (int i = 0; i < shape.filtered; ++i) {
      if (nu > 0) F(2 * nv + i, i) = 1.0 - horizon.decay[0][i];
      F(2 * nv + i, nu + 2 * nv + i) = horizon.decay[0][i];
    }
    return F;
  }

  Eigen::MatrixXd by_differences(Problem& problem, const Eigen::VectorXd& x,
                                 const Eigen::VectorXd& u) {
    const int nu = problem.controls(0), ndx = problem.state().ndx;
    Eigen::VectorXd nominal(x.size());
    problem.roll(0, 0, x.data(), u.data(), nominal.data());
    return extrapolated_differences(
        [&](int k, double h) {
          Eigen::VectorXd at_x = x, at_u = u, next(x.size()), dx(ndx);
          if (k < nu) {
            at_u[k] += h;
          } else {
            dx = h * Eigen::VectorXd::Unit(ndx, k - nu);
            problem.integrate(x.data(), dx.data(), at_x.data());
          }
          problem.roll(0, 0, at_x.data(), at_u.data(), next.data());
          problem.difference(nominal.data(), next.data(), dx.data());
          return dx;
        },
        nu + ndx, ndx);
  }

  void expect_exact_derivatives(const Stage& stage, bool by_autodiff, double own_step = 0.0) {
    Problem problem(one_stage(bare_problem(GetParam(), model), stage));
    if (own_step > 0.0) problem.set_step(0, own_step);
    const ocp::CompiledProblem& compiled = ocp::ProblemInside::of(problem).compiled;
    for (int i = 0; i < 2; ++i) {
      OcpHorizon horizon(problem, generator);
      const Eigen::MatrixXd F = expanded(problem, horizon);
      ASSERT_EQ(horizon.values[0].status, Status::Ok);
      const Eigen::VectorXd x = horizon.x_of(problem, 0), u = horizon.u_of(problem, 0);
      EXPECT_LT(relative_error(F, by_differences(problem, x, u)), 1e-7) << "differences";
      if (!by_autodiff) continue;
      const std::vector<double> targets = targets_of(compiled, 0, problem.time_of(0));
      EXPECT_LT(relative_error(F, step_by_autodiff(compiled, {0, x, u, targets, own_step})), 1e-9)
          << "automatic differentiation";
    }
  }

  Model model = GetParam().robot.model();
  std::mt19937_64 generator{21};
};

TEST_P(StepDerivatives, Euler_HasExactDerivatives) {
  expect_exact_derivatives({.contacts = {"brace", "pad"}, .step = 0.02}, true);
}

TEST_P(StepDerivatives, RungeKutta_HasExactDerivatives) {
  expect_exact_derivatives(
      {.contacts = {"brace", "pad"}, .step = 0.02, .integrator = Integrator::RungeKutta4}, true);
}

TEST_P(StepDerivatives, FreeMotion_HasExactDerivatives) {
  expect_exact_derivatives({.step = 0.05}, true);
  expect_exact_derivatives({.step = 0.05, .integrator = Integrator::RungeKutta4}, true);
}

TEST_P(StepDerivatives, KnotWithItsOwnStep_HasExactDerivatives) {
  for (const Integrator integrator : {Integrator::SemiImplicitEuler, Integrator::RungeKutta4})
    expect_exact_derivatives({.contacts = {"brace", "pad"}, .step = 0.02, .integrator = integrator},
                             true, 0.05);
}

TEST_P(StepDerivatives, Impact_HasExactDerivatives) {
  expect_exact_derivatives({.contacts = {"brace", "pad"}, .impact = true}, false);
  expect_exact_derivatives(
      {.contacts = {"pad"}, .integrator = Integrator::RungeKutta4, .impact = true}, false);
}

TEST_P(StepDerivatives, Impact_ChangesOnlyVelocitiesByContactImpulses) {
  ProblemSpec spec =
      one_stage(bare_problem(GetParam(), model), {.contacts = {"brace", "pad"}, .impact = true});
  Problem problem(spec);
  EXPECT_EQ(problem.controls(0), 0);
  EXPECT_EQ(problem.step_of(0), 0.0);
  EXPECT_EQ(problem.time_of(1), problem.time_of(0));
  const OcpState at = random_ocp_state(problem, generator);
  Eigen::VectorXd next(at.x.size());
  ASSERT_EQ(problem.roll(0, 0, at.x.data(), at.u.data(), next.data()).status, Status::Ok);
  const StateLayout& l = problem.layout();
  EXPECT_EQ(next.head(l.nq), at.x.head(l.nq));
  EXPECT_EQ(next.tail(l.nx() - l.nq - l.nv), at.x.tail(l.nx() - l.nq - l.nv));
  const Eigen::VectorXd before = at.x.segment(l.nq, l.nv), after = next.segment(l.nq, l.nv);
  ContactDynamics dynamics(model, contacts_at(spec.contacts, spec.start_time));
  dynamics.set_active(0, false);
  dynamics.acceleration(at.x.head(l.nq), after, after);
  const Eigen::MatrixXd J = dynamics.jacobian();
  // M (v+ - v-) = J^T Lambda with J v+ = mu Lambda.
  const Eigen::VectorXd momentum = dynamics.mass_matrix() * (after - before);
  const Eigen::VectorXd impulse = least_squares(J.transpose(), momentum);
  EXPECT_LT(relative_error(J.transpose() * impulse, momentum, 1e-3), 1e-6);
  if (spec.contact_solver.mu == 0.0) {
    EXPECT_LT((J * after).cwiseAbs().maxCoeff(), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, StepDerivatives, ::testing::ValuesIn(ocp_cases()),
                         [](const auto& test) { return test.param.label(); });

TEST(TorqueFilter, DiscretizationExactOrEuler_HasItsDecay) {
  const OcpCase test{{"arm7", Base::Fixed, "tool"}, true};
  const Model model = test.robot.model();
  const double cutoff = 30.0, step = 0.01;
  ProblemSpec spec = bare_problem(test, model);
  for (const Integrator integrator : {Integrator::SemiImplicitEuler, Integrator::RungeKutta4})
    for (const auto discretization :
         {TorqueModel::Discretization::Exact, TorqueModel::Discretization::Euler}) {
      spec.torque_model = TorqueModel{cutoff, discretization};
      Problem problem(one_stage(spec, {.step = step, .integrator = integrator}));
      std::mt19937_64 generator(4);
      const OcpState at = random_ocp_state(problem, generator);
      Eigen::VectorXd next(at.x.size());
      problem.roll(0, 0, at.x.data(), at.u.data(), next.data());
      const double decay = discretization == TorqueModel::Discretization::Exact
                               ? std::exp(-cutoff * step)
                               : 1.0 - cutoff * step;
      const Eigen::VectorXd wanted = decay * at.x.tail(7) + (1.0 - decay) * at.u;
      EXPECT_LT((next.tail(7) - wanted).norm(), 1e-13);
    }
}

TEST(TorqueFilter, Acceleration_DependsOnTorquesNotOnControls) {
  const OcpCase test{{"arm7", Base::Fixed, "tool"}, true};
  const Model model = test.robot.model();
  Problem problem(one_stage(bare_problem(test, model), {}));
  std::mt19937_64 generator(5);
  const OcpState at = random_ocp_state(problem, generator);
  const Eigen::VectorXd a = problem.acceleration(0, at.x, at.u);
  EXPECT_EQ(problem.acceleration(0, at.x, 2.0 * at.u), a);
  Eigen::VectorXd changed = at.x;
  changed[changed.size() - 1] += 1.0;
  EXPECT_GT((problem.acceleration(0, changed, at.u) - a).norm(), 1e-3);
}

TEST(TorqueStates, PreviousControl_IsStoredWithoutDelayingTorques) {
  const OcpCase test{{"arm7", Base::Fixed, "tool"}, true, true};
  const OcpCase plain_case{{"arm7", Base::Fixed, "tool"}};
  const Model model = test.robot.model();
  for (const Integrator integrator : {Integrator::SemiImplicitEuler, Integrator::RungeKutta4}) {
    Problem held(one_stage(bare_problem(test, model), {.integrator = integrator}));
    Problem plain(one_stage(bare_problem(plain_case, model), {.integrator = integrator}));
    std::mt19937_64 generator(6);
    const OcpState at = random_ocp_state(held, generator);
    const Eigen::VectorXd without = at.x.head(14);
    Eigen::VectorXd next(21), wanted(14);
    held.roll(0, 0, at.x.data(), at.u.data(), next.data());
    plain.roll(0, 0, without.data(), at.u.data(), wanted.data());
    EXPECT_EQ(next.head(14), wanted);
    EXPECT_EQ(next.tail(7), at.u);
  }
}

TEST(ForceStates, Step_StoresItsForcesWithoutChangingTheMotion) {
  const OcpCase test{{"arm7", Base::Fixed, "tool"}, false, false, true};
  const OcpCase plain{{"arm7", Base::Fixed, "tool"}};
  const Model model = test.robot.model();
  for (const Integrator integrator : {Integrator::SemiImplicitEuler, Integrator::RungeKutta4}) {
    for (const bool braced : {true, false}) {
      const Stage stage{.contacts = {"pad"}, .integrator = integrator};
      ProblemSpec spec = one_stage(bare_problem(test, model), stage);
      ProblemSpec without = one_stage(bare_problem(plain, model), stage);
      if (!braced)
        spec.stages[0].contacts = without.stages[0].contacts = {"pad"};
      else
        spec.stages[0].contacts = without.stages[0].contacts = {"brace", "pad"};
      Problem problem(spec), bare(without);
      std::mt19937_64 generator(7);
      const OcpState at = random_ocp_state(problem, generator);
      const Eigen::VectorXd x = at.x.head(14), forces = bare.forces(0, x, at.u);
      Eigen::VectorXd next(21), wanted(14);
      problem.roll(0, 0, at.x.data(), at.u.data(), next.data());
      bare.roll(0, 0, x.data(), at.u.data(), wanted.data());
      EXPECT_EQ(next.head(14), wanted);
      // Force states are in the order of their contacts' names in the problem: pad, then brace.
      EXPECT_EQ(next.segment(14, 6), forces.tail(6));
      EXPECT_EQ(next[20], braced ? forces[0] : 0.0);
    }
  }
}

}  // namespace
}  // namespace burnish::test
