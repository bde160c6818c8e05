// What follows a fault: the law that holds the robot, and how well it holds one that it does not
// know exactly.
#include <gtest/gtest.h>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/dynamics/placement.hpp"
#include "support/mpc_run.hpp"
#include "support/robots.hpp"

namespace burnish::test {
namespace {

/// b(q, 0) and M(q).
struct Statics {
  Eigen::VectorXd gravity;
  Eigen::MatrixXd mass;
};
Statics statics(const Model& model, const Eigen::VectorXd& q) {
  ContactDynamics dynamics(model);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(model.nv);
  EXPECT_EQ(dynamics.forward(q, zero, zero), Status::Ok);
  return {dynamics.bias(), dynamics.mass_matrix()};
}

/// A controller of any robot in the air, fed by hand; its second measurement comes too late.
class Fed {
 public:
  Fed(const TestRobot& robot, const Fallback& fallback)
      : model(robot.model()), mpc(spec_of(robot, model, fallback)) {
    m.q = model.q_neutral;
    m.v = m.tau = Eigen::VectorXd::Zero(model.nv);
    const auto& driven = mpc.problem().layout().actuated;
    actuated.assign(driven.begin(), driven.end());
  }
  const Eigen::VectorXd& tick(const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
    m.q = q;
    m.v = v;
    m.time += 1e-3;
    return mpc.tick(m).tau;
  }
  void fail_at(const Eigen::VectorXd& q) {
    tick(q, Eigen::VectorXd::Zero(model.nv));
    m.time += 1.0;
    tick(q, Eigen::VectorXd::Zero(model.nv));
    ASSERT_EQ(mpc.fault().kind, FaultKind::StaleMeasurement) << mpc.fault().text();
  }
  /// b(q, 0) - M (k e + c v) on the actuated joints, zero elsewhere.
  Eigen::VectorXd law(const Eigen::VectorXd& q, const Eigen::VectorXd& x) const {
    const Statics at = statics(model, q);
    Eigen::VectorXd driven = Eigen::VectorXd::Zero(model.nv), tau = driven;
    for (const int k : actuated) driven[k] = x[k];
    const Eigen::VectorXd pull = at.mass * driven;
    for (const int k : actuated) tau[k] = at.gravity[k] - pull[k];
    return tau;
  }

  Model model;
  MpcController mpc;
  Measurement m;
  std::vector<int> actuated;

