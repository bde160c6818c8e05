# The compiled part. Shapes stand beside the types; docstrings are in the module itself.
# ruff: noqa
from __future__ import annotations

from pathlib import Path
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
File = Union[str, Path]
S = TypeVar("S")

# ---------------------------------------------------------------------------
# base
# ---------------------------------------------------------------------------

from .base import Status

class Error(ValueError): ...
class EvaluationError(Error): ...

class Trace:
    @property
    def columns(self) -> List[str]: ...
    @property
    def units(self) -> Dict[str, str]: ...
    @property
    def dropped(self) -> int: ...
    def __len__(self) -> int: ...
    def __contains__(self, name: str) -> bool: ...
    def __getitem__(self, column: str) -> Array: ...  # (rows,)
    def array(self) -> NDArray[np.void]: ...  # (rows,), a field per column
    def write_csv(self, file: File) -> None: ...

def describe(status: Union[Status, str]) -> str: ...

# What tests ask of all dataclasses and enumerations.
def spec_names() -> List[str]: ...
def spec_default(name: str) -> Any: ...
def spec_round_trip(value: S) -> S: ...
def enum_words() -> Dict[str, List[str]]: ...

# (end of base)


# ---------------------------------------------------------------------------
# model
# ---------------------------------------------------------------------------

from .model import (
    Frame,
    Joint,
    ModelOptions,
    Posture,
    RobotOverrides,
    TreeSpec,
    Visual,
)

class Model:
    @property
    def name(self) -> str: ...
    @property
    def nq(self) -> int: ...
    @property
    def nv(self) -> int: ...
    @property
    def joints(self) -> List[Joint]: ...
    @property
    def frames(self) -> List[Frame]: ...
    @property
    def visuals(self) -> List[Visual]: ...
    @property
    def gravity(self) -> Array: ...  # (3,)
    @property
    def locked_joints(self) -> List[str]: ...
    @property
    def v_names(self) -> List[str]: ...
    @property
    def q_names(self) -> List[str]: ...
    @property
    def total_mass(self) -> float: ...
    def support(self, body: int) -> List[int]: ...
    def frame_index(self, name: str) -> int: ...
    def joint_index(self, name: str) -> int: ...
    def has_frame(self, name: str) -> bool: ...
    @property
    def q_neutral(self) -> Array: ...  # (nq,)
    @property
    def q_lower(self) -> Array: ...  # (nq,)
    @property
    def q_upper(self) -> Array: ...  # (nq,)
    @property
    def velocity_limit(self) -> Array: ...  # (nv,)
    @property
    def effort_limit(self) -> Array: ...  # (nv,)
    @property
    def damping(self) -> Array: ...  # (nv,)
    @property
    def friction(self) -> Array: ...  # (nv,)
    @property
    def armature(self) -> Array: ...  # (nv,)
    def __copy__(self) -> Model: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> Model: ...

class Robot:
    @property
    def model(self) -> Model: ...
    @property
    def postures(self) -> Dict[str, Posture]: ...
    @property
    def default_posture(self) -> str: ...
    def posture(self, name: str) -> Array: ...  # (nq,)
    def reference_configuration(self) -> Array: ...  # (nq,)
    def __copy__(self) -> Robot: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> Robot: ...

def load_robot(name: str, overrides: Optional[RobotOverrides] = None) -> Robot: ...
def robot_search_path() -> List[Path]: ...
def build_model(tree: TreeSpec, options: Optional[ModelOptions] = None) -> Model: ...
def read_urdf(file: File) -> TreeSpec: ...
def parse_urdf(xml: str, source: str = "<string>") -> TreeSpec: ...
def configuration(model: Model, posture: Posture) -> Array: ...  # (nq,)
def integrate(model: Model, q: ArrayLike, dq: ArrayLike) -> Array: ...  # (nq,) or (n, nq)
def difference(model: Model, q0: ArrayLike, q1: ArrayLike) -> Array: ...  # (nv,) or (n, nv)
def tangent_map(model: Model, q: ArrayLike) -> Array: ...  # (nq, nv)
def normalized(model: Model, q: ArrayLike) -> Array: ...  # (nq,)
def random_configuration(
    model: Model, seed: int = 0, count: Optional[int] = None
) -> Array: ...  # (nq,) or (count, nq)
def check_configuration(model: Model, q: ArrayLike, argument: str = "q") -> None: ...
def check_tangent(model: Model, v: ArrayLike, argument: str = "v") -> None: ...

# (end of model)


# ---------------------------------------------------------------------------
# contact
# ---------------------------------------------------------------------------

