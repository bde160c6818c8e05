// Experiments: tables, batches, and a quick version of each experiment from start to end.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "polishing/experiments/batch.hpp"
#include "polishing/experiments/disturbance_ranges.hpp"
#include "polishing/experiments/experiment.hpp"
#include "polishing/experiments/scaled_robot.hpp"
#include "support/refusal.hpp"
#include "tasks/quick_experiment.hpp"

namespace burnish::testing {
namespace {

TEST(ResultTable, Cells_AreWrittenAsMarkdownAndCsv) {
  ResultTable table{.name = "t", .title = "T", .columns = {{"text"}, {"length", "mm", 1}}};
  table.add({std::string("a, b|c"), 1.0 / 3.0});
  table.add({std::string("say \"x\""), std::numeric_limits<double>::quiet_NaN()});
  table.add({std::monostate(), 12.0});
  EXPECT_EQ(markdown(table),
            "| text    | length [mm] |\n"
            "| ------- | ----------: |\n"
            "| a, b\\|c |         0.3 |\n"
            "| say \"x\" |           - |\n"
            "| -       |        12.0 |\n");
  EXPECT_EQ(csv(table),
            "text,length [mm]\n"
            "\"a, b|c\",0.3333333333333333\n"
            "\"say \"\"x\"\"\",\n"
            ",12\n");
  expect_words(refusal([&] { table.add({1.0}); }), {"'t'", "has 1 cells; wanted 2"});
}

TEST(RunFigures, MissingValues_AreSkippedInStatistics) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> values{3.0, none, 1.0, 2.0, 4.0};
  EXPECT_EQ(mean_of(values), 2.5);
  EXPECT_EQ(largest_of(values), 4.0);
  EXPECT_EQ(quantile_of(values, 0.5), 2.0);
  EXPECT_EQ(quantile_of(values, 0.95), 4.0);
  EXPECT_TRUE(std::isnan(mean_of({none})));
  EXPECT_TRUE(std::isnan(largest_of({})));
}

TEST(RunFigures, RunWithoutTheFigure_IsTheWorst) {
  RunFigures good;
  good.run_torque_margin = 0.3;
  const RunFigures without;
  EXPECT_EQ(worst_shown({good, good}, "run_torque_margin"),
            shown("run_torque_margin", good.run_torque_margin));
  EXPECT_TRUE(std::isnan(worst_shown({good, without}, "run_torque_margin")));
  EXPECT_TRUE(std::isnan(worst_shown({without, good}, "run_torque_margin")));
}

TEST(Batch, EveryIndex_RunsOnceAndTheFirstErrorIsThrown) {
  for (const int threads : {1, 3}) {
    std::vector<std::atomic<int>> visits(50);
    for_each_index(50, threads, [&](int index) { ++visits[static_cast<std::size_t>(index)]; });
    for (const auto& count : visits) EXPECT_EQ(count, 1);
    const auto fail = [&] {
      for_each_index(20, threads, [](int index) {
        if (index % 7 == 6) throw Error("failed at " + std::to_string(index));
      });
    };
    EXPECT_EQ(refusal(fail), "failed at 6");
  }
}

TEST(Batch, OneOrThreeThreads_GiveTheSameFigures) {
  ExperimentSpec spec = quick();
  std::vector<BatchRun> runs;
  for (int seed = 0; seed < 4; ++seed) {
    BatchRun run;
    run.name = std::to_string(seed);
    run.spec.task = experiment_task(spec, seed % 2 == 0 ? "table" : "board", "mismatch", 0.5);
    run.spec.task.disturbances.seed = static_cast<std::uint64_t>(seed);
    runs.push_back(run);
  }
  spec.threads = 1;
  const std::vector<RunFigures> one = run_batch(spec, runs);
  spec.threads = 3;
  const std::vector<RunFigures> three = run_batch(spec, runs);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(one[i].name, runs[i].name);
    EXPECT_TRUE(one[i].succeeded) << one[i].outcome;
    EXPECT_EQ(one[i]["force_rmse"], three[i]["force_rmse"]);
    EXPECT_EQ(one[i]["position_rmse"], three[i]["position_rmse"]);
    EXPECT_EQ(one[i]["run_torque_margin"], three[i]["run_torque_margin"]);
    EXPECT_EQ(one[i].outcome, three[i].outcome);
    EXPECT_LE(one[i]["largest_command"], 1.0);
    EXPECT_TRUE(one[i].finite);
  }
  EXPECT_NE(one[0]["force_rmse"], one[2]["force_rmse"]);
}

