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

from .dynamics import FrameAxes
from .ocp import (
    ProblemCheckOptions,
    ProblemReport,
    ProblemSpec,
    QuasiStatic,
    StateLayout,
    TrajectoryExpansion,
    TrajectoryValues,
)

Place = Union[int, str]

class NodeView:
    @property
    def layout(self) -> StateLayout: ...
    @property
    def time(self) -> float: ...  # s
    @property
    def q(self) -> Array: ...  # (nq,)
    @property
    def v(self) -> Array: ...  # (nv,)
    @property
    def u(self) -> Array: ...  # (nu,)
    @property
    def tau(self) -> Array: ...  # (nv,)
    @property
    def acceleration(self) -> Array: ...  # (nv,)
    def placement(self, frame: Place) -> Array: ...  # (4, 4)
    def velocity(self, frame: Place, axes: Union[FrameAxes, str]) -> Array: ...  # (6,)
    def force(self, contact: Place) -> Array: ...  # (rows held,)
    def jacobian(self, frame: Place, axes: Union[FrameAxes, str]) -> Array: ...  # (6, nv)
    def force_derivative(self, contact: Place) -> Array: ...  # (rows held, nz)

class SignalFunction:
    def __call__(self, time: float) -> Array: ...
    def __copy__(self) -> SignalFunction: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> SignalFunction: ...

class Problem:
    def __init__(self, spec: ProblemSpec) -> None: ...
    @property
    def spec(self) -> ProblemSpec: ...
    @property
    def model(self) -> Model: ...
    @property
    def layout(self) -> StateLayout: ...
    @property
    def knots(self) -> int: ...
    @property
    def nx(self) -> int: ...
    @property
    def ndx(self) -> int: ...
    @property
    def max_controls(self) -> int: ...
    @property
    def stage_names(self) -> List[str]: ...
    @property
    def state_names(self) -> List[str]: ...
    @property
    def control_names(self) -> List[str]: ...
    @property
    def initial_state(self) -> Array: ...  # (nx,)
    def stage_index(self, name: str) -> int: ...
    def term_index(self, stage: Place, name: str) -> int: ...
    def stage_of(self, knot: int) -> int: ...
    def time_of(self, knot: int) -> float: ...
    def step_of(self, knot: int) -> float: ...
    def controls(self, knot: int) -> int: ...
    def term_names(self, knot: int) -> List[str]: ...
    def force_names(self, knot: int) -> List[str]: ...
    def knot_name(self, knot: int) -> str: ...
    def control_lower(self, knot: int) -> Optional[Array]: ...  # (nu,)
    def control_upper(self, knot: int) -> Optional[Array]: ...  # (nu,)
    def set_initial_state(self, x: ArrayLike) -> None: ...
    def set_knot(self, knot: int, stage: Place, time: float) -> None: ...
    def advance(self, stage: Place) -> None: ...
    def set_target(self, knot: int, term: Place, target: ArrayLike) -> None: ...
    def set_torque_bias(self, torque: ArrayLike) -> None: ...
    def residual(
        self, knot: int, term: Place, x: ArrayLike, u: Optional[ArrayLike] = None
    ) -> Array: ...  # (rows,)
    def residual_derivative(
        self, knot: int, term: Place, x: ArrayLike, u: Optional[ArrayLike] = None
    ) -> Array: ...  # (rows, nz)
    def forces(self, knot: int, x: ArrayLike, u: Optional[ArrayLike] = None) -> Array: ...
    def acceleration(self, knot: int, x: ArrayLike, u: Optional[ArrayLike] = None) -> Array: ...
    def term_costs(
        self, knot: int, x: ArrayLike, u: Optional[ArrayLike] = None
    ) -> List[float]: ...
    def roll(
        self, knot: int, x: ArrayLike, u: Optional[ArrayLike] = None
    ) -> Tuple[Optional[Array], float]: ...  # (nx,)
    def quasi_static(
        self, stage: Place, x: ArrayLike, force: Optional[ArrayLike] = None
    ) -> QuasiStatic: ...
    def evaluate(self, xs: ArrayLike, us: ArrayLike, threads: int = 1) -> TrajectoryValues: ...
    def expand(self, xs: ArrayLike, us: ArrayLike, threads: int = 1) -> TrajectoryExpansion: ...
    def prepare(self, workers: int) -> None: ...
    def integrate(self, x: ArrayLike, dx: ArrayLike) -> Array: ...  # (nx,) or (n, nx)
    def difference(self, x0: ArrayLike, x1: ArrayLike) -> Array: ...  # (ndx,) or (n, ndx)

