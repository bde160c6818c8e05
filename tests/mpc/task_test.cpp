// Tests of a controller with a toy task: calls of the task, and when plans begin and end.
#include "burnish/mpc/task.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include "burnish/mpc/mpc.hpp"
#include "support/allocation_guard.hpp"
#include "support/refusal.hpp"
#include "support/toy_task.hpp"

namespace burnish::test {
namespace {

using testing::expect_words;
using testing::refusal;

struct ToyController {
  explicit ToyController(const std::function<void(MpcSpec&)>& change = nullptr) {
    MpcSpec spec = toy_spec(toy);
    if (change) change(spec);
    m = toy_measurement(spec);
    mpc = std::make_unique<MpcController>(spec);
  }
  /// Ticks until this time with the robot at rest.
  const Command& tick_to(double time) {
    const Command* command = nullptr;
    for (; m.time < time - 1e-9; m.time = 1e-3 * ++ticks) command = &mpc->tick(m);
    return command != nullptr ? *command : mpc->tick(m);
  }
  void reset() {
    mpc->reset();
    ticks = 0;
    m.time = 0.0;
  }
  std::shared_ptr<Toy> toy = std::make_shared<Toy>();
  std::unique_ptr<MpcController> mpc;
  Measurement m;
  int ticks = 0;
};

TEST(MpcTask, Event_EndsOnlyThePhaseThatWaitsForIt) {
  ToyController run;
  EXPECT_EQ(run.tick_to(0.015).phase, 0);
  run.toy->rings = true;  // the schedule does not wait for it yet
  run.tick_to(0.019);
  EXPECT_EQ(run.mpc->schedule().phase(), 0);
  run.toy->rings = false;
  EXPECT_EQ(run.tick_to(0.2).phase, 1);
  EXPECT_TRUE(run.mpc->schedule().waits());
  EXPECT_DOUBLE_EQ(run.mpc->schedule().time(), 0.04);
  // The next stage is within the horizon of the plan.
  EXPECT_GT(std::abs(run.mpc->plan()(6, 1) - run.m.q[1]), 1e-3);
  run.toy->rings = true;
  EXPECT_EQ(run.tick_to(0.202).phase, 2);
  EXPECT_EQ(run.mpc->fault().kind, FaultKind::None) << run.mpc->fault().text();
}

TEST(MpcTask, ValidMeasurement_CallsTheTaskOncePerTick) {
  ToyController run;
  run.tick_to(0.01);
  EXPECT_EQ(run.toy->senses, 10);
  EXPECT_EQ(run.toy->watches, 10);
  run.m.q[0] = std::nan("");
  run.tick_to(0.013);
  EXPECT_EQ(run.toy->senses, 10);
  run.m.q = arm7::ready();
  run.tick_to(0.014);
  EXPECT_EQ(run.toy->senses, 11);
  EXPECT_NEAR(run.toy->dt, 4e-3, 1e-12) << "dt must include the bridged ticks";
  run.mpc->reset();
  EXPECT_EQ(run.toy->resets, 1);
}

TEST(MpcTask, QuantityBeyondItsLimit_IsAFaultWithItsName) {
  ToyController run;
  run.toy->heat = 1.0;
  run.toy->sway = std::nan("");
  run.tick_to(0.005);
  EXPECT_EQ(run.mpc->fault().kind, FaultKind::None) << "the limit itself is allowed";
  run.toy->heat = 1.25;
  run.toy->sway = 7.0;
  const AllocationGuard guard;
  run.tick_to(0.006);
  if (AllocationGuard::unavailable() == nullptr) {
    EXPECT_EQ(guard.count(), 0);
  }
  const FaultReport& fault = run.mpc->fault();
  EXPECT_EQ(fault.kind, FaultKind::Watched);
  EXPECT_EQ(fault.value, 1.25);
  EXPECT_EQ(fault.limit, 1.0);
  expect_words(fault.text(), {"beyond a limit at 0.0050 s", "1.25; allowed is 1", "(heat, K)"});
  EXPECT_EQ(fault.last_second.rows(), 6);

  ToyController named;
  named.toy->sway = 2.0;
  named.tick_to(0.001);
  EXPECT_EQ(named.mpc->fault().kind, FaultKind::SpeedLimit);
  EXPECT_EQ(named.mpc->fault().quantity, "");
  named.mpc->reset();
  EXPECT_EQ(named.mpc->fault().text(), "no fault");
}

TEST(MpcTask, Aim_SetsTheTargetsAtTheScheduleTime) {
  ToyController run;
  run.toy->aim = [](double time, Command& command) {
    if (time > 0.01) throw std::runtime_error("no aim");
    command.tools[0].target_force = 100.0 * time;
    command.tools[0].p_target_world.x() = time;
  };
  const Command& command = run.tick_to(0.006);
  EXPECT_DOUBLE_EQ(command.tools[0].target_force, 0.5);
  EXPECT_DOUBLE_EQ(command.tools[0].p_target_world.x(), 0.005);
  EXPECT_NE(run.tick_to(0.013).status, Status::Ok);
  EXPECT_EQ(run.mpc->fault().kind, FaultKind::None) << "targets are only recorded";
  EXPECT_THROW(std::rethrow_exception(run.mpc->take_exception()), std::runtime_error);
}

TEST(MpcTask, Signals_AreTheEstimatesAndThenThoseOfTheTask) {
  ToyController run([](MpcSpec& spec) { spec.model_error.kind = ModelErrorKind::Torque; });
  run.toy->heat = 0.4;
  run.m.tau[2] += 5.0;
  run.tick_to(0.1);
  const std::vector<TraceColumn> signals = run.mpc->signals();
  const Eigen::VectorXd& error = run.mpc->torque_error();
  ASSERT_EQ(signals.size(), static_cast<std::size_t>(error.size()) + 1);
  std::vector<double> values(signals.size());
  {
    const AllocationGuard guard;
    run.mpc->write_signals(values);
  }
  EXPECT_EQ(signals[2].name, "torque_error_" + run.mpc->problem().model().v_name(2));
  EXPECT_EQ(signals[2].unit, "Nm");
  EXPECT_NE(error.norm(), 0.0);
  EXPECT_EQ(Eigen::Map<Eigen::VectorXd>(values.data(), error.size()), error);
  EXPECT_EQ(signals.back().name, "heat");
  EXPECT_EQ(signals.back().unit, "K");
  EXPECT_EQ(values.back(), 0.4);
}

TEST(MpcTask, NoTask_RunsTheScheduleByTime) {
  MpcSpec spec = toy_spec();
  MpcController mpc(spec);
  Measurement m = toy_measurement(spec);
  for (int tick = 0; tick < 100; ++tick, m.time = 1e-3 * tick) mpc.tick(m);
  EXPECT_EQ(mpc.fault().kind, FaultKind::None) << mpc.fault().text();
  EXPECT_EQ(mpc.tick(m).phase, 2);
  EXPECT_EQ(mpc.tick(m).tools[0].target_force, 0.0);
}

TEST(MpcPlans, SettleTime_EndsWithTheFirstPlan) {
  ToyController run([](MpcSpec& spec) { spec.settle = 0.01; });
  run.tick_to(0.01);  // the last tick is at 0.009 s
  EXPECT_TRUE(std::isinf(run.mpc->plan_age()));
  EXPECT_EQ(run.toy->senses, 0);
  EXPECT_GT(run.tick_to(0.011).iterations, 0);
  EXPECT_EQ(run.mpc->plan_age(), 0.0);
  EXPECT_EQ(run.mpc->fault().kind, FaultKind::None) << run.mpc->fault().text();
}

TEST(MpcPlans, FaultWhileAPlanIsFollowed_StopsPlansUntilReset) {
  ToyController run;
  const Command first = run.tick_to(0.001);
  EXPECT_GT(first.iterations, 0);
  run.tick_to(0.01);
  run.toy->heat = 2.0;
  EXPECT_EQ(run.tick_to(0.011).iterations, 0) << "a plan is due, but the fault comes first";
  run.toy->heat = 0.0;
  for (int tick = 0; tick < 20; ++tick)
    EXPECT_EQ(run.tick_to(run.m.time + 1e-3).iterations, 0) << tick;
  EXPECT_EQ(run.mpc->fault().kind, FaultKind::Watched);
  run.reset();
  const Command again = run.tick_to(0.001);
  EXPECT_EQ(run.mpc->fault().kind, FaultKind::None);
  EXPECT_EQ(again.iterations, first.iterations);
  EXPECT_EQ(again.tau, first.tau);
}

TEST(MpcPlans, FaultWhileAThreadPlans_PlanIsDroppedUntilReset) {
  std::atomic<bool> may_end = false;
  ToyController run([&](MpcSpec& spec) {
    spec.timing = PlanTiming::Thread;
    spec.solver.callback = [&](const DdpProgress&) {
      may_end.wait(false);
      return true;
    };
  });
  run.tick_to(0.003);
  run.toy->heat = 2.0;
  run.tick_to(0.004);
  run.toy->heat = 0.0;
  EXPECT_EQ(run.mpc->fault().kind, FaultKind::Watched);
  may_end = true;
  may_end.notify_all();
  run.tick_to(0.05);
  EXPECT_TRUE(std::isinf(run.mpc->plan_age()));
  run.reset();  // possibly while the thread makes the plan
  for (int tick = 0; tick < 20000 && std::isinf(run.mpc->plan_age()); ++tick) {
    run.tick_to(run.m.time + 1e-3);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_TRUE(std::isfinite(run.mpc->plan_age()));
  EXPECT_EQ(run.mpc->fault().kind, FaultKind::None) << run.mpc->fault().text();
}

TEST(MpcTask, ScheduleWithUnknownEvent_IsRefused) {
  const auto with = [](const std::function<void(MpcSpec&)>& change) {
    return refusal([&] { ToyController{change}; });
  };
  expect_words(with([](MpcSpec& s) { s.schedule[1].until = "bel"; }),
               {"phase 1", "'bel'", "not an event of its task", "bell"});
  expect_words(with([](MpcSpec& s) { s.task = nullptr; }), {"phase 1", "'bell'"});
  expect_words(with([](MpcSpec& s) { s.task = [](const MpcSpec&) { return nullptr; }; }),
               {"returned no task"});
}

TEST(MpcSpec, ToolsThatDoNotFit_AreRefused) {
  const auto with = [](const std::function<void(MpcSpec&)>& change) {
    return refusal([&] { ToyController{change}; });
  };
  expect_words(with([](MpcSpec& s) { s.tools[0].contact_threshold = -1.0; }),
               {"tool 'tool'", "contact_threshold", "-1"});
  expect_words(with([](MpcSpec& s) { s.tools[0].base = "tol"; }),
               {"tool 'tool'", "surface of 'tol'", "did you mean 'tool'"});
  expect_words(with([](MpcSpec& s) {
                 s.tools.clear();
                 s.problem.contacts = {{.name = "pad", .tool = "tool"}};
                 s.problem.stages[1].contacts = {"pad"};
               }),
               {"contact 'pad' of stage 'wave'", "tool at frame 'tool'", "'pad' in supports"});
  expect_words(with([](MpcSpec& s) { s.tools.push_back(s.tools[0]); }),
               {"tools has two entries for frame 'tool'"});
  expect_words(with([](MpcSpec& s) {
                 s.model_error.kind = ModelErrorKind::Torque;
                 s.tools.push_back({.frame = "link_3"});
                 s.touches = {{"link_3", WrenchSensor::None}};
               }),
               {"tool 'link_3' has no force sensor", "each of the 2 tools"});
}

TEST(MpcSpec, PlansThatNeedThePreviousStep_AreRefused) {
  const auto with = [](const std::function<void(MpcSpec&)>& change) {
    return refusal([&] { ToyController{change}; });
  };
  expect_words(with([](MpcSpec& s) { s.problem.torque_model = TorqueModel::held(); }),
               {"torque model 'held'", "at every tick", "wanted a torque model with a cut-off"});
  expect_words(with([](MpcSpec& s) { s.problem.force_states = {"pad"}; }),
               {"forces of the previous step", "shorter than steps", "no force_states"});
}

}  // namespace
}  // namespace burnish::test
