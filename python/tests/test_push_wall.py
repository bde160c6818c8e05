"""burnish.push_wall: the task from Python. The C++ tests check the results of runs."""

import os
from pathlib import Path

import burnish
import pytest
from burnish import push_wall

SHIPPED = Path(os.environ.get("BURNISH_ROBOTS", burnish.robot_search_path()[0])).parent / "tasks/push_wall/talos.yaml"


def test_task_with_overrides_round_trips_through_its_text(tmp_path):
    task = push_wall.make_task(SHIPPED, force=40.0, overrides=["force_search.rate=5", "disturbances=sensors"])
    assert task.force_search.rate == 5.0 and task.disturbances.mass_scale == 1.0
    (tmp_path / "task.yaml").write_text(push_wall.task_text(task))
    assert push_wall.read_task(tmp_path / "task.yaml") == task
    assert push_wall.read_task(SHIPPED) != task
    assert push_wall.task_units()["force_search.rate"] == "N/s"


def test_setting_has_feet_and_hands_as_supports():
    task = push_wall.make_task(SHIPPED)
    setting = push_wall.make_setting(task)
    assert [s.frame for s in setting.scene.supports()] == task.standing.feet + task.hands
    assert setting.p_hands.shape == (3, 2)
    assert setting.touch < setting.ramp_end < setting.hold_end < setting.search_end < setting.top_end
    push_wall.refuse_out_of_reach(task, setting)


@pytest.mark.parametrize("work, words", [
    (lambda: push_wall.make_task(forse=3), "no entry 'forse'"),
    (lambda: push_wall.make_task(overrides=["forse=3"]), "did you mean 'force'"),
    (lambda: push_wall.make_task(SHIPPED, force=500.0), "limits.force: the limit is 400 N"),
    (lambda: push_wall.make_setting(push_wall.make_task(SHIPPED, hands=["left_tol", "tool"])), "left_tool"),
    (lambda: push_wall.run(SHIPPED, plant="ideal"), "cannot simulate support"),
    (lambda: push_wall.read_task("nowhere.yaml"), "nowhere.yaml"),
])
def test_invalid_input_raises(work, words):
    with pytest.raises((burnish.Error, AttributeError, TypeError)) as refusal:
        work()
    assert words in str(refusal.value)
