// Model predictive control of a robot with two tools: Talos presses with both hands on two
// surfaces.
#include <gtest/gtest.h>

#include <cmath>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/mujoco/mujoco_plant.hpp"
#include "burnish/robots/robot.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "support/allocation_guard.hpp"
#include "support/plant_touch.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double right_force = 20.0, left_force = 30.0;  // targets [N]

/// Task with a constant target force at each tool.
struct PressBoth final : MpcTask {
  void aim(double /*time*/, Command& command) override {
    command.tools[0].target_force = right_force;
    command.tools[1].target_force = left_force;
  }
};

class TwoToolsLoop : public ::testing::Test {
 protected:
  TwoToolsLoop() {
    const Vector3d right_normal(0.1, -0.2, 1.0), left_normal(-0.3, 0.4, 1.0);
    TouchSpec right = round_tip("tool"), left = round_tip("left_tool");
    right.surface.friction = left.surface.friction = 0.3;
    scene.touches = {with_surface_at(robot.model, q, right_normal, right, -2e-4),
                     with_surface_at(robot.model, q, left_normal, left, -2e-4)};
    spec.problem.model = robot.model;
    spec.problem.initial_state = VectorXd::Zero(robot.model.nq + robot.model.nv);
    spec.problem.initial_state.head(robot.model.nq) = q;
    Stage press{.name = "press", .step = 0.01};
    press.costs = {{.residual = residual::State{spec.problem.initial_state}, .weight = 1.0},
                   {.residual = residual::Control{}, .weight = 1e-5}};
    for (const TouchSpec& touch : scene.touches) {
      const Vector3d n = touch.surface.normal;
      ContactSpec contact{.name = touch.frame, .tool = touch.frame, .directions = Directions::z()};
      contact.reference = Reference::surface_with_normal(n);
      spec.problem.contacts.push_back(contact.with_gains(0.0, 50.0));
      const double target = spec.tools.empty() ? right_force : left_force;
      press.contacts.push_back(touch.frame);
      press.costs.push_back({.name = touch.frame,
                             .residual = residual::ContactForce{touch.frame, {}, target},
                             .weight = 0.1});
      spec.tools.push_back({.frame = touch.frame, .normal_base = n});
    }
    spec.problem.stages = {press};
    spec.problem.horizon = {{"press", 20}};
    spec.schedule = {{.name = "press", .stage = "press"}};
    spec.task = [](const MpcSpec&) { return std::make_unique<PressBoth>(); };
    spec.tick_period = 1e-3;
    spec.update_period = 0.01;
    spec.model_error.bandwidth = 100.0;
  }

  Robot robot = load_robot("talos:two_arms");
  VectorXd q = robot.reference_configuration();
  SceneSpec scene;
  MpcSpec spec;
};

/// The plant has other masses and joint friction, so that forces are right only if the error of
/// both arms is estimated with both forces.
TEST_F(TwoToolsLoop, BothHands_PressWithTheirTargets) {
  Disturbances disturbances;
  disturbances.mass_scale = 1.05;
  disturbances.joint_viscous = 0.5;
  MpcController controller(spec);
  EXPECT_EQ(controller.tools(), (std::vector<std::string>{"tool", "left_tool"}));
  const auto plant = make_mujoco_plant(plant_model(robot.model, disturbances), scene, {});
  ClosedLoop loop(*plant, controller, disturbances, {.control_period = 1e-3, .max_duration = 2.0});
  ASSERT_EQ(loop.reset(q, VectorXd::Zero(robot.model.nv)), Status::Ok);
  ASSERT_TRUE(is_usable(loop.run(2.0)));
  ASSERT_EQ(controller.fault().kind, FaultKind::None) << controller.fault().text();
  const Trace& trace = loop.trace();
  const int rows = trace.rows(), begin = rows - rows / 4;
  for (const std::string prefix : {"", "tool_left_tool_"}) {
    const bool is_left = !prefix.empty();
    const double target = is_left ? left_force : right_force;
    const Vector3d n = scene.touches[is_left ? 1 : 0].surface.normal;
    const int column = trace.index(prefix + "measured_force_x_world");
    const int estimate = trace.index(prefix + "estimated_force_x_world");
    double largest = 0.0, estimate_error = 0.0;
    for (int row = begin; row < rows; ++row) {
      const auto along = [&](int first) {
        return Vector3d(trace.at(row, first), trace.at(row, first + 1), trace.at(row, first + 2))
            .dot(n);
      };
      largest = std::max(largest, std::abs(along(column) - target));
      estimate_error = std::max(estimate_error, std::abs(along(estimate) - along(column)));
    }
    EXPECT_LT(largest, 0.5) << prefix;
    EXPECT_LT(estimate_error, 0.5) << prefix;
    EXPECT_EQ(trace.at(rows - 1, trace.index(prefix + "target_force")), target);
    EXPECT_TRUE(trace.has(prefix + "estimated_friction"));
  }
}

