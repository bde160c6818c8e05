"""Polishing task, its runs and experiments.

    from burnish import plot, polishing
    result = polishing.run("board", seed=1)
    plot.forces(result)
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, List, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._core import (
    RunResult,
    SurfacePath,
    check_home,
    check_reach,
    check_task,
    disturbance_preset,
    disturbance_presets,
    experiments,
    find_posture,
    fit_gains,
    free_homes,
    make_admittance,
    make_baseline,
    make_mpc,
    make_setting,
    margins,
    named_surfaces,
    override_task,
    perform_experiment,
    posture_options,
    pressing_axis,
    pressing_direction,
    put_on,
    read_task,
    run_task,
    task_notes,
    task_point,
    task_text,
    task_units,
    write_task,
)
from ._spec import Spec
from ._task import with_changes
from .contact import SurfaceShape
from .model import Robot
from .mpc import Fallback, FrictionEstimateOptions, LoopMargins, ModelErrorOptions, PlanTiming, SafetyLimits
from .pressing import (
    SEARCHED_POSTURE,
    FoundPosture,
    HomeMove,
    HomeSpec,
    PlanLimits,
    PlanRecord,
    PlantKind,
    PostureLimits,
    PostureOptions,
    ReachOptions,
    ReachProblem,
    ReachReport,
    Standing,
    SurfaceEstimateOptions,
    TickTimes,
    ToolLimits,
)
from .report import PlotSpec
from .sim import AdmittanceGains, Disturbances, ImpedanceGains, SceneSpec, has_mujoco
from .solver import StepUpdate

__all__ = [
    "ControllerKind", "Experiment", "ExperimentReport", "ExperimentSpec", "Figure", "FittedGains", "ForceAxes",
    "ForceProfile", "ForceProfileKind", "FoundPosture", "FreeHome", "HomeMove", "HomeSpec", "NamedSurface", "NamedTask", "PathKind", "PathSpec",
    "PlanLimits", "PlanRecord", "PlanarPoint", "PlantKind", "PostureLimits", "PostureOptions", "ReachOptions",
    "ReachProblem", "ReachReport", "RequiredMargins", "RestFigures", "RestingHand", "ResultCell", "ResultColumn",
    "ResultTable", "RunResult", "RunSpec", "SEARCHED_POSTURE", "Setting", "SurfacePath", "Task", "TaskMargins", "TickTimes", "Verdict",
    "VerdictFigures", "Waving", "Weights", "check_home", "check_reach", "check_task", "disturbance_preset",
    "disturbance_presets", "experiments", "find_posture", "fit_gains", "free_homes", "has_mujoco", "make_admittance",
    "make_baseline", "make_mpc", "make_setting", "make_task", "margins", "named_surfaces", "override_task",
    "perform_experiment", "posture_options", "pressing_axis", "pressing_direction", "put_on", "read_task",
    "run", "run_task", "task_notes", "task_point", "task_text", "task_units", "write_task",
]

# scripts/describe inserts the described classes here.


ResultCell = Union[None, float, str]
"""None, a number or a text. A number that is not finite is written as an empty cell."""


@dataclass(eq=False, repr=False)
class ResultTable(Spec):
    @property
    def names(self) -> List[str]:
        """Names of the columns."""
        return [column.name for column in self.columns]

    def column(self, name: str) -> List[ResultCell]:
        """Returns the cells of a column.

        Parameters
        ----------
        name : str
            Name of the column.

        Returns
        -------
        list of None, float or str

        Raises
        ------
        Error
            If the table has no such column.
        """
        if name not in self.names:
            raise _core.Error(f"table '{self.name}' has no column '{name}'; wanted one of "
                              f"{', '.join(self.names)}")
        place = self.names.index(name)
        return [row[place] for row in self.rows]

    def markdown(self) -> str:
        """Returns a Markdown table, with units below names and numbers aligned to the right."""
        return _core.table_markdown(self)

    def csv(self) -> str:
        """Returns CSV text with the header `name [unit],...`; quotes cells with commas or quotes."""
        return _core.table_csv(self)


@dataclass(eq=False, repr=False)
class TaskMargins(Spec):
    @property
    def delay(self) -> float:
        """Smaller delay margin of both, without and with contact [s]."""
        return min(self.air.delay, self.contact.delay)


@dataclass(eq=False, repr=False)
class ExperimentReport(Spec):
    def table(self, name: str) -> ResultTable:
        """Returns a table.

        Parameters
        ----------
        name : str
            Name of the table.

        Returns
        -------
        ResultTable

        Raises
        ------
        Error
            If the report has no such table.
        """
        for table in self.tables:
            if table.name == name:
                return table
        raise _core.Error(f"the report has no table '{name}'; wanted one of "
                          f"{', '.join(table.name for table in self.tables)}")


@dataclass(eq=False, repr=False)
class Experiment(Spec):
    """An experiment, as experiments() lists them."""

    name: str
    summary: str
    """Summary, one line"""

    def perform(self, spec: Optional[ExperimentSpec] = None) -> ExperimentReport:
        """Performs this experiment with perform_experiment().

        Parameters
        ----------
        spec : ExperimentSpec, optional
            Options of the experiment.

        Returns
        -------
        ExperimentReport
        """
        return perform_experiment(self.name, spec)


def make_task(
    where: Union[str, Path, Task] = "table",
    *,
    disturbances: Union[str, Disturbances, None] = None,
    seed: Optional[int] = None,
    overrides: Sequence[str] = (),
    **entries: Any,
) -> Task:
    """Makes a task from a named surface, a task file, or another task.

    Parameters
    ----------
    where : str, Path or Task
        Name of one of named_surfaces(), task file (a Path, or a text that ends in .yaml or .yml), or task
        to copy.
    disturbances : str, Disturbances or None
        Name of one of disturbance_presets(), or a value. None: the disturbances of the file or task; on a
        named surface "mismatch".
    seed : int, optional
        Seed of the random disturbances.
    overrides : sequence of str
        Changes as for override_task(), such as "path.radius=0.04".
    **entries
        Entries of Task, such as force=20 or weights=Weights(rotation=10).

    Returns
    -------
    Task

    Raises
    ------
    Error
        If the file cannot be read, a key is unknown, or values contradict each other.
    """
    if isinstance(where, Task):
        task = where.replace()
    elif isinstance(where, Path) or where.endswith((".yaml", ".yml")):
        task = read_task(where)
    else:
        task = put_on(Task(), where)
        disturbances = "mismatch" if disturbances is None else disturbances
    if isinstance(disturbances, str):
        disturbances = disturbance_preset(disturbances)
    if disturbances is not None:
        task.disturbances = disturbances
    if seed is not None:
        task.disturbances = task.disturbances.replace(seed=seed)
    return with_changes(task, entries, overrides, override_task, check_task)


def run(
    where: Union[str, Path, Task] = "table",
    *,
    controller: Union[str, ControllerKind] = "mpc",
    plant: Union[str, PlantKind, None] = None,
    disturbances: Union[str, Disturbances, None] = None,
    seed: Optional[int] = None,
    overrides: Sequence[str] = (),
    check_reach: bool = True,
    plan_rate: float = 20.0,
    progress: Optional[Callable[[float, float], Optional[bool]]] = None,
    **entries: Any,
) -> RunResult:
    """Makes a task with make_task() and runs it with run_task().

    Parameters
    ----------
    where, disturbances, seed, overrides, **entries
        Arguments of make_task().
    controller : str or ControllerKind
        "mpc", "baseline" or "admittance".
    plant : str, PlantKind or None
        "mujoco" or "ideal"; None: MuJoCo if this build has it, else ideal.
    check_reach : bool
        If False, run even if the reach check fails.
    plan_rate : float
        Rate at which plans are recorded [Hz].
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
    >>> polishing.run("board", seed=1, polish_duration=4, overrides=["path.radius=0.04"])
    """
    task = make_task(where, disturbances=disturbances, seed=seed, overrides=overrides, **entries)
    spec = RunSpec(task=task, check_reach=check_reach, plan_rate=plan_rate, progress=progress)
    spec.controller = controller  # type: ignore[assignment]  # Spec accepts names of enumerators
    if plant is not None:
        spec.plant = plant  # type: ignore[assignment]
    return run_task(spec)
