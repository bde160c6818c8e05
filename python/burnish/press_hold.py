"""The task of pressing at a point while the rest of the arm moves aside, and its runs.

    from burnish import press_hold
    result = press_hold.run("tasks/press_hold/arm7.yaml", force=15.0)
    print(result.hold.slip, result.metrics.force_rmse)
"""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any, Callable, Optional, Sequence, Union

from ._core import HoldResult as RunResult
from ._core import hold_check_reach as check_reach
from ._core import hold_check_task as check_task
from ._core import hold_fit_to_robot as fit_to_robot
from ._core import hold_make_controller as make_controller
from ._core import hold_make_setting as make_setting
from ._core import hold_override_task as override_task
from ._core import hold_phase_names as phase_names
from ._core import hold_read_task as read_task
from ._core import hold_run_task as run_task
from ._core import hold_task_text as task_text
from ._core import hold_task_units as task_units
from ._task import with_changes
from .model import Robot
from .mpc import SafetyLimits
from .pressing import PlanLimits, PlantKind, PostureLimits, ToolLimits
from .sim import Disturbances, SceneSpec

__all__ = [
    "HoldFigures", "RunResult", "RunSpec", "Setting", "Task", "check_reach", "check_task",
    "fit_to_robot", "make_controller", "make_setting", "make_task", "override_task", "phase_names", "read_task",
    "run", "run_task", "task_text", "task_units",
]


# Described classes stand here (scripts/describe).


def make_task(
    where: Union[str, Path, Task, None] = None,
    *,
    overrides: Sequence[str] = (),
    **entries: Any,
) -> Task:
    """A task: from a file, a copy of another, or the defaults.

    overrides: as override_task() takes them, "tool.frame=flange". entries: of Task, such as
    force=15 or aside={"joint_3": 0.4}. Raises Error for what does not fit together."""
    if where is None:
        task = Task()
    else:
        task = where.replace() if isinstance(where, Task) else read_task(where)
    return with_changes(task, entries, overrides, override_task, check_task)


def run(
    where: Union[str, Path, Task, None] = None,
    *,
    plant: Union[str, PlantKind, None] = None,
    overrides: Sequence[str] = (),
    check_reach: bool = True,
    progress: Optional[Callable[[float, float], Optional[bool]]] = None,
    **entries: Any,
) -> RunResult:
    """run_task() of make_task(). plant: "mujoco" or "ideal"; None: MuJoCo where this build has it.

        press_hold.run("my_task.yaml", plant="ideal", overrides=["disturbances=sensors"])

    With another robot the task goes through fit_to_robot(), whose changes are warnings."""
    task = make_task(where, overrides=overrides, **entries)
    if "robot" in entries or any(change.startswith("robot=") for change in overrides):
        task, changes = fit_to_robot(task)
        for change in changes:
            warnings.warn(change, stacklevel=2)
    spec = RunSpec(task=task, check_reach=check_reach, progress=progress)
    if plant is not None:
        spec.plant = plant  # type: ignore[assignment]  # names are taken for members
    return run_task(spec)
