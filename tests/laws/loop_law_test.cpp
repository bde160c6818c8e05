// Dynamics with all loops of a robot, at postures that close them. Derivatives are compared with
// automatic differentiation of the same kernels, motion and forces with a KKT system.
#include <gtest/gtest.h>

#include <functional>

#include "burnish/contact/loops.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/model/state.hpp"
#include "contact/constrained_dynamics.hpp"
#include "support/autodiff.hpp"
#include "support/contact_laws.hpp"
#include "support/loop_trees.hpp"
#include "support/robots.hpp"

namespace burnish::test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct LoopRobot {
  std::string name;
  std::function<Model()> model;
};
void PrintTo(const LoopRobot& robot, std::ostream* out) { *out << robot.name; }

/// Two legs of a tripod; a weld or a hinge replaces the ball joint that closes the loop.
TreeSpec two_legs(const Directions& first) {
  TreeSpec tree = testing::tripod();
  tree.loops.pop_back();
  tree.loops[0].directions = first;
  return tree;
}

std::vector<LoopRobot> loop_robots() {
  std::vector<LoopRobot> robots{
      {"bars", [] { return build_model(testing::four_bar()); }},
      {"tripod", [] { return build_model(testing::tripod()); }},
      {"tripod_floating", [] { return compiled(testing::tripod(), Base::FreeFlyer); }},
      {"weld", [] { return build_model(two_legs(Directions::all())); }},
      {"hinge", [] { return build_model(two_legs(Directions::parse("x,y,z,rx,rz"))); }}};
  if (has_robot_files)
    for (const char* name : {"four_bar", "parallel_ankle", "gripper"})
      robots.push_back({name, [name] { return named_robot(name); }});
  return robots;
}

class LoopLaw : public ::testing::TestWithParam<LoopRobot> {
 protected:
  LoopLaw() : model(GetParam().model()) {}

  VectorXd closed() {
    for (int tries = 0; tries < 200; ++tries) {
      const VectorXd away = random_vector(model.nv, 0.5, generator);
      const LoopProjection on = project_onto_loops(model, integrate(model, model.q_neutral, away));
      if (on.status == Status::Ok) return on.q;
    }
    ADD_FAILURE() << "no posture closes the loops";
    return model.q_neutral;
  }

  Model model;
  std::mt19937_64 generator{20261};
};

double relative(const MatrixXd& got, const MatrixXd& want) {
  return (got - want).cwiseAbs().maxCoeff() / std::max(want.cwiseAbs().maxCoeff(), 1e-9);
}

MatrixXd stacked(const MatrixXd& a, const MatrixXd& lambda) {
  MatrixXd both(a.rows() + lambda.rows(), a.cols());
  both << a, lambda;
  return both;
}

TEST_P(LoopLaw, Derivatives_EqualAutomaticDifferentiation) {
  const std::vector<ContactSpec> loops = loop_contacts(model, {90.0, 19.0});
  ContactDynamics dynamics(model, loops);
  ConstrainedDynamics<Dual> dual(model, ContactSet(model, loops), {});
  int done = 0;
  for (int tries = 0; done < law_states() && tries < 200 * law_states(); ++tries) {
    const VectorXd q = closed(), v = random_vector(model.nv, 1.0, generator),
                   tau = random_vector(model.nv, 3.0, generator);
    if (dynamics.forward(q, v, tau) != Status::Ok) continue;
    const Eigen::JacobiSVD<MatrixXd> svd{MatrixXd(dynamics.jacobian())};
    if (svd.singularValues().tail<1>()[0] < 1e-2 * svd.singularValues()[0]) continue;
    ++done;
    ASSERT_EQ(dynamics.forward_derivatives(), Status::Ok);
    const Duals constant = constant_duals(tau);
    const ByState want = differentiate(model, q, v, [&](const Duals& at, const Duals& with) {
      dual.set_state(at.data(), with.data());
      dual.forward(constant.data());
      Duals both = dual.a;
      both.insert(both.end(), dual.lambda.begin(), dual.lambda.begin() + dual.rows());
      return both;
    });
    EXPECT_LT(relative(stacked(dynamics.da_dq(), dynamics.dlambda_dq()), want.dq), 1e-9);
    EXPECT_LT(relative(stacked(dynamics.da_dv(), dynamics.dlambda_dv()), want.dv), 1e-9);
  }
  EXPECT_EQ(done, law_states());
}

TEST_P(LoopLaw, MotionAndForces_SolveTheKktSystem) {
  ContactDynamics dynamics(model, loop_contacts(model));
  ContactDynamics free(model);
  for (int i = 0; i < law_states(); ++i) {
    const VectorXd q = closed(), tau = random_vector(model.nv, 3.0, generator);
    const VectorXd v =
        project_velocity_onto_loops(model, q, random_vector(model.nv, 1.0, generator));
    const int n = model.nv, m = dynamics.rows();
    ASSERT_EQ(free.forward(q, v, tau), Status::Ok);
    ASSERT_EQ(dynamics.acceleration(q, v, VectorXd::Zero(n)), Status::Ok);
    MatrixXd K = MatrixXd::Zero(n + m, n + m);
    K.topLeftCorner(n, n) = free.mass_matrix();
    K.topRightCorner(n, m) = -dynamics.jacobian().transpose();
    K.bottomLeftCorner(m, n) = dynamics.jacobian();
    VectorXd rhs(n + m);
    rhs << tau - free.bias(), -VectorXd(dynamics.alpha());
    const VectorXd want = K.partialPivLu().solve(rhs);
    ASSERT_EQ(dynamics.forward(q, v, tau), Status::Ok);
    EXPECT_LT(relative(stacked(dynamics.a(), dynamics.lambda()), want), 1e-9);
    EXPECT_LT((dynamics.jacobian() * v).cwiseAbs().maxCoeff(), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(robots, LoopLaw, ::testing::ValuesIn(loop_robots()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace burnish::test
