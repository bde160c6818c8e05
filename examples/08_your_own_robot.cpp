// A task of one's own for a robot of one's own: whatever stands on balls as feet is put on bent
// legs and bows twice in MuJoCo. It knows where its base is from an inertial unit, encoders and
// feet.
//   08_your_own_robot my_robot.urdf foot_1 foot_2 foot_3 foot_4     # without words: the quadruped
#include <cstdio>

#include "burnish/mpc/mpc.hpp"
#include "burnish/mujoco/mujoco_plant.hpp"
#include "burnish/report/standing_figures.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "burnish/tasks/stand/stand.hpp"

using namespace burnish;
using Eigen::Vector3d, Eigen::VectorXd;

int main(int argc, char** argv) {
  stand::Task task;  // what the robot is and what it stands on; what it does is said below
  task.posture = "search";
  if (argc > 2) task.robot = argv[1], task.standing.feet.assign(argv + 2, argv + argc);
  const stand::Setting at = stand::make_setting(task);
  const Model& model = at.robot.model;
  const int nq = model.nq, nv = model.nv;
  const double weight = model.total_mass() * model.gravity.norm(), bow = 0.15, deep = 0.02;
  const auto share = [](double t) { return 0.5 - 0.5 * std::cos(M_PI * t); };  // 2 s for a bow
  const auto bowed = [=](double t) -> Eigen::Matrix3d {
    return Eigen::AngleAxisd(bow * share(t), Vector3d::UnitY()) * at.R_base;
  };
  const Signal com = Signal::over_time(
      3, [=, com = at.com](double t, auto p) { p = com - deep * share(t) * Vector3d::UnitZ(); });
  const Signal turn = Signal::over_time(
      4, [=](double t, auto quaternion) { quaternion = Eigen::Quaterniond(bowed(t)).coeffs(); });
  MpcSpec mpc{.problem = {.model = model}, .supports = task.standing.feet};
  Stage stage{.name = "bow", .contacts = mpc.supports};
  BaseEstimatorOptions estimator{.gyro_noise = 3e-4, .accelerometer_noise = 5e-3};
  for (const std::string& foot : mpc.supports) {
    mpc.touches.push_back({foot});  // with a sensor of force and moment
    ContactSpec ball{.name = foot, .tool = foot, .directions = Directions::linear()};
    ball.reference = Reference::centered();
    mpc.problem.contacts.push_back(ball.with_gains(0.0, 20.0));
    stage.constraints.push_back({"rubs " + foot, residual::FrictionCone{foot, 0.5}});
    stage.constraints.push_back({.name = "bears " + foot,
                                 .residual = residual::ContactForce{foot},
                                 .lower = Vector3d(-1e9, -1e9, 0.03 * weight),
                                 .scale = VectorXd::Constant(1, weight)});
    estimator.feet.push_back({foot, FootKind::Ball});
  }
  mpc.problem.initial_state = VectorXd::Zero(nq + nv);
  mpc.problem.initial_state.head(nq) = at.q_start;
  VectorXd weights = VectorXd::Constant(2 * nv, 0.1);
  weights.head<6>().setZero();  // where the base is and how it moves, balance and bow say
  weights.segment<6>(nv).setZero();
  stage.costs = {{"state", residual::State{}, 1.0, weights},
                 {"balance", residual::CenterOfMass{com}, 1e4},
                 {"bow", residual::FrameRotation{at.base, turn}, 1e3}};
  mpc.problem.stages = {stage};
  mpc.problem.horizon = {{.stage = "bow", .knots = 20, .step = 0.01, .duration = 0.6}};
  mpc.schedule = {{.name = "bow", .stage = "bow"}};
  mpc.settle = 0.5;  // s that it is held at first, while the estimate of its base settles
  mpc.fallback = task.standing.fallback;
  mpc.tick_period = 1e-3;
  mpc.update_period = mpc.solver_delay = 5e-3;  // plans take 5 ms
  mpc.model_error = {.bandwidth = 60.0, .decay_time = 0.2};
  MpcController controller(mpc);
  const Disturbances disturbances = disturbance_preset("mismatch");
  const auto plant = make_mujoco_plant(plant_model(model, disturbances), at.scene);
  ClosedLoop loop(*plant, controller, disturbances);
  FootContactOptions feet;
  feet.force_noise = 1e-3 * weight;
  loop.estimate_base(model, estimator, feet);
  const VectorXd rest = VectorXd::Zero(nv);
  if (loop.reset(at.q_start, rest) != Status::Ok || !is_usable(loop.run(4.5))) return 1;
  if (controller.fault().kind != FaultKind::None)
    return std::puts(controller.fault().text().c_str()), 1;
  const StandingFigures stood = measure_standing(loop.trace(), plant->model(), at.scene.supports());
  std::printf("bowed: by %.3f rad, the centre of mass moved %.0f mm\n", stood.base_tilt,
              1e3 * stood.com_moved);
  std::printf("stood: each foot bore %.0f %% of the weight or more\n",
              100.0 * stood.min_load / weight);
}
