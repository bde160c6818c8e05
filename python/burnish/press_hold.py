"""Task of pressing at a point while the other joints of the arm move aside, and its runs.

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


# scripts/describe inserts the described classes here.


def make_task(
    where: Union[str, Path, Task, None] = None,
    *,
    overrides: Sequence[str] = (),
    **entries: Any,
) -> Task:
    """Makes a task from a task file, another task, or the defaults.

    Parameters
    ----------
    where : str, Path, Task or None
        Task file, task to copy, or None for the defaults.
    overrides : sequence of str
        Changes as for override_task(), such as "tool.frame=flange".
    **entries
        Entries of Task, such as force=15 or aside={"joint_3": 0.4}.

    Returns
    -------
    Task

    Raises
    ------
    Error
        If the file cannot be read, a key is unknown, or values contradict each other.
    """
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
    """Makes a task with make_task() and runs it with run_task().

    Parameters
    ----------
    where, overrides, **entries
        Arguments of make_task().
    plant : str, PlantKind or None
        "mujoco" or "ideal"; None: MuJoCo if this build has it, else ideal.
    check_reach : bool
        If False, run even if the reach check fails.
    progress : callable or None
        Function of the simulated time and the duration [s]; the run stops if it returns False.

    Returns
    -------
    RunResult
        Result of the run. Faults are in the result.

    Raises
    ------
    Error
        If the task is contradictory, or this build does not have the plant.

    Warns
    -----
    UserWarning
        For each change by fit_to_robot(), which is called if `robot` is set in `entries` or `overrides`.

    Examples
    --------
    >>> press_hold.run("my_task.yaml", plant="ideal", overrides=["disturbances=sensors"])
    """
    task = make_task(where, overrides=overrides, **entries)
    if "robot" in entries or any(change.startswith("robot=") for change in overrides):
        task, changes = fit_to_robot(task)
        for change in changes:
            warnings.warn(change, stacklevel=2)
    spec = RunSpec(task=task, check_reach=check_reach, progress=progress)
    if plant is not None:
        spec.plant = plant  # type: ignore[assignment]  # Spec accepts names of enumerators
    return run_task(spec)
