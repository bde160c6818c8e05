// Experiments with robots on their feet, and with a plate in the other hand.
#include "burnish/tasks/polishing/task_file.hpp"
#include "polishing/experiments/pushes.hpp"
#include "polishing/experiments/shipped_tasks.hpp"
#include "support/refusal.hpp"
#include "tasks/quick_experiment.hpp"

namespace burnish::testing {
namespace {

TEST(Experiments, FramesWithTurningPlate_FavourSurfaceAxes) {
  if (!has_mujoco()) GTEST_SKIP() << "needs MuJoCo";
  const ExperimentReport report = experiment_named("frames").perform(quick());
  expect_complete(report);
  const ResultTable& plate = table_named(report, "plate");
  ASSERT_EQ(plate.rows.size(), 1U);
  EXPECT_EQ(number_at(plate, 0, "plate turned"), 20.0);
  const double own = number_at(plate, 0, "force_rmse, surface");
  EXPECT_LT(3.0 * own, number_at(plate, 0, "force_rmse, world"));
  EXPECT_LT(3.0 * own, number_at(plate, 0, "force_rmse, local"));
  // The first table contains these runs and those on fixed surfaces.
  EXPECT_EQ(report.tables.front().rows.size(), 2U * 2 * 2 * 2 + 3);
}

TEST(Experiments, ShippedTasks_MatchTheirFiles) {
  ASSERT_FALSE(shipped_task_texts().empty());
  for (const auto& [name, text] : shipped_task_texts())
    EXPECT_EQ(task_text(shipped_task(std::string(name))),
              task_text(read_task(BURNISH_TASKS_DIR "/polishing/" + std::string(name) + ".yaml")))
        << name;
  expect_words(refusal([] { shipped_task("sitting"); }), {"no bundled task 'sitting'"});
}

/// Returns the pushes of the search, in order, for a robot that survives `max_survived` [N].
std::vector<double> searched(double max_survived, double step) {
  PushDirection direction;
  std::vector<double> forces;
  while (const auto force = next_push(direction, step)) {
    forces.push_back(*force);
    note_push(*force, {.made = true, .succeeded = *force <= max_survived}, direction);
  }
  EXPECT_LE(direction.largest_survived(), max_survived);
  EXPECT_GT(direction.largest_survived() + step, std::min(max_survived, largest_push));
  return forces;
}

TEST(Pushes, LargestSurvivedPush_IsFoundByBisection) {
  EXPECT_EQ(searched(155.0, 10.0), (std::vector<double>{120, 240, 180, 150, 160}));
  EXPECT_EQ(searched(5.0, 10.0), (std::vector<double>{120, 60, 30, 10}));
  EXPECT_EQ(searched(1e3, 10.0), (std::vector<double>{120, 240, 480}));
  EXPECT_EQ(searched(300.0, 10.0).size(), 7U);
  // A missing run ends the search, and a robot that falls has not survived.
  PushDirection direction;
  note_push(120.0, {.made = false}, direction);
  EXPECT_FALSE(next_push(direction, 10.0).has_value());
  RunFigures lies{.made = true, .succeeded = true};
  lies.standing.emplace().base_tilt = 1.0;
  note_push(120.0, lies, direction);
  EXPECT_EQ(direction.largest_survived(), 0.0);
  EXPECT_EQ(direction.smallest_lost(), 120.0);
}

TEST(Experiments, Standing_CountsFallsAndFindsTheLargestPush) {
  if (!has_mujoco()) GTEST_SKIP() << "needs MuJoCo";
  ExperimentSpec spec = quick();
  double last_progress = 0.0;
  spec.progress = [&](double progress, const std::string&) {
    // The end of a run is estimated until its path begins, so progress may drop slightly.
    EXPECT_GE(progress, last_progress - 0.01);
    EXPECT_LE(progress, 1.0 + 1e-12);
    last_progress = progress;
  };
  RunCounts counts;
  spec.counts = &counts;
  const ExperimentReport report = experiment_named("standing").perform(spec);
  expect_complete(report);
  const ResultTable& summary = table_named(report, "summary");
  ASSERT_EQ(summary.rows.size(), 2U);  // the board without disturbances and with `mismatch`
  for (std::size_t row = 0; row < 2; ++row) {
    EXPECT_EQ(number_at(summary, row, "seeds"), 1.0);
    EXPECT_EQ(number_at(summary, row, "falls"), 0.0);
    EXPECT_LT(number_at(summary, row, "position_rmse"), 2.0);
  }
  const ResultTable& pushes = table_named(report, "pushes");
  ASSERT_EQ(pushes.rows.size(), 2U);
  for (std::size_t row = 0; row < 2; ++row) {
    EXPECT_EQ(std::get<std::string>(pushes.rows[row][2]), "survived");
    EXPECT_GE(number_at(pushes, row, "largest survived"), 120.0);
  }
  // The first table contains all runs, including later rounds, and the counts match.
  EXPECT_GT(report.tables.front().rows.size(), 2U + 2U);
  EXPECT_EQ(static_cast<int>(report.tables.front().rows.size()), counts.made);
  EXPECT_EQ(counts.wanted, counts.made);
}

TEST(Experiments, StandingOnTheWrongPlantOrSurface_IsRefused) {
  ExperimentSpec spec = quick();
  spec.plant = PlantKind::Ideal;
  expect_words(refusal([&] { experiment_named("standing").perform(spec); }),
               {"wanted the plant mujoco"});
  if (!has_mujoco()) return;
  spec.plant = PlantKind::Mujoco;
  spec.surfaces = {"board_y"};
  expect_words(refusal([&] { experiment_named("standing").perform(spec); }),
               {"'board_y'", "board or table"});
}

}  // namespace
}  // namespace burnish::testing
