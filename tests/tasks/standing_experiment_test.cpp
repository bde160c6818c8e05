// The experiments of robots on their feet, and of a plate in the other hand.
#include "burnish/tasks/polishing/task_file.hpp"
#include "polishing/experiments/pushes.hpp"
#include "polishing/experiments/shipped_tasks.hpp"
#include "support/refusal.hpp"
#include "tasks/quick_experiment.hpp"

namespace burnish::testing {
namespace {

TEST(Experiments, FramesShowThatAPlateThatTurnsWantsItsOwnAxes) {
  if (!has_mujoco()) GTEST_SKIP() << "needs MuJoCo";
  const ExperimentReport report = experiment_named("frames").perform(quick());
  expect_complete(report);
  const ResultTable& plate = table_named(report, "plate");
  ASSERT_EQ(plate.rows.size(), 1U);
  EXPECT_EQ(number_at(plate, 0, "plate turned"), 20.0);
  const double own = number_at(plate, 0, "force_rmse, surface");
  EXPECT_LT(3.0 * own, number_at(plate, 0, "force_rmse, world"));
  EXPECT_LT(3.0 * own, number_at(plate, 0, "force_rmse, local"));
  // The runs stand in the first table, beside those of surfaces that stand still.
  EXPECT_EQ(report.tables.front().rows.size(), 2U * 2 * 2 * 2 + 3);
}

TEST(Experiments, TasksThatComeAlongAreTheirFiles) {
  ASSERT_FALSE(shipped_task_texts().empty());
  for (const auto& [name, text] : shipped_task_texts())
    EXPECT_EQ(task_text(shipped_task(std::string(name))),
              task_text(read_task(BURNISH_TASKS_DIR "/polishing/" + std::string(name) + ".yaml")))
        << name;
  expect_words(refusal([] { shipped_task("sitting"); }), {"no task 'sitting'"});
}

/// What a robot that bears up to `bears` N is pushed with, in order.
std::vector<double> searched(double bears, double step) {
  PushDirection direction;
  std::vector<double> forces;
  while (const auto force = next_push(direction, step)) {
    forces.push_back(*force);
    note_push(*force, {.made = true, .polished = *force <= bears}, direction);
  }
  EXPECT_LE(direction.largest_survived(), bears);
  EXPECT_GT(direction.largest_survived() + step, std::min(bears, largest_push));
  return forces;
}

TEST(Pushes, TheLargestThatIsSurvivedIsFoundByHalves) {
  EXPECT_EQ(searched(155.0, 10.0), (std::vector<double>{120, 240, 180, 150, 160}));
  EXPECT_EQ(searched(5.0, 10.0), (std::vector<double>{120, 60, 30, 10}));
  EXPECT_EQ(searched(1e3, 10.0), (std::vector<double>{120, 240, 480}));
  EXPECT_EQ(searched(300.0, 10.0).size(), 7U);
  // One that was not made ends its search, and one who falls has not survived.
  PushDirection direction;
  note_push(120.0, {.made = false}, direction);
  EXPECT_FALSE(next_push(direction, 10.0).has_value());
  RunFigures lies{.made = true, .polished = true};
  lies.standing.emplace().base_tilt = 1.0;
  note_push(120.0, lies, direction);
  EXPECT_EQ(direction.largest_survived(), 0.0);
  EXPECT_EQ(direction.smallest_lost(), 120.0);
}

TEST(Experiments, StandingCountsFallsAndFindsTheLargestPush) {
  if (!has_mujoco()) GTEST_SKIP() << "needs MuJoCo";
  ExperimentSpec spec = quick();
  double told = 0.0;
  spec.progress = [&](double share, const std::string&) {
    EXPECT_GE(share, told - 0.01);  // a run's end is known once its path has begun
    EXPECT_LE(share, 1.0 + 1e-12);
    told = share;
  };
  RunCounts counts;
  spec.counts = &counts;
  const ExperimentReport report = experiment_named("standing").perform(spec);
  expect_complete(report);
  const ResultTable& summary = table_named(report, "summary");
  ASSERT_EQ(summary.rows.size(), 2U);  // the board under none and mismatch
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
  // All runs stand in the first table, those of later rounds too, and are counted.
  EXPECT_GT(report.tables.front().rows.size(), 2U + 2U);
  EXPECT_EQ(static_cast<int>(report.tables.front().rows.size()), counts.made);
  EXPECT_EQ(counts.wanted, counts.made);
}

TEST(Experiments, StandingIsRefusedWhereNothingCanStand) {
  ExperimentSpec spec = quick();
  spec.plant = PlantKind::Ideal;
  expect_words(refusal([&] { experiment_named("standing").perform(spec); }), {"needs MuJoCo"});
  if (!has_mujoco()) return;
  spec.plant = PlantKind::Mujoco;
  spec.surfaces = {"board_y"};
  expect_words(refusal([&] { experiment_named("standing").perform(spec); }),
               {"'board_y'", "board or table"});
}

}  // namespace
}  // namespace burnish::testing
