// Whole Talos on its feet, judged by MuJoCo's own tree: what its momentum and energy do is what
// torques, contacts and gravity say, and feet stand within what they bear.
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

/// Momentum about the world's origin and energy of a state, by MuJoCo's tree.
class Judge {
 public:
  Judge(const Model& model, const SceneSpec& scene) : engine_(model, scene, {}) {
    engine_.m->opt.enableflags |= mjENBL_ENERGY;
  }
  void look(const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
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

  double mass = 0.0, energy = 0.0;  ///< kg, J
  Eigen::Vector3d com;              ///< m
  Vector6 momentum;                 ///< kg m/s, kg m^2/s

 private:
  mujoco::Engine engine_;
};

/// Root of the mean of squares, and the largest.
struct Deviation {
  double square = 0.0, most = 0.0;
  long count = 0;
  void add(double value) {
    square += value * value;
    most = std::max(most, std::abs(value));
    ++count;
  }
  double rms() const { return std::sqrt(square / static_cast<double>(std::max(count, 1L))); }
};

/// What acts on the robot from outside, and what all of it does, during steps of a run.
class Balance {
 public:
  explicit Balance(MpcRun& run, const std::vector<Push>& pushes)
      : run_(run),
        pushes_(pushes),
        body_(run.plant().model()),
        judge_(run.plant().model(), run.plant().scene()) {}

  void step() {
    const Plant& plant = run_.plant();
    const double dt = plant.dt();
    const Eigen::VectorXd q = plant.q(), v = plant.v();
    const double now = plant.time();
    const Vector6 turning = momentum_rate_at_constant_speed(q, v);
    judge_.look(q, v);
    const Vector6 momentum = judge_.momentum;
    const double energy = judge_.energy, mass = judge_.mass;
    const Eigen::Vector3d com = judge_.com;
    ASSERT_LE(run_.run(dt), Status::NotConverged);
    judge_.look(q, plant.v());  // a step changes speeds where it begins
    const Vector6 rate = (judge_.momentum - momentum) / dt + turning;
    judge_.look(plant.q(), plant.v());
    if (now < settling) return;
    const Eigen::VectorXd v_mid = 0.5 * (v + plant.v());
    ASSERT_EQ(body_.update(q, v_mid), Status::Ok);
    add_outside(now);
    const Eigen::Vector3d weight = mass * plant.model().gravity;
    total_.head<3>() += weight;
    total_.tail<3>() += com.cross(weight);
    const Vector6 off = rate - total_;
    force.add(off.head<3>().norm());
    moment.add(off.tail<3>().norm());
    // MuJoCo's step takes damping at its end.
    const Eigen::VectorXd joints =
        plant.friction_torque() - plant.model().damping.cwiseProduct(plant.v() - v);
    motors += dt * run_.loop().actuation().step().applied.dot(v_mid);
    friction += dt * joints.dot(v_mid);
    contacts += dt * power_;
    change += judge_.energy - energy;
    flow += dt * (std::abs(run_.loop().actuation().step().applied.dot(v_mid)) + std::abs(power_));
  }

  Deviation force, moment;  ///< N, Nm about the world's origin
  /// J: of the torques, of joints' friction, of contacts and pushes; of the robot's energy; what
  /// went in and out
  double motors = 0.0, friction = 0.0, contacts = 0.0, change = 0.0, flow = 0.0;

 private:
  static constexpr double settling = 0.05;  ///< s, in which the ground takes the robot

  /// The part of d(momentum)/dt that comes of where the robot goes, by central differences.
  Vector6 momentum_rate_at_constant_speed(const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
    constexpr double ahead = 1e-5;  // s
    const Model& model = run_.plant().model();
    judge_.look(integrate(model, q, ahead * v), v);
    const Vector6 after = judge_.momentum;
    judge_.look(integrate(model, q, -ahead * v), v);
    return (after - judge_.momentum) / (2.0 * ahead);
  }

