// Payloads that are set at run time. Results equal a model that contains the payload. Derivatives
// by its parameters equal differences and automatic differentiation.
#include <limits>

#include "burnish/derivatives/contact_dynamics_batch.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "dynamics/inverse_dynamics.tpp"
#include "dynamics/kinematics.tpp"
#include "support/allocation_guard.hpp"
#include "support/autodiff.hpp"
#include "support/contact_states.hpp"
#include "support/kernel_law.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

InertiaSpec brick() {
  InertiaSpec result;
  result.mass = 1.3;
  result.com = {0.02, -0.03, 0.08};
  result.inertia_at_com << 4e-3, 2e-4, -1e-4, 2e-4, 3e-3, 3e-4, -1e-4, 3e-4, 5e-3;
  return result;
}

class CarriedPayload : public OnRobots {
 protected:
  std::string tool = GetParam().tool;
  std::vector<ContactSpec> contacts() const {
    return {burnish::test::contact(tool, "world", Reference::centered(), Directions::parse("x,z"))};
  }
  int tool_body() const {
    return model.frames[static_cast<std::size_t>(model.frame_index(tool))].body;
  }
  std::mt19937_64 generator{17};
};

TEST_P(CarriedPayload, SetPayload_EqualsAPayloadInTheModel) {
  const Model loaded = with_payload(model, {tool, brick()});
  ContactDynamics loaded_later(model, contacts()), made(loaded, contacts()),
      bare(model, contacts());
  const RobotState s = regular_state(model, made, generator);
  ASSERT_EQ(loaded_later.set_payload(tool, brick()), Status::Ok);
  const auto expect_same = [&](ContactDynamics& a, ContactDynamics& b) {
    ASSERT_EQ(a.forward(s.q, s.v, s.tau), b.forward(s.q, s.v, s.tau));
    a.forward_derivatives(), b.forward_derivatives();
    EXPECT_LE(relative_error(a.a(), b.a()), 1e-13);
    EXPECT_LE(relative_error(a.lambda(), b.lambda()), 1e-13);
    EXPECT_LE(relative_error(a.da_dq(), b.da_dq()), 1e-13);
  };
  expect_same(loaded_later, made);
  // A new payload replaces the old one; an empty payload restores the bare robot.
  InertiaSpec heavier = brick();
  heavier.mass = 9.0;
  loaded_later.set_payload(tool, heavier);
  loaded_later.set_payload(tool, brick());
  expect_same(loaded_later, made);
  loaded_later.set_payload(tool, {});
  expect_same(loaded_later, bare);

  RigidBody body(model), body_made(loaded);
  ASSERT_EQ(body.set_payload(tool, brick()), Status::Ok);
  ASSERT_EQ(body.update(s.q, s.v), Status::Ok);
  ASSERT_EQ(body_made.update(s.q, s.v), Status::Ok);
  EXPECT_NEAR(body.mass(), body_made.mass(), 1e-12);
  EXPECT_LE(relative_error(body.gravity_torque(), body_made.gravity_torque()), 1e-13);
  EXPECT_LE(relative_error(body.momentum(), body_made.momentum()), 1e-13);

  ContactDynamicsBatch batch(model, contacts(), 1);
  ASSERT_EQ(batch.set_payload(tool, brick()), Status::Ok);
  ASSERT_EQ(batch.forward(s.q, s.v, s.tau), Status::Ok);
  made.forward(s.q, s.v, s.tau);
  EXPECT_LE(relative_error(batch.a(0), made.a()), 1e-9);
}

