// Task files: values arrive in the task, written tasks read back, and invalid files are refused
// with the place of the error.
#include "burnish/tasks/polishing/task_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "burnish/tasks/polishing/run.hpp"
#include "burnish/tasks/polishing/stages.hpp"
#include "polishing/descriptions.hpp"
#include "support/refusal.hpp"
#include "support/scratch.hpp"

namespace burnish::testing {
namespace {

namespace fs = std::filesystem;
using namespace burnish::polishing;

const fs::path shipped = fs::path(BURNISH_ROBOTS_DIR).parent_path() / "tasks" / "polishing";

/// Scratch folder for the files of one test.
class TaskFile : public ::testing::Test {
 protected:
  fs::path write(const std::string& text, const std::string& name = "task.yaml") const {
    return scratch_.write(name, text);
  }
  testing::Scratch scratch_;
  const fs::path& folder_ = scratch_.folder;
};

TEST_F(TaskFile, ShippedTable_StatesTheDefaults) {
  Task task;
  put_on(task, "table");
  task.disturbances = disturbance_preset("mismatch");
  EXPECT_EQ(contents(shipped / "table.yaml"), task_text(task))
      << "burnish polish --surface table --write-task tasks/polishing/table.yaml updates it";
  EXPECT_EQ(task_text(read_task(shipped / "table.yaml")), task_text(task));
}

TEST_F(TaskFile, ShippedBoard_IsTheTableTaskOnABoard) {
  Task task;
  put_on(task, "board");
  task.disturbances = disturbance_preset("mismatch");
  EXPECT_EQ(task_text(read_task(shipped / "board.yaml")), task_text(task));
}

/// Task in which every kind of entry differs from its default.
Task unusual_task() {
  Task task;
  put_on(task, "tilt_45");
  task.point_base = Eigen::Vector3d(0.3, -0.43, 1.0 / 3.0);
  task.force = 12.5;
  task.tool_axis = Eigen::Vector3d(0.0, 0.6, 0.8);
  task.extent = std::numeric_limits<double>::infinity();
  task.search = {.tilt = 0.5, .joint_margin = 0.1, .body_distance = 0.2};
  task.path.kind = PathKind::Points;
  task.path.points = {{0.01, -0.02}, {1e-5, 0.1 + 0.2}};
  task.path.rows = 4;
  task.solver = StepUpdate::Rollout;
  task.axes = ForceAxes::Local;
  task.feedback = false;
  task.model_error.kind = ModelErrorKind::Force;
  task.limits.deadline = 0.003;
  task.tool_limits.force = std::numeric_limits<double>::infinity();
  task.tool_limits.late_contact_travel = std::numeric_limits<double>::infinity();
  task.tool_limits.late_contact_time = 7.5;
  task.tool_limits.release = 0.25;
  task.fallback = {.stiffness = 0.0, .damping = 12.0, .saturation_fraction = 0.3};
  task.verdict = {.contact_share = 0.5, .force_rmse = 0.25, .path_share = 0.0};
  task.weights.terminal = 1e-7;
  Disturbances& d = task.disturbances;
  d.seed = 41;
  d.torque_scale = Eigen::VectorXd::LinSpaced(6, 0.8, 1.2);
  d.torque_loop = true;
  d.surface_tilt_deg = {-6.0, 2.5};
  d.surface_friction = 0.5;
  d.surface_height = -0.002;
  d.surface_shape = SurfaceShape{.kind = SurfaceShape::Kind::Ridge, .slope = 0.2, .hollow = true};
  d.surface_motion = {.amplitude = 1e-3, .frequency = 2.5, .drift = -0.01, .start = 0.5};
  d.payload = {.frame = "flange", .mass = 1.2, .com = {0.0, 0.01, 0.1}, .mass_range = 0.3};
  d.pushes = {{1.0, 0.2, {0.0, 0.0, -20.0}}, {2.5, 0.1, {5.0, 0.0, 0.0}}};
  return task;
}

TEST_F(TaskFile, WrittenTask_ReadsBackUnchanged) {
  const Task task = unusual_task();
  const fs::path file = folder_ / "task.yaml";
  write_task(task, file);
  const Task back = read_task(file);
  EXPECT_EQ(task_text(back), task_text(task));
  EXPECT_EQ(back.posture, "tilt_45");
  EXPECT_EQ(*back.point_base, *task.point_base);
  EXPECT_EQ(back.normal_base, task.normal_base);
  EXPECT_EQ(back.path.kind, PathKind::Points);
  ASSERT_EQ(back.path.points.size(), 2U);
  EXPECT_EQ(back.path.points[1], task.path.points[1]);
  EXPECT_EQ(back.solver, StepUpdate::Rollout);
  EXPECT_EQ(back.axes, ForceAxes::Local);
  EXPECT_FALSE(back.feedback);
  EXPECT_EQ(back.model_error.kind, ModelErrorKind::Force);
  EXPECT_EQ(back.limits.deadline, 0.003);
  EXPECT_TRUE(std::isinf(back.tool_limits.force));
  EXPECT_EQ(back.disturbances.seed, 41U);
  EXPECT_EQ(back.disturbances.torque_scale, task.disturbances.torque_scale);
  EXPECT_EQ(back.disturbances.surface_tilt_deg, task.disturbances.surface_tilt_deg);
  EXPECT_EQ(*back.disturbances.surface_friction, 0.5);
  ASSERT_TRUE(back.disturbances.surface_shape.has_value());
  EXPECT_EQ(back.disturbances.surface_shape->kind, SurfaceShape::Kind::Ridge);
  EXPECT_TRUE(back.disturbances.surface_shape->hollow);
  EXPECT_EQ(back.disturbances.surface_motion.drift, -0.01);
  EXPECT_EQ(back.disturbances.payload.frame, "flange");
  EXPECT_EQ(back.disturbances.payload.com, task.disturbances.payload.com);
  EXPECT_EQ(back.disturbances.payload.mass_range, 0.3);
  ASSERT_EQ(back.disturbances.pushes.size(), 2U);
  EXPECT_EQ(back.disturbances.pushes[0].force_world, Eigen::Vector3d(0.0, 0.0, -20.0));
}

TEST_F(TaskFile, OmittedKeys_KeepTheirDefaults) {
  const Task task = read_task(write("force: 20\nweights: {rotation: 3}\n"));
  Task expected;
  expected.force = 20.0;
  expected.weights.rotation = 3.0;
  EXPECT_EQ(task_text(task), task_text(expected));
}

TEST_F(TaskFile, NamedSurfaces_MatchThePosturesOfTheRobot) {
  for (const NamedSurface& surface : named_surfaces()) {
    const Task task = read_task(write("surface: " + surface.name + "\n"));
    const Setting setting = make_setting(task);
    EXPECT_EQ(setting.scene.tool().surface.normal, surface.normal_world.normalized());
    EXPECT_EQ(setting.q_start, setting.robot.posture(surface.posture)) << surface.name;
    EXPECT_NEAR(gap(setting.scene.tool(), setting.p_start), task.clearance, 1e-12);
  }
}

TEST_F(TaskFile, NamedSurface_AcceptsSingleChanges) {
  const Task task = read_task(write("posture: table\nsurface: {name: board, friction: 0.2}\n"));
  EXPECT_EQ(task.normal_base, Eigen::Vector3d(-1.0, 0.0, 0.0));
  EXPECT_EQ(task.posture, "table");
  EXPECT_EQ(task.friction, 0.2);
}

TEST_F(TaskFile, FrameOrPostureMissing_IsRefusedWithItsLine) {
  const auto refused = [](const std::string& text, const std::vector<std::string>& overrides = {}) {
    return refusal([&] {
      const auto parsed = parse_said_task(text, "my.yaml", files::as_overrides(overrides));
      files::placed(parsed.texts, [&] { make_setting(parsed.spec); });
    });
  };
  expect_words(refused("robot: arm7\ntool: {frame: tol}\n"),
               {"my.yaml: line 2: tool.frame: the tool's frame 'tol'", "did you mean 'tool'?"});
  expect_words(refused("robot: arm7\nposture: redy\n"), {"my.yaml: line 2: posture: ", "ready"});
  expect_words(refused("force: 20\n", {"robot=arm8"}), {"override 'robot=arm8': robot: "});
}

TEST_F(TaskFile, FileOfAnotherTask_IsRefused) {
  EXPECT_EQ(parse_task("task: polishing\nforce: 20\n", "my.yaml").force, 20.0);
  expect_words(refusal([] { parse_task("task: press_hold\n", "my.yaml"); }),
               {"my.yaml: line 1: task: the task is 'press_hold'; wanted polishing"});
}

TEST_F(TaskFile, Presets_BuildOnEachOther) {
  const Disturbances sensors = disturbance_preset("sensors");
  const Disturbances mismatch = disturbance_preset("mismatch");
  const Disturbances joint_friction = disturbance_preset("joint_friction");
  EXPECT_EQ(disturbance_preset("none").encoder_bits, 0);
  EXPECT_EQ(sensors.encoder_bits, 17);
  EXPECT_EQ(sensors.mass_scale, 1.0);
  EXPECT_EQ(mismatch.mass_scale, 1.05);
  EXPECT_EQ(*mismatch.surface_friction, 0.3);
  EXPECT_EQ(mismatch.joint_coulomb, 0.0);
  EXPECT_EQ(joint_friction.joint_coulomb, 1.0);
  EXPECT_EQ(joint_friction.joint_viscous, 1.0);
  const Task task = read_task(write(
      "disturbances: {preset: mismatch, seed: 5, mass_scale: 0.9, surface_friction: none}\n"));
  EXPECT_EQ(task.disturbances.mass_scale, 0.9);
  EXPECT_EQ(task.disturbances.seed, 5U);
  EXPECT_FALSE(task.disturbances.surface_friction.has_value());
  EXPECT_EQ(task.disturbances.encoder_bits, 17);
}

TEST_F(TaskFile, SurfaceFrictionBesideAPreset_ExplicitOrLaterWins) {
  const auto friction = [&](const std::string& text, const std::vector<std::string>& overrides) {
    const Task task = read_task(write(text), overrides);
    return task.disturbances.surface_friction.value_or(task.friction);
  };
  EXPECT_EQ(friction("disturbances: mismatch\n", {}), 0.3);
  EXPECT_EQ(friction("surface: {friction: 0.8}\ndisturbances: mismatch\n", {}), 0.8);
  EXPECT_EQ(friction("disturbances: {surface_friction: 0.3}\n", {"surface.friction=0"}), 0.0);
  EXPECT_EQ(friction("force: 30\n", {"surface.friction=0.8", "disturbances=mismatch"}), 0.8);
  EXPECT_EQ(friction("surface: {friction: 0.8}\n", {"disturbances=mismatch"}), 0.3);
  EXPECT_EQ(friction("surface: {friction: 0.8}\ndisturbances: {surface_friction: 0.1}\n", {}), 0.1);
  for (const char* value : {"0", "0.8"}) {
    const Task task = read_task(fs::path(BURNISH_TASKS_DIR) / "polishing" / "table.yaml",
                                {"surface.friction=" + std::string(value)});
    EXPECT_EQ(task.friction, std::stod(value));
    EXPECT_FALSE(task.disturbances.surface_friction.has_value());
  }
}

TEST_F(TaskFile, ToolAxis_OffTheGivenPosture_IsRefused) {
  const auto axis = [](const char* text) {
    Task task = parse_task("surface: table\n", "my.yaml", {"tool.axis=" + std::string(text)});
    (void)make_setting(task);
  };
  for (const char* text : {"[1, 0, 0]", "[0, 1, 0]", "[0, 0, 1]", "[0, -1, 0.5]"})
    expect_words(refusal([&] { axis(text); }),
                 {"tool.axis", "direction into the surface is", "search.tilt"});
  axis("[0, 0, -1]");
  axis("[0.3, 0, -2]");
}

TEST_F(TaskFile, Overrides_ApplyLastAndInOrder) {
  const fs::path file = write("force: 20\ndisturbances: {seed: 3}\n");
  const Task task = read_task(file, {"force=25", "weights.rotation=2", "disturbances=sensors",
                                     "surface=board", "surface.normal=[-1, 0, 0.1]", "force=26"});
  EXPECT_EQ(task.force, 26.0);
  EXPECT_EQ(task.weights.rotation, 2.0);
  EXPECT_EQ(task.posture, "board_x");
  EXPECT_EQ(task.normal_base.z(), 0.1);
  EXPECT_EQ(task.disturbances.encoder_bits, 17);
  EXPECT_EQ(task.disturbances.seed, 3U);
}

TEST_F(TaskFile, OverrideWithSpecialCharacters_IsTakenLiterally) {
  const fs::path file = write("force: 20\n");
  for (const std::string robot : {"my arm #2", "a: b", "a, b", "*x", "it's \"so\"", "- a"}) {
    Task task = read_task(file, {"robot=" + robot});
    EXPECT_EQ(task.robot, robot);
    EXPECT_EQ(parse_task(task_text(task), "written").robot, robot);
  }
  EXPECT_EQ(read_task(file, {"robot='{a'"}).robot, "{a");
}

TEST_F(TaskFile, PathPoints_AreReadFromCsv) {
  write("u [m],w [m]\n0.01,0\n0.02,-0.03\n", "corners.csv");
  const Task task = read_task(write("path: {kind: points, points: corners.csv}\n"));
  ASSERT_EQ(task.path.points.size(), 2U);
  EXPECT_EQ(task.path.points[1], Eigen::Vector2d(0.02, -0.03));
  const Task other =
      read_task(write("path: points\n"), {"path.points=" + (folder_ / "corners.csv").string()});
  EXPECT_EQ(other.path.points, task.path.points);
}

struct InvalidText {
  const char* text;
  std::vector<std::string> words;
};

class InvalidTaskFile : public TaskFile, public ::testing::WithParamInterface<InvalidText> {};

TEST_P(InvalidTaskFile, AnyError_IsRefusedWithItsPlace) {
  const fs::path file = write(GetParam().text);
  std::vector<std::string> words = GetParam().words;
  words.push_back(file.string());
  expect_words(refusal([&] { read_task(file); }), words);
}

INSTANTIATE_TEST_SUITE_P(
    Files, InvalidTaskFile,
    ::testing::Values(
        InvalidText{
            "weights:\n  position_limits: 3\n",
            {"line 2", "weights.position_limits", "was removed", "constraints.joint_margin"}},
        InvalidText{"forse: 3\n", {"line 1", "key 'forse' is unknown", "did you mean 'force'?"}},
        InvalidText{"path:\n  radus: 0.1\n",
                    {"line 2: path: key 'radus'", "did you mean 'radius'?"}},
        InvalidText{"force: 1\nforce: 2\n", {"'force' is stated twice"}},
        InvalidText{"force: -3\n", {"force: it is -3; wanted more than 0"}},
        InvalidText{"force: much\n", {"force: 'much' is not a number"}},
        InvalidText{"force: .inf\n", {"force: '.inf' is not a number"}},
        InvalidText{"path: circl\n", {"path: 'circl' is unknown; did you mean 'circle'?"}},
        InvalidText{"path: {radius: 0}\n", {"path.radius: it is 0"}},
        InvalidText{"path: {radius: 1e300}\n",
                    {"radius is 1e+300; wanted a number from 1e-06 to 100"}},
        InvalidText{"path: {rate: 1e300}\n",
                    {"rate is 1e+300; wanted a finite number of at most 10000"}},
        InvalidText{"path: {kind: zigzag, speed: 1e-300}\n", {"speed is 1e-300"}},
        InvalidText{"path: {kind: points, points: [[1e9, 0]]}\n", {"a point is 1e+09 m"}},
        InvalidText{"path: {kind: points}\n", {"points is empty"}},
        InvalidText{"path: {kind: points, points: none.csv}\n", {"path.points", "none.csv"}},
        InvalidText{"path: {kind: points, points: [[1, 2, 3]]}\n",
                    {"path.points[0]: it has 3 numbers; wanted 2"}},
        InvalidText{"path: {rows: 1}\n", {"path.rows: it is 1; wanted at least 2"}},
        InvalidText{"surface: bord\n", {"surface: 'bord' is unknown; did you mean 'board'?"}},
        InvalidText{"surface: {normal: [0, 0, 0]}\n",
                    {"surface.normal: the normal has no direction"}},
        InvalidText{"surface: {normal: [0, 1]}\n", {"surface.normal: it has 2 numbers; wanted 3"}},
        InvalidText{"surface: {extent: -0.1}\n", {"surface.extent: it is -0.1; wanted at least 0"}},
        InvalidText{"tool: {axis: [0, 0, 0]}\n", {"tool.axis: the axis has no direction"}},
        InvalidText{"search: {distance: 1}\n", {"search: key 'distance'", "body_distance"}},
        InvalidText{"surface: {friction: -0.1}\n", {"surface.friction: it is -0.1"}},
        InvalidText{"surface: {point: here}\n",
                    {"surface.point: it is the text 'here'; wanted a list of 3 numbers"}},
        InvalidText{"weights: {forces: 3}\n", {"weights: key 'forces'", "did you mean 'force'?"}},
        InvalidText{"weights: 3\n", {"weights: it is the number 3; wanted keys with values"}},
        InvalidText{"weights: {force: -1}\n", {"weights.force: it is -1; wanted at least 0"}},
        InvalidText{"controller: {solver: ddp}\n", {"controller.solver: 'ddp' is unknown"}},
        InvalidText{"controller: {iterations: 0.5}\n", {"controller.iterations: it is 0.5"}},
        InvalidText{"controller: {feedback: 3}\n", {"controller.feedback"}},
        InvalidText{"controller: {horizon: 0.055}\n", {"horizon of 0.055 s is not a multiple"}},
        InvalidText{"controller: {step: 0.2}\n",
                    {"controller.step", "0.2 s", "controller.contact_kd is 40", "below 0.05 s"}},
        InvalidText{"controller: {step: 0.1, horizon: 1, contact_kd: 20}\n",
                    {"controller.step", "controller.contact_kd is 20", "below 0.1 s"}},
        InvalidText{"controller: {update_rate: 300}\n",
                    {"update_rate is 300 Hz", "ticks per update"}},
        InvalidText{"controller: {update_rate: 4000}\n", {"update_rate is 4000 Hz"}},
        InvalidText{"controller: {update_rate: 100, solver_delay: 0.02}\n",
                    {"solver_delay is 0.02 s"}},
        InvalidText{
            "force: 120\n",
            {"limits.force is 100 N; wanted more than the largest force of the task, 120 N"}},
        InvalidText{"verdict: {contact_share: 1.5}\n",
                    {"verdict.contact_share: it is 1.5", "fraction between"}},
        InvalidText{"verdict: {path_share: -0.1}\n", {"verdict.path_share: it is -0.1"}},
        InvalidText{"verdict: {force_rmse: 0}\n", {"verdict.force_rmse: it is 0"}},
        InvalidText{"phases: {polish_duration: 1e9}\n",
                    {"phases.polish_duration is 1e+09 s; wanted at most 100000 s"}},
        InvalidText{"phases: {polish_duration: 1e300}\n", {"phases.polish_duration is 1e+300 s"}},
        InvalidText{"phases: {reach_duration: 1e9}\n", {"phases.reach_duration is 1e+09 s"}},
        InvalidText{"phases: {approach_speed: 1e-12}\n",
                    {"phases.clearance / approach_speed is 2e+10 s"}},
        InvalidText{"limits: {late_contact_time: 1e300}\n",
                    {"limits.late_contact_time is 1e+300 s"}},
        InvalidText{"controller: {tick_rate: 1e9}\n",
                    {"controller.tick_rate is 1e+09 Hz; wanted at most 100000 Hz"}},
        InvalidText{"phases: {polish_duration: 9e4}\ncontroller: {tick_rate: 1e4}\n",
                    {"steps; wanted at most 5e+08"}},
        InvalidText{"controller: {horizon: 1e6}\n", {"more than 100000 steps of 0.01 s"}},
        InvalidText{"controller: {step: 1e-9}\n", {"more than 100000 steps of 1e-09 s"}},
        InvalidText{"limits: {force: nevr}\n", {"limits.force: 'nevr' is not a number"}},
        InvalidText{"model_error: {kind: torqe}\n", {"model_error.kind", "did you mean 'torque'?"}},
        InvalidText{"disturbances: mismach\n", {"'mismach' is unknown; did you mean 'mismatch'?"}},
        InvalidText{"disturbances: {torque_nois: 1}\n", {"did you mean 'torque_noise'?"}},
        InvalidText{"disturbances: {pushes: [{start: 1, force: [0, 0, 1]}]}\n",
                    {"disturbances.pushes[0]: key 'duration' is missing"}},
        InvalidText{"- 1\n", {"it is a list; wanted keys with values"}},
        InvalidText{"force: [\n", {"this is not valid YAML"}}));

TEST_F(TaskFile, InvalidOverrides_AreRefusedByName) {
  Task task;
  const auto refused = [&](const std::string& word) {
    return refusal([&] { override_task(task, {word}); });
  };
  expect_words(refused("path.radus=1"),
               {"override 'path.radus=1': path: key 'radus'", "did you mean 'radius'?"});
  expect_words(refused("force=a"), {"override 'force=a': force: 'a' is not a number"});
  expect_words(refused("force"), {"'force' is not an override; wanted key.path=value"});
  expect_words(refused("=3"), {"wanted key.path=value"});
  expect_words(refused("force="), {"wanted key.path=value"});
  expect_words(refused("force=[1"), {"override 'force=[1'", "not valid YAML"});
  expect_words(refused("limits.release=-1"),
               {"override 'limits.release=-1': limits.release: it is"});
  expect_words(refused("fallback.stifness=1"), {"fallback: key", "did you mean 'stiffness'?"});
  expect_words(refused("a b.c: d=1"), {"override"});
}

TEST_F(TaskFile, DoubtfulSettings_AreNoted) {
  Task task;
  task.disturbances = disturbance_preset("mismatch");
  EXPECT_TRUE(task_notes(task).empty());
  task.friction = 0.5;
  ASSERT_EQ(task_notes(task).size(), 1U);
  expect_words(task_notes(task)[0], {"surface.friction of 0.5 has no effect",
                                     "disturbances.surface_friction of 0.3 replaces it"});
  task.friction = 0.3;
  EXPECT_TRUE(task_notes(task).empty());
  task.friction = 0.0;
  task.path.rate = 3.0;
  EXPECT_TRUE(task_notes(task).empty());
  task.torque_cutoff = 60.0;
  ASSERT_EQ(task_notes(task).size(), 1U);
  expect_words(task_notes(task)[0], {"model have a cutoff of 60 rad/s (controller.torque_cutoff)",
                                     "plant's motors have no lag", "which causes overshoot"});
  task.disturbances.torque_cutoff = 50.0;
  EXPECT_TRUE(task_notes(task).empty());
  task.torque_cutoff = 0.0;
  ASSERT_EQ(task_notes(task).size(), 1U);
  expect_words(
      task_notes(task)[0],
      {"model have no lag", "plant's motors have a cutoff of 50 rad/s", "causes oscillation"});
  task.disturbances.torque_cutoff = 500.0;  // 2 ms
  EXPECT_TRUE(task_notes(task).empty());
  task.model_error = {.kind = ModelErrorKind::Force, .bandwidth = 50.0};
  EXPECT_TRUE(task_notes(task).empty());
  task.model_error.bandwidth = 80.0;
  ASSERT_EQ(task_notes(task).size(), 1U);
  expect_words(task_notes(task)[0],
               {"model_error.bandwidth of 80 rad/s causes oscillation", "at most 50 rad/s"});
  task.model_error.kind = ModelErrorKind::Torque;
  EXPECT_TRUE(task_notes(task).empty());
}

TEST_F(TaskFile, IdealWorld_IsNotedUnlessStated) {
  Task task = parse_task("force: 20", "mine.yaml");
  ASSERT_EQ(task_notes(task).size(), 1U);
  expect_words(task_notes(task)[0], {"the world is ideal", "`disturbances: mismatch`",
                                     "`disturbances: none` if an ideal world is intended"});
  EXPECT_TRUE(task_notes(task, true).empty());
  task.disturbances.seed = 3;  // without any disturbance
  EXPECT_EQ(task_notes(task).size(), 1U);
  task.disturbances.command_delay = 1e-3;
  EXPECT_TRUE(task_notes(task).empty());
}

TEST_F(TaskFile, UnreadableFilesAndUnknownNames_AreRefused) {
  expect_words(refusal([] { read_task("nowhere.yaml"); }), {"nowhere.yaml", "cannot be opened"});
  expect_words(refusal([&] { read_task(folder_); }), {"this is a folder"});
  expect_words(refusal([&] { write_task({}, folder_ / "no" / "task.yaml"); }), {"cannot write"});
  Task task;
  expect_words(refusal([&] { put_on(task, "tabel"); }), {"did you mean 'table'?"});
  expect_words(refusal([] { disturbance_preset("sensor"); }), {"did you mean 'sensors'?"});
}

}  // namespace
}  // namespace burnish::testing
