"""The polishing task from Python: tasks and their files, reach and postures, runs, experiments."""

from __future__ import annotations

import copy
import gc
import os
import pickle
import signal
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import burnish
from burnish import polishing

SHORT = dict(polish_duration=0.6, overrides=["path.start_up=0.3", "path.radius=0.02"],
             update_rate=200.0, plant="ideal")


def short_run(where="table", **changes):
    return polishing.run(where, **{**SHORT, **changes})


@pytest.fixture(scope="module")
def result():
    return short_run(seed=3)


@pytest.fixture(scope="module")
def baseline():
    return short_run(controller="baseline", seed=3)


class TestTasks:
    def test_written_file_reads_back_unchanged(self, tmp_path):
        task = polishing.make_task(
            "tilt_45", seed=41, force=12.5, point_base=[0.3, -0.43, 1.0 / 3.0],
            path=polishing.PathSpec(kind="points", points=[[0.01, -0.02], [1e-5, 0.3]]),
            axes="local", solver="rollout", feedback=False,
            weights=polishing.Weights(terminal=1e-7))
        task.disturbances.pushes.append(burnish.Push(1.0, 0.2, [0.0, 0.0, -20.0]))
        file = tmp_path / "task.yaml"
        polishing.write_task(task, file)
        back = polishing.read_task(str(file))
        assert polishing.task_text(back) == polishing.task_text(task) == file.read_text()
        assert back.axes is polishing.ForceAxes.LOCAL
        assert back.solver is burnish.StepUpdate.ROLLOUT
        np.testing.assert_array_equal(back.path.points, task.path.points)
        assert back.disturbances == task.disturbances
        assert polishing.make_task(file) == back

    def test_empty_file_gives_the_defaults(self, tmp_path):
        (tmp_path / "empty.yaml").write_text("force: 30\n")
        assert polishing.read_task(tmp_path / "empty.yaml") == polishing.Task()

    def test_shipped_table_equals_the_named_task(self):
        robots = Path(os.environ.get("BURNISH_ROBOTS", burnish.robot_search_path()[0]))
        file = robots.parent / "tasks" / "polishing" / "table.yaml"
        if not file.exists():
            pytest.skip("task files are not beside the robots")
        assert polishing.read_task(file) == polishing.make_task("table")

    def test_changes_leave_the_original_task(self):
        task = polishing.Task()
        changed = polishing.override_task(task, ["force=20", "weights.rotation=3"])
        board = polishing.put_on(task, "board")
        made = polishing.make_task(task, seed=5, force=10.0)
        assert task == polishing.Task()
        assert (changed.force, changed.weights.rotation) == (20.0, 3.0)
        np.testing.assert_array_equal(board.normal_base, [-1.0, 0.0, 0.0])
        assert (made.disturbances.seed, made.force) == (5, 10.0)
        made.disturbances.seed = 6
        assert task.disturbances.seed == 0

    def test_given_disturbances_are_copied(self):
        mine = burnish.Disturbances(mass_scale=1.02)
        task = polishing.make_task("table", disturbances=mine, seed=7)
        assert mine.seed == 0 and task.disturbances.seed == 7
        assert task.disturbances.mass_scale == 1.02

    def test_copied_or_pickled_task_is_equal_and_independent(self):
        task = polishing.make_task("board", seed=2)
        for other in (pickle.loads(pickle.dumps(task)), copy.deepcopy(task)):
            assert other == task
            other.path.radius = 0.01
            assert task.path.radius == 0.07

    @pytest.mark.parametrize("call, words", [
        (lambda t: polishing.override_task(t, ["froce=3"]), "did you mean 'force'"),
        (lambda t: polishing.override_task(t, ["force=-3"]), "force"),
        (lambda t: polishing.put_on(t, "tabel"), "did you mean 'table'"),
        (lambda t: polishing.disturbance_preset("mismach"), "did you mean 'mismatch'"),
        (lambda t: polishing.make_task("table", controller_kind=1), "no entry 'controller_kind'"),
        (lambda t: polishing.check_task(t.replace(force=300.0)), "limits.force"),
        (lambda t: polishing.check_task(t.replace(force="much")), "Task.force: got 'much'"),
        (lambda t: polishing.check_task(t.replace(axes="toll")), "ForceAxes: there is no 'toll'"),
        (lambda t: polishing.read_task("nowhere.yaml"), "nowhere.yaml"),
        (lambda t: polishing.run("table", controller="mcp"), "did you mean 'mpc'"),
        (lambda t: polishing.perform_experiment("papr"), "did you mean 'paper'"),
    ])
    def test_invalid_input_raises_with_the_reason(self, call, words):
        with pytest.raises((burnish.Error, AttributeError)) as refused:
            call(polishing.Task())
        assert words in str(refused.value)

    def test_surfaces_and_presets_are_listed(self):
        assert [s.name for s in polishing.named_surfaces()] == [
            "table", "board", "board_x", "board_y", "board_minus_y", "tilt_45"]
        assert polishing.disturbance_presets() == ["none", "sensors", "mismatch", "joint_friction"]
        assert polishing.disturbance_preset("none") == burnish.Disturbances()

    def test_doubtful_settings_are_noted(self):
        slow = polishing.make_task("table", overrides=["controller.torque_cutoff=60"])
        assert any("lag" in note for note in polishing.task_notes(slow))
        assert polishing.task_notes(polishing.make_task("table")) == []
        ideal = polishing.make_task("table", disturbances="none")
        assert "the world is ideal" in polishing.task_notes(ideal)[0]
        assert polishing.task_notes(ideal, ideal_is_meant=True) == []


