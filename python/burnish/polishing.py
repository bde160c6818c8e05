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
from .pressing import ToolLimits
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

SEARCHED_POSTURE = "search"
"""In a task, in place of a posture's name: let find_posture() find one."""


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


@dataclass(eq=False, repr=False)
class ReachOptions(Spec):
    """How check_reach() looks."""

    spacing: float = 5e-3
    """m between two points that are looked at"""
    tolerance: float = 1e-4
    """m that the tool may be off"""
    joint_margin: float = 0.02
    """rad (m) that joints keep from their limits"""
    torque_share: float = 0.8
    """of the effort limits that statics may take: the rest is for motion and feedback"""
    link_radius: float = 0.03
    """m, how thick links are taken to be"""


class ReachProblem(enum.Enum):
    """What is in the way."""

    NONE = 0
    POSITION = 1
    """no posture puts the tool there, whatever the limits"""
    JOINT = 2
    """the only postures found are beyond a joint's limit"""
    TORQUE = 3
    """holding the tool there takes more than a joint's effort limit"""
    COLLISION = 4
    """the arm itself would touch the surface"""


@dataclass(eq=False, repr=False)
class ReachReport(Spec):
    """The first thing in the way of a task, and how much room there is elsewhere."""

    problem: ReachProblem = ReachProblem.NONE
    text: str = ""
    """one sentence: where, which joint, what came and what is allowed; empty without a problem"""
    s: float = 0.0
    """m along the path in contact where the problem is; negative: so far before the path's start"""
    p_world: ArrayLike = zeros(3)
    """of the tool there, m"""
    joint: str = ""
    """empty for POSITION"""
    value: float = 0.0
    """m that the tool is off, rad (m) of the joint, Nm (N), m of the joint's origin from the
    surface"""
    limit: float = 0.0
    """what is allowed, in the same unit"""
    points: int = 0
    """that were looked at"""
    path_length: float = 0.0
    """m, once around where the path repeats itself"""
    joint_margin: float = 0.0
    """rad (m), smallest of all points"""
    tightest_joint: str = ""
    torque_share: float = 0.0
    """of the effort limit, largest of all points"""
    tightest_torque: str = ""
    clearance: float = 0.0
    """m between the surface and the arm without its tool link, smallest of all points; infinite
    where nothing but the tool link moves"""
    tightest_clearance: str = ""
    """joint there"""

    @property
    def ok(self) -> bool:
        """Whether nothing is in the way."""
        return self.problem == ReachProblem.NONE


@dataclass(eq=False, repr=False)
class PostureOptions(Spec):
    """How find_posture() searches."""

    random_starts: int = 48
    """besides the robot's named postures and the middle of the limits"""
    seed: int = 0
    """of those"""
    tilt_limit: float = 1.0
    """rad between the pressing axis and the normal's opposite"""
    joint_margin: float = 0.15
    """rad (m) that joints keep from their limits at the start"""
    body_distance: float = 0.25
    """m between the last link and the robot's body, both taken as a few points and lines; of parts
    that are near each other along the arm no more than `bend` times its length between them"""
    bend: float = 0.55
    """see body_distance; of two equal links it lets 67 degrees between them"""
    checked: int = 48
    """best candidates whose whole path is looked at"""
    reach: ReachOptions = field(default_factory=ReachOptions)


@dataclass(eq=False, repr=False)
class FoundPosture(Spec):
    """What find_posture() found."""

    q: NDArray[np.float64]
    """(nq,)"""
    score: float
    """lower is better"""
    tilt: float
    """rad between the pressing axis and the normal's opposite"""
    reach: ReachReport
    """of the task from there"""
    candidates: int
    """postures that met all conditions at the start"""


class ControllerKind(enum.Enum):
    """What controls a run."""

    MPC = 0
    """model predictive control (MpcController)"""
    BASELINE = 1
    """impedance with force feedback, no optimisation (make_impedance_controller())"""


class PlantKind(enum.Enum):
    """What is controlled in a run."""

    MUJOCO = 0
    """an engine that shares no code with this library"""
    IDEAL = 1
    """the library's own contact dynamics, a rigid surface"""


def _default_plant() -> PlantKind:
    return PlantKind.MUJOCO if has_mujoco() else PlantKind.IDEAL


@dataclass(eq=False, repr=False)
class RunSpec(Spec):
    """A run of a task."""

    task: Task = field(default_factory=Task)
    robot: Optional[Robot] = None
    """in place of the one that the task names"""
    controller: ControllerKind = ControllerKind.MPC
    plant: PlantKind = field(default_factory=_default_plant)
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
class TickTimes(Spec):
    """Wall clock of a controller's ticks after the first, s."""

    count: int = 0
    """ticks that were timed: every nth of more than a million"""
    period: float = 0.0
    """s, between two ticks"""
    median: float = 0.0
    """s, median computing time of a tick"""
    p99: float = 0.0
    """s, computing time that 99 % of the ticks stay below"""
    maximum: float = 0.0
    """s, longest computing time of a tick"""
    mean: float = 0.0
    """s, mean computing time of a tick"""
    late: int = 0
    """ticks that took longer than a period"""


@dataclass(eq=False, repr=False)
class PlanRecord(Spec):
    """Plans of model predictive control, now and then along a run; empty without plans."""

    time: NDArray[np.float64]
    """(plans,), s, of each plan's first knot"""
    terms: List[str]
    """of the costs of all stages that were planned with"""
    costs: NDArray[np.float64]
    """(terms, plans), summed over the plan, terminal costs included"""
    step: float
    """s between the knots that are kept"""
    q: NDArray[np.float32]
    """(plans, knots, nq)"""


@dataclass(eq=False, repr=False)
class ExperimentSpec(Spec):
    """How an experiment is performed."""

    plant: PlantKind = field(default_factory=_default_plant)
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
