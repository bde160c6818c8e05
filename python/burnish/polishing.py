"""The polishing task: what it is, its runs, its experiments.

    from burnish import plot, polishing
    result = polishing.run("board", seed=1)
    plot.forces(result)
"""

from __future__ import annotations

import enum
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Callable, List, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._core import (
    RunResult,
    SurfacePath,
    check_reach,
    check_task,
    disturbance_preset,
    disturbance_presets,
    experiments,
    find_posture,
    make_baseline,
    make_mpc,
    make_setting,
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
    write_task,
)
from ._spec import Spec, items, vector, zeros
from .model import Robot
from .mpc import Fallback, ModelErrorOptions, SafetyLimits
from .pressing import (
    SEARCHED_POSTURE,
    FoundPosture,
    PlanRecord,
    PlantKind,
    PostureLimits,
    PostureOptions,
    ReachOptions,
    ReachProblem,
    ReachReport,
    TickTimes,
    ToolLimits,
    default_plant,
)
from .report import PlotSpec
from .sim import Disturbances, SceneSpec, has_mujoco
from .solver import StepUpdate

__all__ = [
    "ControllerKind", "Experiment", "ExperimentReport", "ExperimentSpec", "Figure", "ForceAxes",
    "FoundPosture", "NamedSurface", "NamedTask", "PathKind", "PathSpec", "PlanRecord",
    "PlanarPoint", "PlantKind", "PostureLimits", "PostureOptions", "ReachOptions", "ReachProblem",
    "ReachReport",
    "ResultCell", "ResultColumn", "ResultTable", "RunResult", "RunSpec", "SEARCHED_POSTURE",
    "Setting", "SurfacePath", "Task", "TickTimes", "Verdict", "VerdictFigures", "Weights",
    "check_reach", "check_task",
    "disturbance_preset", "disturbance_presets", "experiments", "find_posture", "has_mujoco",
    "make_baseline", "make_mpc", "make_setting", "make_task", "named_surfaces", "override_task",
    "perform_experiment", "posture_options", "pressing_axis", "pressing_direction", "put_on",
    "read_task", "run", "run_task", "task_notes",
    "task_point", "task_text", "write_task",
]

# Described classes stand here (scripts/describe).


@dataclass(eq=False, repr=False)
class VerdictFigures(Spec):
    """What Verdict is about, as it was in a run."""

    contact_share: float = 0.0
    """share of the time on the path that was in contact"""
    force_rmse: float = 0.0
    """N, root mean square error of the force's mean over 10 ms, on all of the path"""
    path_share: float = 0.0
    """share of the path's length along which the tip was over its target"""


@dataclass(eq=False, repr=False)
class NamedSurface(Spec):
    """A surface by name: where its normal points and a starting posture of the robot for it."""

    name: str
    posture: str
    """of the robot's settings"""
    normal_world: NDArray[np.float64]
    """out of the surface"""


@dataclass(eq=False, repr=False)
class Setting(Spec):
    """A task with everything resolved: robot, start, surface, path in the world, phases."""

    robot: Robot
    q_start: ArrayLike
    """(nq,)"""
    scene: SceneSpec
    """as the controller knows it"""
    surface_axes: ArrayLike
    """3 x 3, columns: two tangents and the normal, world"""
    p_start: ArrayLike
    """3, of the tool, m, world"""
    p_center: ArrayLike
    """3, of the tool at the path's origin in contact, m, world"""
    reach_end: float = 0.0
    """s of the schedule"""
    touch: float = 0.0
    """s of the schedule"""
    ramp_end: float = 0.0
    """s of the schedule"""
    track_end: float = 0.0
    """s of the schedule"""


class ControllerKind(enum.Enum):
    """What controls a run."""

    MPC = 0
    """model predictive control (MpcController)"""
    BASELINE = 1
    """impedance with force feedback, no optimisation (make_impedance_controller())"""


