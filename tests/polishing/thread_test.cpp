// Planning in a thread of its own while the controller ticks.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include "support/mpc_run.hpp"

namespace burnish::test {
namespace {

/// Run with a planning thread in real time, or somewhat slower, as on a robot.
MpcCase with_planning_thread() {
  MpcCase wanted;
  wanted.task.timing = PlanTiming::Thread;
  wanted.task.tick_rate = 1000.0;
  wanted.spoil = [](Measurement&) { std::this_thread::sleep_for(std::chrono::milliseconds(1)); };
  return wanted;
}

int plans_made(MpcRun& run) {
  return static_cast<int>((run.loop().trace().column("solve_time").array() > 0.0).count());
}

void expect_fault_free(MpcRun& run) {
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
}

/// Runs until the first plan is in use, for at most 20 s (slow machines).
void await_plan(MpcRun& run) {
  for (int tick = 0; tick < 20000 && !std::isfinite(run.mpc().plan_age()); ++tick) {
    ASSERT_EQ(run.run(1e-3), Status::Ok);
  }
}

TEST(PlanningThread, TickingController_GetsNewPlans) {
  MpcRun run(with_planning_thread());
  ASSERT_EQ(run.run(0.3), Status::Ok);
  expect_fault_free(run);
  EXPECT_GE(plans_made(run), 2);
  EXPECT_EQ(run.watched().allocations, 0);
  EXPECT_TRUE(run.watched().finite);
  run.reset();  // possibly while the thread makes a plan
  ASSERT_EQ(run.run(0.05), Status::Ok);
  expect_fault_free(run);
}

TEST(PlanningThread, FirstPlanLate_RobotStaysAtItsStart) {
  std::atomic<bool> may_end = false;
  MpcCase wanted = with_planning_thread();
  wanted.change = [&](MpcSpec& spec) {
    spec.solver.callback = [&](const DdpProgress&) {
      for (int i = 0; i < 5000 && !may_end; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      return true;
    };
  };
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.05), Status::Ok);  // no tick waits for the plan
  EXPECT_EQ(run.watched().ticks, 50);
  EXPECT_EQ(plans_made(run), 0);
  EXPECT_TRUE(std::isinf(run.mpc().plan_age()));
  EXPECT_LE(run.mpc().schedule().time(), 1e-3);
  EXPECT_LT((run.plant().q() - run.setting().q_start).norm(), 1e-6);
  may_end = true;
  await_plan(run);
  EXPECT_LE(run.mpc().schedule().time(), 2e-3);
  ASSERT_EQ(run.run(0.1), Status::Ok);
  EXPECT_GT(run.mpc().schedule().time(), 0.09);
  EXPECT_LT(run.mpc().plan_age(), 0.1);
  expect_fault_free(run);
}

TEST(PlanningThread, ChangingPayload_CommandsStayFinite) {
  MpcRun run(with_planning_thread());
  InertiaSpec payload;
  payload.mass = 0.5;
  for (int i = 0; i < 5; ++i) {
    ASSERT_EQ(run.run(0.02), Status::Ok);
    payload.mass += 0.01;
    EXPECT_EQ(run.mpc().set_payload("tool", payload), Status::Ok);
  }
  EXPECT_TRUE(run.watched().finite);
}

TEST(PlanningThread, Planning_AllocatesNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  std::atomic<long> allocated = 0;
  MpcCase wanted = with_planning_thread();
  wanted.change = [&](MpcSpec& spec) {
    spec.solver.callback = [&](const DdpProgress&) {  // called in the planning thread
      thread_local const AllocationGuard since_first;
      allocated = since_first.count();
      return true;
    };
  };
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.3), Status::Ok);
  expect_fault_free(run);
  EXPECT_GE(plans_made(run), 2);
  EXPECT_EQ(allocated.load(), 0);
}

}  // namespace
}  // namespace burnish::test
