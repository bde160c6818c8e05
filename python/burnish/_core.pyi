# The compiled part. Shapes stand beside the types; docstrings are in the module itself.
# ruff: noqa
from __future__ import annotations

from pathlib import Path
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
File = Union[str, Path]

# ---------------------------------------------------------------------------
# base
# ---------------------------------------------------------------------------

# (end of base)


# ---------------------------------------------------------------------------
# model
# ---------------------------------------------------------------------------

# (end of model)


# ---------------------------------------------------------------------------
# contact
# ---------------------------------------------------------------------------

# (end of contact)


# ---------------------------------------------------------------------------
# dynamics
# ---------------------------------------------------------------------------

# (end of dynamics)


# ---------------------------------------------------------------------------
# derivatives
# ---------------------------------------------------------------------------

# (end of derivatives)


# ---------------------------------------------------------------------------
# ocp
# ---------------------------------------------------------------------------

# (end of ocp)


# ---------------------------------------------------------------------------
# solver
# ---------------------------------------------------------------------------

# (end of solver)


# ---------------------------------------------------------------------------
# files
# ---------------------------------------------------------------------------

# (end of files)


# ---------------------------------------------------------------------------
# mpc
# ---------------------------------------------------------------------------

# (end of mpc)


# ---------------------------------------------------------------------------
# sim
# ---------------------------------------------------------------------------

# (end of sim)


# ---------------------------------------------------------------------------
# report
# ---------------------------------------------------------------------------

# (end of report)


# ---------------------------------------------------------------------------
# polishing
# ---------------------------------------------------------------------------

from .model import Robot
from .mpc import FaultReport, MpcSpec
from .polishing import (
    ControllerKind,
    Experiment,
    ExperimentReport,
    ExperimentSpec,
    FoundPosture,
    NamedSurface,
    PathSpec,
    PlanarPoint,
    PlanRecord,
    PlantKind,
    PostureOptions,
    ReachOptions,
    ReachReport,
    ResultTable,
    RunSpec,
    Setting,
    Task,
    TickTimes,
)
from .report import Metrics
from .sim import Disturbances, ImpedanceSpec, TaskPoint

class Path:
    def __init__(self, spec: PathSpec) -> None: ...
    def at(self, t: float) -> PlanarPoint: ...
    def positions(self, t: ArrayLike) -> Array: ...  # (n,) -> (n, 2)
    @property
    def duration(self) -> float: ...

class RunResult:
    @property
    def task(self) -> Task: ...
    @property
    def controller(self) -> ControllerKind: ...
    @property
    def plant(self) -> PlantKind: ...
    @property
    def setting(self) -> Setting: ...
    @property
    def reach(self) -> Optional[ReachReport]: ...
    @property
    def trace(self) -> Trace: ...
    @property
    def plans(self) -> PlanRecord: ...
    @property
    def plant_status(self) -> Status: ...
    @property
    def fault(self) -> FaultReport: ...
    @property
    def interrupted(self) -> bool: ...
    @property
    def polished(self) -> bool: ...
    @property
    def metrics(self) -> Optional[Metrics]: ...
    @property
    def ticks(self) -> TickTimes: ...
    @property
    def first_tick(self) -> float: ...
    @property
    def wall_time(self) -> float: ...
    @property
    def outcome(self) -> str: ...
    def write(
        self,
        folder: File,
        *,
        name: str = "run",
        page: bool = True,
        recording: bool = False,
        record_every: int = 10,
    ) -> List[str]: ...

def has_mujoco() -> bool: ...
def named_surfaces() -> List[NamedSurface]: ...
def put_on(task: Task, surface: str) -> Task: ...
def disturbance_presets() -> List[str]: ...
def disturbance_preset(name: str) -> Disturbances: ...
def read_task(file: File, overrides: Sequence[str] = ...) -> Task: ...
def override_task(task: Task, overrides: Sequence[str]) -> Task: ...
def check_task(task: Task) -> None: ...
def task_text(task: Task) -> str: ...
def write_task(task: Task, file: File) -> None: ...
def task_notes(task: Task, plant: Union[PlantKind, str]) -> List[str]: ...
def make_setting(
    task: Task, robot: Optional[Robot] = None, q_start: Optional[ArrayLike] = None
) -> Setting: ...
def task_point(task: Task, setting: Setting, path: Path, time: float) -> TaskPoint: ...
def make_mpc(task: Task, setting: Setting) -> MpcSpec: ...
def make_baseline(task: Task, setting: Setting) -> ImpedanceSpec: ...
def check_reach(
    task: Task, setting: Optional[Setting] = None, options: Optional[ReachOptions] = None
) -> ReachReport: ...
def pressing_axis(tool_placement: ArrayLike) -> Array: ...  # (4, 4) -> (3,)
def find_posture(
    task: Task, robot: Optional[Robot] = None, options: Optional[PostureOptions] = None
) -> FoundPosture: ...
def run_task(spec: RunSpec) -> RunResult: ...
def experiments() -> List[Experiment]: ...
def perform_experiment(name: str, spec: Optional[ExperimentSpec] = None) -> ExperimentReport: ...
def table_markdown(table: ResultTable) -> str: ...
def table_csv(table: ResultTable) -> str: ...

# (end of polishing)