from .contact import ContactForce, ContactSolver, ContactSpec, Reference

def surface_with_normal(normal: ArrayLike) -> Reference: ...
def parse_reference(name: str) -> Reference: ...
def reference_name(reference: Reference) -> str: ...
def force_in(force: ContactForce, reference: Reference) -> ContactForce: ...
def force_axes(force: ContactForce) -> Array: ...  # (3, 3)
def force_origin(force: ContactForce) -> Array: ...  # (3,)
def force_text(force: ContactForce) -> str: ...

# (end of contact)


# ---------------------------------------------------------------------------
# dynamics
# ---------------------------------------------------------------------------

from .dynamics import FrameAxes

def frame_placement(model: Model, q: ArrayLike, frame: str) -> Array: ...  # (4, 4)
def frame_placements(model: Model, q: ArrayLike) -> Array: ...  # (frames, 4, 4)

# (end of dynamics)


# ---------------------------------------------------------------------------
# derivatives
# ---------------------------------------------------------------------------

from .derivatives import (
    CheckGains,
    CheckOptions,
    CheckReport,
    ContactDiagnosis,
    FrameDerivatives,
    PlacementDerivatives,
    RedundantRow,
    WrenchDerivatives,
)

class ContactDynamics:
    def __init__(
        self,
        model: Model,
        contacts: Sequence[ContactSpec] = (),
        solver: Optional[ContactSolver] = None,
    ) -> None: ...
    @property
    def contacts(self) -> List[ContactSpec]: ...
    @property
    def nq(self) -> int: ...
    @property
    def nv(self) -> int: ...
    @property
    def rows(self) -> int: ...
    @property
    def row_names(self) -> List[str]: ...
    def set_active(self, contact: Union[int, str], active: bool) -> None: ...
    def is_active(self, contact: Union[int, str]) -> bool: ...
    def forward(self, q: ArrayLike, v: ArrayLike, tau: ArrayLike) -> Status: ...
    def forward_derivatives(self) -> Status: ...
    def inverse(self, q: ArrayLike, v: ArrayLike, a: ArrayLike, lambda_: ArrayLike) -> None: ...
    def inverse_derivatives(self) -> None: ...
    def acceleration(self, q: ArrayLike, v: ArrayLike, a: ArrayLike) -> None: ...
    def acceleration_derivatives(self) -> None: ...
    @property
    def a(self) -> Array: ...  # (nv,)
    @property
    def lambda_(self) -> Array: ...  # (rows,)
    @property
    def tau(self) -> Array: ...  # (nv,)
    @property
    def alpha(self) -> Array: ...  # (rows,)
    @property
    def bias(self) -> Array: ...  # (nv,)
    @property
    def mass_matrix(self) -> Array: ...  # (nv, nv)
    @property
    def jacobian(self) -> Array: ...  # (rows, nv)
    @property
    def da_dq(self) -> Array: ...  # (nv, nv)
    @property
    def da_dv(self) -> Array: ...  # (nv, nv)
    @property
    def da_dtau(self) -> Array: ...  # (nv, nv)
    @property
    def dlambda_dq(self) -> Array: ...  # (rows, nv)
    @property
    def dlambda_dv(self) -> Array: ...  # (rows, nv)
    @property
    def dlambda_dtau(self) -> Array: ...  # (rows, nv)
    @property
    def dtau_dq(self) -> Array: ...  # (nv, nv)
    @property
    def dtau_dv(self) -> Array: ...  # (nv, nv)
    @property
    def dalpha_dq(self) -> Array: ...  # (rows, nv)
    @property
    def dalpha_dv(self) -> Array: ...  # (rows, nv)
    @property
    def contact_velocity(self) -> Array: ...  # (rows,)
    @property
    def contact_error(self) -> Array: ...  # (rows,)
    @property
    def proximal_iterations(self) -> int: ...
    @property
    def proximal_residual(self) -> float: ...
    def force(self, contact: Union[int, str]) -> ContactForce: ...
    def wrench(self, contact: Union[int, str], reference: Reference) -> Array: ...  # (6,)
    def wrench_derivatives(
        self, contact: Union[int, str], reference: Reference
    ) -> WrenchDerivatives: ...