  /// A wrench at the origin of a frame, in the axes of that frame.
  void add(int frame, const Vector6& wrench) {
    const Eigen::Isometry3d at = body_.placement(frame);
    const Eigen::Vector3d f_world = at.linear() * wrench.head<3>();
    total_.head<3>() += f_world;
    total_.tail<3>() += at.linear() * wrench.tail<3>() + at.translation().cross(f_world);
    power_ += wrench.dot(body_.velocity(frame, Reference::local()));
  }
  void add_at(int frame, const Eigen::Vector3d& p_world, const Eigen::Vector3d& f_world) {
    const Eigen::Isometry3d at = body_.placement(frame);
    Vector6 wrench;
    wrench.head<3>() = at.linear().transpose() * f_world;
    wrench.tail<3>() = at.linear().transpose() * (p_world - at.translation()).cross(f_world);
    add(frame, wrench);
  }
  void add_outside(double now) {
    const Plant& plant = run_.plant();
    const SceneSpec& scene = plant.scene();
    total_.setZero();
    power_ = 0.0;
    for (std::size_t i = 0; i < scene.supports.size(); ++i)
      add(body_.frame(scene.supports[i].frame),
          plant.support_wrenches().col(static_cast<Eigen::Index>(i)));
    const int tip = body_.frame(scene.tip.frame);
    add_at(tip, body_.placement(tip).translation() - scene.tip.radius * scene.surface.normal,
           plant.contact_force_world());
    for (const Push& push : pushes_) {
      const int at = body_.frame(push.frame);
      if (acts_at(push, now)) add_at(at, body_.placement(at).translation(), push.force_world);
    }
  }

  MpcRun& run_;
  const std::vector<Push>& pushes_;
  RigidBody body_;
  Judge judge_;
  Vector6 total_ = Vector6::Zero();
  double power_ = 0.0;  ///< W
};

/// Of the rows of plans that keep what the feet bear.
struct FootRowsOfPlans {
  long plans = 0, broken = 0;
  double most = 0.0;  ///< of the row's scale

  void look(const DdpSolver& solver) {
    ++plans;
    bool any = false;
    for (const CostReport::Row& row : solver.cost_report().rows) {
      const bool of_feet = row.name.find("sole_link") != std::string::npos;
      if (!of_feet) continue;
      most = std::max(most, row.outside / row.scale);
      any = any || row.outside > 0.01 * row.scale;
    }
    broken += any ? 1 : 0;
  }
};

/// Every step of a run is judged.
void judge(const MpcCase& wanted) {
  MpcRun run(wanted);
  Balance balance(run, wanted.task.disturbances.pushes);
  FootRowsOfPlans rows;
  double solved = 0.0;
  while (run.now() < 2.6) {
    ASSERT_NO_FATAL_FAILURE(balance.step());
    const double took = run.loop().command().solve_time;
    if (took > 0.0 && took != solved && run.now() > 0.3) rows.look(run.mpc().solver());
    solved = took;
  }
  ASSERT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
  const StandingFigures stood =
      measure_standing(run.loop().trace(), run.plant().model(), run.plant().scene().supports);
  const double left = balance.change - balance.motors - balance.friction - balance.contacts;
  std::printf(
      "rate of momentum less wrenches: %.3f N rms, %.3f N at most; %.3f Nm rms, %.3f Nm at most\n"
      "energy: change %.3f J; motors %.3f J, joints' friction %.3f J, contacts and pushes %.3f J; "
      "left %.4f J, of %.1f J that went in and out\n"
      "plans: %ld, %ld of them break a foot's limit by 1 %% of its scale, the largest %.2f %%\n"
      "feet: moved %.2f mm, used %.0f %% of their friction, bore %.0f N or more\n",
      balance.force.rms(), balance.force.most, balance.moment.rms(), balance.moment.most,
      balance.change, balance.motors, balance.friction, balance.contacts, left, balance.flow,
      rows.plans, rows.broken, 100.0 * rows.most, 1e3 * stood.slip, 100.0 * stood.friction_used,
      stood.least_load);
  EXPECT_LT(balance.force.rms(), 0.02);  // of a weight of 900 N
  EXPECT_LT(balance.force.most, 0.2);
  EXPECT_LT(balance.moment.rms(), 0.02);
  EXPECT_LT(balance.moment.most, 0.2);
  EXPECT_LT(std::abs(left), 3e-3 * balance.flow);
  EXPECT_GT(rows.plans, 300);
  EXPECT_EQ(rows.broken, 0);
  EXPECT_LT(stood.friction_used, 1.0);
}

TEST(StandingJudged, momentum_and_energy_are_what_torques_and_contacts_make_of_them) {
  if (!has_mujoco()) GTEST_SKIP() << "this build has no MuJoCo";
  judge(standing_case());
}

TEST(StandingJudged, so_they_are_while_the_torso_is_pushed) {
  if (!has_mujoco()) GTEST_SKIP() << "this build has no MuJoCo";
  judge(standing_case({{2.0, 0.1, Eigen::Vector3d(-60.0, 100.0, 0.0), "torso_2_link"}}));
}

}  // namespace
}  // namespace burnish::test
