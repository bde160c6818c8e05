// Results of runs in files: read back unchanged, named by every input, and never computed twice.
#include <gtest/gtest.h>

#include <cmath>

#include "burnish/tasks/polishing/task_file.hpp"
#include "dynamics/instruction_set.hpp"
#include "polishing/experiments/batch.hpp"
#include "polishing/figures.hpp"
#include "support/refusal.hpp"
#include "support/scratch.hpp"

namespace burnish::testing {
namespace {

using namespace burnish::polishing;
namespace fs = std::filesystem;

/// Experiment of short runs on the ideal plant.
ExperimentSpec short_spec() {
  ExperimentSpec spec;
  spec.quick = true;
  spec.plant = PlantKind::Ideal;
  return spec;
}
/// Returns two short runs; the first one records its curves.
std::vector<BatchRun> two_runs() {
  std::vector<BatchRun> runs(2);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs[i].name = "seed " + std::to_string(i);
    runs[i].spec.plant = PlantKind::Ideal;
    runs[i].spec.controller = ControllerKind::Baseline;
    runs[i].spec.task = experiment_task(short_spec(), "table", "mismatch", 0.4);
    runs[i].spec.task.disturbances.seed = i;
  }
  runs[0].curves = "baseline";
  return runs;
}

void expect_same(double a, double b, const std::string& name) {
  EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << name << ": " << a << " and " << b;
}

void expect_same(const RunFigures& a, const RunFigures& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.outcome, b.outcome);
  EXPECT_EQ(a.made, b.made);
  EXPECT_EQ(a.refused, b.refused);
  EXPECT_EQ(a.late, b.late);
  EXPECT_EQ(a.succeeded, b.succeeded);
  EXPECT_EQ(a.fault, b.fault);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.finite, b.finite);
  EXPECT_EQ(a.kernels, b.kernels);
  EXPECT_EQ(a.q_start, b.q_start);
  EXPECT_EQ(a.p_center, b.p_center);
  expect_same(a.computing, b.computing, "computing");
  ASSERT_EQ(a.metrics.has_value(), b.metrics.has_value());
  each_metric([&](const FigureEntry& entry, auto) {
    if (!std::string(entry.name).starts_with("tightest"))
      expect_same(a[entry.name], b[entry.name], entry.name);
  });
  each_solver_figure([&](const FigureEntry& entry, auto) {
    const std::string name = std::string("solver.") + entry.name;
    expect_same(a[name], b[name], name);
  });
  each_tick_figure([&](const FigureEntry& entry, auto) {
    const std::string name = std::string("ticks.") + entry.name;
    expect_same(a[name], b[name], name);
  });
  each_run_figure([&](const FigureEntry& entry, auto member) {
    expect_same(a.*member, b.*member, entry.name);
  });
  if (a.metrics) {
    EXPECT_EQ(a.metrics->tightest_joint, b.metrics->tightest_joint);
    EXPECT_EQ(a.metrics->impact_peak, b.metrics->impact_peak);
  }
  ASSERT_EQ(a.measured.size(), b.measured.size());
  for (std::size_t i = 0; i < a.measured.size(); ++i) {
    EXPECT_EQ(a.measured[i].test, b.measured[i].test);
    EXPECT_EQ(a.measured[i].figure, b.measured[i].figure);
    EXPECT_EQ(a.measured[i].value, b.measured[i].value);
  }
  ASSERT_EQ(a.curves.has_value(), b.curves.has_value());
  if (!a.curves) return;
  EXPECT_EQ(a.curves->force.x, b.curves->force.x);
  EXPECT_EQ(a.curves->distance.y, b.curves->distance.y);
  EXPECT_EQ(a.curves->target.dashed, b.curves->target.dashed);
  EXPECT_EQ(a.curves->target.color, b.curves->target.color);
  EXPECT_EQ(a.curves->path.name, b.curves->path.name);
}