class ContactDynamicsBatch:
    def __init__(
        self,
        model: Model,
        contacts: Sequence[ContactSpec],
        capacity: int,
        solver: Optional[ContactSolver] = None,
        threads: int = 1,
    ) -> None: ...
    @property
    def nq(self) -> int: ...
    @property
    def nv(self) -> int: ...
    @property
    def rows(self) -> int: ...
    @property
    def capacity(self) -> int: ...
    @property
    def threads(self) -> int: ...
    def set_active(self, contact: Union[int, str], active: bool) -> None: ...
    # q: (n, nq), v and tau: (n, nv)
    def forward(self, q: ArrayLike, v: ArrayLike, tau: ArrayLike) -> Status: ...
    def forward_with_derivatives(self, q: ArrayLike, v: ArrayLike, tau: ArrayLike) -> Status: ...
    @property
    def status(self) -> Status: ...
    @property
    def statuses(self) -> NDArray[np.uint8]: ...  # (n,)
    # Read-only views, written over by the next call.
    @property
    def a(self) -> Array: ...  # (n, nv)
    @property
    def lambda_(self) -> Array: ...  # (n, rows)
    @property
    def da_dq(self) -> Array: ...  # (n, nv, nv)
    @property
    def da_dv(self) -> Array: ...  # (n, nv, nv)
    @property
    def da_dtau(self) -> Array: ...  # (n, nv, nv)
    @property
    def dlambda_dq(self) -> Array: ...  # (n, rows, nv)
    @property
    def dlambda_dv(self) -> Array: ...  # (n, rows, nv)
    @property
    def dlambda_dtau(self) -> Array: ...  # (n, rows, nv)

def pack_width() -> int: ...

class RigidBody:
    def __init__(self, model: Model, slip_velocity: float = 0.01) -> None: ...
    @property
    def nq(self) -> int: ...
    @property
    def nv(self) -> int: ...
    def frame(self, name: str) -> int: ...
    def update(self, q: ArrayLike, v: ArrayLike, a: Optional[ArrayLike] = None) -> None: ...
    def update_derivatives(self) -> None: ...
    def placement(self, frame: Union[int, str]) -> Array: ...  # (4, 4)
    def velocity(self, frame: Union[int, str], axes: Union[FrameAxes, str]) -> Array: ...  # (6,)
    def acceleration(
        self, frame: Union[int, str], axes: Union[FrameAxes, str]
    ) -> Array: ...  # (6,)
    def frame_derivatives(
        self, frame: Union[int, str], axes: Union[FrameAxes, str]
    ) -> FrameDerivatives: ...
    def placement_error(self, frame: Union[int, str], target: ArrayLike) -> Array: ...  # (6,)
    def placement_derivatives(
        self, frame: Union[int, str], target: ArrayLike
    ) -> PlacementDerivatives: ...
    @property
    def mass(self) -> float: ...
    @property
    def kinetic_energy(self) -> float: ...
    @property
    def potential_energy(self) -> float: ...
    @property
    def com(self) -> Array: ...  # (3,)
    @property
    def com_velocity(self) -> Array: ...  # (3,)
    @property
    def momentum(self) -> Array: ...  # (6,)
    @property
    def centroidal_momentum(self) -> Array: ...  # (6,)
    @property
    def gravity_torque(self) -> Array: ...  # (nv,)
    @property
    def passive_torque(self) -> Array: ...  # (nv,)
    @property
    def com_dq(self) -> Array: ...  # (3, nv)
    @property
    def com_velocity_dq(self) -> Array: ...  # (3, nv)
    @property
    def momentum_dq(self) -> Array: ...  # (6, nv)
    @property
    def momentum_dv(self) -> Array: ...  # (6, nv)
    @property
    def centroidal_momentum_dq(self) -> Array: ...  # (6, nv)
    @property
    def centroidal_momentum_dv(self) -> Array: ...  # (6, nv)
    @property
    def kinetic_energy_dq(self) -> Array: ...  # (nv,)
    @property
    def kinetic_energy_dv(self) -> Array: ...  # (nv,)
    @property
    def potential_energy_dq(self) -> Array: ...  # (nv,)
    @property
    def passive_torque_dv(self) -> Array: ...  # (nv,)

def check_derivatives(model: Model, options: Optional[CheckOptions] = None) -> CheckReport: ...
def default_check_references() -> List[Reference]: ...
def default_check_directions() -> List[str]: ...
def default_check_gains() -> List[CheckGains]: ...
def check_report_text(report: CheckReport) -> str: ...
def diagnose(
    model: Model,
    contacts: Sequence[ContactSpec],
    q: ArrayLike,
    active: Sequence[Union[int, str]] = (),
    tolerance: float = 1e-8,
) -> ContactDiagnosis: ...
def redundant_row_text(row: RedundantRow) -> str: ...
def contact_diagnosis_text(diagnosis: ContactDiagnosis) -> str: ...

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

class SurfacePath:
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
def task_point(task: Task, setting: Setting, path: SurfacePath, time: float) -> TaskPoint: ...
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


