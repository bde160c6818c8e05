// Whole Talos on its feet, checked with the kinematic tree of MuJoCo: momentum and energy balance
// torques, contacts and gravity, and plans keep the constraints of the feet.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cstdio>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/model/state.hpp"
#include "burnish/report/standing_figures.hpp"
#include "burnish/solver/ddp.hpp"
#include "mujoco/mujoco_engine.hpp"
#include "support/standing_case.hpp"

namespace burnish::test {
namespace {

/// Momentum about the origin of the world and energy of a state, computed by MuJoCo.
class ReferenceTree {
 public:
  ReferenceTree(const Model& model, const SceneSpec& scene) : engine_(model, scene, {}) {
    engine_.m->opt.enableflags |= mjENBL_ENERGY;
  }
  void evaluate(const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
    using Vector3 = Eigen::Map<const Eigen::Vector3d>;
    mjData* const d = engine_.d.get();
    engine_.coordinates.store(q, v, *d);
    mj_fwdPosition(engine_.m.get(), d);
    mj_fwdVelocity(engine_.m.get(), d);
    mj_energyPos(engine_.m.get(), d);
    mj_energyVel(engine_.m.get(), d);
    mj_subtreeVel(engine_.m.get(), d);
    mass = engine_.m->body_subtreemass[0];
    com = Vector3(d->subtree_com);
    momentum.head<3>() = mass * Vector3(d->subtree_linvel);
    momentum.tail<3>() = Vector3(d->subtree_angmom) + com.cross(momentum.head<3>());
    energy = d->energy[0] + d->energy[1];
  }

  double mass = 0.0, energy = 0.0;  ///< Mass [kg] and energy [J]
  Eigen::Vector3d com;              ///< Centre of mass [m]
  Vector6 momentum;                 ///< Linear [kg m/s] and angular [kg m^2/s]

 private:
  mujoco::Engine engine_;
};

/// Root mean square and largest magnitude of a value.
struct Deviation {
  double sum_of_squares = 0.0, max = 0.0;
  long count = 0;
  void add(double value) {
    sum_of_squares += value * value;
    max = std::max(max, std::abs(value));
    ++count;
  }
  double rms() const {
    return std::sqrt(sum_of_squares / static_cast<double>(std::max(count, 1L)));
  }
};

/// Balance of momentum and energy over the steps of a run, with all external forces.
class Balance {
 public:
  explicit Balance(MpcRun& run, const std::vector<Push>& pushes)
      : run_(run),
        pushes_(pushes),
        body_(run.plant().model()),
        tree_(run.plant().model(), run.plant().scene()) {}

  void step() {
    const Plant& plant = run_.plant();
    const double dt = plant.dt();
    const Eigen::VectorXd q = plant.q(), v = plant.v();
    const double now = plant.time();
    const Vector6 turning = momentum_rate_at_constant_speed(q, v);
    tree_.evaluate(q, v);
    const Vector6 momentum = tree_.momentum;
    const double energy = tree_.energy, mass = tree_.mass;
    const Eigen::Vector3d com = tree_.com;
    ASSERT_LE(run_.run(dt), Status::NotConverged);
    tree_.evaluate(q, plant.v());  // a step applies its impulse at the old configuration
    const Vector6 rate = (tree_.momentum - momentum) / dt + turning;
    tree_.evaluate(plant.q(), plant.v());
    if (now < settle_time) return;
    const Eigen::VectorXd v_mid = 0.5 * (v + plant.v());
    ASSERT_EQ(body_.update(q, v_mid), Status::Ok);
    add_external_forces(now);
    const Eigen::Vector3d weight = mass * plant.model().gravity;
    total_.head<3>() += weight;
    total_.tail<3>() += com.cross(weight);
    const Vector6 deviation = rate - total_;
    force.add(deviation.head<3>().norm());
    moment.add(deviation.tail<3>().norm());
    // MuJoCo applies joint damping at the end of a step.
    const Eigen::VectorXd joints =
        plant.friction_torque() - plant.model().damping.cwiseProduct(plant.v() - v);
    motors += dt * run_.loop().actuation().step().applied.dot(v_mid);
    friction += dt * joints.dot(v_mid);
    contacts += dt * power_;
    change += tree_.energy - energy;
    flow += dt * (std::abs(run_.loop().actuation().step().applied.dot(v_mid)) + std::abs(power_));
  }

  Deviation force, moment;  ///< Error of force [N] and of moment about the origin of the world [Nm]
  /// Work of the motors, of joint friction, of contacts and pushes; change of energy; absolute work
  /// of motors and contacts [J]
  double motors = 0.0, friction = 0.0, contacts = 0.0, change = 0.0, flow = 0.0;

 private:
  /// Time in which the robot settles on the ground [s].
  static constexpr double settle_time = 0.05;

  /// Part of d(momentum)/dt due to the change of configuration, by central differences.
  Vector6 momentum_rate_at_constant_speed(const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
    constexpr double half_step = 1e-5;  // [s]
    const Model& model = run_.plant().model();
    tree_.evaluate(integrate(model, q, half_step * v), v);
    const Vector6 after = tree_.momentum;
    tree_.evaluate(integrate(model, q, -half_step * v), v);
    return (after - tree_.momentum) / (2.0 * half_step);
  }