 private:
  static MpcSpec spec_of(const TestRobot& robot, Model& model, const Fallback& fallback) {
    model.velocity_limit.setConstant(infinity);
    MpcSpec spec;
    spec.problem.model = model;
    spec.problem.stages = {{.name = "air",
                            .costs = {{.name = "state", .residual = residual::State{}},
                                      {.name = "torque", .residual = residual::Control{}}}}};
    spec.problem.horizon = {{"air", 5}};
    spec.problem.initial_state = Eigen::VectorXd::Zero(model.nq + model.nv);
    spec.problem.initial_state.head(model.nq) = model.q_neutral;
    spec.schedule = {{.phase = Phase::Reach, .stage = "air"}};
    spec.tool = robot.tool;
    spec.target = [](double) { return TaskTarget{}; };
    spec.tick_period = 1e-3;
    spec.fallback = fallback;
    return spec;
  }
};

Eigen::VectorXd robot_at_home() {
  return load_robot(std::string(BURNISH_ROBOTS_DIR) + "/talos:right_arm").reference_configuration();
}

std::vector<TestRobot> robots() {
  return {{"talos:right_arm", Base::Fixed, "tool"},
          {"every_joint", Base::Fixed, "tip"},
          {"every_joint", Base::FreeFlyer, "tip"}};
}

TEST(Fallback, is_a_spring_and_a_damper_of_every_kind_of_joint) {
  std::mt19937_64 generator(4);
  const Fallback fallback{.stiffness = 300.0, .damping = 20.0, .give = 1.0};
  for (const TestRobot& robot : robots()) {
    Fed fed(robot, fallback);
    fed.model.effort_limit.setConstant(infinity);
    const Eigen::VectorXd q_hold = random_configuration(fed.model, generator);
    fed.fail_at(q_hold);
    for (int trial = 0; trial < 5; ++trial) {
      const Eigen::VectorXd e = random_vector(fed.model.nv, 0.01, generator);
      const Eigen::VectorXd v = random_vector(fed.model.nv, 0.01, generator);
      const Eigen::VectorXd q = integrate(fed.model, q_hold, e);
      const Eigen::VectorXd due = fed.law(q, fallback.stiffness * e + fallback.damping * v);
      EXPECT_LT((fed.tick(q, v) - due).norm(), 1e-9 * due.norm()) << robot.label();
    }
  }
}

TEST(Fallback, slips_where_the_spring_would_take_more_than_its_share) {
  const Fallback fallback{.stiffness = 900.0, .damping = 0.0, .give = 0.1};
  const TestRobot robot = robots()[0];
  Fed fed(robot, fallback);
  const Eigen::VectorXd q_hold = robot_at_home(), zero = Eigen::VectorXd::Zero(6),
                        limit = fallback.give * fed.model.effort_limit;
  fed.fail_at(q_hold);
  const Eigen::VectorXd way = Eigen::VectorXd::LinSpaced(6, 0.2, 0.7);
  const auto spring = [&](double along) {
    const Eigen::VectorXd q = q_hold + along * way;
    return Eigen::VectorXd(fed.tick(q, zero) - statics(fed.model, q).gravity);
  };
  // Out, with a torque that stays at its share on the joint that reaches it first.
  for (const double along : {0.05, 0.2, 0.5}) {
    const Eigen::ArrayXd share = spring(along).array().abs() / limit.array();
    EXPECT_NEAR(share.maxCoeff(), 1.0, 1e-9) << along;
  }
  // A little back, and the spring is slack; farther, and it draws the other way.
  const Eigen::VectorXd out = spring(0.5), back = spring(0.45);
  EXPECT_LT(out.dot(back), 0.0);
  EXPECT_NEAR((back.array().abs() / limit.array()).maxCoeff(), 1.0, 1e-9);
  // Within its share it is a spring: there and back it gives the same.
  const Eigen::VectorXd slack = spring(0.451);
  spring(0.4515);
  EXPECT_LT((spring(0.451) - slack).norm(), 1e-9);
}

TEST(Fallback, lets_go_while_nothing_is_measured_and_holds_where_it_sees_again) {
  const Fallback fallback{};
  Fed fed(robots()[0], fallback);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(6), q_hold = robot_at_home(),
                        e = Eigen::VectorXd::Constant(6, 1e-4), nan = zero * std::nan("");
  fed.fail_at(q_hold);
  const Eigen::VectorXd q = q_hold + e, gravity = fed.law(q, zero),
                        held = fed.law(q, fallback.stiffness * e);
  ASSERT_GT((held - gravity).norm(), 0.1);
  EXPECT_LT((fed.tick(q, zero) - held).norm(), 1e-9);
  // A gap of 10 ms is bridged with the position before it; then there is gravity alone.
  for (int i = 0; i < 10; ++i) EXPECT_LT((fed.tick(nan, nan) - held).norm(), 1e-9) << i;
  for (int i = 0; i < 10; ++i) EXPECT_LT((fed.tick(nan, nan) - gravity).norm(), 1e-9) << i;
  const Eigen::VectorXd elsewhere = q_hold + 1e3 * e;
  EXPECT_LT((fed.tick(elsewhere, zero) - fed.law(elsewhere, zero)).norm(), 1e-9);
  const Eigen::VectorXd due = fed.law(elsewhere + e, fallback.stiffness * e);
  EXPECT_LT((fed.tick(elsewhere + e, zero) - due).norm(), 1e-9);
  // The clock of the sensors standing still is as bad.
  for (int i = 0; i < 20; ++i) {
    fed.m.time -= 1e-3;
    fed.tick(elsewhere + e, zero);
  }
  EXPECT_LT((fed.tick(elsewhere, zero) - fed.law(elsewhere, zero)).norm(), 1e-9);
  EXPECT_EQ(fed.mpc.fault().kind, FaultKind::StaleMeasurement);
}

/// A robot that is 5 % heavier than known, with 2 Nm too much at every joint.
MpcCase wrong_model() {
  MpcCase wanted;
  wanted.task.disturbances.mass_scale = 1.05;
  wanted.task.disturbances.torque_bias = Eigen::VectorXd::Constant(6, 2.0);
  return wanted;
}

struct Happening {
  FaultKind kind;
  double until;  ///< s, when all that caused it is over
  std::function<void(MpcCase&)> arrange;
};

void push(MpcCase& wanted, double start, const Eigen::Vector3d& force) {
  wanted.task.disturbances.pushes = {{start, 0.2, force}};
}

std::vector<Happening> happenings() {
  const auto spoil = [](MpcCase& wanted, auto what) {
    wanted.spoil = [what](Measurement& m) {
      if (m.time > 0.7 && m.time < 0.75) what(m);
    };
  };
  return {
      {FaultKind::StaleMeasurement, 0.8,
       [=](MpcCase& w) { spoil(w, [](Measurement& m) { m.time = 0.7; }); }},
      {FaultKind::BadMeasurement, 0.8,
       [=](MpcCase& w) { spoil(w, [](Measurement& m) { m.q[2] = std::nan(""); }); }},
      {FaultKind::OutOfRange, 0.5,
       [](MpcCase& w) {
         w.change = [](MpcSpec& spec) {
           spec.problem.model.q_lower[5] = spec.problem.initial_state[5] - 0.002;
           spec.problem.model.q_upper[5] = spec.problem.initial_state[5] + 0.002;
           spec.limits.joint_margin = 1e-3;
         };
       }},
      {FaultKind::SolverFailed, 0.8,
       [](MpcCase& w) {
         w.change = [](MpcSpec& spec) {
           spec.problem.stages[2].costs.push_back(
               {.name = "impossible",
                .residual =
                    residual::FramePosition{
                        "tool", Signal::over_time(3,
                                                  [](double t, Eigen::Ref<Eigen::VectorXd> p) {
                                                    p.setConstant(t > 1.0 ? std::nan("") : 0.0);
                                                  })},
                .weight = 1e-9});
         };
       }},
      {FaultKind::SolverLate, 0.1, [](MpcCase& w) { w.task.limits.deadline = 0.0; }},
      {FaultKind::ContactLost, 1.0,
       [](MpcCase& w) {
         w.task.limits.contact_lost = 0.02;
         push(w, 0.8, {0.0, 0.0, 80.0});
       }},
      {FaultKind::NoContact, 1.6, [](MpcCase& w) { w.task.disturbances.surface_height = -0.2; }},
      {FaultKind::ContactLate, 0.5,
       [](MpcCase& w) {
         w.task.disturbances.surface_height = -0.2;
         w.task.limits.late_contact_time = 0.1;
       }},
      {FaultKind::UnexpectedContact, 0.5,
       [](MpcCase& w) {
         w.task.reach_duration = 0.5;
         w.task.point_world = polishing::make_setting(w.task).p_start -
                              (w.task.tip_radius + 0.04) * w.task.normal_world;
         w.task.disturbances.surface_height = 0.02;
       }},
      {FaultKind::ForceLimit, 1.0,
       [](MpcCase& w) {
         push(w, 0.8, {0.0, 0.0, -150.0});
       }},
      {FaultKind::SpeedLimit, 0.25, [](MpcCase& w) {
         w.task.limits.tool_speed = 0.3;
         push(w, 0.05, {0.0, 100.0, 0.0});
       }}};
}

Eigen::Vector3d tool_of(MpcRun& run) {
  return frame_placement(run.setting().robot.model, run.plant().q(), "tool").translation();
}

/// Runs into the fault and on until its cause is over.
void fail(MpcRun& run, const Happening& happening) {
  while (run.mpc().fault().kind == FaultKind::None && run.now() < 2.5)
    ASSERT_EQ(run.run(5e-4), Status::Ok);
  ASSERT_EQ(run.mpc().fault().kind, happening.kind) << run.mpc().fault().text();
  if (run.now() < happening.until) {
    ASSERT_EQ(run.run(happening.until - run.now()), Status::Ok);
  }
}

TEST(Fallback, holds_a_robot_that_it_does_not_know_exactly_after_every_fault) {
  for (const Happening& happening : happenings()) {
    SCOPED_TRACE(name_of(happening.kind));
    MpcCase wanted = wrong_model();
    happening.arrange(wanted);
    MpcRun run(wanted);
    fail(run, happening);
    const Eigen::Vector3d at_fault = tool_of(run);
    ASSERT_EQ(run.run(0.5), Status::Ok);
    const Eigen::Vector3d at_rest = tool_of(run);
    double drift = 0.0, pressed = 0.0;
    for (int i = 0; i < 60; ++i) {
      ASSERT_EQ(run.run(0.05), Status::Ok);
      drift = std::max(drift, (tool_of(run) - at_rest).norm());
      pressed = std::max(pressed, run.plant().contact_force_world().norm());
    }
    RecordProperty(std::string(name_of(happening.kind)) + " mm",
                   std::to_string(1e3 * (at_rest - at_fault).norm()) + " + " +
                       std::to_string(1e3 * drift) + ", N " + std::to_string(pressed));
    EXPECT_LT(drift, 1e-3) << "it sinks";
    EXPECT_LT((at_rest - at_fault).norm(), 0.015);
    EXPECT_LT(run.plant().v().norm(), 1e-3);
    EXPECT_LT(pressed, 30.0);
    EXPECT_TRUE(run.watched().finite);
    EXPECT_TRUE(
        (run.watched().largest.array() <= run.mpc().problem().model().effort_limit.array()).all());
    if (AllocationGuard::unavailable() == nullptr) {
      EXPECT_EQ(run.watched().allocations, 0);
    }
  }
}

TEST(Fallback, lets_the_robot_sink_without_a_spring) {
  MpcCase wanted = wrong_model();
  wanted.task.limits.deadline = 0.0;
  wanted.task.fallback.stiffness = 0.0;
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.5), Status::Ok);
  ASSERT_EQ(run.mpc().fault().kind, FaultKind::SolverLate);
  const Eigen::Vector3d before = tool_of(run);
  ASSERT_EQ(run.run(1.5), Status::Ok);
  EXPECT_GT((tool_of(run) - before).norm(), 0.03);
}