TEST(Batch, RefusedRun_ReportsTheRefusalAsItsOutcome) {
  ExperimentSpec spec = quick();
  std::vector<BatchRun> runs(1);
  runs[0].name = "far";
  runs[0].spec.task = experiment_task(spec, "table", "none", 0.5);
  runs[0].spec.task.path.radius = 0.8;
  ExperimentReport report;
  const std::vector<RunFigures> figures = run_batch(spec, runs);
  EXPECT_TRUE(std::isnan(figures[0]["force_rmse"]));
  note_failures(spec, figures, report);
  ASSERT_EQ(report.failures.size(), 1U);
  expect_words(report.failures[0], {"far: ", "out of reach"});
}

TEST(DisturbanceRanges, Draws_DependOnTheSeedAlone) {
  const auto drawn = [](int seed) {
    Task task;
    draw_disturbances({}, static_cast<std::uint64_t>(seed), task);
    return task;
  };
  const DisturbanceRanges ranges;
  for (int seed = 0; seed < 100; ++seed) {
    const Task task = drawn(seed);
    EXPECT_NO_THROW(check_task(task));
    EXPECT_NO_THROW(check_disturbances(make_setting(task).robot.model, task.disturbances));
    EXPECT_LE(task.disturbances.command_delay, ranges.command_delay.high);
    EXPECT_LE(task.solver_delay, 1.0 / task.update_rate);
    EXPECT_GE(task.disturbances.mass_scale, ranges.mass_scale.low);
    EXPECT_EQ(task.disturbances.pushes.size(), 1U);
  }
  EXPECT_EQ(task_text(drawn(3)), task_text(drawn(3)));
  EXPECT_NE(task_text(drawn(3)), task_text(drawn(4)));
  // The range of one disturbance does not change the draws of the others.
  DisturbanceRanges exact_torques;
  exact_torques.torque_scale = {0.0, 0.0};
  Task task;
  draw_disturbances(exact_torques, 3, task);
  EXPECT_EQ(task.disturbances.torque_scale_range, 0.0);
  EXPECT_EQ(task.disturbances.mass_scale, drawn(3).disturbances.mass_scale);
}

TEST(Experiments, Names_AreFoundOrCorrected) {
  EXPECT_EQ(experiments().size(), 10U);
  EXPECT_EQ(experiment_named("tick").name, "tick");
  expect_words(refusal([] { experiment_named("papr"); }),
               {"unknown experiment 'papr'", "did you mean 'paper'?"});
  expect_words(refusal([] { check_experiment_task({.overrides = {"froce=3"}}, "table"); }),
               {"did you mean 'force'?"});
  expect_words(refusal([] { check_experiment_task({}, "tabel"); }), {"did you mean 'table'?"});
}

TEST(Experiments, Paper_HasARowPerCaseAndAVerdictPerAim) {
  ExperimentSpec spec = quick();
  spec.seeds = 2;
  spec.surfaces = {"table"};
  const ExperimentReport report = experiment_named("paper").perform(spec);
  expect_complete(report);
  EXPECT_EQ(table_named(report, "runs").rows.size(), 3U * (1 + 2 + 2));
  const ResultTable& summary = table_named(report, "summary");
  ASSERT_EQ(summary.rows.size(), 9U);
  EXPECT_EQ(number_at(summary, 0, "seeds"), 1.0);
  EXPECT_EQ(number_at(summary, 3, "seeds"), 2.0);
  EXPECT_EQ(number_at(summary, 3, "polished"), 2.0);
  EXPECT_EQ(std::get<std::string>(summary.rows[8][2]), "admittance");
  const ResultTable& aims = table_named(report, "aims");
  ASSERT_EQ(aims.rows.size(), 15U);
  for (std::size_t row = 0; row < aims.rows.size(); ++row) {
    const bool met = number_at(aims, row, "worst") <= number_at(aims, row, "aim") + 1e-9;
    EXPECT_EQ(std::get<std::string>(aims.rows[row].back()) == "met", met) << row;
  }
}

