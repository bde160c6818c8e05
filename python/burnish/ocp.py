"""Optimal control problems: costs, stages, horizons, the checker. Residuals are in burnish.residual."""

from __future__ import annotations

import enum
from dataclasses import dataclass, field
from typing import Callable, List, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._core import Model, NodeView, Problem, check_problem, complaints
from ._signal import OverTime, Signal, over_time
from ._spec import Spec, empty, items
from .base import Status
from .contact import ContactSolver, ContactSpec
from .derivatives import CheckEntry
from .residual import Residual

__all__ = ["ActuationSpec", "Constraint", "CostTerm", "Discretization", "HorizonSegment", "Integrator", "NodeView",
           "OverTime", "Penalty", "PenaltyKind", "Problem", "ProblemCheckOptions", "ProblemCheckRow",
           "ProblemReport", "ProblemSpec", "QuasiStatic", "Residual", "Signal", "Stage",
           "StateLayout", "TorqueModel", "TrajectoryExpansion", "TrajectoryValues",
           "check_problem", "complaints", "over_time"]


class PenaltyKind(enum.Enum):
    """phi of one residual entry r. All are convex, so that Gauss-Newton Hessians are positive."""

    SQUARE = 0
    """r^2 / 2"""
    BARRIER = 1
    """half the square of how far r is outside [lower, upper], zero inside"""
    SMOOTH_ABSOLUTE = 2
    """sqrt(r^2 + width^2) - width: |r| far from zero, r^2 / (2 width) close to it"""
    LOG_BARRIER = 3
    """-log(s / width), s the distance to each limit, where s > width; below, and beyond the limit, the
    parabola ((s / width - 2)^2 - 1) / 2 that continues it smoothly"""


@dataclass(eq=False, repr=False)
class Penalty(Spec):
    """What a residual costs: a function of each of its entries."""

    kind: PenaltyKind = PenaltyKind.SQUARE
    lower: ArrayLike = empty()
    """barriers: limit in the residual's unit, a number for all rows or one per row, infinite where
    there is none; empty: none"""
    upper: ArrayLike = empty()
    """likewise"""
    width: float = 1.0
    """residual's unit, positive"""

    @classmethod
    def square(cls) -> Penalty:
        return cls()

    @classmethod
    def barrier(cls, lower: ArrayLike, upper: ArrayLike) -> Penalty:
        return cls(PenaltyKind.BARRIER, lower, upper)

    @classmethod
    def at_least(cls, lower: float) -> Penalty:
        """A barrier with a lower limit for all rows."""
        return cls(PenaltyKind.BARRIER, np.array([lower], dtype=float))

    @classmethod
    def smooth_absolute(cls, width: float) -> Penalty:
        return cls(PenaltyKind.SMOOTH_ABSOLUTE, width=width)

    @classmethod
    def log_barrier(cls, lower: ArrayLike, upper: ArrayLike, width: float) -> Penalty:
        return cls(PenaltyKind.LOG_BARRIER, lower, upper, width)


@dataclass(eq=False, repr=False)
class CostTerm(Spec):
    """weight * sum over rows i of weights_i phi(r_i), times the stage's step while time passes."""

    residual: Residual
    weight: float = 1.0
    """1 / (unit of phi) / s while time passes; not negative"""
    name: str = ""
    """unique in its stage; the residual's name if left empty"""
    weights: ArrayLike = empty()
    """per row, or empty for ones; not negative"""
    penalty: Optional[Penalty] = None
    """None: a square, or what the residual says"""


@dataclass(eq=False, repr=False)
class Constraint(Spec):
    """lower <= r_i <= upper for every row i of a residual; an equality where the two meet. Evaluated,
    differentiated, checked and reported along a trajectory. The solver minimises the costs alone: it
    says how far a row is outside its limits, and does not keep it inside."""

    residual: Residual
    name: str = ""
    """unique among the terms of its stage; the residual's name if left empty"""
    lower: ArrayLike = empty()
    """in the residual's unit: per row, one for all, or empty: none. At least one of the two, but for
    the margins (friction cone, center of pressure), whose rows are at least zero unless said"""
    upper: ArrayLike = empty()
    """likewise"""


class Integrator(enum.Enum):
    """How the state goes from one knot to the next."""

    SEMI_IMPLICIT_EULER = 0
    """v' = v + step a(q, v, tau), q' = q (+) step v'"""
    RUNGE_KUTTA4 = 1
    """classical, the control held; costs are taken at the start of the step"""


class Discretization(enum.Enum):
    """Of the torque model."""

    EXACT = 0
    """decay over a step: exp(-cutoff step)"""
    EULER = 1
    """1 - cutoff step"""


@dataclass(eq=False, repr=False)
class TorqueModel(Spec):
    """Actuators as a first-order low-pass of the control: dtau/dt = cutoff (u - tau). The torques join
    the state."""

    cutoff: float = 0.0
    """rad/s"""
    discretization: Discretization = Discretization.EXACT


@dataclass(eq=False, repr=False)
class ActuationSpec(Spec):
    """Which joints are driven."""

    joints: List[str] = items()
    """empty: every joint but a free-flying base"""
    passive_torques: bool = False
    """joint damping and friction of the model act too, friction smoothed"""
    slip_velocity: float = 0.01
    """rad/s or m/s"""


@dataclass(eq=False, repr=False)
class Stage(Spec):
    """A kind of knot: which contacts hold, what is aimed at, how long a step is."""

    name: str = ""
    contacts: List[str] = items()
    """names of those that hold"""
    costs: List[CostTerm] = items()
    constraints: List[Constraint] = items()
    step: float = 0.01
    """s"""
    integrator: Integrator = Integrator.SEMI_IMPLICIT_EULER
    impact: bool = False
    """the contacts are made here: velocities jump so that they hold (inelastic), no time passes, there
    is no control, and costs are not multiplied by a step"""


