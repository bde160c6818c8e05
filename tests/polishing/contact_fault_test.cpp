// Faults of contact: lost, late, missing or unexpected, in closed loop and with given measurements.
#include <gtest/gtest.h>

#include "burnish/mpc/mpc.hpp"
#include "support/fault_checks.hpp"
#include "support/tool_force.hpp"

namespace burnish::test {
namespace {

using testing::expect_words;

/// Plant whose surface vanishes at a given time.
class VanishingSurfacePlant final : public Plant {
 public:
  VanishingSurfacePlant(const Model& model, const SceneSpec& scene, double until)
      : until_(until), with_(make_ideal_plant(model, scene)) {
    SceneSpec far = scene;
    far.tool().surface.point -= 10.0 * scene.tool().surface.normal;
    without_ = make_ideal_plant(model, far);
  }
  const Model& model() const override { return with_->model(); }
  const SceneSpec& scene() const override { return with_->scene(); }
  double dt() const override { return with_->dt(); }
  Status reset(const ConstVectorRef& q, const ConstVectorRef& v) noexcept override {
    gone_ = false;
    return with_->reset(q, v);
  }
  Status step(const ConstVectorRef& tau) noexcept override {
    if (!gone_ && with_->time() > until_) {
      gone_ = true;
      if (without_->reset(with_->q(), with_->v()) != Status::Ok) return Status::NotFinite;
    }
    return now().step(tau);
  }
  double time() const override { return gone_ ? with_->time() + without_->time() : with_->time(); }
  const Eigen::VectorXd& q() const override { return now().q(); }
  const Eigen::VectorXd& v() const override { return now().v(); }
  const Wrenches& wrenches() const override { return now().wrenches(); }
  const Eigen::VectorXd& friction_torque() const override { return now().friction_torque(); }
  void save(PlantSnapshot& snapshot) const override { now().save(snapshot); }
  Status restore(const PlantSnapshot& snapshot) noexcept override {
    return now().restore(snapshot);
  }