TEST(Experiments, Orientation_SearchesAPosturePerNormal) {
  const ExperimentReport report = experiment_named("orientation").perform(quick());
  expect_complete(report);
  const ResultTable& normals = table_named(report, "normals");
  ASSERT_EQ(normals.rows.size(), 4U);
  EXPECT_NEAR(number_at(normals, 0, "of the table's"), 1.0, 1e-12);
  for (std::size_t row = 1; row < 4; ++row)
    EXPECT_LT(number_at(normals, row, "tool_to_normal"), 40.0);
  expect_words(report.findings.front(), {"3 of 3 directions"});
}

TEST(Experiments, OrientationOutOfReach_IsReported) {
  ExperimentSpec spec = quick();
  spec.overrides = {"limits.force=9000", "force=3000"};
  const ExperimentReport report = experiment_named("orientation").perform(spec);
  const ResultTable& table = table_named(report, "out_of_reach");
  EXPECT_GE(table.rows.size(), 1U);
  expect_words(std::get<std::string>(table.rows[0][1]),
               {"no posture was found for the surface", "pressing with 3000 N"});
}

TEST(Experiments, FramesWithTurningTool_FavourSurfaceAxes) {
  ExperimentSpec spec = quick();
  spec.surfaces = {"board"};
  spec.overrides = {"path.radius=0.05"};
  const ExperimentReport report = experiment_named("frames").perform(spec);
  expect_complete(report);
  const ResultTable& axes = table_named(report, "axes");
  ASSERT_EQ(axes.rows.size(), 4U);
  // Row 1 is the ideal plant with a free wrist; the last column of force errors uses the tool axes.
  const double surface = number_at(axes, 1, "force_rmse, surface"),
               local = number_at(axes, 1, "local");
  EXPECT_GT(local, 5.0 * surface);
}

TEST(Experiments, Seeds_CountFailedRuns) {
  ExperimentSpec spec = quick();
  spec.seeds = 3;
  spec.first_seed = 5;
  const ExperimentReport report = experiment_named("seeds").perform(spec);
  expect_complete(report);
  EXPECT_EQ(number_at(report.tables.front(), 0, "seed"), 5.0);
  EXPECT_EQ(report.tables.front().rows.size(), 3U);
  ASSERT_EQ(report.tasks.size(), 1U);
  EXPECT_GE(report.tasks[0].task.disturbances.seed, 5U);
  EXPECT_LE(report.tasks[0].task.disturbances.seed, 7U);
  // Every run violates this limit.
  spec.overrides = {"limits.tool_speed=0.005"};
  const ExperimentReport failed = experiment_named("seeds").perform(spec);
  EXPECT_EQ(failed.failures.size(), 3U);
  const ResultTable& outcomes = table_named(failed, "outcomes");
  EXPECT_EQ(std::get<std::string>(outcomes.rows[1][0]), "fault: speed limit");
  EXPECT_EQ(std::get<double>(outcomes.rows[1][1]), 3.0);
  expect_words(failed.findings.front(), {"3 of 3 runs diverged"});
}

TEST(Experiments, Surfaces_AreComparedWithTheirAims) {
  const ExperimentReport report = experiment_named("surfaces").perform(quick());
  expect_complete(report);
  const ResultTable& aims = table_named(report, "aims");
  ASSERT_EQ(aims.rows.size(), 4U);  // one of each group
  for (std::size_t row = 0; row < aims.rows.size(); ++row) {
    EXPECT_EQ(number_at(aims, row, "seeds"), 1.0);
    EXPECT_GT(number_at(aims, row, "force_rmse, worst"), 0.0);
  }
  // A plane tilted by 6 degrees has a normal error, which the estimate reduces.
  EXPECT_GT(number_at(aims, 1, "normal_error, worst"), 0.01);
  EXPECT_LT(number_at(aims, 1, "normal_error, worst"), 6.0);
  // Runs that fault do not polish.
  ExperimentSpec lifted = quick();
  lifted.overrides = {"limits.tool_speed=0.005"};
  const ExperimentReport failed = experiment_named("surfaces").perform(lifted);
  EXPECT_EQ(failed.failures.size(), 4U);
  expect_words(failed.findings.front(), {"0 of 4 aims are met"});
}

