// A control loop: an arm comes down on a tilted board, presses with 20 N and draws a line of 6 cm,
// with masses 5 % larger and friction that its controller does not know of.
// Shows: model predictive control of a task of your own, its schedule, a plant, and the score.
#include <algorithm>
#include <cstdio>

#include "burnish/mpc/mpc.hpp"
#include "burnish/report/metrics.hpp"
#include "burnish/robots/robot.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "burnish/sim/ideal_plant.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"

using namespace burnish;
using Eigen::Vector3d;

int main() {
  const Robot robot = load_robot("arm7");
  const Eigen::VectorXd q = robot.posture("ready"), rest = Eigen::VectorXd::Zero(robot.model.nv);
  const Vector3d tilted(0.2, -0.1, 1.0);  // out of the board, world
  // The board is 1 cm under the tip of the tool.
  const TouchSpec tip = with_surface_at(robot.model, q, tilted, {.frame = "tool"}, 0.01);
  const Eigen::Matrix3d axes = Reference::surface_with_normal(tilted).rotation;
  const Vector3d n = axes.col(2), start = tip.surface.point + tip.radius * n;

  // Where the tool shall be and how hard it shall press, by time. Contact is due at 0.5 s.
  const auto target = [=](double t) {
    const double drawn = std::clamp(0.03 * (t - 1.0), 0.0, 0.06);
    return TaskTarget{start + drawn * axes.col(0),
                      t < 0.5 ? 0.0 : 5.0 + 15.0 * std::min(1.0, 2 * (t - 0.5))};
  };
  const Signal place = Signal::over_time(3, [=](double t, auto p) { p = target(t).p_world; });
  const Signal push = Signal::over_time(1, [=](double t, auto f) { f[0] = target(t).force; });
  Eigen::VectorXd speed = Eigen::VectorXd::Zero(6), along_normal = speed;
  speed[2] = -0.02;  // m/s, towards the board
  along_normal[2] = 1.0;

  MpcSpec mpc{.problem = {.model = robot.model}, .tools = {{.frame = "tool", .normal_base = n}}};
  ContactSpec board{.name = "board", .tool = "tool", .directions = Directions::z()};
  board.reference = Reference::surface(axes);
  mpc.problem.contacts = {board.with_gains(0.0, 40.0)};
  mpc.problem.initial_state.setZero(robot.model.nq + robot.model.nv);
  mpc.problem.initial_state.head(robot.model.nq) = q;
  const CostTerm state{.residual = residual::State{mpc.problem.initial_state}, .weight = 0.1};
  const CostTerm across{.residual = residual::FramePosition{"tool", place, Reference::world(axes)},
                        .weight = 1e4,
                        .weights = Vector3d(1, 1, 0)};
  const CostTerm down{.residual = residual::FrameVelocity{"tool", Reference::centered(axes), speed},
                      .weight = 1e2,
                      .weights = along_normal};
  const CostTerm force{.residual = residual::ContactForce{"board", {}, push}, .weight = 1.0};
  const CostTerm torque{.residual = residual::Control{}, .weight = 1e-4};
  mpc.problem.stages = {
      {.name = "approach", .costs = {state, torque, across, down}},
      {.name = "press", .contacts = {"board"}, .costs = {state, torque, across, force}}};
  mpc.problem.terminal = {state, across};
  mpc.problem.horizon = {{"approach", 50}};  // half a second
  mpc.schedule = {{.name = "approach", .stage = "approach", .duration = 0.5, .until = "contact"},
                  {.name = "press", .stage = "press"}};
  mpc.task = PressingTask{.touch = {Touch::Due, Touch::Wanted}, .target = target};
  mpc.tick_period = mpc.update_period = 1e-3;
  mpc.model_error.bandwidth = 150.0;

  MpcController controller(mpc);
  const Disturbances disturbances{
      .joint_viscous = 0.2, .mass_scale = 1.05, .surface_friction = 0.3};
  const auto plant = make_ideal_plant(plant_model(robot.model, disturbances),
                                      plant_scene({.touches = {tip}}, disturbances));
  ClosedLoop loop(*plant, controller, disturbances);
  if (loop.reset(q, rest) != Status::Ok || !is_usable(loop.run(4.0))) return 1;
  if (controller.fault().kind != FaultKind::None)
    return std::puts(controller.fault().text().c_str()), 1;
  const Metrics score =
      measure(loop.trace(), robot.model, {.start = 1.1, .end = 3.0, .normal_world = n});
  std::printf("polished: force error %.3f N, path error %.3f mm rms\n", score.force_rmse,
              1e3 * score.position_rmse);
}
