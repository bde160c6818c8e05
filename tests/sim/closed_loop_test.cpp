// Tests of the loop around plant and controller: records, timing, repeatability, refusals.
#include "burnish/sim/closed_loop.hpp"

#include <gtest/gtest.h>

#include "burnish/sim/ideal_plant.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"
#include "support/allocation_guard.hpp"
#include "support/biped.hpp"
#include "support/constant_torque.hpp"
#include "support/polishing_run.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

std::unique_ptr<Plant> ideal(const Model& model, const SceneSpec& scene) {
  return make_ideal_plant(model, scene);
}

PolishingCase noisy_case() {
  PolishingCase result;
  result.friction = 0.3;
  result.ki = 10.0;
  result.disturbances = sensor_noise(1.05);
  return result;
}

TEST(ClosedLoop, PolishingRun_ApproachesTouchesRampsAndTracks) {
  PolishingCase setup;
  setup.ki = 10.0;
  setup.clearance = 5e-3;
  PolishingRun run(setup, ideal);
  ASSERT_EQ(run.run(2.0), Status::Ok);
  const Trace& trace = run.loop().trace();
  ASSERT_EQ(trace.rows(), 4000);
  EXPECT_EQ(trace.columns().front().name, "time");
  EXPECT_EQ(trace.columns()[static_cast<std::size_t>(trace.index("tool_force_z_world"))].unit, "N");
  EXPECT_EQ(trace.at(0, trace.index("time")), 0.0);
  EXPECT_NEAR(trace.at(3999, 0), 2.0 - 5e-4, 1e-9);
  const Trace::Column phase = trace.column("phase"), in_contact = trace.column("in_contact");
  EXPECT_EQ(phase[0], static_cast<double>(Phase::Approach));
  EXPECT_EQ(phase[3999], static_cast<double>(Phase::Track));
  EXPECT_EQ(in_contact[0], 0.0);
  EXPECT_EQ(in_contact[3999], 1.0);
  for (int row = 1; row < trace.rows(); ++row) ASSERT_GE(phase[row], phase[row - 1]);
  EXPECT_NEAR(trace.column("tool_force_z_world")[3999], 30.0, 0.1);
  EXPECT_EQ(trace.dropped(), 0);
}

/// Zero torque, with two signals: the number of ticks, and the time of the last tick.
class CountingTicks final : public Controller {
 public:
  explicit CountingTicks(int nv) { command_.tau.setZero(nv); }
  int nv() const override { return static_cast<int>(command_.tau.size()); }
  std::vector<TraceColumn> signals() const override {
    return {{"ticks", "-"}, {"ticked_at", "s"}, {"unwritten", "m"}};
  }
  void write_signals(std::span<double> values) const noexcept override {
    values[0] = ticks_;
    values[1] = time_;
  }
  void reset() noexcept override { ticks_ = 0; }
  const Command& tick(const Measurement& m) noexcept override {
    ++ticks_;
    time_ = m.time;
    return command_;
  }

 private:
  Command command_;
  int ticks_ = 0;
  double time_ = 0.0;
};

TEST(ClosedLoop, SignalsOfTheController_AreColumnsOfTheTrace) {
  const Model& model = right_arm();
  const std::unique_ptr<Plant> plant = ideal(model, SceneSpec{});
  CountingTicks counting(model.nv);
  ControllerWrapper controller(counting);
  ClosedLoop loop(*plant, controller, {}, {.control_period = 2.0 * plant->dt()});
  ASSERT_EQ(loop.reset(plant->q(), plant->v()), Status::Ok);
  for (int i = 0; i < 6; ++i) ASSERT_EQ(loop.step(), Status::Ok);
  const Trace& trace = loop.trace();
  const int last = trace.index("signal_ticked_at");
  EXPECT_EQ(trace.columns()[static_cast<std::size_t>(last)].unit, "s");
  for (int row = 0; row < 6; ++row) {
    EXPECT_EQ(trace.column("signal_ticks")[row], 1 + row / 2);
    EXPECT_NEAR(trace.at(row, last), (row - row % 2) * plant->dt(), 1e-12);
    EXPECT_TRUE(std::isnan(trace.column("signal_unwritten")[row]));
  }
}

