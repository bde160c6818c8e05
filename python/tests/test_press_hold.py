"""Pressing at a point while the arm moves aside, from Python: files, runs on both plants, results."""

from __future__ import annotations

import json
import os
import pickle
from pathlib import Path

import numpy as np
import pytest

import burnish
from burnish import press_hold

SHIPPED = Path(os.environ.get("BURNISH_ROBOTS", burnish.robot_search_path()[0])).parent / "tasks/press_hold/arm7.yaml"
SHORT = dict(aside_duration=0.5, hold_duration=0.3)


@pytest.fixture(scope="module")
def result():
    return press_hold.run(SHIPPED, plant="ideal", **SHORT)


def test_task_text_reads_back_unchanged(tmp_path):
    task = press_hold.make_task(SHIPPED, force=12.5, aside={"joint_3": -0.25}, overrides=["posture=bent"])
    (tmp_path / "task.yaml").write_text(press_hold.task_text(task))
    back = press_hold.read_task(tmp_path / "task.yaml")
    assert back == task and back.aside == {"joint_3": -0.25} and back.posture == "bent"
    assert press_hold.read_task(SHIPPED) != task


def test_arm_moving_aside_keeps_force_and_point(result):
    assert result.succeeded and result.outcome.startswith("held"), result.outcome
    assert result.hold.moved_aside > 0.1 and result.hold.slip < 2e-3
    assert result.metrics.force_rmse < 1.0 and result.metrics.without_contact == 0.0
    assert result.trace["phase"][-1] == press_hold.phase_names().index("retreat")
    assert result.ticks.count > 1000 and len(result.plans.time) > 10
    assert result.setting.q_aside[2] - result.setting.q_start[2] == pytest.approx(0.6)


def test_run_on_another_robot_fits_the_task_with_a_warning():
    arm = "talos:right_arm"
    with pytest.warns(UserWarning, match="aside: robot 'talos' does not have"):
        other = press_hold.run(SHIPPED, robot=arm, plant="ideal", **SHORT)
    assert other.succeeded, other.outcome
    task, changes = press_hold.fit_to_robot(press_hold.make_task(SHIPPED, robot=arm, **SHORT))
    assert len(changes) == 2 and task == other.task
    own = press_hold.make_task(SHIPPED)
    assert press_hold.fit_to_robot(own) == (own, [])


@pytest.mark.skipif(not burnish.has_mujoco(), reason="this build has no MuJoCo")
def test_run_on_mujoco_keeps_force_and_point():
    result = press_hold.run(SHIPPED, **SHORT)
    assert result.succeeded and result.plant.name == "MUJOCO", result.outcome


def test_write_creates_the_files_of_a_run(result, tmp_path):
    try:
        names = result.write(tmp_path, name="mine")
    except burnish.Error as error:
        pytest.skip(str(error))
    assert {"trace.csv", "metrics.json", "task.yaml"} <= set(names)
    figures = json.loads((tmp_path / "metrics.json").read_text())
    assert figures["hold"]["slip_m"] == result.hold.slip and figures["name"] == "mine"
    assert press_hold.read_task(tmp_path / "task.yaml") == result.task


def test_result_pickles_unchanged(result):
    other = pickle.loads(pickle.dumps(result))
    np.testing.assert_array_equal(other.trace["time"], result.trace["time"])
    assert (other.hold, other.outcome, other.task) == (result.hold, result.outcome, result.task)


def test_progress_returning_false_interrupts_the_run():
    result = press_hold.run(SHIPPED, plant="ideal", progress=lambda time, end: time < 0.1)
    assert result.interrupted and not result.succeeded and result.hold is None


def test_make_controller_in_an_own_loop_gives_the_forces_of_the_run(result):
    task, setting = result.task, result.setting
    controller = press_hold.make_controller(task, setting)
    plant = burnish.make_ideal_plant(burnish.plant_model(setting.robot.model, task.disturbances),
                                     burnish.plant_scene(setting.scene, task.disturbances))
    loop = burnish.ClosedLoop(plant, controller, task.disturbances,
                              burnish.ClosedLoopOptions(control_period=1.0 / task.tick_rate))
    loop.reset(setting.q_start, np.zeros(setting.robot.model.nv))
    loop.run(setting.ramp_end + 0.1)
    rows = len(loop.trace)
    np.testing.assert_array_equal(loop.trace["tool_force_z_world"], result.trace["tool_force_z_world"][:rows])


@pytest.mark.parametrize("call, words", [
    (lambda: press_hold.make_task(forse=3), "no entry 'forse'"),
    (lambda: press_hold.make_task(overrides=["forse=3"]), "did you mean 'force'"),
    (lambda: press_hold.make_task(force=-3.0), "force is -3"),
    (lambda: press_hold.make_task(touch_force=50.0), "phases.touch_force: it is 50 N"),
    (lambda: press_hold.make_setting(press_hold.make_task(tool="tol")), "tool.frame: "),
    (lambda: press_hold.make_setting(press_hold.make_task(aside={"joint_33": 1.0})), "aside.joint_33"),
    (lambda: press_hold.run(force=3000.0, overrides=["limits.force=never"]), "out of reach: at the point"),
    (lambda: press_hold.read_task("nowhere.yaml"), "nowhere.yaml"),
    (lambda: press_hold.check_task(press_hold.Task(aside=3)), "Task.aside: got 3"),
])
def test_invalid_task_raises_with_the_reason(call, words):
    with pytest.raises((burnish.Error, AttributeError)) as refused:
        call()
    assert words in str(refused.value)


def test_override_that_is_no_list_is_refused():
    with pytest.raises(burnish.Error, match=r"overrides: got 'force=10'; wanted a list"):
        press_hold.make_task(overrides="force=10")