def check_problem(
    problem: Problem, options: Optional[ProblemCheckOptions] = None
) -> ProblemReport: ...
def complaints(problem: Problem) -> List[str]: ...
def problem_report_text(report: ProblemReport) -> str: ...

# (end of ocp)


# ---------------------------------------------------------------------------
# solver
# ---------------------------------------------------------------------------

from .solver import CostReport, DdpOptions, DdpSummary, NamedMatrix

class DdpSolver:
    def __init__(self, problem: Problem, options: Optional[DdpOptions] = None) -> None: ...
    @property
    def problem(self) -> Problem: ...
    @property
    def options(self) -> DdpOptions: ...
    def set_options(self, options: DdpOptions) -> None: ...
    def set_time_budget(self, seconds: float) -> None: ...
    def set_max_iterations(self, iterations: int) -> None: ...
    def set_guess(self, xs: ArrayLike, us: ArrayLike) -> None: ...
    def solve(self) -> DdpSummary: ...
    @property
    def summary(self) -> DdpSummary: ...
    def text(self) -> str: ...
    @property
    def xs(self) -> Array: ...  # (N + 1, nx)
    @property
    def us(self) -> Array: ...  # (N, max_controls)
    def feedforward(self, knot: int) -> Array: ...  # (nu,)
    def gain(self, knot: int) -> Array: ...  # (nu, ndx)
    def value_gradient(self, knot: int) -> Array: ...  # (ndx,)
    def value_hessian(self, knot: int) -> Array: ...  # (ndx, ndx)
    def named_gain(self, knot: int) -> NamedMatrix: ...
    def named_value_hessian(self, knot: int) -> NamedMatrix: ...
    def cost_report(self) -> CostReport: ...
    def optimality_error(self) -> float: ...

def check_ddp_options(options: DdpOptions) -> None: ...
def summary_text(summary: DdpSummary, problem: Problem) -> str: ...
def cost_report_text(report: CostReport) -> str: ...

# (end of solver)


# ---------------------------------------------------------------------------
# files
# ---------------------------------------------------------------------------

from .files import ProblemFile, TrajectoryGuess, WarmStart

def read_problem_file(file: File) -> ProblemFile: ...
def make_guess(problem: Problem, start: Optional[WarmStart] = None) -> TrajectoryGuess: ...

# (end of files)


# ---------------------------------------------------------------------------
# mpc
# ---------------------------------------------------------------------------

from .mpc import (
    Command,
    Controller,
    FaultReport,
    LinearFeedback,
    Measurement,
    ModelErrorOptions,
    MpcSpec,
    SchedulePhase,
)

class CompiledController(Controller):
    @property
    def nv(self) -> int: ...
    def reset(self) -> None: ...
    def tick(self, measurement: Measurement) -> Command: ...

class MpcController(CompiledController):
    def __init__(self, spec: MpcSpec) -> None: ...
    @property
    def spec(self) -> MpcSpec: ...
    @property
    def problem(self) -> Problem: ...
    def fault(self) -> FaultReport: ...
    def feedback(self) -> LinearFeedback: ...
    @property
    def torque_error(self) -> Array: ...  # (nv,), Nm (N)
    @property
    def force_error(self) -> float: ...  # N
    @property
    def schedule(self) -> Schedule: ...
    def plan(self) -> Array: ...  # (N + 1, nx)
    def plan_costs(self, knot: int) -> Dict[str, float]: ...

class Schedule:
    def __init__(self, phases: Sequence[SchedulePhase]) -> None: ...
    @property
    def phases(self) -> List[SchedulePhase]: ...
    def start_of(self, phase: int) -> float: ...  # s
    def reset(self) -> None: ...
    def advance(self, dt: float, contact: bool) -> bool: ...
    def jump_to(self, phase: int) -> None: ...
    @property
    def time(self) -> float: ...  # s
    @property
    def waits(self) -> bool: ...
    @property
    def phase(self) -> int: ...
    def phase_at(self, time: float) -> int: ...
    @property
    def finished(self) -> bool: ...
    def __copy__(self) -> Schedule: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> Schedule: ...

class TorqueErrorObserver:
    def __init__(
        self, model: Model, tool: str = "tool", options: Optional[ModelErrorOptions] = None
    ) -> None: ...
    def reset(self) -> None: ...
    def update(
        self, q: ArrayLike, v: ArrayLike, tau: ArrayLike, force_world: ArrayLike, dt: float
    ) -> Status: ...
    @property
    def torque_error(self) -> Array: ...  # (nv,), Nm (N)

def fault_text(report: FaultReport) -> str: ...

# (end of mpc)


# ---------------------------------------------------------------------------
# sim
# ---------------------------------------------------------------------------