TEST(RunStore, StoredResult_ReadsBackUnchanged) {
  const Scratch scratch;
  const RunStore store("e", "1", {scratch.folder / "new" / "runs"});
  RunFigures run{.name = "a \"b\"\n", .outcome = "it: {failed}, 100 %", .made = true};
  run.fault = FaultKind::ContactLate;
  run.seed = 18446744073709551615U;
  run.finite = false;
  run.force_error_mean = -1.0 / 3.0;
  run.largest_command = std::numeric_limits<double>::infinity();
  run.kernels = "SSE2";
  run.computing = 1e-7;
  run.q_start = Eigen::Vector3d(0.1, -0.0, 1e300);
  run.ticks = {.count = 3, .period = 5e-4, .median = 1.0 / 7.0, .late = 2};
  run.metrics.emplace();
  run.metrics->tightest_joint = "yes";
  run.metrics->joint_margin = std::numeric_limits<double>::infinity();
  run.metrics->impact_peak = 17.25;
  run.metrics->solver = SolverFigures{.updates = 4, .p99 = 2e-4};
  run.curves.emplace();
  run.curves->force = {.name = "null", .x = Eigen::Vector2d(0, 1), .y = Eigen::Vector2d(2, NAN)};
  run.curves->target.dashed = true;
  run.measured = {{"step up", "overshoot", 1.0 / 3.0}, {"step up", "delay", -2.0}};
  EXPECT_FALSE(store.find("x"));
  store.keep("x", run);
  const std::optional<RunFigures> found = store.find("x");
  ASSERT_TRUE(found);
  EXPECT_TRUE(std::isnan(found->curves->force.y[1]));
  run.curves->force.y[1] = 0.0;
  RunFigures same = *found;
  same.curves->force.y[1] = 0.0;
  expect_same(run, same);
  // A refused run.
  const RunFigures refused{.name = "b", .outcome = "no", .made = true, .refused = true};
  store.keep("y", refused);
  expect_same(refused, *store.find("y"));
}

TEST(RunStore, ResultName_DependsOnEveryInput) {
  const RunStore store("e", "1", {"."});
  const RunSpec spec = two_runs()[0].spec;
  std::vector<std::string> names{store.name_of("a", spec), store.name_of("b", spec),
                                 RunStore("f", "1", {"."}).name_of("a", spec),
                                 RunStore("e", "2", {"."}).name_of("a", spec)};
  const auto changed = [&](const auto& change) {
    RunSpec other = spec;
    change(other);
    names.push_back(store.name_of("a", other));
  };
  changed([](RunSpec& s) { s.controller = ControllerKind::Mpc; });
  changed([](RunSpec& s) { s.plant = PlantKind::Mujoco; });
  changed([](RunSpec& s) { s.check_reach = false; });
  changed([](RunSpec& s) { s.task.disturbances.seed = 7; });
  changed([](RunSpec& s) { s.task.force += 1e-12; });
  changed([](RunSpec& s) { s.task.robot = "no such robot"; });
  // The same robot name with a different model.
  changed([](RunSpec& s) {
    s.robot = load_task_robot(s.task);
    s.robot->model.joints[2].mass += 1e-9;
  });
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(names[i].size(), 32U);
    for (std::size_t k = 0; k < i; ++k) EXPECT_NE(names[i], names[k]) << i << " " << k;
  }
  EXPECT_EQ(store.name_of("a", spec), names[0]);
  // A robot given as an object has the same name as one given by name.
  RunSpec given = spec;
  given.robot = load_task_robot(spec.task);
  EXPECT_EQ(store.name_of("a", given), names[0]);
}

TEST(Batch, StoreAndShards_MakeEveryRunOnce) {
  const Scratch scratch;
  const RunStore store("e", "1", {scratch.folder});
  ExperimentSpec spec = short_spec();
  RunCounts counts;
  spec.counts = &counts;
  const std::vector<RunFigures> once = run_batch(spec, two_runs());
  spec.store = &store;
  spec.shard = {{2}, 2};
  const std::vector<RunFigures> half = run_batch(spec, two_runs());
  EXPECT_FALSE(half[0].made);
  EXPECT_EQ(counts.wanted, 1);
  EXPECT_EQ(counts.made, 1);
  spec.only_found = true;
  spec.shard = {};
  expect_words(refusal([&] { run_batch(spec, two_runs()); }),
               {"1 of 2 runs are missing, the first is 'seed 0' (number 1)"});
  spec.only_found = false;
  run_batch(spec, two_runs());
  EXPECT_EQ(counts.found, 1);
  EXPECT_EQ(counts.made, 1);
  spec.only_found = true;
  const std::vector<RunFigures> found = run_batch(spec, two_runs());
  EXPECT_EQ(counts.found, 2);
  ASSERT_TRUE(found[0].curves);
  EXPECT_GT(found[0].curves->path.x.size(), 10);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(found[i]["force_rmse"], once[i]["force_rmse"]);
    EXPECT_EQ(found[i].outcome, once[i].outcome);
    EXPECT_EQ(found[i].kernels, instruction_set());
    EXPECT_GT(found[i].computing, 0.0);
  }
}