class TestPaths:
    def test_derivatives_match_finite_differences(self):
        path = polishing.SurfacePath(polishing.PathSpec(kind="spiral"))
        t, h = 2.7, 1e-6
        before, now, after = path.at(t - h), path.at(t), path.at(t + h)
        np.testing.assert_allclose((after.p - before.p) / (2 * h), now.v, atol=1e-7)
        np.testing.assert_allclose((after.v - before.v) / (2 * h), now.a, atol=1e-7)

    def test_positions_at_many_times_are_rows(self):
        path = polishing.SurfacePath(polishing.PathSpec())
        times = np.linspace(-1.0, 9.0, 7)
        rows = path.positions(times)
        assert rows.shape == (7, 2)
        np.testing.assert_array_equal(rows, [path.at(t).p for t in times])
        assert np.isinf(path.duration)

    def test_path_of_points_ends_at_the_last(self):
        corners = np.array([[0.05, 0.0], [0.05, 0.05]])
        path = polishing.SurfacePath(polishing.PathSpec(kind="points", points=corners))
        assert 1.0 < path.duration < 10.0
        np.testing.assert_allclose(path.at(path.duration).p, corners[-1], atol=1e-12)

    def test_negative_radius_raises(self):
        with pytest.raises(burnish.Error, match="radius"):
            polishing.SurfacePath(polishing.PathSpec(radius=-1.0))


class TestReach:
    def test_table_is_reported_as_reachable(self):
        report = polishing.check_reach(polishing.make_task("table"))
        assert report.ok and report.problem is polishing.ReachProblem.NONE
        assert report.points > 50 and 0.4 < report.path_length < 0.7
        assert report.tightest_joint and 0.0 < report.torque_share < 0.8

    def test_large_force_is_reported_as_a_torque_problem(self):
        task = polishing.make_task("table", force=500.0, overrides=["limits.force=2000"])
        report = polishing.check_reach(task)
        assert not report.ok and report.problem is polishing.ReachProblem.TORQUE
        assert "pressing with 500 N" in report.text and report.value > report.limit > 0.0
        with pytest.raises(burnish.Error, match="out of reach"):
            short_run(task)
        coarse = polishing.ReachOptions(torque_share=100.0)
        assert polishing.check_reach(task, options=coarse).problem is not polishing.ReachProblem.TORQUE

    def test_run_from_home_moves_to_the_start_and_polishes(self):
        task = polishing.make_task("table", overrides=["home=board_y", "home.speed_ratio=0.5"])
        assert task.home == polishing.HomeSpec(posture="board_y", speed_ratio=0.5)
        setting = polishing.make_setting(task)
        home = setting.home
        assert len(home.corners) == len(home.durations) + 1
        np.testing.assert_array_equal(home.corners[-1], setting.q_start)
        assert polishing.check_home(task, setting).ok
        assert "board_y" in [free.posture for free in polishing.free_homes(task, setting)]
        result = short_run(home=task.home, controller="baseline")
        assert result.succeeded, result.outcome
        phase = result.trace["phase"]
        assert phase[0] == burnish.pressing.Phase.HOME and phase[-1] == burnish.pressing.Phase.TRACK
        assert polishing.make_setting(polishing.make_task("table")).home is None

    def test_searched_posture_is_the_start_of_the_setting(self):
        task = polishing.make_task("table", normal_base=[-1.0, 0.5, 1.5], posture="search")
        found = polishing.find_posture(task)
        assert found.reach.ok and found.candidates > 0 and found.tilt < 1.0
        np.testing.assert_array_equal(found.q, polishing.find_posture(task).q)
        setting = polishing.make_setting(task)
        np.testing.assert_array_equal(setting.q_start, found.q)
        tool = burnish.frame_placement(setting.robot.model, found.q, task.tool)
        normal = setting.surface_axes[:, 2]
        into = -polishing.pressing_axis(tool)
        tilt = np.arctan2(np.linalg.norm(np.cross(into, normal)), into @ normal)
        assert tilt == pytest.approx(found.tilt, abs=1e-6)

    def test_search_options_come_from_the_task(self):
        task = polishing.make_task("table", overrides=["search.body_distance=0.3"])
        assert polishing.posture_options(task).body_distance == 0.3
        task.tool_axis = [0.0, 2.0, 0.0]
        model = burnish.load_robot(task.robot).model
        np.testing.assert_array_equal(polishing.pressing_direction(task, model), [0.0, 1.0, 0.0])
        task.tool_axis = None
        np.testing.assert_array_equal(polishing.pressing_direction(task, model), [0.0, 0.0, -1.0])

    def test_extent_of_the_surface_is_beyond_the_path(self):
        task = polishing.make_task("table", extent=0.2)
        assert polishing.make_setting(task).scene.tool().surface.extent == pytest.approx(0.27)
        task.extent = float("inf")
        assert np.isinf(polishing.make_setting(task).scene.tool().surface.extent)

    def test_search_without_a_posture_raises(self):
        task = polishing.make_task("table", posture="search", overrides=["path.radius=2"])
        with pytest.raises(burnish.Error, match="no posture was found"):
            polishing.find_posture(task)


