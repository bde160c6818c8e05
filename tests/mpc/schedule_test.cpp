// The clock of a task: what contact does to it, and what it refuses.
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

/// Until the clock shows this time, in steps of 1 ms; the number of ticks that were off.
int advance_to(Schedule& schedule, double time, bool contact) {
  int off = 0;
  for (int i = 0; i < 10000 && schedule.time() < time - 1e-9; ++i)
    off += schedule.advance(1e-3, contact) ? 1 : 0;
  return off;
}

TEST(Schedule, knows_the_phase_at_every_time) {
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

TEST(Schedule, jumps_to_the_end_of_the_approach_when_contact_is_early) {
  Schedule schedule(phases());
  EXPECT_EQ(advance_to(schedule, 0.7, false), 0);
  EXPECT_TRUE(schedule.advance(1e-3, true));
  EXPECT_EQ(schedule.time(), 0.9);
  EXPECT_EQ(schedule.phase(), 2);
  // Contact that comes and goes changes nothing any more.
  EXPECT_EQ(advance_to(schedule, 1.0, false), 0);
  EXPECT_EQ(schedule.phase(), 2);
}

TEST(Schedule, stands_still_before_the_end_of_the_approach_while_contact_is_late) {
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

TEST(Schedule, passes_contact_over_where_it_is_not_waited_for) {
  Schedule schedule(phases());
  EXPECT_EQ(advance_to(schedule, 0.499, true), 0);
  EXPECT_EQ(schedule.phase(), 0);
}

TEST(Schedule, never_steps_over_a_phase_that_waits) {
  Schedule schedule(phases());
  EXPECT_TRUE(schedule.advance(100.0, false));
  EXPECT_DOUBLE_EQ(schedule.time(), 0.85);
  EXPECT_EQ(schedule.phase(), 1);
  schedule.advance(1e-3, true);
  // Several phases that do not wait may pass at once.
  EXPECT_FALSE(schedule.advance(10.0, false));
  EXPECT_EQ(schedule.phase(), 3);
}

TEST(Schedule, holds_at_the_start_of_a_phase_shorter_than_the_hold) {
  std::vector<SchedulePhase> short_ones = phases();
  short_ones[1].hold = 10.0;
  Schedule schedule(short_ones);
  for (int i = 0; i < 1000; ++i) schedule.advance(1e-3, false);
  EXPECT_EQ(schedule.time(), 0.5);
  EXPECT_EQ(schedule.phase(), 1);
}

TEST(Schedule, ends_only_with_a_last_phase_of_finite_duration) {
  Schedule open(phases());
  open.jump_to(3);
  EXPECT_EQ(open.time(), open.start_of(3));
  open.advance(1e6, false);
  EXPECT_FALSE(open.finished());

  std::vector<SchedulePhase> finite = phases();
  finite[3].duration = 0.2;
  Schedule closed(finite);
  closed.jump_to(2);
  EXPECT_EQ(closed.phase(), 2);
  closed.advance(0.49, false);
  EXPECT_FALSE(closed.finished());
  closed.advance(0.02, false);
  EXPECT_TRUE(closed.finished());
  EXPECT_EQ(closed.phase(), 3);
  closed.reset();
  EXPECT_EQ(closed.time(), 0.0);
  EXPECT_EQ(closed.phase(), 0);
}

TEST(Schedule, jumps_to_phases_that_there_are) {
  Schedule schedule(phases());
  schedule.jump_to(17);
  EXPECT_EQ(schedule.phase(), 3);
  schedule.jump_to(-2);
  EXPECT_EQ(schedule.phase(), 0);
}

TEST(Schedule, tells_events_apart) {
  std::vector<SchedulePhase> two = phases();
  two[2].until = "told";
  Schedule schedule(two);
  EXPECT_EQ(schedule.events(), (std::vector<std::string>{"contact", "told"}));
  advance_to(schedule, 0.6, false);
  EXPECT_FALSE(schedule.advance(1e-3, 2U)) << "told before anybody waits for it";
  EXPECT_EQ(schedule.phase(), 1);
  EXPECT_TRUE(schedule.advance(1e-3, 1U));
  EXPECT_EQ(schedule.phase(), 2);
  for (int i = 0; i < 1000; ++i) schedule.advance(1e-3, 1U);
  EXPECT_TRUE(schedule.waits());
  EXPECT_TRUE(schedule.advance(1e-3, 3U));
  EXPECT_EQ(schedule.phase(), 3);
  // In the order that the events are given in.
  Schedule given(two, {"told", "contact"});
  advance_to(given, 0.6, false);
  EXPECT_TRUE(given.advance(1e-3, 2U));
}

TEST(Schedule, refuses_what_is_no_schedule) {
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
               {"phase 1", "'contact'", "no event", "contacts"});
  expect_words(refusal([] { Schedule(phases(), std::vector<std::string>(33, "contact")); }),
               {"33 events", "at most 32"});
}

}  // namespace
}  // namespace burnish