  /// Adds a wrench at the origin of a frame, in the axes of the frame.
  void add(int frame, const Vector6& wrench) {
    const Eigen::Isometry3d at = body_.placement(frame);
    const Eigen::Vector3d f_world = at.linear() * wrench.head<3>();
    total_.head<3>() += f_world;
    total_.tail<3>() += at.linear() * wrench.tail<3>() + at.translation().cross(f_world);
    power_ += wrench.dot(body_.velocity(frame, Reference::local()));
  }
  void add_external_forces(double now) {
    const Plant& plant = run_.plant();
    const SceneSpec& scene = plant.scene();
    total_.setZero();
    power_ = 0.0;
    for (std::size_t i = 0; i < scene.touches.size(); ++i)
      add(body_.frame(scene.touches[i].frame), plant.wrenches().col(static_cast<Eigen::Index>(i)));
    for (const Push& push : pushes_) {
      if (!acts_at(push, now)) continue;
      const int at = body_.frame(push.frame);
      Vector6 wrench = Vector6::Zero();
      wrench.head<3>() = body_.placement(at).linear().transpose() * push.force_world;
      add(at, wrench);
    }
  }

  MpcRun& run_;
  const std::vector<Push>& pushes_;
  RigidBody body_;
  ReferenceTree tree_;
  Vector6 total_ = Vector6::Zero();
  double power_ = 0.0;  ///< Power of the external forces [W]
};

/// Violations of the constraints of the feet by plans.
struct FootConstraints {
  long plans = 0, violating = 0;
  double max_violation = 0.0;  ///< As a fraction of the scale of the constraint

  void add(const DdpSolver& solver) {
    ++plans;
    bool is_violated = false;
    for (const CostReport::Row& row : solver.cost_report().rows) {
      const bool is_of_foot = row.name.find("sole_link") != std::string::npos;
      if (!is_of_foot) continue;
      max_violation = std::max(max_violation, row.violation / row.scale);
      is_violated = is_violated || row.violation > 0.01 * row.scale;
    }
    violating += is_violated ? 1 : 0;
  }
};

/// Checks the balance over every step of a run.
void expect_balance(const MpcCase& wanted) {
  MpcRun run(wanted);
  Balance balance(run, wanted.task.disturbances.pushes);
  FootConstraints rows;
  double solved = 0.0;
  while (run.now() < 2.6) {
    ASSERT_NO_FATAL_FAILURE(balance.step());
    const double took = run.loop().command().solve_time;
    if (took > 0.0 && took != solved && run.now() > 0.3) rows.add(run.mpc().solver());
    solved = took;
  }
  ASSERT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
  const StandingFigures figures =
      measure_standing(run.loop().trace(), run.plant().model(), run.plant().scene().supports());
  const double residual = balance.change - balance.motors - balance.friction - balance.contacts;
  std::printf(
      "rate of momentum minus wrenches: %.3f N rms, %.3f N at most; %.3f Nm rms, %.3f Nm at most\n"
      "energy: change %.3f J; motors %.3f J, joint friction %.3f J, contacts and pushes %.3f J; "
      "residual %.4f J, absolute work %.1f J\n"
      "plans: %ld, %ld of them violate a constraint of a foot by 1 %% of its scale, at most %.2f "
      "%%\n"
      "feet: moved %.2f mm, used %.0f %% of their friction, carried at least %.0f N\n",
      balance.force.rms(), balance.force.max, balance.moment.rms(), balance.moment.max,
      balance.change, balance.motors, balance.friction, balance.contacts, residual, balance.flow,
      rows.plans, rows.violating, 100.0 * rows.max_violation, 1e3 * figures.slip,
      100.0 * figures.friction_used, figures.min_load);
  EXPECT_LT(balance.force.rms(), 0.02);  // the weight is 900 N
  EXPECT_LT(balance.force.max, 0.2);
  EXPECT_LT(balance.moment.rms(), 0.02);
  EXPECT_LT(balance.moment.max, 0.2);
  EXPECT_LT(std::abs(residual), 3e-3 * balance.flow);
  EXPECT_GT(rows.plans, 300);
  EXPECT_EQ(rows.violating, 0);
  EXPECT_LT(figures.friction_used, 1.0);
}

TEST(StandingBalance, UndisturbedRun_MomentumAndEnergyBalance) {
  if (!has_mujoco()) GTEST_SKIP() << "this build has no MuJoCo";
  expect_balance(standing_case());
}

TEST(StandingBalance, PushAtTheTorso_MomentumAndEnergyBalance) {
  if (!has_mujoco()) GTEST_SKIP() << "this build has no MuJoCo";
  expect_balance(standing_case({{2.0, 0.1, Eigen::Vector3d(-60.0, 100.0, 0.0), "torso_2_link"}}));
}

}  // namespace
}  // namespace burnish::test