TEST(Fallback, resists_a_push_and_gives_way_to_a_hard_one) {
  const auto pushed = [](double force, double duration) {
    MpcCase wanted;
    wanted.task.limits.deadline = 0.0;
    wanted.task.disturbances.pushes = {{0.5, duration, Eigen::Vector3d(0.0, force, 0.0)}};
    return wanted;
  };
  // 20 N: a little, and back.
  MpcRun gentle(pushed(20.0, 1.0));
  ASSERT_EQ(gentle.run(0.5), Status::Ok);
  ASSERT_EQ(gentle.mpc().fault().kind, FaultKind::SolverLate);
  const Eigen::Vector3d start = tool_of(gentle);
  ASSERT_EQ(gentle.run(1.0), Status::Ok);
  const double moved = (tool_of(gentle) - start).norm();
  ASSERT_EQ(gentle.run(1.0), Status::Ok);
  RecordProperty("20 N mm", std::to_string(1e3 * moved));
  EXPECT_GT(moved, 1e-3);
  EXPECT_LT(moved, 0.02);
  EXPECT_LT((tool_of(gentle) - start).norm(), 1e-3);

  // 150 N: it goes along, slowly, and stays near where it was left.
  MpcRun hard(pushed(150.0, 0.3));
  ASSERT_EQ(hard.run(0.8), Status::Ok);
  const Eigen::Vector3d left = tool_of(hard);
  EXPECT_GT((left - start).norm(), 0.05);
  ASSERT_EQ(hard.run(1.0), Status::Ok);
  EXPECT_LT((tool_of(hard) - left).norm(), 0.05);
  EXPECT_LT(hard.plant().v().norm(), 1e-3);
  EXPECT_TRUE(
      (hard.watched().largest.array() <= hard.mpc().problem().model().effort_limit.array()).all());
}

TEST(Fallback, holds_with_noisy_late_measurements_of_which_some_are_lost) {
  MpcCase wanted = wrong_model();
  Disturbances& d = wanted.task.disturbances;
  d.command_delay = 2e-3;
  d.encoder_bits = 17;
  d.finite_difference_velocity = true;
  d.velocity_cutoff = 314.0;
  d.torque_noise = 0.05;
  wanted.task.limits.deadline = 0.0;
  wanted.spoil = [tick = 0](Measurement& m) mutable {
    if (++tick % 10 == 0) m.q[1] = std::nan("");
  };
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.5), Status::Ok);
  ASSERT_EQ(run.mpc().fault().kind, FaultKind::SolverLate) << run.mpc().fault().text();
  const Eigen::Vector3d before = tool_of(run);
  ASSERT_EQ(run.run(3.0), Status::Ok);
  EXPECT_LT((tool_of(run) - before).norm(), 1e-3);
  EXPECT_LT(run.plant().v().norm(), 0.02);
}

}  // namespace
}  // namespace burnish::test
