"""burnish.stand: the task from Python. The C++ tests check the results of runs."""

import os
import pickle
from pathlib import Path

import burnish
import numpy as np
import pytest
from burnish import stand

SHIPPED = Path(os.environ.get("BURNISH_ROBOTS", burnish.robot_search_path()[0])).parent / "tasks/stand/quadruped.yaml"


def test_task_with_overrides_round_trips_through_its_text(tmp_path):
    task = stand.make_task(SHIPPED, sway_duration=4.0, overrides=["sway.rise=2", "disturbances=sensors"])
    assert task.sway.rise == 2.0 and task.disturbances.mass_scale == 1.0
    (tmp_path / "task.yaml").write_text(stand.task_text(task))
    assert stand.read_task(tmp_path / "task.yaml") == task
    assert stand.read_task(SHIPPED) != task
    assert stand.task_units()["sway.shift_rate"] == "Hz"


def test_setting_has_feet_as_supports_and_finds_a_posture():
    task = stand.make_task(SHIPPED)
    setting = stand.make_setting(task)
    assert [s.frame for s in setting.scene.supports()] == task.standing.feet
    assert setting.base == "trunk" and setting.sway_end == 8.5
    np.testing.assert_allclose(setting.heading, np.eye(3))
    stand.refuse_out_of_reach(task, setting)
    lower = stand.make_setting(task.replace(posture="search", crouch=0.4))
    assert lower.p_base[2] < setting.p_base[2] - 0.02


@pytest.mark.skipif(not burnish.has_mujoco(), reason="without MuJoCo there are no feet to stand on")
def test_run_has_figures_and_pickles():
    result = stand.run(SHIPPED, sway_duration=0.8, settle_duration=0.1, rest_duration=0.1,
                       overrides=["sway.rise=0.4", "standing.settle=0.2", "sway.shift=[0.01, 0, 0.01]"])
    assert result.succeeded and not result.fell and result.outcome.startswith("stood")
    assert 0.0 < result.sway.com_rmse < 5e-3 and result.standing.min_load > 12.0
    again = pickle.loads(pickle.dumps(result))
    assert again.sway == result.sway and again.fell == result.fell
    assert stand.phase_names() == ["settle", "sway", "rest"]


def test_setting_of_another_robot_finds_its_feet():
    setting = stand.make_setting(stand.make_task(SHIPPED, robot="talos"))
    assert setting.standing.feet == ["left_sole_link", "right_sole_link"]
    assert setting.standing.half_x == pytest.approx(0.105)
    assert "(found)" in setting.notes[0]


@pytest.mark.parametrize("work, words", [
    (lambda: stand.make_task(sways=3), "no entry 'sways'"),
    (lambda: stand.make_task(overrides=["sways=3"]), "did you mean 'sway'"),
    (lambda: stand.make_task(SHIPPED, sway_duration=1.0), "sway.rise: it is 1.5 s"),
    (lambda: stand.make_setting(stand.make_task(SHIPPED, robot="arm7")), "no feet were found"),
    (lambda: stand.run(SHIPPED, overrides=["sway.shift=[0, 0.2, 0]", "sway.fit=false"]), "cannot stand"),
    (lambda: stand.run(SHIPPED, plant="ideal"), "cannot simulate support"),
    (lambda: stand.read_task("nowhere.yaml"), "nowhere.yaml"),
])
def test_invalid_input_raises(work, words):
    with pytest.raises((burnish.Error, AttributeError, TypeError)) as refusal:
        work()
    assert words in str(refusal.value)