class TestSetting:
    def test_setting_has_consistent_path_and_phases(self):
        task = polishing.make_task("board")
        setting = polishing.make_setting(task)
        normal = setting.surface_axes[:, 2]
        np.testing.assert_allclose(normal, [-1.0, 0.0, 0.0], atol=1e-12)
        path = polishing.SurfacePath(task.path)
        point = polishing.task_point(task, setting, path, setting.ramp_end + 3.0)
        wanted = setting.p_center + setting.surface_axes[:, :2] @ path.at(3.0).p
        np.testing.assert_allclose(point.p_world, wanted, atol=1e-12)
        assert point.force == task.force
        assert 0.0 < setting.reach_end < setting.touch < setting.ramp_end < setting.track_end

    def test_robot_without_its_posture_raises(self):
        task = polishing.make_task("board")
        setting = polishing.make_setting(task)
        again = polishing.make_setting(task, setting.robot, setting.q_start)
        np.testing.assert_array_equal(again.p_center, setting.p_center)
        with pytest.raises(burnish.Error, match="wanted both or neither"):
            polishing.make_setting(task, robot=setting.robot)

    def test_setting_gives_the_specs_of_both_controllers(self):
        task = polishing.make_task("table", force=22.0)
        setting = polishing.make_setting(task)
        mpc = polishing.make_mpc(task, setting)
        phases = [p.name.lower() for p in burnish.Phase if p is not burnish.Phase.HOME]
        assert [p.name for p in mpc.schedule] == phases
        assert mpc.task.target(setting.ramp_end + 1.0).force == 22.0
        baseline = polishing.make_baseline(task, setting)
        assert baseline.path.task(1.0).force == 22.0
        np.testing.assert_array_equal(baseline.path.posture, setting.q_start)

    def test_unstated_gains_are_fitted_to_the_arm(self):
        task = polishing.make_task("table")
        setting = polishing.make_setting(task)
        fitted, report = polishing.fit_gains(task, setting)
        assert task.weights.position is None and task.model_error.transient_scale is None
        assert fitted.weights.position == 1e5 and fitted.model_error.transient_scale == 6.0
        assert fitted.model_error.force_gain == 0.5 and 4e-3 < fitted.model_error.lag < 5e-3
        assert report.meets and "weights.position 100000 in place of 10000" in report.changes
        assert polishing.make_mpc(task, setting).model_error == fitted.model_error
        margins = polishing.margins(task, setting)
        assert 2e-3 <= margins.delay == min(margins.air.delay, margins.contact.delay)
        assert [gain.joint for gain in margins.air.gains][0] == "torso_1_joint"
        stated = task.replace(weights=task.weights.replace(position=2e4))
        assert polishing.fit_gains(stated, setting)[0].weights.position == 2e4
        hasty = task.replace(model_error=task.model_error.replace(lag=0.0))
        slower, report = polishing.fit_gains(hasty, setting, polishing.RequiredMargins(delay=5e-3, gain=1.5))
        assert report.meets and slower.model_error.bandwidth < 120.0
        assert "weights.position 100000 in place of 10000" in short_run("table").fitted

    def test_too_long_steps_give_complaints(self):
        task = polishing.make_task("table")
        mpc = polishing.make_mpc(task, polishing.make_setting(task))
        assert burnish.step_complaints(mpc) == []
        for stage in mpc.problem.stages:
            stage.step = 0.2
        assert any("kd 40" in sentence for sentence in burnish.step_complaints(mpc))
        with pytest.raises(burnish.Error, match="controller.step"):
            polishing.run_task(polishing.RunSpec(task.replace(step=0.2)))

    def test_controller_in_an_own_loop_gives_the_bits_of_the_run(self):
        task = polishing.make_task("table", **{k: v for k, v in SHORT.items() if k != "plant"})
        setting = polishing.make_setting(task)
        controller = burnish.MpcController(polishing.make_mpc(task, setting))
        model = setting.robot.model
        plant = burnish.make_ideal_plant(burnish.plant_model(model, task.disturbances),
                                         burnish.plant_scene(setting.scene, task.disturbances))
        loop = burnish.ClosedLoop(plant, controller, task.disturbances,
                                  burnish.ClosedLoopOptions(control_period=1.0 / task.tick_rate))
        loop.reset(setting.q_start, np.zeros(model.nv))
        loop.run(setting.ramp_end + 0.3)
        whole = short_run("table")
        rows = len(loop.trace)
        for column in ("tool_force_z_world", "q_torso_1_joint", "tau_applied_arm_right_2_joint"):
            np.testing.assert_array_equal(loop.trace[column][:rows], whole.trace[column][:rows])