TEST_F(TwoToolsLoop, Ticks_AllocateNothing) {
  MpcController controller(spec);
  Measurement m;
  m.q = q;
  m.v = m.tau = VectorXd::Zero(robot.model.nv);
  m.wrenches.setZero(6, 2);
  (void)controller.tick(m);
  const AllocationGuard guard;
  for (int tick = 1; tick < 25; ++tick) {
    m.time = 1e-3 * tick;
    (void)controller.tick(m);
  }
  controller.reset();
  if (AllocationGuard::unavailable() == nullptr) {
    EXPECT_EQ(guard.count(), 0);
  }
}

/// Controller that states other tools than the controller within it.
class WithTools final : public ControllerWrapper {
 public:
  WithTools(Controller& inner, std::vector<std::string> tools)
      : ControllerWrapper(inner), tools_(std::move(tools)) {}
  std::vector<std::string> tools() const override { return tools_; }

 private:
  std::vector<std::string> tools_;
};

TEST_F(TwoToolsLoop, ToolsThatDoNotFitTheScene_AreRefused) {
  MpcController controller(spec);
  const auto plant = make_mujoco_plant(robot.model, scene, {});
  const auto refused = [&](const std::vector<std::string>& tools) {
    WithTools named(controller, tools);
    return testing::refusal(
        [&] { ClosedLoop(*plant, named, {}, {.control_period = 1e-3, .max_duration = 0.1}); });
  };
  EXPECT_EQ(refused({"left_tool", "tool"}), "");
  testing::expect_words(refused({"tool", "left_tol"}),
                        {"has the tool 'left_tol'", "did you mean 'left_tool'"});
  testing::expect_words(refused({"tool", "elbow"}), {"'elbow'", "wanted a touch at this frame"});
  testing::expect_words(refused({"tool", "tool"}), {"has the tool 'tool' twice", "one entry"});
}

/// In a fault, the last second has columns for both tools.
TEST_F(TwoToolsLoop, LastSecondBeforeAFault_HasBothTools) {
  spec.limits.bad = 2e-3;
  MpcController controller(spec);
  Measurement m;
  m.q = q;
  m.v = m.tau = VectorXd::Zero(robot.model.nv);
  m.wrenches.setZero(6, 2);
  m.wrenches(2, 1) = 7.0;
  for (int tick = 0; tick < 10; ++tick) {
    m.time = 1e-3 * tick;
    if (tick == 5) m.wrenches(0, 1) = std::nan("");
    (void)controller.tick(m);
  }
  ASSERT_EQ(controller.fault().kind, FaultKind::BadMeasurement);
  EXPECT_NE(controller.fault().text().find("'left_tool'"), std::string::npos);
  const Trace& trace = controller.fault().last_second;
  EXPECT_EQ(trace.column("target_force")[0], right_force);
  EXPECT_EQ(trace.column("tool_left_tool_target_force")[0], left_force);
  EXPECT_EQ(trace.column("tool_force_z_world")[3], 0.0);
  EXPECT_NE(trace.column("tool_left_tool_force_z_world")[3], 0.0);
}

}  // namespace
}  // namespace burnish::test