TEST(ClosedLoop, BetweenTicks_TheTorqueIsConstant) {
  PolishingRun run({}, ideal);
  ASSERT_EQ(run.run(0.05), Status::Ok);
  const Trace& trace = run.loop().trace();
  const Trace::Column tick = trace.column("tick");
  const Trace::Column tau = trace.column("tau_command_" + right_arm().v_name(3));
  int ticks = 0;
  for (int row = 1; row < trace.rows(); ++row) {
    if (tick[row] == 0.0) {
      EXPECT_EQ(tau[row], tau[row - 1]);
    }
    ticks += tick[row] != 0.0 ? 1 : 0;
  }
  EXPECT_EQ(ticks, 49);
}

TEST(ClosedLoop, SameSeed_GivesTheSameBits) {
  PolishingCase setup = noisy_case();
  PolishingRun once(setup, ideal), again(setup, ideal);
  ASSERT_EQ(once.run(0.5), Status::Ok);
  ASSERT_EQ(again.run(0.5), Status::Ok);
  const auto last_row = [](PolishingRun& run) {
    const Trace& trace = run.loop().trace();
    Eigen::VectorXd row(static_cast<Eigen::Index>(trace.columns().size()));
    for (Eigen::Index i = 0; i < row.size(); ++i)
      row[i] = trace.at(trace.rows() - 1, static_cast<int>(i));
    return row;
  };
  const Eigen::VectorXd first = last_row(once);
  EXPECT_EQ(first, last_row(again));

  // The same bits come again after a reset.
  ASSERT_EQ(again.loop().reset(again.start(), Eigen::VectorXd::Zero(again.controller().nv())),
            Status::Ok);
  EXPECT_EQ(again.loop().trace().rows(), 0);
  ASSERT_EQ(again.run(0.5), Status::Ok);
  EXPECT_EQ(first, last_row(again));

  setup.disturbances.seed = 8;
  PolishingRun other(setup, ideal);
  ASSERT_EQ(other.run(0.5), Status::Ok);
  EXPECT_NE(first, last_row(other));
}

TEST(ClosedLoop, Push_ActsOnTheToolAtItsTime) {
  PolishingCase setup;
  setup.ki = 10.0;
  setup.disturbances.pushes = {{1.2, 0.1, {0.0, 10.0, 0.0}}};
  PolishingRun pushed(setup, ideal);
  ASSERT_EQ(pushed.run(1.3), Status::Ok);
  const Trace& trace = pushed.loop().trace();
  const Trace::Column push = trace.column("push_y_world"), y = trace.column("tool_y_world");
  EXPECT_EQ(push[2399], 0.0);
  EXPECT_EQ(push[2400], 10.0);
  EXPECT_GT(y[2599] - y[2399], 1e-3);
}

/// The pushes of a robot without a tool act for their durations, and add up.
TEST(ClosedLoop, OverlappingPushes_ActForTheirDurationsAndAddUp) {
  const Model model = right_arm();
  const Eigen::Vector3d first(1.0, 0.0, 0.0), second(0.0, 2.0, 0.0);
  const auto plant = make_ideal_plant(model, {});
  const auto reference = make_ideal_plant(model, {});
  ConstantTorque limp = no_torque(model);
  Disturbances disturbances;
  disturbances.pushes = {{0.01, 0.005, first, "tool"}, {0.012, 0.01, second, "tool"}};
  ClosedLoop loop(*plant, limp, disturbances);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.nv);
  ASSERT_EQ(loop.reset(model.q_neutral, rest), Status::Ok);
  ASSERT_EQ(reference->reset(model.q_neutral, rest), Status::Ok);
  RigidBody body(model);
  for (int step = 0; step < 50; ++step) {
    const Eigen::Vector3d push = (step >= 20 && step < 30 ? first : Eigen::Vector3d::Zero()) +
                                 (step >= 24 && step < 44 ? second : Eigen::Vector3d::Zero());
    ASSERT_EQ(body.update(reference->q(), reference->v()), Status::Ok);
    ASSERT_LE(reference->step(torque_of_force(body, "tool", push)), Status::NotConverged);
    ASSERT_LE(loop.step(), Status::NotConverged);
    const Trace& trace = loop.trace();
    const int column = trace.index("push_x_world");
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(trace.at(step, column + axis), push[axis]) << "step " << step;
    }
    ASSERT_LE((plant->v() - reference->v()).norm(), 1e-12) << "step " << step;
  }
}