class TestRuns:
    def test_both_controllers_polish(self, result, baseline):
        for run in (result, baseline):
            assert run.succeeded and run.outcome.startswith("polished")
            assert run.plant_status is burnish.Status.OK
            assert run.fault.kind is burnish.FaultKind.NONE and not run.interrupted
            assert run.metrics.force_mean == pytest.approx(30.0, abs=2.0)
            assert run.metrics.without_contact < 0.01
            assert run.reach.ok and run.reach.points > 10
            assert run.ticks.count > 500 and run.ticks.median <= run.ticks.p99 <= run.ticks.maximum
        assert result.controller is polishing.ControllerKind.MPC
        assert result.plant is polishing.PlantKind.IDEAL
        assert result.metrics.solver is not None and baseline.metrics.solver is None
        assert repr(result).startswith("<RunResult: mpc on ideal; polished: ")

    def test_stricter_verdict_fails_the_run(self, baseline):
        figures = baseline.verdict
        assert figures.contact_share > 0.99 and figures.path_share > 0.99
        assert 0.0 < figures.force_rmse < 0.1 * baseline.task.force
        strict = polishing.Verdict(force_rmse=0.1 * figures.force_rmse / baseline.task.force)
        run = short_run(controller="baseline", seed=3, verdict=strict)
        assert not run.succeeded and run.fault.kind is burnish.FaultKind.NONE
        assert "verdict.force_rmse allows" in run.outcome and run.verdict == figures
        with pytest.raises(burnish.Error, match="verdict.path_share is 2"):
            polishing.make_task(verdict=polishing.Verdict(path_share=2.0))

    def test_metrics_match_the_trace(self, result):
        rows, metrics = result.trace.array(), result.metrics
        inside = (rows["time"] >= metrics.start) & (rows["time"] <= metrics.end)
        assert inside.sum() == metrics.rows
        axes, row = result.setting.surface_axes, rows[inside]
        force = sum(row[f"tool_force_{a}_world"] * axes[i, 2] for i, a in enumerate("xyz"))
        error = force - row["target_force"]
        assert metrics.force_rmse_raw == pytest.approx(np.sqrt(np.mean(error**2)), rel=1e-9)
        assert metrics.force_mean == pytest.approx(np.mean(force), rel=1e-9)
        assert metrics.force_peak_raw == pytest.approx(np.max(np.abs(error)), rel=1e-9)
        off = np.stack([row[f"tool_{a}_world"] - row[f"target_{a}_world"] for a in "xyz"])
        distance = np.linalg.norm(axes[:, :2].T @ off, axis=0)
        assert metrics.position_rmse == pytest.approx(np.sqrt(np.mean(distance**2)), rel=1e-9)
        again = burnish.measure(
            result.trace, result.setting.robot.model,
            burnish.MetricsSpec(start=metrics.start, end=metrics.end, normal_world=axes[:, 2]))
        assert again.force_rmse == metrics.force_rmse

    def test_same_seed_gives_the_same_bits(self, result):
        again, other = short_run(seed=3), short_run(seed=4)
        wall_clock = ["solve_time"]
        columns = [c for c in result.trace.columns if c not in wall_clock]
        np.testing.assert_array_equal(again.trace.array()[columns], result.trace.array()[columns])
        assert again.metrics.force_rmse == result.metrics.force_rmse != other.metrics.force_rmse
        np.testing.assert_array_equal(again.plans.q, result.plans.q)

    def test_plans_start_at_the_state_and_follow_the_path(self, result):
        plans = result.plans
        count = len(plans.time)
        assert plans.costs.shape == (len(plans.terms), count) and "force" in plans.terms
        assert plans.q.shape == (count, plans.q.shape[1], 6) and plans.q.dtype == np.float32
        assert (plans.q.shape[1] - 1) * plans.step == pytest.approx(result.task.horizon, abs=plans.step)
        names = result.setting.robot.model.q_names
        i = count // 2
        row = np.argmin(np.abs(result.trace["time"] - plans.time[i]))
        q = [result.trace[f"q_{name}"][row] for name in names]
        np.testing.assert_allclose(plans.q[i, 0], q, atol=2e-3)

    def test_trace_outlives_its_result(self):
        run = short_run(controller="baseline")
        time, rows, force = run.trace["time"], run.trace.array(), run.trace["tool_force_z_world"]
        last, total = time[-1], force.sum()
        del run
        gc.collect()
        blocks = [np.ones(100_000) for _ in range(50)]
        assert time[-1] == last == rows["time"][-1] and force.sum() == total and blocks
        with pytest.raises(ValueError):
            time[0] = 1.0

    def test_pickled_result_is_equal(self, result):
        back = pickle.loads(pickle.dumps(result))
        np.testing.assert_array_equal(back.trace.array(), result.trace.array())
        assert back.task == result.task and back.metrics == result.metrics
        assert back.plans == result.plans and back.reach == result.reach
        assert back.outcome == result.outcome and repr(back) == repr(result)
        np.testing.assert_array_equal(back.setting.p_center, result.setting.p_center)

    def test_run_without_plans_has_an_empty_record(self, baseline):
        assert baseline.plans.time.shape == (0,) and baseline.plans.q.size == 0
        task = polishing.make_task("table", **{k: v for k, v in SHORT.items() if k != "plant"})
        run = polishing.run_task(polishing.RunSpec(task, plant="ideal", plan_rate=0.0,
                                                   check_reach=False))
        assert run.plans.terms == [] and run.reach is None and run.succeeded

    def test_fault_ends_the_run_with_its_report(self):
        task = polishing.make_task("table", polish_duration=0.6)
        task.disturbances.pushes = [burnish.Push(0.2, 1.0, [0.0, 0.0, 1000.0])]
        run = polishing.run(task, plant="ideal")
        assert not run.succeeded and run.metrics is None
        assert run.fault.kind is not burnish.FaultKind.NONE
        assert run.outcome == run.fault.text() and len(run.fault.last_second) > 100

    def test_missing_plant_raises(self):
        if polishing.has_mujoco():
            assert polishing.RunSpec().plant is polishing.PlantKind.MUJOCO
            assert short_run(plant="mujoco").succeeded
        else:
            with pytest.raises(burnish.Error, match="no MuJoCo"):
                short_run(plant="mujoco")