TEST_P(CarriedPayload, ParameterDerivatives_EqualDifferences) {
  ContactDynamics dynamics(model, contacts());
  ASSERT_EQ(dynamics.set_payload(tool, brick()), Status::Ok);
  const RobotState s = regular_state(model, dynamics, generator);
  const std::vector<int> bodies{tool_body()};
  InertiaDerivatives d;
  EXPECT_EQ(dynamics.inertia_derivatives(bodies, d), Status::NotEvaluated);
  ASSERT_EQ(dynamics.forward(s.q, s.v, s.tau), Status::Ok);
  EXPECT_EQ(dynamics.inertia_derivatives(bodies, d), Status::NotEvaluated);
  ASSERT_EQ(dynamics.forward_derivatives(), Status::Ok);
  ASSERT_EQ(dynamics.inertia_derivatives(bodies, d), Status::Ok);
  // Differences by the parameters of the body, in its own axes.
  const std::string joint = model.joints[static_cast<std::size_t>(tool_body())].name;
  ContactDynamics moved(model, contacts());
  const Eigen::Isometry3d placement =
      model.frames[static_cast<std::size_t>(model.frame_index(tool))].placement;
  const Vector10 theta = inertia_parameters(placed(brick(), placement));
  const auto at = [&](int k, double h) {
    Vector10 other = theta;
    other[k] += h;
    const InertiaSpec carried = placed(inertia_of(other), placement.inverse());
    EXPECT_EQ(moved.set_payload(tool, carried), Status::Ok);
    EXPECT_EQ(moved.forward(s.q, s.v, s.tau), Status::Ok);
    Eigen::VectorXd result(model.nv + moved.rows());
    result << moved.a(), moved.lambda();
    return result;
  };
  Eigen::MatrixXd wanted(model.nv + moved.rows(), 10), got(wanted.rows(), 10);
  for (int k = 0; k < 10; ++k) {
    const double h = k < 4 ? 1e-5 : 1e-6;
    wanted.col(k) = (at(k, h) - at(k, -h)) / (2.0 * h);
  }
  got << d.a, d.lambda;
  EXPECT_LE(relative_error(got, wanted), 1e-6);
}

/// Regressor of all bodies with the parameters as duals: the sum over bodies of
/// J_i^T (I_i a_i + v_i x* I_i v_i), by spatial algebra alone.
Eigen::MatrixXd regressor_by_duals(const Model& model, const RobotState& s,
                                   const Eigen::VectorXd& a) {
  const Tree tree(model);
  Kinematics<double> kinematics(tree);
  InverseDynamics<double> id(tree);
  update_kinematics(tree, s.q.data(), s.v.data(), kinematics);
  accelerate(tree, kinematics, a.data(), id);
  const auto lifted = [](const Motion<double>& m) {
    return Motion<Dual>{lift<Dual>(m.linear), lift<Dual>(m.angular)};
  };
  Eigen::MatrixXd Y = Eigen::MatrixXd::Zero(model.nv, 10 * tree.bodies());
  for (int body = 0; body < tree.bodies(); ++body) {
    const BodyState<double>& state = kinematics.bodies[body];
    const auto in_body = [&](const Motion<double>& m) {
      const Motion<double> there = at_point(m, state.p);
      return Motion<double>{transpose_times(state.R, there.linear),
                            transpose_times(state.R, there.angular)};
    };
    const Motion<Dual> v = lifted(in_body(state.v));
    const Motion<Dual> acceleration = lifted(in_body(state.a_bias + id.a_joint[body]));
    const Vector10 theta = inertia_parameters(inertia_of_body(model, body));
    for (int first = 0; first < 10; first += dual_directions) {
      std::array<Dual, 10> p;
      for (int i = 0; i < 10; ++i)
        p[i] =
            i >= first && i < first + dual_directions ? Dual(theta[i], i - first) : Dual(theta[i]);
      const Inertia<Dual> inertia{p[0], {p[1], p[2], p[3]}, {p[4], p[5], p[6], p[7], p[8], p[9]}};
      const Force<Dual> force = inertia * acceleration + cross(v, inertia * v);
      for (int k = tree.joints[body].axis + tree.joints[body].nv - 1; k >= 0;
           k = tree.parent_of_axis[k]) {
        const Dual torque = dot(lifted(in_body(kinematics.axes[k].axis)), force);
        for (int i = first; i < std::min(10, first + dual_directions); ++i)
          Y(tree.v_of_axis[k], 10 * body + i) += torque.derivative(i - first);
      }
    }
  }
  return Y;
}

