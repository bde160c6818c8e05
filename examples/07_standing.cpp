// A robot on its feet: whole Talos stands in MuJoCo, draws a circle in the air with its right hand
// and is pushed at the torso with 80 N; it is 2 % heavier than its controller thinks.
// Shows: feet as contacts within what they bear, balance, knots that grow, ground that only pushes.
#include <cstdio>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/mujoco/mujoco_plant.hpp"
#include "burnish/report/standing_figures.hpp"
#include "burnish/robots/robot.hpp"
#include "burnish/sim/closed_loop.hpp"

using namespace burnish;
using Eigen::Vector3d, Eigen::VectorXd;

int main() {
  const Robot robot = load_robot("talos");  // or a URDF of your own, {.base = Base::FreeFlyer}
  const int nq = robot.model.nq, nv = robot.model.nv;
  const VectorXd q = robot.posture("standing_table"), rest = VectorXd::Zero(nv);
  RigidBody body(robot.model);
  if (body.update(q, rest) != Status::Ok) return 1;
  const Vector3d hand = body.placement(body.frame("tool")).translation(), com = body.com();
  const auto circle = [=](double t) -> Vector3d {
    return hand + 0.04 * std::min(1.0, t) * Vector3d(0.0, std::cos(4.0 * t), std::sin(4.0 * t));
  };
  const Signal drawn = Signal::over_time(3, [=](double t, auto p) { p = circle(t); });
  MpcSpec mpc{.problem = {.model = robot.model},
              .supports = {"left_sole_link", "right_sole_link"},
              .touches = {{"left_sole_link"}, {"right_sole_link"}}};  // all have force sensors
  Stage stand{.name = "stand", .contacts = mpc.supports};
  SceneSpec scene;
  VectorXd least = VectorXd::Constant(6, -1e9);
  least[2] = 40.0;  // N that each foot bears, and all 6 directions of it are held
  for (const std::string& foot : mpc.supports) {
    ContactSpec sole{.name = foot, .tool = foot, .reference = Reference::centered()};
    mpc.problem.contacts.push_back(sole.with_gains(0.0, 20.0));
    stand.constraints.push_back({"rubs " + foot, residual::FrictionCone{foot, 0.5}});
    stand.constraints.push_back({"tips " + foot, residual::CenterOfPressure{foot, 0.09, 0.06}});
    stand.constraints.push_back({.name = "bears " + foot,
                                 .residual = residual::ContactForce{foot},
                                 .lower = least,
                                 .scale = VectorXd::Constant(1, 100.0)});
    const Vector3d under = body.placement(body.frame(foot)).translation();
    scene.touches.push_back(
        {.frame = foot,
         .half_x = 0.1,
         .half_y = 0.065,
         .surface = {.point = under, .friction = 0.7, .stiffness = 2e6, .damping = 1e5},
         .is_support = true});
  }
  mpc.problem.initial_state = VectorXd::Zero(nq + nv);
  mpc.problem.initial_state.head(nq) = q;
  VectorXd weights = VectorXd::Constant(2 * nv, 0.1);
  weights.head<3>().setZero();               // where the base is, the centre of mass says
  weights.segment<3>(3).setConstant(100.0);  // it is upright
  weights.tail(nv).setConstant(5.0);
  stand.costs = {{"state", residual::State{}, 1.0, weights},
                 {"balance", residual::CenterOfMass{com}, 1e3},
                 {"momentum", residual::CentroidalMomentum{}, 1e-2},
                 {"circle", residual::FramePosition{"tool", drawn}, 1e4}};
  mpc.problem.stages = {stand};
  mpc.problem.horizon = {{.stage = "stand", .knots = 25, .step = 0.01, .duration = 0.8}};
  const VectorXd held = Problem(mpc.problem).quasi_static(0, mpc.problem.initial_state).control;
  mpc.problem.stages[0].costs.push_back({"torque", residual::Control{held}, 1e-4});
  mpc.schedule = {{.name = "stand", .stage = "stand"}};
  mpc.tick_period = 1e-3;
  mpc.update_period = mpc.solver_delay = 5e-3;  // plans take 5 ms
  mpc.model_error = {.bandwidth = 60.0, .decay_time = 0.2};
  MpcController controller(mpc);
  Disturbances disturbances{.mass_scale = 1.02};
  disturbances.pushes = {{1.5, 0.2, Vector3d(0.0, 80.0, 0.0), "torso_2_link"}};
  const auto plant = make_mujoco_plant(plant_model(robot.model, disturbances), scene);
  ClosedLoop loop(*plant, controller, disturbances);
  if (loop.reset(q, rest) != Status::Ok || !is_usable(loop.run(2.5))) return 1;
  if (controller.fault().kind != FaultKind::None)
    return std::puts(controller.fault().text().c_str()), 1;
  const StandingFigures stood = measure_standing(loop.trace(), plant->model(), scene.touches);
  if (body.update(plant->q(), plant->v()) != Status::Ok) return 1;
  const Vector3d off = body.placement(body.frame("tool")).translation() - circle(2.5);
  std::printf("stood: each foot bore %.0f N or more, used %.0f %% of its friction, slid %.1f mm\n",
              stood.min_load, 100.0 * stood.friction_used, 1e3 * stood.slip);
  std::printf("balance: the centre of mass moved %.0f mm, the hand is %.1f mm off\n",
              1e3 * stood.com_moved, 1e3 * off.norm());
}