@dataclass(eq=False, repr=False)
class RunSpec(Spec):
    """A run of a task."""

    task: Task = field(default_factory=Task)
    robot: Optional[Robot] = None
    """in place of the one that the task names"""
    controller: ControllerKind = ControllerKind.MPC
    plant: PlantKind = field(default_factory=default_plant)
    """MUJOCO where this build has it"""
    check_reach: bool = True
    """before anything moves; a problem is then an Error"""
    reach: ReachOptions = field(default_factory=ReachOptions)
    plan_rate: float = 20.0
    """Hz, at which plans of the MPC are recorded, at most 20 000 of them; 0: none"""
    progress: Optional[Callable[[float, float], Optional[bool]]] = None
    """called now and then with the simulated time and about when it will be over, s; returning
    False stops the run"""


@dataclass(eq=False, repr=False)
class ExperimentSpec(Spec):
    """How an experiment is performed."""

    plant: PlantKind = field(default_factory=default_plant)
    """MUJOCO where this build has it"""
    seeds: int = 0
    """at most 10 000; 0: the experiment's own number"""
    first_seed: int = 0
    threads: int = 0
    """runs at once; 0: as many as there are cores"""
    quick: bool = False
    """few and short runs, to see whether it works"""
    surfaces: List[str] = items()
    """empty: the experiment's own"""
    robots: List[str] = items()
    """of the experiment `robots`; empty: its own"""
    tools: List[str] = items()
    """the frame that each of these holds its tool with; "tool" for those that lack one"""
    overrides: List[str] = items()
    """changes to the task, as override_task() takes them; what the experiment sweeps is set after
    them"""
    progress: Optional[Callable[[float, str], Optional[bool]]] = None
    """called now and then with the share that is done, 0 to 1, and what is being done; from one
    thread at a time, but not always the same one. Returning False stops the experiment."""


@dataclass(eq=False, repr=False)
class ResultColumn(Spec):
    name: str
    unit: str = ""
    """empty for text and counts"""
    digits: int = 3
    """behind the point, in Markdown; CSV has all of them"""


ResultCell = Union[None, float, str]
"""Nothing, a number or text. A number that is not finite is written as nothing."""


@dataclass(eq=False, repr=False)
class ResultTable(Spec):
    """Results as a table: named columns with units, cells of text or numbers.
    pandas.DataFrame(table.rows, columns=table.names) makes a data frame of it."""

    name: str
    """of one word, such as "runs\""""
    title: str = ""
    """for people"""
    columns: List[ResultColumn] = items()
    rows: List[List[ResultCell]] = items()
    for_people: bool = True
    """False: too long to be read"""

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
class Figure(Spec):
    name: str
    """of its file, without ending"""
    plot: PlotSpec


@dataclass(eq=False, repr=False)
class NamedTask(Spec):
    """A task worth running again by itself."""

    name: str
    """of its file, without ending"""
    task: Task


@dataclass(eq=False, repr=False)
class ExperimentReport(Spec):
    """What came out of an experiment."""

    title: str
    tables: List[ResultTable]
    """the first one has a row for every run"""
    figures: List[Figure]
    tasks: List[NamedTask]
    findings: List[str]
    """sentences"""
    failures: List[str]
    """runs that did not polish, and why; empty: all did"""
    interrupted: bool

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
    for name, value in entries.items():
        setattr(task, name, value)
    task = override_task(task, overrides)
    check_task(task)
    return task


def run(
    where: Union[str, Path, Task] = "table",
    *,
    controller: Union[str, ControllerKind] = "mpc",
    plant: Union[str, PlantKind, None] = None,
    disturbances: Union[str, Disturbances, None] = None,
    seed: Optional[int] = None,
    overrides: Sequence[str] = (),
    check_reach: bool = True,
    progress: Optional[Callable[[float, float], Optional[bool]]] = None,
    **entries: Any,
) -> RunResult:
    """Polishes: run_task() of make_task().

    controller: "mpc" or "baseline". plant: "mujoco" or "ideal"; None: MuJoCo where this build has
    it. The rest is make_task()'s and RunSpec's.

        polishing.run("board", seed=1, polish_duration=4, overrides=["path.radius=0.04"])
    """
    task = make_task(where, disturbances=disturbances, seed=seed, overrides=overrides, **entries)
    spec = RunSpec(task=task, check_reach=check_reach, progress=progress)
    spec.controller = controller  # type: ignore[assignment]  # names are taken for members
    if plant is not None:
        spec.plant = plant  # type: ignore[assignment]
    return run_task(spec)
