// Tests of the schedule: how contact changes its time, and which schedules it rejects.
#include <gtest/gtest.h>

#include "burnish/mpc/task.hpp"
#include "support/refusal.hpp"
#include "support/special_numbers.hpp"

namespace burnish {
namespace {

using testing::expect_words;
using testing::refusal;

std::vector<SchedulePhase> phases() {
  return {{.stage = "reach", .duration = 0.5},
          {.stage = "approach", .duration = 0.4, .until = "contact", .hold = 0.05},
          {.stage = "press", .duration = 0.3},
          {.stage = "reach"}};
}

/// Advances until the schedule's time reaches `time`, in ticks of 1 ms. Returns the number of ticks
/// in which the schedule jumped or waited.
int advance_to(Schedule& schedule, double time, bool contact) {
  int jumps = 0;
  for (int i = 0; i < 10000 && schedule.time() < time - 1e-9; ++i)
    jumps += schedule.advance(1e-3, contact) ? 1 : 0;
  return jumps;
}

TEST(Schedule, AnyTime_HasItsPhase) {
  const Schedule schedule(phases());
  EXPECT_EQ(schedule.phase_at(-1.0), 0);
  EXPECT_EQ(schedule.phase_at(0.0), 0);
  EXPECT_EQ(schedule.phase_at(0.4999), 0);
  EXPECT_EQ(schedule.phase_at(0.5), 1);
  EXPECT_EQ(schedule.phase_at(0.9), 2);
  EXPECT_EQ(schedule.phase_at(1.2), 3);
  EXPECT_EQ(schedule.phase_at(1e9), 3);
  EXPECT_DOUBLE_EQ(schedule.start_of(3), 1.2);
}

TEST(Schedule, EarlyContact_EndsTheApproach) {
  Schedule schedule(phases());
  EXPECT_EQ(advance_to(schedule, 0.7, false), 0);
  EXPECT_TRUE(schedule.advance(1e-3, true));
  EXPECT_EQ(schedule.time(), 0.9);
  EXPECT_EQ(schedule.phase(), 2);
  // A contact that is lost and found again has no further effect.
  EXPECT_EQ(advance_to(schedule, 1.0, false), 0);
  EXPECT_EQ(schedule.phase(), 2);
}

TEST(Schedule, LateContact_StopsTheTimeBeforeTheEndOfTheApproach) {
  Schedule schedule(phases());
  EXPECT_EQ(advance_to(schedule, 0.849, false), 0);
  EXPECT_FALSE(schedule.waits());
  for (int i = 0; i < 300; ++i) schedule.advance(1e-3, false);
  EXPECT_DOUBLE_EQ(schedule.time(), 0.85);
  EXPECT_EQ(schedule.phase(), 1);
  EXPECT_TRUE(schedule.advance(1e-3, false));
  EXPECT_TRUE(schedule.waits());
  EXPECT_TRUE(schedule.advance(1e-3, true));
  EXPECT_FALSE(schedule.waits());
  EXPECT_EQ(schedule.time(), 0.9);
  EXPECT_FALSE(schedule.advance(1e-3, true));
  EXPECT_DOUBLE_EQ(schedule.time(), 0.901);
}

TEST(Schedule, ContactInAPhaseWithoutEvent_IsIgnored) {
  Schedule schedule(phases());
  EXPECT_EQ(advance_to(schedule, 0.499, true), 0);
  EXPECT_EQ(schedule.phase(), 0);
}

TEST(Schedule, LongStep_StopsInAPhaseThatWaits) {
  Schedule schedule(phases());
  EXPECT_TRUE(schedule.advance(100.0, false));
  EXPECT_DOUBLE_EQ(schedule.time(), 0.85);
  EXPECT_EQ(schedule.phase(), 1);
  schedule.advance(1e-3, true);
  // Phases that do not wait may pass together in one step.
  EXPECT_FALSE(schedule.advance(10.0, false));
  EXPECT_EQ(schedule.phase(), 3);
}

TEST(Schedule, HoldLongerThanItsPhase_WaitsAtTheStartOfThePhase) {
  std::vector<SchedulePhase> short_ones = phases();
  short_ones[1].hold = 10.0;
  Schedule schedule(short_ones);
  for (int i = 0; i < 1000; ++i) schedule.advance(1e-3, false);
  EXPECT_EQ(schedule.time(), 0.5);
  EXPECT_EQ(schedule.phase(), 1);
}

TEST(Schedule, LastPhase_FinishesOnlyIfItsDurationIsFinite) {
  Schedule endless(phases());
  endless.jump_to(3);
  EXPECT_EQ(endless.time(), endless.start_of(3));
  endless.advance(1e6, false);
  EXPECT_FALSE(endless.finished());

  std::vector<SchedulePhase> finite = phases();
  finite[3].duration = 0.2;
  Schedule ending(finite);
  ending.jump_to(2);
  EXPECT_EQ(ending.phase(), 2);
  ending.advance(0.49, false);
  EXPECT_FALSE(ending.finished());
  ending.advance(0.02, false);
  EXPECT_TRUE(ending.finished());
  EXPECT_EQ(ending.phase(), 3);
  ending.reset();
  EXPECT_EQ(ending.time(), 0.0);
  EXPECT_EQ(ending.phase(), 0);
}

TEST(Schedule, JumpBeyondThePhases_GoesToTheNearestPhase) {
  Schedule schedule(phases());
  schedule.jump_to(17);
  EXPECT_EQ(schedule.phase(), 3);
  schedule.jump_to(-2);
  EXPECT_EQ(schedule.phase(), 0);
}

TEST(Schedule, TwoEvents_EndOnlyTheirOwnPhases) {
  std::vector<SchedulePhase> two = phases();
  two[2].until = "signal";
  Schedule schedule(two);
  EXPECT_EQ(schedule.events(), (std::vector<std::string>{"contact", "signal"}));
  advance_to(schedule, 0.6, false);
  EXPECT_FALSE(schedule.advance(1e-3, 2U)) << "the schedule does not wait for 'signal' yet";
  EXPECT_EQ(schedule.phase(), 1);
  EXPECT_TRUE(schedule.advance(1e-3, 1U));
  EXPECT_EQ(schedule.phase(), 2);
  for (int i = 0; i < 1000; ++i) schedule.advance(1e-3, 1U);
  EXPECT_TRUE(schedule.waits());
  EXPECT_TRUE(schedule.advance(1e-3, 3U));
  EXPECT_EQ(schedule.phase(), 3);
  // Bits follow the order of the given events.
  Schedule reordered(two, {"signal", "contact"});
  advance_to(reordered, 0.6, false);
  EXPECT_TRUE(reordered.advance(1e-3, 2U));
}

TEST(Schedule, InvalidPhasesAndEvents_AreRefused) {
  expect_words(refusal([] { Schedule({}); }), {"no phases"});
  const auto with = [](int phase, auto&& change) {
    return refusal([&] {
      std::vector<SchedulePhase> bad = phases();
      change(bad[static_cast<std::size_t>(phase)]);
      Schedule{bad};
    });
  };
  expect_words(with(0, [](SchedulePhase& p) { p.duration = 0.0; }), {"phase 0", "positive"});
  expect_words(with(2, [](SchedulePhase& p) { p.duration = std::nan(""); }), {"phase 2"});
  expect_words(with(2, [](SchedulePhase& p) { p.duration = test::infinity; }),
               {"phase 2", "never ends"});
  expect_words(with(1, [](SchedulePhase& p) { p.hold = 0.0; }), {"phase 1", "hold", "positive"});
  EXPECT_EQ(with(0, [](SchedulePhase& p) { p.hold = 0.0; }), "");
  expect_words(refusal([] { Schedule(phases(), {"contacts"}); }),
               {"phase 1", "'contact'", "not an event", "contacts"});
  expect_words(refusal([] { Schedule(phases(), std::vector<std::string>(33, "contact")); }),
               {"33 events", "at most 32"});
}

}  // namespace
}  // namespace burnish
