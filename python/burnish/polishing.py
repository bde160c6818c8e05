"""The polishing task: what it is, its runs, its experiments.

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
    "ReachProblem", "ReachReport", "RequiredMargins", "ResultCell", "ResultColumn", "ResultTable", "RunResult",
    "RunSpec", "SEARCHED_POSTURE", "Setting", "SurfacePath", "Task", "TaskMargins", "TickTimes", "Verdict",
    "VerdictFigures", "Waving", "Weights", "check_home", "check_reach", "check_task", "disturbance_preset",
    "disturbance_presets", "experiments", "find_posture", "fit_gains", "free_homes", "has_mujoco", "make_admittance",
    "make_baseline", "make_mpc", "make_setting", "make_task", "margins", "named_surfaces", "override_task",
    "perform_experiment", "posture_options", "pressing_axis", "pressing_direction", "put_on", "read_task",
    "run", "run_task", "task_notes", "task_point", "task_text", "task_units", "write_task",
]

# Described classes stand here (scripts/describe).


ResultCell = Union[None, float, str]
"""Nothing, a number or text. A number that is not finite is written as nothing."""


@dataclass(eq=False, repr=False)
class ResultTable(Spec):
    @property
    def names(self) -> List[str]:
        """Of the columns."""
        return [column.name for column in self.columns]

    def column(self, name: str) -> List[ResultCell]:
        """The cells of a column."""
        if name not in self.names:
            raise _core.Error(f"table '{self.name}' has no column '{name}'; wanted one of "
                              f"{', '.join(self.names)}")
        place = self.names.index(name)
        return [row[place] for row in self.rows]

    def markdown(self) -> str:
        """As a Markdown table: units below names, numbers to the right."""
        return _core.table_markdown(self)

    def csv(self) -> str:
        """First line `name [unit],...`; text with commas or quotes is quoted."""
        return _core.table_csv(self)


@dataclass(eq=False, repr=False)
class TaskMargins(Spec):
    @property
    def delay(self) -> float:
        """The smaller one of both, s."""
        return min(self.air.delay, self.contact.delay)


@dataclass(eq=False, repr=False)
class ExperimentReport(Spec):
    def table(self, name: str) -> ResultTable:
        """A table by its name."""
        for table in self.tables:
            if table.name == name:
                return table
        raise _core.Error(f"there is no table '{name}'; wanted one of "
                          f"{', '.join(table.name for table in self.tables)}")


@dataclass(eq=False, repr=False)
class Experiment(Spec):
    """One of experiments()."""

    name: str
    summary: str
    """one line"""

    def perform(self, spec: Optional[ExperimentSpec] = None) -> ExperimentReport:
        """perform_experiment() of this one."""
        return perform_experiment(self.name, spec)


def make_task(
    where: Union[str, Path, Task] = "table",
    *,
    disturbances: Union[str, Disturbances, None] = None,
    seed: Optional[int] = None,
    overrides: Sequence[str] = (),
    **entries: Any,
) -> Task:
    """A task: on one of named_surfaces(), from a task file (a path, or a text that ends in .yaml or
    .yml), or a copy of another.

    disturbances: one of disturbance_presets() or a value; None: the file's or the task's own, on a
    named surface "mismatch". seed: of what is drawn at random. overrides: as override_task() takes
    them, "path.radius=0.04". entries: of Task, such as force=20 or weights=Weights(rotation=10).
    Raises Error for what does not fit together."""
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
    """Polishes: run_task() of make_task().

    controller: "mpc", "baseline" or "admittance". plant: "mujoco" or "ideal"; None: MuJoCo where this build has
    it. The rest is make_task()'s and RunSpec's.

        polishing.run("board", seed=1, polish_duration=4, overrides=["path.radius=0.04"])
    """
    task = make_task(where, disturbances=disturbances, seed=seed, overrides=overrides, **entries)
    spec = RunSpec(task=task, check_reach=check_reach, plan_rate=plan_rate, progress=progress)
    spec.controller = controller  # type: ignore[assignment]  # names are taken for members
    if plant is not None:
        spec.plant = plant  # type: ignore[assignment]
    return run_task(spec)
