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

# (end of polishing)


