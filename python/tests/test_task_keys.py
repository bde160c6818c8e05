"""Every key of every task has an effect: another value changes the run or is refused with a sentence.

All keys take minutes (./test --long); a selection of each task is always tested."""

from __future__ import annotations

import json
import os
from pathlib import Path

import numpy as np
import pytest

import burnish
from burnish import _core
from task_keys import TASKS, UNSEEN, Case

long = pytest.mark.skipif("BURNISH_TEST_LONG" not in os.environ, reason="takes long: ./test --long")
TASK_FILES = Path(os.environ.get("BURNISH_ROBOTS", str(burnish.robot_search_path()[0]))).parent / "tasks"
pytestmark = [pytest.mark.skipif(not TASK_FILES.is_dir(), reason="task files are not beside the robots"),
              pytest.mark.skipif(not burnish.sim.has_mujoco(), reason="the surface's material needs MuJoCo")]

QUICK = {
    "polishing": ["surface.friction", "surface.stiffness", "tool.axis", "search.tilt", "fallback.stiffness",
                  "shape.radius", "weights.rotation", "limits.force", "disturbances.surface_friction"],
    "press_hold": ["surface.friction", "tool.axis", "search.tilt", "limits.slip", "controller.command_delay",
                   "controller.measurement_delay", "disturbances.measurement_delay"],
    "stand": ["standing.friction", "model_error.limit", "limits.sink"],
}
"""Selected keys of each task; the first ones had no effect in an earlier version."""


class Runs:
    """Short runs of the file of a task with other values."""

    def __init__(self, name):
        self.task = TASKS[name]
        self.module = getattr(burnish, self.task.module)
        self.file = TASK_FILES / self.task.file

    def read(self, words):
        return self.module.read_task(self.file, [*self.task.short, *words])

    def made(self, words):
        """Returns everything that distinguishes two runs, except measured times."""
        task = self.read(words)
        options = {"plan_rate": 0.0}
        if self.task.module == "polishing":
            key = words[-1] if words else ""
            options["controller"] = next((kind for kind in ("baseline", "admittance") if key.startswith(kind)), "mpc")
        result = self.module.run_task(self.module.RunSpec(task=task, check_reach=False, **options))
        rows = np.array(result.trace.array())
        rows["solve_time"] = 0.0
        return result.outcome.partition(", simulated in")[0], rows.dtype.names, rows.tobytes()

    def keys(self):
        tree = _core.parse_yaml(self.module.task_text(self.read([])))
        for section, value in tree.items():
            if section == "task":
                continue
            entries = value.items() if isinstance(value, dict) and section != "aside" else [(None, value)]
            for key, of_file in entries:
                yield (section if key is None else f"{section}.{key}"), of_file


def other_values(value):
    """Returns values that a key may have in place of the value in the file."""
    if isinstance(value, bool):
        return [json.dumps(not value)]
    if isinstance(value, int):
        return [str(value + 1), str(max(1, value // 2)), "0.5"] if value else ["0.5", "1"]
    if isinstance(value, float):
        return [repr(0.7 * value), repr(1.5 * value)]
    if isinstance(value, list) and value and all(isinstance(entry, (int, float)) for entry in value):
        return [json.dumps([entry + 0.05 * (i + 1) for i, entry in enumerate(value)])]
    return {"never": ["1", "0.01"], "none": ["0.3"], "endless": ["0.05"]}.get(value if isinstance(value, str) else "", [])


def complaint(runs, key, value):
    """Returns the reason why a key has no effect; empty if it has one."""
    case = runs.task.cases.get(key, Case())
    reasons = []
    reference = None
    for new in case.values or other_values(value):
        words = [*case.setting, f"{key}={new}"]
        try:
            changed = runs.made(words)
        except burnish.Error as error:
            if case.refused:
                return ""
            reasons.append(f"{new}: {error}")
            continue
        if reference is None:
            # The name of the key selects the controller.
            reference = runs.made([*case.setting, f"{key}={_word(value)}"] if key.startswith(("baseline", "admittance"))
                              else case.setting)
        if not case.refused and changed != reference:
            return ""
        reasons.append(f"{new}: the same run")
    return f"{key}: {'; '.join(reasons) or 'no value to try'}"


def _word(value):
    return json.dumps(value)


@pytest.mark.parametrize("name", QUICK)
def test_selected_keys_change_the_run(name):
    runs = Runs(name)
    values = dict(runs.keys())
    assert [text for text in (complaint(runs, key, values[key]) for key in QUICK[name]) if text] == []


@long
@pytest.mark.parametrize("name", TASKS)
def test_every_key_changes_the_run(name):
    runs = Runs(name)
    keys = [(key, value) for key, value in runs.keys() if not {key, f"{name}: {key}"} & set(UNSEEN)]
    complaints = [complaint(runs, key, value) for key, value in keys]
    assert [text for text in complaints if text] == []


@pytest.mark.parametrize("name", TASKS)
def test_cases_name_existing_keys(name):
    keys = {key for key, _ in Runs(name).keys()}
    assert set(TASKS[name].cases) - keys == set()


@pytest.mark.parametrize("name, key", [("press_hold", "disturbances.gyro_noise"), ("press_hold", "limits.base_lost"),
                                       ("stand", "disturbances.surface_friction"), ("stand", "constraints.force_band"),
                                       ("press_hold", "constraints.joint_torque_rate"),
                                       ("push_wall", "disturbances.surface_shape")])
def test_keys_without_effect_in_the_task_are_refused(name, key):
    with pytest.raises(burnish.Error, match=f"key '{key.partition('.')[2]}' has no effect in this task: "):
        Runs(name).read([f"{key}=1"])


def test_unseen_keys_exist_in_some_task():
    keys = {text for name in TASKS for key, _ in Runs(name).keys() for text in (key, f"{name}: {key}")}
    assert set(UNSEEN) - keys == set()