class TestProgress:
    def test_returning_false_interrupts_the_run(self):
        seen = []

        def until(time, end):
            seen.append((time, end))
            return time < 0.3

        run = short_run(progress=until)
        assert run.interrupted and not run.succeeded and run.metrics is None
        assert 0.3 <= seen[-1][0] < 0.4 and seen[-1][1] > 1.5
        assert len(run.trace) == round(seen[-1][0] / 5e-4)

    def test_returning_none_continues_the_run(self):
        seen = []
        assert short_run(controller="baseline", progress=lambda t, end: seen.append(t)).succeeded
        assert len(seen) > 10 and seen == sorted(seen)

    def test_exception_reaches_the_caller(self):
        def fail(time, end):
            raise KeyError("mine")

        with pytest.raises(KeyError, match="mine"):
            short_run(progress=fail)

    def test_ctrl_c_ends_the_run(self):
        timer = threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT))
        timer.start()
        with pytest.raises(KeyboardInterrupt):
            polishing.run("table", plant="ideal", polish_duration=600.0)
        timer.join()

    def test_other_threads_run_meanwhile(self):
        counts, over = [0], threading.Event()

        def count():
            while not over.is_set():
                counts[0] += 1
                time.sleep(1e-3)

        thread = threading.Thread(target=count)
        thread.start()
        before = counts[0]
        run = short_run("table")
        during = counts[0] - before
        over.set()
        thread.join()
        assert during > 20 * run.wall_time

    def test_spec_of_wrong_type_raises(self):
        with pytest.raises(TypeError, match="wanted a RunSpec"):
            polishing.run_task(polishing.Task())


