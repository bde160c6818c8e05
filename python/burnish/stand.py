"""Task of standing on feet and swaying, and its runs.

    from burnish import stand
    result = stand.run("tasks/stand/quadruped.yaml", overrides=["disturbances=joint_friction"])
    print(result.outcome, result.fell, result.sway.com_rmse, result.standing.min_load)
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, Callable, Optional, Sequence, Union

from ._core import StandResult as RunResult
from ._core import stand_check_task as check_task
from ._core import stand_make_controller as make_controller
from ._core import stand_make_setting as make_setting
from ._core import stand_override_task as override_task
from ._core import stand_phase_names as phase_names
from ._core import stand_read_task as read_task
from ._core import stand_refuse_out_of_reach as refuse_out_of_reach
from ._core import stand_run_task as run_task
from ._core import stand_task_text as task_text
from ._core import stand_task_units as task_units
from ._task import with_changes
from .model import Robot
from .mpc import ModelErrorOptions, SafetyLimits
from .pressing import PlanLimits, PlantKind, Standing
from .sim import Disturbances, SceneSpec, SurfaceSpec

__all__ = [
    "RunResult", "RunSpec", "Setting", "Sway", "SwayFigures", "Task", "Weights", "check_task",
    "make_controller", "make_setting", "make_task", "override_task", "phase_names", "read_task",
    "refuse_out_of_reach", "run", "run_task", "task_text", "task_units",
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
        Changes as for override_task(), such as "sway.rise=2".
    **entries
        Entries of Task, such as robot="my_robot.urdf" or sway_duration=4.0.

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
    >>> stand.run("my_task.yaml", overrides=["disturbances=sensors"])
    """
    task = make_task(where, overrides=overrides, **entries)
    spec = RunSpec(task=task, check_reach=check_reach, progress=progress)
    if plant is not None:
        spec.plant = plant  # type: ignore[assignment]  # Spec accepts names of enumerators
    return run_task(spec)