TEST_P(CarriedPayload, ParameterDerivativesOfAllBodies_EqualADenseSystem) {
  ContactDynamics dynamics(model, contacts());
  const RobotState s = regular_state(model, dynamics, generator);
  ASSERT_EQ(dynamics.forward(s.q, s.v, s.tau), Status::Ok);
  ASSERT_EQ(dynamics.forward_derivatives(), Status::Ok);
  std::vector<int> bodies;
  for (std::size_t i = 0; i < model.joints.size(); ++i) bodies.push_back(static_cast<int>(i));
  InertiaDerivatives d;
  RowMatrix Y;
  ASSERT_EQ(dynamics.inertia_derivatives(bodies, d), Status::Ok);
  ASSERT_EQ(dynamics.regressor(bodies, Y), Status::Ok);
  const Eigen::MatrixXd wanted = regressor_by_duals(model, s, dynamics.a());
  EXPECT_LE(relative_error(Y, wanted), 1e-12);
  // M da - J^T dlambda = -Y, J da = 0.
  const Eigen::MatrixXd M = dynamics.mass_matrix(), J = dynamics.jacobian();
  const double scale = std::max(1.0, wanted.cwiseAbs().maxCoeff());
  EXPECT_LE((M * d.a - J.transpose() * d.lambda + wanted).cwiseAbs().maxCoeff() / scale, 1e-8);
  EXPECT_LE((J * d.a).cwiseAbs().maxCoeff() / std::max(1.0, d.a.cwiseAbs().maxCoeff()), 1e-8);
}

TEST_P(CarriedPayload, InvalidPayload_ChangesNothing) {
  ContactDynamics dynamics(model, contacts());
  const RobotState s = regular_state(model, dynamics, generator);
  dynamics.forward(s.q, s.v, s.tau);
  const Eigen::VectorXd before = dynamics.a();
  InertiaSpec bad = brick();
  bad.mass = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(dynamics.set_payload(tool, bad), Status::NotFinite);
  bad.mass = -1.0;
  EXPECT_EQ(dynamics.set_payload(tool, bad), Status::NotFinite);
  bad = brick();
  bad.inertia_at_com(2, 2) = 1.0;
  EXPECT_EQ(dynamics.set_payload(tool, bad), Status::NotPhysical);
  EXPECT_THROW((void)dynamics.set_payload(tool + "x", brick()), Error);
  dynamics.forward(s.q, s.v, s.tau);
  EXPECT_EQ(before, dynamics.a());
}

TEST_P(CarriedPayload, Evaluation_AllocatesNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  ContactDynamics dynamics(model, contacts());
  RigidBody body(model);
  ContactDynamicsBatch batch(model, contacts(), 2);
  const RobotState s = regular_state(model, dynamics, generator);
  const std::vector<int> bodies{tool_body()};
  InertiaDerivatives d;
  RowMatrix Y;
  dynamics.forward(s.q, s.v, s.tau);
  dynamics.forward_derivatives();
  dynamics.inertia_derivatives(bodies, d);
  dynamics.regressor(bodies, Y);
  InertiaSpec carried = brick();
  const AllocationGuard guard;
  for (int i = 0; i < 3; ++i) {
    carried.mass += 0.1;
    dynamics.set_payload(tool, carried);
    body.set_payload(tool, carried);
    batch.set_payload(tool, carried);
    dynamics.forward(s.q, s.v, s.tau);
    dynamics.forward_derivatives();
    dynamics.inertia_derivatives(bodies, d);
    dynamics.regressor(bodies, Y);
  }
  EXPECT_EQ(guard.count(), 0);
}

INSTANTIATE_TEST_SUITE_P(Robots, CarriedPayload, ::testing::ValuesIn(test_robots()), robot_label);

}  // namespace
}  // namespace burnish::test