TEST(Experiments, Robots_PolishOrReportWhyNot) {
  const ExperimentReport report = experiment_named("robots").perform(quick());
  for (const std::string& failure : report.failures) ADD_FAILURE() << failure;
  const ResultTable& summary = table_named(report, "summary");
  ASSERT_EQ(summary.rows.size(), 1U);
  EXPECT_NEAR(number_at(summary, 0, "mass"), 10.0, 1e-9);
  EXPECT_EQ(number_at(summary, 0, "polished"), 1.0);
  EXPECT_LT(number_at(summary, 0, "force_rmse"), 3.0);
  const ResultTable& others = table_named(report, "others");
  ASSERT_EQ(others.rows.size(), 1U);
  EXPECT_EQ(std::get<std::string>(others.rows[0][0]), "pendulum");
  EXPECT_FALSE(std::get<std::string>(others.rows[0][3]).empty());
}

TEST(Experiments, RequestedRobotThatCannotPolish_IsAFailure) {
  ExperimentSpec spec = quick();
  spec.robots = {"pendulum"};
  spec.tools = {"tip"};
  const ExperimentReport report = experiment_named("robots").perform(spec);
  ASSERT_EQ(report.failures.size(), 1U);
  expect_words(report.failures[0], {"pendulum, table: "});
}

TEST(ScaledRobot, GivenMass_KeepsTheProportions) {
  const Robot arm = load_robot("arm7");
  const double mass = 8.0 * arm.model.total_mass();  // twice as long
  const Robot large = scaled_robot(arm, mass);
  EXPECT_NEAR(large.model.total_mass(), mass, 1e-9);
  const Eigen::VectorXd q = arm.posture("bent");
  EXPECT_LT((frame_placement(large.model, q, "tool").translation() -
             2.0 * frame_placement(arm.model, q, "tool").translation())
                .norm(),
            1e-9);
  RigidBody small_body(arm.model), large_body(large.model);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(7);
  ASSERT_EQ(small_body.update(q, rest), Status::Ok);
  ASSERT_EQ(large_body.update(q, rest), Status::Ok);
  const Eigen::VectorXd weight = small_body.gravity_torque();
  EXPECT_LT((Eigen::VectorXd(large_body.gravity_torque()) - 16.0 * weight).norm(),
            1e-9 * weight.norm());
  // Gravity torques take the same fraction of the effort limits.
  EXPECT_LT((large.model.effort_limit - 16.0 * arm.model.effort_limit).norm(), 1e-9);
  EXPECT_LT((large.model.armature - 32.0 * arm.model.armature).norm(), 1e-9);
  EXPECT_EQ(large.model.q_upper, arm.model.q_upper);
  EXPECT_EQ(large.model.velocity_limit, arm.model.velocity_limit);
  expect_words(refusal([&] { scaled_robot(arm, -1.0); }), {"wanted a positive mass"});
  expect_words(refusal([] { scaled_robot(load_robot("crane"), 3.0); }), {"is not revolute"});
}