TEST(ClosedLoop, Hoist_CarriesTheRobotUntilItReleases) {
  const Model model = biped::model(Base::FreeFlyer);
  const auto plant = make_ideal_plant(model, {.hoist = {.frame = "pelvis", .duration = 0.4}});
  ConstantTorque limp = no_torque(model);
  ClosedLoop loop(*plant, limp, {});
  ASSERT_EQ(loop.reset(biped::half_sitting(model), Eigen::VectorXd::Zero(model.nv)), Status::Ok);
  const double height = plant->q()[2];
  ASSERT_LE(loop.run(0.2), Status::NotConverged);
  EXPECT_NEAR(plant->q()[2], height, 0.01);
  EXPECT_NEAR(plant->q()[6], 1.0, 0.01);  // the base is upright
  ASSERT_LE(loop.run(0.4), Status::NotConverged);
  EXPECT_LT(plant->q()[2], height - 0.1);
}

TEST(ClosedLoop, RobotWithoutATool_RecordsNone) {
  const Model model = right_arm();
  const auto plant = make_ideal_plant(model, {});
  ConstantTorque limp = no_torque(model);
  Disturbances disturbances = disturbance_preset("sensors");
  ClosedLoop loop(*plant, limp, disturbances);
  ASSERT_EQ(loop.reset(model.q_neutral, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
  ASSERT_EQ(loop.run(0.01), Status::Ok);
  for (const TraceColumn& column : loop.trace().columns())
    EXPECT_TRUE(column.name.find("tool") == std::string::npos &&
                column.name.find("contact") == std::string::npos)
        << column.name;
  EXPECT_TRUE(loop.trace().has("target_x_world"));
  disturbances.pushes = {{1.0, 0.1, {0.0, 10.0, 0.0}}};
  testing::expect_words(testing::refusal([&] { ClosedLoop(*plant, limp, disturbances); }),
                        {"push at 1 s states no frame", "no tool"});
  disturbances.pushes[0].frame = "tool";
  EXPECT_EQ(testing::refusal([&] { ClosedLoop(*plant, limp, disturbances); }), "");
}

TEST(HoistSpec, LoadFraction_FallsInTheSecondHalf) {
  const HoistSpec hoist{"pelvis", 2.0};
  EXPECT_EQ(hoist.load_fraction(0.0), 1.0);
  EXPECT_EQ(hoist.load_fraction(1.0), 1.0);
  EXPECT_NEAR(hoist.load_fraction(1.5), 0.5, 1e-12);
  EXPECT_EQ(hoist.load_fraction(2.0), 0.0);
  EXPECT_EQ(HoistSpec{}.load_fraction(0.0), 0.0);
}

TEST(ClosedLoop, FirstCommand_StartsTheMotorsAtItsTorque) {
  PolishingCase setup;
  setup.disturbances.torque_cutoff = 50.0;
  setup.disturbances.command_delay = 5e-3;
  PolishingRun run(setup, ideal);
  ASSERT_EQ(run.loop().step(), Status::Ok);
  EXPECT_EQ(run.loop().actuation().step().applied, run.loop().command().tau);
  EXPECT_GT(run.loop().command().tau.norm(), 1.0);
}

TEST(ClosedLoop, StepWithAllDisturbances_AllocatesNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  PolishingCase setup = noisy_case();
  setup.disturbances.torque_cutoff = 300.0;
  setup.disturbances.torque_scale_range = 0.05;
  setup.disturbances.joint_coulomb = 0.5;
  setup.disturbances.joint_viscous = 0.5;
  setup.disturbances.position_noise = 1e-5;
  setup.disturbances.velocity_noise = 1e-4;
  setup.disturbances.torque_sensor_noise = 0.01;
  setup.disturbances.pushes = {{0.1, 0.1, {1.0, 0.0, 0.0}}};
  PolishingRun run(setup, ideal);
  const AllocationGuard guard;
  const Status status = run.run(0.8);
  EXPECT_EQ(guard.count(), 0);
  EXPECT_EQ(status, Status::Ok);
  EXPECT_EQ(run.loop().command().phase, number_of(Phase::Track));
}

TEST(ClosedLoop, InvalidOptions_AreRefused) {
  Eigen::VectorXd q;
  const Model model = right_arm(&q);
  PolishingRun run({}, ideal);
  ClosedLoopOptions options;
  options.control_period = 7e-4;
  testing::expect_words(
      testing::refusal([&] { ClosedLoop(run.plant(), run.controller(), {}, options); }),
      {"control period", "0.0007", "0.0005"});
  options = {};
  options.record_every = 0;
  testing::expect_words(
      testing::refusal([&] { ClosedLoop(run.plant(), run.controller(), {}, options); }),
      {"record_every"});
  ImpedanceSpec spec;
  spec.path.posture = q;
  testing::expect_words(testing::refusal([&] { make_impedance_controller(model, spec); }),
                        {"task is empty"});
  spec.path.task = [](double) { return TaskPoint{}; };
  spec.path.tool = "tol";
  testing::expect_words(testing::refusal([&] { make_impedance_controller(model, spec); }),
                        {"'tol'", "tool"});
  spec.path.tool = "tool";
  spec.gains.ki = -1.0;
  testing::expect_words(testing::refusal([&] { make_impedance_controller(model, spec); }),
                        {"ki", "-1"});
}

TEST(ImpedanceController, InvalidMeasurement_ReturnsAStatusAndTheLastTorque) {
  PolishingRun run({}, ideal);
  ASSERT_EQ(run.run(0.1), Status::Ok);
  Measurement bad = run.loop().measurement();
  const Eigen::VectorXd before = run.controller().tick(bad).tau;
  bad.v[1] = std::nan("");
  EXPECT_EQ(run.controller().tick(bad).status, Status::NotFinite);
  EXPECT_EQ(run.controller().tick(bad).tau, before);
  bad.v = Eigen::VectorXd::Zero(2);
  EXPECT_EQ(run.controller().tick(bad).status, Status::WrongSize);
}

TEST(CirclePath, Derivatives_MatchThePosition) {
  CirclePath circle;
  circle.normal_world = {-1.0, 0.0, 1.0};
  circle.center_world = {0.3, -0.4, 1.0};
  const double h = 1e-4;
  for (const double t : {0.3, 1.0, 1.9, 2.5, 5.0}) {
    const TaskPoint at = circle.at(t), before = circle.at(t - h), after = circle.at(t + h);
    EXPECT_LE((at.v_world - (after.p_world - before.p_world) / (2.0 * h)).norm(), 1e-8);
    EXPECT_LE((at.a_world - (after.v_world - before.v_world) / (2.0 * h)).norm(), 1e-8);
    EXPECT_NEAR(circle.normal_world.dot(at.p_world - circle.center_world), 0.0, 1e-15);
  }
  EXPECT_NEAR((circle.at(4.0).p_world - circle.center_world).norm(), 0.07, 1e-15);
  EXPECT_EQ(circle.at(-1.0).p_world, circle.center_world);
  EXPECT_TRUE(circle.at(0.0).v_world.isZero(0.0));
}

}  // namespace
}  // namespace burnish::test