from .sim import (
    ActuationStep,
    CirclePath,
    ClosedLoopOptions,
    Disturbances,
    IdealPlantOptions,
    ImpedanceSpec,
    MujocoPlantOptions,
    Plant,
    PlantSnapshot,
    Push,
    SceneSpec,
    TaskPoint,
)

class CompiledPlant(Plant):
    @property
    def model(self) -> Model: ...
    @property
    def scene(self) -> SceneSpec: ...
    @property
    def dt(self) -> float: ...  # s
    @property
    def time(self) -> float: ...  # s
    @property
    def q(self) -> Array: ...  # (nq,)
    @property
    def v(self) -> Array: ...  # (nv,)
    @property
    def contact_force_world(self) -> Array: ...  # (3,), N
    @property
    def in_contact(self) -> bool: ...
    @property
    def friction_torque(self) -> Array: ...  # (nv,), Nm (N)
    def reset(self, q: ArrayLike, v: Optional[ArrayLike] = None) -> None: ...
    def step(self, tau: ArrayLike, push_world: Optional[ArrayLike] = None) -> Status: ...
    def save(self) -> PlantSnapshot: ...
    def restore(self, snapshot: PlantSnapshot) -> None: ...

def make_ideal_plant(
    model: Model, scene: SceneSpec, options: Optional[IdealPlantOptions] = None
) -> CompiledPlant: ...
def make_mujoco_plant(
    model: Model, scene: SceneSpec, options: Optional[MujocoPlantOptions] = None
) -> CompiledPlant: ...
def has_mujoco() -> bool: ...
def checked_scene(model: Model, scene: SceneSpec) -> SceneSpec: ...
def scene_under_tip(
    model: Model,
    q: ArrayLike,
    normal: ArrayLike,
    scene: Optional[SceneSpec] = None,
    clearance: float = 0.0,
) -> SceneSpec: ...
def gap(scene: SceneSpec, p_tip_world: ArrayLike) -> float: ...  # m
def check_disturbances(model: Model, disturbances: Disturbances) -> None: ...
def plant_model(nominal: Model, disturbances: Disturbances) -> Model: ...
def plant_scene(nominal: SceneSpec, disturbances: Disturbances) -> SceneSpec: ...
def push_at(pushes: Sequence[Push], time: float) -> Array: ...  # (3,), N
def circle_path_at(path: CirclePath, t: float) -> TaskPoint: ...
def make_impedance_controller(model: Model, spec: ImpedanceSpec) -> CompiledController: ...

class Actuation:
    def __init__(self, model: Model, disturbances: Disturbances, dt: float) -> None: ...
    def reset(self, tau: Optional[ArrayLike] = None) -> None: ...
    def apply(self, command: ArrayLike) -> Array: ...  # (nv,), Nm (N)
    @property
    def last_step(self) -> ActuationStep: ...
    @property
    def scale(self) -> Array: ...  # (nv,)
    @property
    def bias(self) -> Array: ...  # (nv,), Nm (N)
    @property
    def delay_steps(self) -> int: ...

class Sensing:
    def __init__(self, model: Model, disturbances: Disturbances) -> None: ...
    def reset(self) -> None: ...
    def measure(self, plant: CompiledPlant, applied: ArrayLike) -> Measurement: ...

class ClosedLoop:
    # Subclasses of burnish.Plant and burnish.Controller, or objects with their attributes.
    def __init__(
        self,
        plant: Any,
        controller: Any,
        disturbances: Optional[Disturbances] = None,
        options: Optional[ClosedLoopOptions] = None,
    ) -> None: ...
    def reset(self, q: ArrayLike, v: Optional[ArrayLike] = None) -> None: ...
    def step(self) -> Status: ...
    def run(self, duration: float) -> Status: ...
    @property
    def trace(self) -> Trace: ...
    @property
    def actuation(self) -> Actuation: ...
    @property
    def measurement(self) -> Measurement: ...
    @property
    def command(self) -> Command: ...
    @property
    def plant(self) -> Any: ...
    @property
    def controller(self) -> Any: ...

# (end of sim)


# ---------------------------------------------------------------------------
# report
# ---------------------------------------------------------------------------

from .report import Metrics, MetricsSpec, NamedMetrics, PlotSpec

def measure(trace: Trace, model: Model, spec: Optional[MetricsSpec] = None) -> Metrics: ...
def metrics_table(runs: Sequence[NamedMetrics]) -> str: ...
def metrics_text(metrics: Metrics) -> str: ...
def svg_plot(spec: PlotSpec) -> str: ...
def write_svg_plot(spec: PlotSpec, file: File) -> None: ...
def plot_palette() -> List[str]: ...

# (end of report)


# ---------------------------------------------------------------------------
# polishing
# ---------------------------------------------------------------------------

# (end of polishing)