 private:
  Plant& now() const { return gone_ ? *without_ : *with_; }
  double until_;
  bool gone_ = false;
  std::unique_ptr<Plant> with_, without_;
};

TEST(Fault, SurfaceVanishes_ReportsContactLost) {
  MpcCase wanted;
  wanted.make_plant = [](const Model& model, const SceneSpec& scene) {
    return std::make_unique<VanishingSurfacePlant>(model, scene, 0.8);
  };
  MpcRun run(wanted);
  ASSERT_EQ(run.polish(), Status::Ok);
  expect_report(run.mpc().fault(), FaultKind::ContactLost, 0.95, 2e-3);
  EXPECT_EQ(run.mpc().fault().limit, 0.15);
  expect_fallback(run);
  expect_rest(run);
}

TEST(Fault, SurfaceMissing_ReportsNoContact) {
  MpcCase wanted;
  wanted.task.disturbances.surface_height = -0.1;
  MpcRun run(wanted);
  ASSERT_EQ(run.run(2.0), Status::Ok);
  // The schedule waits from 0.25 s on; 3 cm at 0.025 m/s take 1.2 s.
  const FaultReport& fault = run.mpc().fault();
  ASSERT_EQ(fault.kind, FaultKind::NoContact) << fault.text();
  EXPECT_NEAR(fault.time, 1.45, 0.1);
  EXPECT_EQ(fault.limit, 0.03);
  EXPECT_NEAR(fault.value, 0.03, 1e-3);
  EXPECT_EQ(fault.last_second.column("phase")[0], static_cast<double>(Phase::Approach));
  expect_words(fault.text(),
               {"no contact at 1.", "moved 0.03", "m without contact", "allowed are 0.03 m"});
  expect_fallback(run);
  expect_rest(run);

  // A larger limit delays the fault, and an infinite one disables it.
  wanted.task.tool_limits.late_contact_travel = 0.05;
  MpcRun farther(wanted);
  ASSERT_EQ(farther.run(3.0), Status::Ok);
  EXPECT_EQ(farther.mpc().fault().kind, FaultKind::NoContact);
  EXPECT_NEAR(farther.mpc().fault().time - fault.time, 0.8, 0.1);
  wanted.task.tool_limits.late_contact_travel = infinity;
  MpcRun endless(wanted);
  ASSERT_EQ(endless.run(2.5), Status::Ok);
  EXPECT_EQ(endless.mpc().fault().kind, FaultKind::None) << endless.mpc().fault().text();
}

/// Controller that measures a robot at rest at every tick, with the torques that it commanded.
struct StillRobot {
  explicit StillRobot(const MpcCase& wanted)
      : setting(polishing::make_setting(wanted.task)),
        mpc(polishing::make_mpc(wanted.task, setting)) {
    m.q = setting.q_start;
    m.v = m.tau = Eigen::VectorXd::Zero(m.q.size());
  }
  /// Ticks until this time [s], with a measured force along the normal [N].
  void feed(double until, double force) {
    for (; m.time < until - 1e-9; m.time = 5e-4 * static_cast<double>(++ticks)) {
      set_tool_force(m, setting.robot.model, force * setting.scene.tool().surface.normal);
      m.tau = mpc.tick(m).tau;
    }
  }
  polishing::Setting setting;
  MpcController mpc;
  Measurement m;
  long ticks = 0;
};

TEST(Fault, ToolStandsStill_ReportsContactLate) {
  MpcCase wanted;
  wanted.task.tool_limits.late_contact_time = 0.2;
  // The schedule waits from 0.25 s on.
  StillRobot late(wanted);
  late.feed(0.449, 1.9);
  EXPECT_EQ(late.mpc.fault().kind, FaultKind::None) << late.mpc.fault().text();
  late.feed(0.46, 1.9);
  const FaultReport& fault = late.mpc.fault();
  ASSERT_EQ(fault.kind, FaultKind::ContactLate) << fault.text();
  EXPECT_NEAR(fault.time, 0.45, 1.1e-3);
  EXPECT_EQ(fault.limit, 0.2);
  expect_words(fault.text(),
               {"contact late at 0.4", "no contact for 0.2", "after it was due; allowed are 0.2 s",
                "the largest force was 1.9 N; contact needs 2 N"});

  // Contact just before the limit.
  StillRobot good(wanted);
  good.feed(0.449, 0.0);
  good.feed(0.5, 6.0);
  EXPECT_EQ(good.mpc.fault().kind, FaultKind::None) << good.mpc.fault().text();
}

TEST(Fault, TouchInRetreat_ReportsUnexpectedContact) {
  MpcCase wanted;
  wanted.task.polish_duration = 0.1;
  const auto pressed_until_the_retreat = [&](StillRobot& run) {
    run.feed(0.25, 0.0);
    while (run.mpc.schedule().phase() != number_of(Phase::Retreat))
      run.feed(run.m.time + 5e-4, 30.0);
    EXPECT_EQ(run.mpc.fault().kind, FaultKind::None) << run.mpc.fault().text();
    return run.m.time;
  };
  // After the tool has left the surface, a force is unexpected.
  StillRobot touches(wanted);
  double begin = pressed_until_the_retreat(touches);
  touches.feed(begin + 0.05, 30.0);
  touches.feed(begin + 0.1, 0.0);
  EXPECT_EQ(touches.mpc.fault().kind, FaultKind::None) << touches.mpc.fault().text();
  touches.feed(begin + 0.11, 20.0);
  EXPECT_EQ(touches.mpc.fault().kind, FaultKind::UnexpectedContact);
  EXPECT_EQ(touches.mpc.fault().limit, 15.0);
  EXPECT_NEAR(touches.mpc.fault().time, begin + 0.104, 1.1e-3);

  // A tool that never leaves the surface is a fault, too.
  StillRobot stuck(wanted);
  begin = pressed_until_the_retreat(stuck);
  stuck.feed(begin + 0.499, 30.0);
  EXPECT_EQ(stuck.mpc.fault().kind, FaultKind::None) << stuck.mpc.fault().text();
  stuck.feed(begin + 0.51, 30.0);
  EXPECT_EQ(stuck.mpc.fault().kind, FaultKind::UnexpectedContact);

  // In closed loop, without and with a push.
  wanted.task.polish_duration = 0.3;
  for (const double push : {0.0, -25.0}) {
    const polishing::Setting setting = polishing::make_setting(wanted.task);
    const double end = setting.track_end;
    wanted.task.disturbances.pushes = {{end + 0.3, 0.5, Eigen::Vector3d(0.0, 0.0, push)}};
    // The force sensor measures the push.
    wanted.spoil = [end, push, model = setting.robot.model](Measurement& m) {
      if (!(m.time > end + 0.3 && m.time < end + 0.8)) return;
      const Eigen::Matrix3d R_tool = frame_placement(model, m.q, "tool").linear();
      m.wrenches.col(0).head<3>() -= push * R_tool.transpose().col(2);
    };
    MpcRun run(wanted);
    ASSERT_EQ(run.run(end + 0.5), Status::Ok);
    EXPECT_EQ(run.mpc().fault().kind, push == 0.0 ? FaultKind::None : FaultKind::UnexpectedContact)
        << run.mpc().fault().text();
  }
}

TEST(Fault, TouchInReach_ReportsUnexpectedContact) {
  MpcCase wanted;
  // The tool comes from 4 cm above and meets something 2 cm above the surface.
  const polishing::Setting setting = polishing::make_setting(wanted.task);
  wanted.task.reach_duration = 0.5;
  wanted.task.clearance = 0.005;
  wanted.task.point_base =
      setting.p_start - (wanted.task.tip_radius + 0.04) * wanted.task.normal_base;
  wanted.task.disturbances.surface_height = 0.02;
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.6), Status::Ok);
  const FaultReport& fault = run.mpc().fault();
  ASSERT_EQ(fault.kind, FaultKind::UnexpectedContact) << fault.text();
  expect_report(fault, FaultKind::UnexpectedContact, fault.time, 1e-9);
  EXPECT_GT(fault.value, 15.0);
  const Trace::Column contact = run.loop().trace().column("in_contact");
  int touch = 0;
  while (contact[touch] == 0.0) ++touch;
  EXPECT_LT(fault.time - run.loop().trace().at(touch, 0), 0.01)
      << "later than the window of the mean force";
  expect_fallback(run);
  expect_rest(run);
}