TEST(Experiments, ForceTest_MeasuresEveryController) {
  if (!has_mujoco()) GTEST_SKIP() << "needs MuJoCo";
  ExperimentSpec spec = quick();
  spec.robots = {"arm7"};
  const ExperimentReport report = experiment_named("force_test").perform(spec);
  expect_complete(report);
  const ResultTable& summary = table_named(report, "summary");
  const auto row_of = [&](const std::string& test, const std::string& figure) {
    for (std::size_t row = 0; row < summary.rows.size(); ++row)
      if (std::get<std::string>(summary.rows[row][0]) == test &&
          std::get<std::string>(summary.rows[row][1]) == figure)
        return row;
    throw Error("no figure " + figure + " of " + test);
  };
  for (const char* controller : {"mpc", "mpc without preview", "baseline"}) {
    EXPECT_LT(std::abs(number_at(summary, row_of("step up", "steady_error"), controller)), 1.5);
    EXPECT_GT(number_at(summary, row_of("step up", "rise_time"), controller), 0.0);
    EXPECT_GT(number_at(summary, row_of("sine sweep", "bandwidth_3db"), controller), 0.0);
  }
  // Preview is the only difference between the two controllers. The phase of one run changes by up
  // to 0.5 degrees with the seed.
  EXPECT_LT(std::abs(number_at(summary, row_of("sine 8 Hz", "phase"), "mpc")) + 0.5,
            std::abs(number_at(summary, row_of("sine 8 Hz", "phase"), "mpc without preview")));
  for (const char* test : {"impact at 30 mm/s", "push along the normal", "edge that falls",
                           "edge that rises", "curved, unknown", "surface swings"})
    for (const char* controller : {"mpc", "baseline"}) {
      const std::string figure = test[0] == 'i' ? "impact_peak" : "force_peak";
      EXPECT_GT(number_at(summary, row_of(test, figure), controller), 0.0) << test;
    }
  // A row identifies robot, figure and unit, followed by the values of the runs.
  const ResultTable& figures = report.tables.front();
  EXPECT_EQ(figures.columns.size(), 6U + 1U + 3U);
  for (const auto& row : figures.rows) EXPECT_EQ(std::get<std::string>(row[0]), "arm7");
}

TEST(Experiments, ForceTest_ReportsFailuresWithReasons) {
  ExperimentSpec spec = quick();
  spec.plant = PlantKind::Ideal;                 // supports neither edges nor moving surfaces
  spec.overrides = {"limits.tool_speed=0.005"};  // every plan violates it
  const ExperimentReport report = experiment_named("force_test").perform(spec);
  std::string all;
  for (const std::string& finding : report.findings) all += finding + " ";
  expect_words(
      all, {"mpc, step: no figures; seed 0: speed limit", "baseline, surface swings: no figures",
            "wanted a surface at rest", "baseline, edge that falls: no figures", "wanted a plane"});
  EXPECT_FALSE(report.failures.empty());
}

TEST(Experiments, Tick_MeasuresEveryRate) {
  const ExperimentReport report = experiment_named("tick").perform(quick());
  expect_complete(report);
  const ResultTable& rates = report.tables.front();
  ASSERT_EQ(rates.rows.size(), 2U);
  EXPECT_EQ(number_at(rates, 0, "plans"), 100.0);
  EXPECT_GT(number_at(rates, 0, "solver.median"), 0.0);
  EXPECT_GE(number_at(rates, 1, "ticks.maximum"), number_at(rates, 1, "ticks.median"));
}

TEST(Experiments, IdealPlant_RunsThePaperExperiment) {
  ExperimentSpec spec = quick();
  spec.plant = PlantKind::Ideal;
  spec.seeds = 1;
  spec.surfaces = {"table"};
  expect_complete(experiment_named("paper").perform(spec));
}

TEST(Experiments, StopRequest_InterruptsTheExperiment) {
  ExperimentSpec spec = quick();
  spec.surfaces = {"table"};
  std::atomic<int> calls = 0;
  spec.stopped = [&] { return ++calls > 6; };
  double last_progress = 0.0;
  spec.progress = [&](double done, const std::string& task_name) {
    EXPECT_GE(done, 0.0);
    EXPECT_LE(done, 1.0 + 1e-12);
    EXPECT_FALSE(task_name.empty());
    last_progress = done;
  };
  const ExperimentReport report = experiment_named("paper").perform(spec);
  EXPECT_TRUE(report.interrupted);
  EXPECT_FALSE(report.failures.empty());
  EXPECT_FALSE(report.tables.empty());
}

}  // namespace
}  // namespace burnish::testing
