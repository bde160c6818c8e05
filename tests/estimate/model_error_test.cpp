// Tests of the torque error observer: its speed, the errors it estimates, and the torques it must
// not mistake for errors.
#include "burnish/estimate/model_error.hpp"

#include <gtest/gtest.h>

#include <random>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/sim/disturbances.hpp"
#include "dynamics/integration.hpp"
#include "support/allocation_guard.hpp"
#include "support/pressing_arm.hpp"
#include "support/refusal.hpp"
#include "support/robots.hpp"

namespace burnish {
namespace {

using testing::expect_words;
using testing::refusal;

/// Robot held in a posture by springs and simulated with the model `truth`, with the observer of
/// `model`.
struct HeldRobot {
  HeldRobot(const Model& model, const Model& truth, const ModelErrorOptions& options)
      : observer(model, "tool", options), plant(truth), body(truth), tree(truth) {
    q0 = q = test::pressing_arm().posture;
    v = v_measured = tau = encoder_step = Eigen::VectorXd::Zero(model.nv);
    (void)body.update(q0, v);
    holding = body.gravity_torque();
  }

  /// One step of dt [s], with an additional joint torque and a force on the tool.
  void step(double dt, const Eigen::VectorXd& torque, const Eigen::Vector3d& force,
            const Eigen::Vector3d& force_known) {
    tau = holding - spring_scale * (200.0 * (q - q0) + 20.0 * v);
    (void)body.update(q, v);
    body.frame_derivatives(body.frame("tool"), Reference::centered(), tool);
    const Eigen::VectorXd total = tau + torque + tool.jacobian.topRows(3).transpose() * force;
    ASSERT_EQ(plant.forward(q, v, total), Status::Ok);
    v += dt * plant.a();
    const Eigen::VectorXd dq = dt * v;
    integrate_configuration(tree, q.data(), dq.data(), q.data());
    if (velocity_lag > 0.0)
      v_measured += -std::expm1(-dt / velocity_lag) * (v - v_measured);
    else
      v_measured = v;
    for (Eigen::Index k = 0; k < v.size(); ++k) {
      const double step = encoder_noise * drawn(random);
      v_measured[k] += (step - encoder_step[k]) / dt;
      encoder_step[k] = step;
    }
    status = observer.update(q, v_measured, tau, force_known, dt);
  }
  void run(double duration, double dt, const Eigen::VectorXd& torque,
           const Eigen::Vector3d& force = Eigen::Vector3d::Zero(),
           const Eigen::Vector3d& force_known = Eigen::Vector3d::Zero()) {
    for (int i = 0; i < std::lround(duration / dt); ++i) {
      step(dt, torque, force, force_known);
      ASSERT_EQ(status, Status::Ok);
    }
  }