class TestFiles:
    def test_write_creates_the_files_of_the_command_line(self, result, tmp_path):
        try:
            names = result.write(tmp_path / "run", name="mine", page=True, recording=True)
        except burnish.Error as refused:
            if "no fmt" in str(refused):
                pytest.skip(str(refused))
            raise
        assert {"trace.csv", "metrics.json", "task.yaml", "run.json", "run.mcap"} <= set(names)
        assert ("run.html" in names) != ("force.svg" in names)
        assert "force.svg" in result.write(tmp_path / "again", plots=True)
        assert all((tmp_path / "run" / name).stat().st_size > 0 for name in names)
        assert polishing.read_task(tmp_path / "run" / "task.yaml") == result.task
        rows = (tmp_path / "run" / "trace.csv").read_text().count("\n") - 1
        assert rows == pytest.approx(len(result.trace) / 10, abs=2)
        with pytest.raises(burnish.Error, match="record_every"):
            result.write(tmp_path, record_every=0)


class TestExperiments:
    def test_experiments_are_listed(self):
        assert [e.name for e in polishing.experiments()] == [
            "paper", "orientation", "frames", "seeds", "tilt", "surfaces", "robots", "force_test", "standing",
            "tick"]

    def test_seeds_experiment_gives_tables_and_figures(self):
        seen = []
        spec = polishing.ExperimentSpec(
            quick=True, seeds=2, first_seed=5, threads=2, plant="ideal",
            progress=lambda fraction, name: seen.append(fraction))
        report = next(e for e in polishing.experiments() if e.name == "seeds").perform(spec)
        assert not report.interrupted and report.failures == [] and report.findings
        table = report.tables[0]
        assert table is report.table(table.name) and len(table.rows) == 2
        assert table.column("seed") == [5.0, 6.0] and all(len(r) == len(table.names) for r in table.rows)
        assert table.markdown().count("\n") == 4 and table.csv().startswith("seed,")
        assert report.figures and report.figures[0].plot.panels[0].curves
        assert report.tasks[0].task.disturbances.seed in (5, 6)
        assert seen and seen[-1] == pytest.approx(1.0) and min(seen) >= 0.0
        with pytest.raises(burnish.Error, match="no column 'sed'"):
            table.column("sed")

    def test_returning_false_stops_with_the_finished_runs(self):
        spec = polishing.ExperimentSpec(quick=True, seeds=4, threads=1, plant="ideal",
                                        progress=lambda fraction, name: fraction < 0.3)
        report = polishing.perform_experiment("seeds", spec)
        assert report.interrupted and "were stopped" in report.failures[-1]

    def test_exception_in_progress_and_ctrl_c_reach_the_caller(self):
        def fail(fraction, name):
            raise KeyError("mine")

        spec = polishing.ExperimentSpec(quick=True, seeds=2, threads=2, plant="ideal", progress=fail)
        with pytest.raises(KeyError, match="mine"):
            polishing.perform_experiment("seeds", spec)
        timer = threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT))
        timer.start()
        with pytest.raises(KeyboardInterrupt):
            polishing.perform_experiment(
                "seeds", polishing.ExperimentSpec(seeds=1000, threads=1, plant="ideal"))
        timer.join()

    def test_invalid_override_raises_before_any_run(self):
        with pytest.raises(burnish.Error, match="did you mean 'force'"):
            polishing.perform_experiment("paper", polishing.ExperimentSpec(overrides=["froce=3"]))

    def test_folder_without_public_robots_raises(self, tmp_path):
        with pytest.raises(burnish.Error, match="has none of the"):
            polishing.perform_experiment("robots", polishing.ExperimentSpec(folder=str(tmp_path)))