TEST(Fault, BouncesInRetreat_ReportsNoFault) {
  MpcCase wanted;
  wanted.task.polish_duration = 0.1;
  StillRobot bounces(wanted);
  bounces.feed(0.25, 0.0);
  while (bounces.mpc.schedule().phase() != number_of(Phase::Retreat))
    bounces.feed(bounces.m.time + 5e-4, 30.0);
  // Late torques shake a tool like this: off for 16 ms, on for 8 ms, until it is away.
  for (int i = 0; i < 4; ++i) {
    bounces.feed(bounces.m.time + 0.016, 0.0);
    bounces.feed(bounces.m.time + 0.008, 20.0);
  }
  bounces.feed(bounces.m.time + 0.1, 0.0);
  EXPECT_EQ(bounces.mpc.fault().kind, FaultKind::None) << bounces.mpc.fault().text();
}

TEST(Fault, LateTorques_ReportsTheDelayAndNoMotorFault) {
  for (const double delay : {9e-3, 12e-3}) {
    MpcCase wanted;
    wanted.task.model_error.transient_scale = 6.0;
    wanted.task.disturbances.command_delay = delay;
    MpcRun run(wanted);
    ASSERT_EQ(run.polish(), Status::Ok);
    const FaultReport& fault = run.mpc().fault();
    EXPECT_NE(fault.kind, FaultKind::None) << delay;
    EXPECT_NE(fault.kind, FaultKind::MotorLost) << fault.text();
    EXPECT_NE(fault.kind, FaultKind::UnexpectedContact) << fault.text();
    const std::string late = std::to_string(std::lround(1e3 * delay));
    expect_words(fault.text(), {"follow commands " + late + " ms late"});
  }
}

