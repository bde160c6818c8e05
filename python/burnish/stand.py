"""The task of standing on feet and swaying, and its runs.

    from burnish import stand
    result = stand.run("tasks/stand/quadruped.yaml", overrides=["disturbances=joint_friction"])
    print(result.outcome, result.fell, result.sway.com_rmse, result.standing.least_load)
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
from .sim import Disturbances, SceneSpec

__all__ = [
    "RunResult", "RunSpec", "Setting", "Sway", "SwayFigures", "Task", "Weights", "check_task",
    "make_controller", "make_setting", "make_task", "override_task", "phase_names", "read_task",
    "refuse_out_of_reach", "run", "run_task", "task_text", "task_units",
]


# Described classes stand here (scripts/describe).


def make_task(
    where: Union[str, Path, Task, None] = None,
    *,
    overrides: Sequence[str] = (),
    **entries: Any,
) -> Task:
    """A task: from a file, a copy of another, or the defaults.

    overrides: as override_task() takes them, "sway.rise=2". entries: of Task, such as
    robot="my_robot.urdf" or sway_duration=4.0. Raises Error for what does not fit together."""
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
    """run_task() of make_task(). plant: "mujoco", which alone has feet to stand on.

        stand.run("my_task.yaml", overrides=["disturbances=sensors"])
    """
    task = make_task(where, overrides=overrides, **entries)
    spec = RunSpec(task=task, check_reach=check_reach, progress=progress)
    if plant is not None:
        spec.plant = plant  # type: ignore[assignment]  # names are taken for members
    return run_task(spec)