@dataclass(eq=False, repr=False)
class HorizonSegment(Spec):
    """Consecutive knots of one stage."""

    stage: str = ""
    knots: int = 1


@dataclass(eq=False, repr=False)
class ProblemSpec(Spec):
    """An optimal control problem as a user states it: a robot, contacts, stages of costs, a horizon."""

    model: Model
    contacts: List[ContactSpec] = items()
    """all contacts of the problem; stages choose"""
    contact_solver: ContactSolver = field(default_factory=ContactSolver)
    actuation: ActuationSpec = field(default_factory=ActuationSpec)
    torque_model: Optional[TorqueModel] = None
    control_lower: ArrayLike = empty()
    """nu, or a number for all, Nm (N); empty: none"""
    control_upper: ArrayLike = empty()
    """likewise"""
    stages: List[Stage] = items()
    horizon: List[HorizonSegment] = items()
    terminal: List[CostTerm] = items()
    """costs of the last state"""
    terminal_constraints: List[Constraint] = items()
    initial_state: ArrayLike = empty()
    """(q, v), or (q, v, tau) with a torque model"""
    start_time: float = 0.0
    """s, of the first knot"""


@dataclass(eq=False, repr=False)
class StateLayout(Spec):
    """Where the parts of z = (du, dq, dv, dtau) start, and how many entries they have."""

    nq: int = 0
    nv: int = 0
    filtered: int = 0
    """torques in the state (torque model), or 0"""
    nu: int = 0
    actuated: List[int] = items()
    """entry of v that control i drives; nu entries"""

    @property
    def nx(self) -> int:
        """Entries of a state."""
        return self.nq + self.nv + self.filtered

    @property
    def ndx(self) -> int:
        """Entries of a tangent of a state."""
        return 2 * self.nv + self.filtered

    @property
    def nz(self) -> int:
        return self.nu + self.ndx

    @property
    def column_q(self) -> int:
        """First column of dq in z; column_v and column_tau likewise."""
        return self.nu

    @property
    def column_v(self) -> int:
        return self.nu + self.nv

    @property
    def column_tau(self) -> int:
        return self.nu + 2 * self.nv


@dataclass(eq=False, repr=False)
class QuasiStatic(Spec):
    """The control of least norm that with the contacts of a stage holds a state at rest."""

    control: NDArray[np.float64]
    """nu, Nm"""
    force: NDArray[np.float64]
    """rows of the stage's contacts, N and Nm"""
    residual: float
    """largest torque that nothing balances, Nm"""


@dataclass(eq=False, repr=False)
class TrajectoryValues(Spec):
    """All knots of a horizon, evaluated at given states and controls."""

    costs: NDArray[np.float64]
    """N + 1, of each knot, the terminal one last"""
    next_states: NDArray[np.float64]
    """N x nx, where the dynamics lead from each knot"""
    statuses: List[Status]
    """N + 1"""
    terms: List[int]
    """N + 1, first cost term that is not finite, -1: none, or the dynamics"""

    @property
    def cost(self) -> float:
        """Of all knots."""
        return float(np.sum(self.costs))


@dataclass(eq=False, repr=False)
class TrajectoryExpansion(TrajectoryValues):
    """Values and derivatives of all knots by z = (du, dx), controls first, dx the right tangent
    increment; nz = nu + ndx. Where a knot has no controls (impacts, the end) their columns are zero."""

    gradients: NDArray[np.float64]
    """(N + 1) x nz: d(cost)/dz"""
    hessians: NDArray[np.float64]
    """(N + 1) x nz x nz: Gauss-Newton, symmetric"""
    dynamics: NDArray[np.float64]
    """N x ndx x nz: d(next state)/dz, in the tangent of the next state"""


@dataclass(eq=False, repr=False)
class ProblemCheckOptions(Spec):
    """How check_problem() looks."""

    states: int = 3
    """random states per stage, at least 1"""
    seed: int = 1
    """the same seed gives the same states on every machine"""
    tolerance: float = 1e-6
    """on |derivative - difference| over the block's largest entry"""
    x: List[ArrayLike] = items()
    """trajectory to draw around: N + 1 states (nx) and N controls (nu); empty: the initial state, and
    the control that holds it at rest"""
    u: List[ArrayLike] = items()
    position: float = 0.2
    """rad, m: how far states are drawn from it, uniformly"""
    velocity: float = 0.5
    """rad/s, m/s"""
    torque: float = 5.0
    """Nm, N: controls, and torques in the state"""
    progress: Optional[Callable[[int, int], None]] = None
    """called after each stage with the number of stages done and the number of all stages"""


@dataclass(eq=False, repr=False)
class ProblemCheckRow(Spec):
    """The next state, one cost term or the costs together, of one stage at all its states."""

    stage: str
    term: str
    """name of a cost term, "next state" or "all costs\""""
    states: int
    worst_error: float
    """relative to the block's largest entry; infinite after a NaN"""
    worst: CheckEntry
    """blocks: such as "dnext_dq", "dr_du", "dcost_dv\""""
    pass_: bool
    """worst_error <= tolerance"""


@dataclass(eq=False, repr=False)
class ProblemReport(Spec):
    """What check_problem() found."""

    robot: str
    rows: List[ProblemCheckRow]
    tolerance: float
    pass_: bool
    """there are rows, and all of them pass"""

    def text(self) -> str:
        """A table of all rows, the worst entries of those that fail, and the verdict."""
        return _core.problem_report_text(self)