  /// Scale of the springs: the wrist of arm7 is so light that Talos's springs would be unstable.
  static constexpr double spring_scale = test::has_robot_files ? 1.0 : 0.1;
  TorqueErrorObserver observer;
  ContactDynamics plant;
  RigidBody body;
  Tree tree;
  FrameDerivatives tool;
  Eigen::VectorXd q0, q, v, v_measured, tau, holding, encoder_step;
  double velocity_lag = 0.0;   ///< time constant of the velocity filter [s]
  double encoder_noise = 0.0;  ///< noise of the differentiated positions [rad]
  std::mt19937 random{1};
  std::normal_distribution<double> drawn{0.0, 1.0};
  Status status = Status::Ok;
};

Eigen::VectorXd some_bias() {
  const Eigen::Vector<double, 7> bias(1.0, -2.0, 0.5, 3.0, -0.2, 1.5, -0.3);
  return bias.head(test::pressing_arm().model.nv);
}

TEST(TorqueErrorObserver, ConstantError_ConvergesWithTheBandwidth) {
  for (const double dt : {5e-4, 2e-3})
    for (const double bandwidth : {30.0, 100.0}) {
      SCOPED_TRACE(::testing::Message() << "dt " << dt << ", bandwidth " << bandwidth);
      const Model model = test::pressing_arm().model;
      HeldRobot robot(model, model, {.bandwidth = bandwidth});
      const Eigen::VectorXd bias = some_bias();
      robot.run(2.0 / bandwidth, dt, bias);
      EXPECT_GT((robot.observer.torque_error() - bias).norm(), 0.2 * bias.norm()) << "too fast";
      robot.run(2.8 / bandwidth, dt, bias);
      EXPECT_LT((robot.observer.torque_error() - bias).norm(), 0.08 * bias.norm());
      robot.run(15.0 / bandwidth, dt, bias);
      EXPECT_LT((robot.observer.torque_error() - bias).norm(), 0.01 * bias.norm());
    }
}

TEST(TorqueErrorObserver, MissingMass_IsEstimatedAsItsGravityTorque) {
  const test::PressingArm robot = test::pressing_arm();
  const Model heavy = plant_model(robot.model, {.mass_scale = 1.1});
  HeldRobot arm(robot.model, heavy, {.bandwidth = 50.0});
  arm.run(1.5, 1e-3, Eigen::VectorXd::Zero(heavy.nv));
  RigidBody nominal(robot.model), real(heavy);
  ASSERT_EQ(nominal.update(arm.q, arm.v), Status::Ok);
  ASSERT_EQ(real.update(arm.q, arm.v), Status::Ok);
  const Eigen::VectorXd lacking = nominal.gravity_torque() - real.gravity_torque();
  ASSERT_GT(lacking.norm(), 1.0);
  EXPECT_LT((arm.observer.torque_error() - lacking).norm(), 0.02 * lacking.norm());
}

TEST(TorqueErrorObserver, MeasuredForce_IsNotTakenForAnError) {
  const Model model = test::pressing_arm().model;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(model.nv);
  const Eigen::Vector3d force(0.0, 0.0, 30.0);
  HeldRobot with_force(model, model, {}), without_force(model, model, {});
  // The mistaken torque grows with the step and the speed. The soft springs of arm7 let it move at
  // 4 rad/s.
  const double dt = test::has_robot_files ? 1e-3 : 1e-4;
  const int push = static_cast<int>(std::lround(0.1 / dt));
  for (int i = 0; i < 10 * push; ++i) {
    // The force alternates between on and off.
    const Eigen::Vector3d now = (i / push) % 2 == 0 ? force : Eigen::Vector3d::Zero().eval();
    with_force.step(dt, none, now, now);
    without_force.step(dt, none, now, Eigen::Vector3d::Zero());
    ASSERT_LT(with_force.observer.torque_error().norm(), 0.03) << i;
  }
  without_force.run(test::has_robot_files ? 1.0 : 20.0, 1e-3, none,
                    force);  // until the robot is at rest
  const Eigen::VectorXd taken = without_force.tool.jacobian.topRows(3).transpose() * force;
  EXPECT_LT((without_force.observer.torque_error() - taken).norm(), 0.01 * taken.norm());
}

TEST(TorqueErrorObserver, LagOption_PreventsMistakingCommandsForErrors) {
  const Model model = test::pressing_arm().model;
  const double dt = test::has_robot_files ? 1e-3 : 1e-4;
  const auto mistaken = [&](double lag) {
    HeldRobot robot(model, model, {.bandwidth = 100.0, .transient_scale = 1.0, .lag = lag});
    robot.velocity_lag = 4e-3;
    robot.run(0.02, dt, Eigen::VectorXd::Zero(model.nv));
    double largest = 0.0;
    for (int half = 0; half < 6; ++half) {  // a command that turns around every 50 ms
      robot.holding[1] += half % 2 == 0 ? 2.0 : -2.0;
      for (int i = 0; i < std::lround(0.05 / dt); ++i) {
        robot.step(dt, Eigen::VectorXd::Zero(model.nv), {0, 0, 0}, {0, 0, 0});
        largest = std::max(largest, robot.observer.torque_error().norm());
      }
    }
    return largest;
  };
  const double without_lag = mistaken(0.0);
  EXPECT_GT(without_lag, 0.2);
  EXPECT_LT(mistaken(4e-3), 0.3 * without_lag);
}

TEST(TorqueErrorObserver, LagOption_StillFindsAConstantError) {
  const Model model = test::pressing_arm().model;
  HeldRobot robot(model, model, {.bandwidth = 100.0, .lag = 4e-3});
  robot.velocity_lag = 4e-3;
  robot.run(1.0, test::has_robot_files ? 1e-3 : 1e-4, some_bias());
  EXPECT_LT((robot.observer.torque_error() - some_bias()).norm(), 0.01 * some_bias().norm());
  EXPECT_NE(refusal([&] { TorqueErrorObserver(model, "tool", {.lag = -1.0}); }), "");
}

TEST(TorqueErrorObserver, LongSteps_ConvergeAndStayWithinTheLimit) {
  const Model model = test::pressing_arm().model;
  TorqueErrorObserver observer(model, "tool", {.bandwidth = 100.0, .limit = 5.0});
  const Eigen::VectorXd q = test::pressing_arm().posture, zero = Eigen::VectorXd::Zero(model.nv);
  RigidBody body(model);
  ASSERT_EQ(body.update(q, zero), Status::Ok);
  const Eigen::VectorXd bias = Eigen::VectorXd::Constant(model.nv, 1.0);
  // At rest although the motors lack 1 Nm: the error converges with steps of any length.
  for (const double dt : {0.02, 0.1, 5e-4, 0.05}) {
    for (int i = 0; i < 50; ++i)
      ASSERT_EQ(observer.update(q, zero, body.gravity_torque() - bias, {0, 0, 0}, dt), Status::Ok);
    EXPECT_LT((observer.torque_error() - bias).norm(), 1e-3) << dt;
  }
  for (int i = 0; i < 50; ++i)
    ASSERT_EQ(observer.update(q, zero, body.gravity_torque() - 100.0 * bias, {0, 0, 0}, 0.01),
              Status::Ok);
  EXPECT_EQ(observer.torque_error(), Eigen::VectorXd::Constant(model.nv, 5.0));
}

TEST(TorqueErrorObserver, PureNoise_LowersTheBandwidthAndChangesRestoreIt) {
  const Model model = test::pressing_arm().model;
  const ModelErrorOptions options{
      .bandwidth = 100.0, .transient_scale = 1.0, .quiescent_scale = 0.5};
  const double dt = test::has_robot_files ? 1e-3 : 1e-4;
  HeldRobot quiet(model, model, options),
      always(model, model, {.bandwidth = 100.0, .transient_scale = 1.0});
  quiet.encoder_noise = always.encoder_noise = 2e-6;
  quiet.run(0.4, dt, some_bias());
  EXPECT_EQ(quiet.observer.bandwidth(), 100.0) << "before the noise level is estimated";
  quiet.run(7.6, dt, some_bias());
  always.run(8.0, dt, some_bias());
  EXPECT_NEAR(quiet.observer.bandwidth(), 50.0, 1e-9);
  EXPECT_EQ(always.observer.bandwidth(), 100.0);
  EXPECT_LT((quiet.observer.torque_error() - some_bias()).norm(), 0.2 * some_bias().norm());

  // Friction of one joint that reverses suffices, and is detected within a second.
  Eigen::VectorXd friction = some_bias();
  for (int half = 0; half < 4; ++half) {
    friction[1] = -friction[1];
    quiet.run(0.25, dt, friction);
  }
  EXPECT_EQ(quiet.observer.bandwidth(), 100.0);
  quiet.observer.reset();
  quiet.step(dt, friction, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
  EXPECT_EQ(quiet.observer.bandwidth(), 100.0);
}

TEST(TorqueErrorObserver, InvalidMeasurement_LeavesTheEstimateUnchanged) {
  const Model model = test::pressing_arm().model;
  HeldRobot robot(model, model, {.bandwidth = 100.0});
  robot.run(0.05, 1e-3, some_bias());
  const Eigen::VectorXd before = robot.observer.torque_error();
  const Eigen::VectorXd q = robot.q, v = robot.v, tau = robot.tau;
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  Eigen::VectorXd nan = v;
  nan[2] = std::nan("");
  const double infinite = std::numeric_limits<double>::infinity();
  TorqueErrorObserver& o = robot.observer;
  EXPECT_EQ(o.update(q, nan, tau, none, 1e-3), Status::NotFinite);
  EXPECT_EQ(o.update(nan, v, tau, none, 1e-3), Status::NotFinite);
  EXPECT_EQ(o.update(q, v, nan, none, 1e-3), Status::NotFinite);
  EXPECT_EQ(o.update(q, v, tau, Eigen::Vector3d::Constant(infinite), 1e-3), Status::NotFinite);
  EXPECT_EQ(o.update(q, v, tau, none, std::nan("")), Status::NotFinite);
  EXPECT_EQ(o.update(q, v, tau.head(5), none, 1e-3), Status::WrongSize);
  EXPECT_EQ(o.update(q.head(5), v, tau, none, 1e-3), Status::WrongSize);
  EXPECT_EQ(o.update(q, v.head(5), tau, none, 1e-3), Status::WrongSize);
  EXPECT_EQ(o.update(q, v, tau, none, 0.0), Status::Ok);
  EXPECT_EQ(o.update(q, v, tau, none, -1.0), Status::Ok);
  EXPECT_EQ(o.torque_error(), before);

  // Later updates are unaffected, too.
  HeldRobot same(model, model, {.bandwidth = 100.0});
  same.run(0.05, 1e-3, some_bias());
  same.step(1e-3, some_bias(), none, none);
  robot.step(1e-3, some_bias(), none, none);
  EXPECT_EQ(robot.observer.torque_error(), same.observer.torque_error());
}

TEST(TorqueErrorObserver, Reset_StartsFromZero) {
  const Model model = test::pressing_arm().model;
  HeldRobot robot(model, model, {});
  robot.run(0.2, 1e-3, some_bias());
  robot.observer.reset();
  EXPECT_EQ(robot.observer.torque_error(), Eigen::VectorXd::Zero(model.nv).eval());
  // The first measurement only initializes the observer, whatever its velocity.
  ASSERT_EQ(robot.observer.update(robot.q, Eigen::VectorXd::Constant(model.nv, 3.0), robot.tau,
                                  Eigen::Vector3d::Zero(), 1e-3),
            Status::Ok);
  EXPECT_EQ(robot.observer.torque_error(), Eigen::VectorXd::Zero(model.nv).eval());
}

/// At rest, tau = g - (J_tool - J_plate)^T f, with both Jacobians at the tool.
TEST(TorqueErrorObserver, ForceOnACarriedPlate_IsNotTakenForAnError) {
  if (!test::has_robot_files) GTEST_SKIP() << "needs robots in files";
  const Model model = test::named_robot("talos:two_arms");
  RigidBody body(model);
  const Eigen::VectorXd q = Eigen::VectorXd::LinSpaced(model.nq, -0.6, 0.5);
  const Eigen::VectorXd v = Eigen::VectorXd::Zero(model.nv);
  ASSERT_EQ(body.update(q, v), Status::Ok);
  const int tool = body.frame("tool"), plate = body.frame("plate");
  FrameDerivatives of_tool, of_plate;
  body.frame_derivatives(tool, Reference::centered(), of_tool);
  body.frame_derivatives(plate, Reference::centered(), of_plate);
  const Eigen::Vector3d f(5.0, -20.0, 8.0);
  const Eigen::Vector3d r =
      body.placement(tool).translation() - body.placement(plate).translation();
  const Eigen::VectorXd by_tool = of_tool.jacobian.topRows(3).transpose() * f;
  const Eigen::VectorXd by_plate =
      -of_plate.jacobian.transpose() * (Vector6() << f, r.cross(f)).finished();
  ASSERT_GT(by_plate.norm(), 1.0);
  const Eigen::VectorXd tau = body.gravity_torque() - by_tool - by_plate;
  const ModelErrorOptions options{.bandwidth = 50.0};
  TorqueErrorObserver with_plate(model, "tool", options, {}, {}, "plate"),
      without_plate(model, "tool", options);
  const AllocationGuard guard;
  for (int i = 0; i < 1000; ++i) {
    ASSERT_EQ(with_plate.update(q, v, tau, f, 1e-3), Status::Ok);
    ASSERT_EQ(without_plate.update(q, v, tau, f, 1e-3), Status::Ok);
  }
  EXPECT_EQ(guard.count(), 0);
  EXPECT_LT(with_plate.torque_error().norm(), 1e-9);
  EXPECT_LT((without_plate.torque_error() - by_plate).norm(), 1e-3);
  expect_words(refusal([&] { TorqueErrorObserver(model, "tool", options, {}, {}, "plait"); }),
               {"plait", "plate"});
}

TEST(TorqueErrorObserver, Update_AllocatesNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  const Model model = test::pressing_arm().model;
  TorqueErrorObserver observer(model, "tool", {});
  const Eigen::VectorXd q = test::pressing_arm().posture, v = Eigen::VectorXd::Zero(model.nv);
  const AllocationGuard guard;
  for (int i = 0; i < 5; ++i)
    EXPECT_EQ(observer.update(q, v, v, Eigen::Vector3d(0, 0, 30), 1e-3), Status::Ok);
  observer.reset();
  EXPECT_EQ(guard.count(), 0);
}

TEST(TorqueErrorObserver, OptionsOutOfRangeAndUnknownFrames_AreRefused) {
  const Model model = test::pressing_arm().model;
  const auto with = [&](const std::string& tool, const ModelErrorOptions& options) {
    return refusal([&] { TorqueErrorObserver(model, tool, options); });
  };
  expect_words(with("tol", {}), {"tol", "tool"});
  expect_words(with("tool", {.bandwidth = 0.0}), {"bandwidth", "positive"});
  expect_words(with("tool", {.bandwidth = std::nan("")}), {"bandwidth", "positive"});
  expect_words(with("tool", {.quiescent_scale = 0.0}), {"quiescent_scale", "0.01 to 1"});
  expect_words(with("tool", {.quiescent_scale = 1.1}), {"quiescent_scale", "0.01 to 1"});
  expect_words(with("tool", {.limit = -1.0}), {"limit", "positive"});
  EXPECT_EQ(with("tool", {.limit = std::numeric_limits<double>::infinity()}), "");
}

}  // namespace
}  // namespace burnish