/// Delays of commands and measurements [s]; the controller is configured with a fraction of them.
MpcCase late(double fraction, double command, double measurement) {
  MpcCase wanted;
  wanted.task.disturbances = disturbance_preset("mismatch");
  wanted.task.disturbances.command_delay = command;
  wanted.task.disturbances.measurement_delay = measurement;
  wanted.task.command_delay = fraction * command;
  wanted.task.measurement_delay = fraction * measurement;
  return wanted;
}

TEST(LoopDelay, EightMilliseconds_PolishesIfConfiguredElseFaults) {
  for (const auto& [command, measurement] : {std::pair(8e-3, 0.0), {0.0, 8e-3}, {5e-3, 3e-3}}) {
    SCOPED_TRACE(std::to_string(command) + " s, " + std::to_string(measurement) + " s");
    MpcRun configured(late(1.0, command, measurement));
    ASSERT_EQ(configured.polish(), Status::Ok);
    EXPECT_EQ(configured.mpc().fault().kind, FaultKind::None) << configured.mpc().fault().text();
    EXPECT_LT(configured.metrics().force_rmse, 0.6);
    EXPECT_LT(configured.metrics().position_rmse, 0.5e-3);
    EXPECT_EQ(configured.watched().allocations, 0);
    MpcRun not_configured(late(0.0, command, measurement));
    ASSERT_EQ(not_configured.polish(), Status::Ok);
    EXPECT_NE(not_configured.mpc().fault().kind, FaultKind::None);
  }
}

/// Force sensor with noise, white or low-pass filtered.
MpcCase noisy(double deviation, double cutoff) {
  MpcCase wanted;
  wanted.task.disturbances.force_noise = deviation;
  wanted.task.disturbances.force_cutoff = cutoff;
  wanted.task.model_error.bandwidth = 30.0;
  return wanted;
}

TEST(Fault, NoisyForceSensor_ReportsNoFault) {
  for (const double deviation : {2.0, 4.0})
    for (const double cutoff : {0.0, 314.0})
      for (const std::uint64_t seed : {1, 2, 3}) {
        SCOPED_TRACE(std::to_string(deviation) + " N, " + std::to_string(cutoff) + " rad/s");
        MpcCase wanted = noisy(deviation, cutoff);
        wanted.task.disturbances.seed = seed;
        // A longer approach, in which the detector could mistake noise for a touch.
        wanted.task.clearance = 0.02;
        wanted.task.polish_duration = 0.3;
        MpcRun run(wanted);
        ASSERT_EQ(run.polish_and_retreat(), Status::Ok);
        EXPECT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
        // The ramp begins at the touch, not earlier.
        const Trace& trace = run.loop().trace();
        const Trace::Column phase = trace.column("phase"), contact = trace.column("in_contact");
        int touch = 0, ramp = 0;
        while (contact[touch] == 0.0) ++touch;
        while (phase[ramp] < static_cast<double>(Phase::Ramp)) ++ramp;
        EXPECT_GE(ramp, touch);
        EXPECT_LE(ramp - touch, 40) << "20 ms";
      }
}

TEST(Fault, SurfaceVanishesInNoise_ReportsContactLost) {
  MpcCase wanted = noisy(2.0, 0.0);
  wanted.make_plant = [](const Model& model, const SceneSpec& scene) {
    return std::make_unique<VanishingSurfacePlant>(model, scene, 0.8);
  };
  MpcRun run(wanted);
  ASSERT_EQ(run.polish(), Status::Ok);
  expect_report(run.mpc().fault(), FaultKind::ContactLost, 0.953, 6e-3);
}

}  // namespace
}  // namespace burnish::test
