// Tests of the state machine of an MpcController: one test for each transition.
#include "mpc/plan_life.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace burnish::test {
namespace {

using LifeState = PlanLife::State;

/// Returns a new state machine after the events that lead to `state`.
PlanLife life_in(LifeState state) {
  PlanLife life;
  switch (state) {
    case LifeState::Settling:
      break;
    case LifeState::FirstPlan:
      life.begin();
      break;
    case LifeState::Following:
      life = life_in(LifeState::FirstPlan);
      life.finish(true);
      break;
    case LifeState::FollowingWhileMaking:
      life = life_in(LifeState::Following);
      life.begin();
      break;
    case LifeState::Faulted:
      life.raise_fault();
      break;
    case LifeState::FaultedWhileMaking:
      life = life_in(LifeState::FirstPlan);
      life.raise_fault();
      break;
  }
  EXPECT_EQ(life.state(), state);
  return life;
}

LifeState after_begin(LifeState state) {
  PlanLife life = life_in(state);
  life.begin();
  return life.state();
}

LifeState after_finish(LifeState state, bool usable) {
  PlanLife life = life_in(state);
  life.finish(usable);
  return life.state();
}

LifeState after_fault(LifeState state) {
  PlanLife life = life_in(state);
  life.raise_fault();
  return life.state();
}

constexpr LifeState all_states[] = {LifeState::Settling,  LifeState::FirstPlan,
                                    LifeState::Following, LifeState::FollowingWhileMaking,
                                    LifeState::Faulted,   LifeState::FaultedWhileMaking};

TEST(PlanLife, New_IsSettling) { EXPECT_EQ(PlanLife().state(), LifeState::Settling); }

TEST(PlanLife, BeginWhileSettling_MakesTheFirstPlan) {
  EXPECT_EQ(after_begin(LifeState::Settling), LifeState::FirstPlan);
}

TEST(PlanLife, FirstPlanUsable_IsFollowed) {
  EXPECT_EQ(after_finish(LifeState::FirstPlan, true), LifeState::Following);
}

TEST(PlanLife, FirstPlanUnusable_IsAFault) {
  EXPECT_EQ(after_finish(LifeState::FirstPlan, false), LifeState::Faulted);
}

TEST(PlanLife, BeginWhileFollowing_KeepsFollowing) {
  EXPECT_EQ(after_begin(LifeState::Following), LifeState::FollowingWhileMaking);
}

TEST(PlanLife, NextPlanUsable_IsFollowed) {
  EXPECT_EQ(after_finish(LifeState::FollowingWhileMaking, true), LifeState::Following);
}

TEST(PlanLife, NextPlanUnusable_PreviousPlanIsFollowed) {
  EXPECT_EQ(after_finish(LifeState::FollowingWhileMaking, false), LifeState::Following);
}

TEST(PlanLife, FaultWithoutComputation_IsFaulted) {
  for (const LifeState state : {LifeState::Settling, LifeState::Following, LifeState::Faulted})
    EXPECT_EQ(after_fault(state), LifeState::Faulted) << static_cast<int>(state);
}

TEST(PlanLife, FaultDuringComputation_KeepsTheComputation) {
  for (const LifeState state :
       {LifeState::FirstPlan, LifeState::FollowingWhileMaking, LifeState::FaultedWhileMaking})
    EXPECT_EQ(after_fault(state), LifeState::FaultedWhileMaking) << static_cast<int>(state);
}

TEST(PlanLife, FinishAfterAFault_StaysFaulted) {
  for (const bool usable : {false, true})
    EXPECT_EQ(after_finish(LifeState::FaultedWhileMaking, usable), LifeState::Faulted) << usable;
}

TEST(PlanLife, Reset_FromEveryStateIsSettling) {
  for (const LifeState state : all_states) {
    PlanLife life = life_in(state);
    life.reset();
    EXPECT_EQ(life.state(), LifeState::Settling) << static_cast<int>(state);
  }
}

TEST(PlanLife, UnexpectedEvent_LeavesTheState) {
  for (const LifeState state : {LifeState::FirstPlan, LifeState::FollowingWhileMaking,
                                LifeState::Faulted, LifeState::FaultedWhileMaking})
    EXPECT_EQ(after_begin(state), state);
  for (const LifeState state : {LifeState::Settling, LifeState::Following, LifeState::Faulted})
    for (const bool usable : {false, true}) EXPECT_EQ(after_finish(state, usable), state);
}

TEST(PlanLife, Queries_DependOnTheState) {
  const auto states_with = [](bool (PlanLife::*query)() const noexcept) {
    std::vector<LifeState> result;
    for (const LifeState state : all_states)
      if ((life_in(state).*query)()) result.push_back(state);
    return result;
  };
  EXPECT_EQ(states_with(&PlanLife::follows),
            (std::vector{LifeState::Following, LifeState::FollowingWhileMaking}));
  EXPECT_EQ(states_with(&PlanLife::is_making),
            (std::vector{LifeState::FirstPlan, LifeState::FollowingWhileMaking,
                         LifeState::FaultedWhileMaking}));
  EXPECT_EQ(states_with(&PlanLife::can_begin),
            (std::vector{LifeState::Settling, LifeState::Following}));
}

}  // namespace
}  // namespace burnish::test