TEST(Batch, CustomRun_IsStoredByItsDependsOnText) {
  const Scratch scratch;
  const RunStore store("e", "1", {scratch.folder});
  ExperimentSpec spec = short_spec();
  RunCounts counts;
  spec.counts = &counts;
  spec.store = &store;
  BatchRun run{.name = "it stands"};
  run.depends_on = "a text";
  int calls = 0;
  run.perform = [&calls](const RunProgress& progress) {
    ++calls;
    EXPECT_TRUE(progress(0.5, 1.0));
    return RunFigures{.name = "it stands", .made = true, .succeeded = true};
  };
  EXPECT_TRUE(run_batch(spec, {run})[0].succeeded);
  EXPECT_TRUE(run_batch(spec, {run})[0].succeeded);
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(counts.found, 1);
  run.depends_on = "another text";
  run_batch(spec, {run});
  EXPECT_EQ(calls, 2);
  run.depends_on = "refused";
  run.perform = [](const RunProgress&) -> RunFigures { throw Error("out of reach"); };
  const RunFigures refused = run_batch(spec, {run})[0];
  EXPECT_TRUE(refused.refused);
  EXPECT_EQ(refused.outcome, "out of reach");
}

TEST(Batch, ResultsOfOtherKernels_NeedTheMixedOption) {
  const Scratch scratch;
  const RunStore store("e", "1", {scratch.folder});
  ExperimentSpec spec = short_spec();
  spec.store = &store;
  const std::vector<BatchRun> runs = two_runs();
  RunFigures other{.name = "seed 1", .made = true, .succeeded = true};
  other.kernels = "MMX";
  store.keep(store.name_of("seed 1", runs[1].spec), other);
  expect_words(refusal([&] { run_batch(spec, runs); }),
               {"kernels for different processors", "1 with MMX", "or --mixed"});
  spec.mixed = true;
  const std::vector<RunFigures> mixed = run_batch(spec, runs);
  EXPECT_TRUE(mixed[0].made);
  ExperimentReport report;
  note_failures(spec, mixed, report);
  ASSERT_EQ(report.findings.size(), 1U);
  expect_words(report.findings[0], {"1 with " + instruction_set(), "1 with MMX"});
}

TEST(Batch, TimeLimit_EndsTheRunAndAllowsARetry) {
  const Scratch scratch;
  const RunStore store("e", "1", {scratch.folder});
  ExperimentSpec spec = short_spec();
  spec.store = &store;
  spec.time_limit = 1e-9;
  RunCounts counts;
  spec.counts = &counts;
  const std::vector<RunFigures> late = run_batch(spec, two_runs());
  EXPECT_EQ(late[0].outcome, "ended by its time limit");
  EXPECT_TRUE(late[0].late && late[0].made && !late[0].succeeded);
  ExperimentReport report;
  note_failures(spec, late, report);
  EXPECT_EQ(report.failures.size(), 2U);
  EXPECT_FALSE(report.interrupted);
  // A merge accepts such a result, and a run without the limit replaces it.
  spec.only_found = true;
  EXPECT_TRUE(run_batch(spec, two_runs())[1].late);
  spec.only_found = false;
  spec.time_limit = 0.0;
  EXPECT_FALSE(run_batch(spec, two_runs())[1].late);
  EXPECT_EQ(counts.made, 2);
}

TEST(Batch, UnreadableResultOrFolder_IsRefused) {
  const Scratch scratch;
  const RunStore store("e", "1", {scratch.folder});
  ExperimentSpec spec = short_spec();
  spec.store = &store;
  const std::vector<BatchRun> runs = two_runs();
  const std::string name = store.name_of("seed 1", runs[1].spec);
  const fs::path file = scratch.write(name + ".json", "{\"run\": \"seed 1\"}");
  expect_words(refusal([&] { run_batch(spec, runs); }), {name + ".json", "seed"});
  fs::remove(file);
  const fs::path blocked = scratch.write("file", "");
  const RunStore nowhere("e", "1", {blocked / "runs"});
  spec.store = &nowhere;
  spec.threads = 1;
  RunCounts counts;
  spec.counts = &counts;
  expect_words(refusal([&] { run_batch(spec, runs); }), {"cannot create the folder"});
}

}  // namespace
}  // namespace burnish::testing
