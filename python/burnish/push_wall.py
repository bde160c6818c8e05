"""Task of pushing against a wall with both hands, and its runs.

    from burnish import push_wall
    result = push_wall.run("tasks/push_wall/talos.yaml", force=40.0)
    print(result.push.force_rmse, result.push.largest_force, result.limit)
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, Callable, Optional, Sequence, Union

from ._core import PushResult as RunResult
from ._core import push_check_task as check_task
from ._core import push_make_controller as make_controller
from ._core import push_make_setting as make_setting
from ._core import push_override_task as override_task
from ._core import push_phase_names as phase_names
from ._core import push_read_task as read_task
from ._core import push_refuse_out_of_reach as refuse_out_of_reach
from ._core import push_run_task as run_task
from ._core import push_task_text as task_text
from ._core import push_task_units as task_units
from ._task import with_changes
from .model import Robot
from .mpc import ModelErrorOptions, SafetyLimits
from .pressing import PlanLimits, PlantKind, Standing
from .sim import Disturbances, SceneSpec

__all__ = [
    "ForceSearch", "Limit", "PushFigures", "RunResult", "RunSpec", "Setting", "Task", "Wall", "Weights",
    "check_task", "make_controller", "make_setting", "make_task", "override_task", "phase_names",
    "read_task", "refuse_out_of_reach", "run", "run_task", "task_text", "task_units",
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
        Changes as for override_task(), such as "force_search.rate=5".
    **entries
        Entries of Task, such as force=40 or hands=["left_tool", "tool"].

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
        "mujoco" or None; the other plant does not simulate feet.
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

    Examples
    --------
    >>> push_wall.run("my_task.yaml", overrides=["disturbances=sensors"])
    """
    task = make_task(where, overrides=overrides, **entries)
    spec = RunSpec(task=task, check_reach=check_reach, progress=progress)
    if plant is not None:
        spec.plant = plant  # type: ignore[assignment]  # Spec accepts names of enumerators
    return run_task(spec)
