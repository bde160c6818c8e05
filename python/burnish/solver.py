"""Differential dynamic programming."""

from __future__ import annotations

import enum
import math
from dataclasses import dataclass, field
from typing import Callable, List, Optional

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._core import DdpSolver, Problem
from ._spec import Spec, items
from .base import Status

__all__ = ["CostEntry", "CostKnot", "CostReport", "DdpOptions", "DdpProgress", "DdpSolver",
           "DdpSummary", "LimitedRow", "LineSearch", "NamedMatrix", "PhaseTimes", "Regularization", "StepUpdate",
           "StopReason"]


# Described classes stand here (scripts/describe).


class StopReason(enum.Enum):
    """Why a solve ended."""

    CONVERGED = 0
    """feasible, and the expected improvement is below stop_tolerance"""
    MAX_ITERATIONS = 1
    """max_iterations were made"""
    TIME_BUDGET = 2
    """time_budget was spent"""
    NOT_EVALUATED = 3
    """a knot of the iterate cannot be evaluated: see status, knot, term"""
    NOT_POSITIVE_DEFINITE = 4
    """Quu of a knot, with the largest regularisation"""
    NO_STEP = 5
    """no step length was acceptable, with the largest regularisation"""
    CALLBACK = 6
    """the callback asked for it"""


@dataclass(eq=False, repr=False)
class Regularization(Spec):
    """Levenberg term, added to the diagonal of Quu, in cost per squared unit of control."""

    initial: float = 0.0
    smallest: float = 1e-9
    """below this there is none: a decrease ends at 0, an increase from 0 begins here"""
    largest: float = 1e9
    """needed more than this: the solver gives up"""
    factor: float = 10.0
    """of an increase, and 1 / factor of a decrease"""
    decrease_above: float = 0.5
    """decreases after a step of length > this"""
    increase_at_or_below: float = 0.01
    """increases after a step of length <= this"""


@dataclass(eq=False, repr=False)
class LineSearch(Spec):
    """The step lengths 1, 1/2, 1/4, ... and what a trial must reach to be taken."""

    halvings: int = 9
    """the smallest length is 2^-halvings"""
    sufficient_decrease: float = 0.1
    """ROLLOUT, expected improvement dV(alpha) >= 0: taken if
    cost - trial > sufficient_decrease * dV(alpha)"""
    allowed_increase: float = 2.0
    """ROLLOUT, dV(alpha) < 0 (closing gaps costs): taken if
    cost - trial > allowed_increase * dV(alpha)"""
    merit_decrease: float = 1e-4
    """MULTIPLE_SHOOTING, merit = cost + penalty * sum |gap|_1 with slope D: taken if
    trial <= merit + merit_decrease * alpha * D"""
    merit_share: float = 0.5
    """MULTIPLE_SHOOTING: the penalty makes D <= -merit_share * penalty * sum |gap|_1"""
    rounding: float = 1e-14
    """of a sum of costs: every comparison above is relaxed by rounding * |cost|"""


@dataclass(eq=False, repr=False)
class DdpProgress(Spec):
    """What a callback sees after each iteration."""

    iteration: int = 0
    """from 1"""
    cost: float = 0.0
    expected_improvement: float = 0.0
    """what the quadratic model said before the step that the whole step would save"""
    largest_gap: float = 0.0
    step_length: float = 0.0
    """0: no length was acceptable"""
    regularization: float = 0.0
    penalty: float = 0.0
    """of gaps in the merit; MULTIPLE_SHOOTING only"""
    feasible: bool = False
    seconds: float = 0.0
    """since the solve began"""


@dataclass(eq=False, repr=False)
class DdpOptions(Spec):
    """How a DdpSolver works, each tolerance beside the inequality it enters."""

    update: StepUpdate = StepUpdate.ROLLOUT
    max_iterations: int = 100
    time_budget: float = math.inf
    """s, looked at between phases and between trials; the best iterate so far is kept"""
    threads: int = 1
    pin_threads: bool = False
    """thread i of the solver stays on the i-th core that the thread which makes it (or gives it
    options) may run on; the thread that solves is left as it is. Linux alone"""
    share_knots: bool = True
    """threads work together on each knot of the recursion where knots are large (a humanoid's), which
    is faster on cores that share a cache and slower on others; results have the same bits"""
    segments: int = 1
    """parts of the horizon that the recursion works on at the same time, for long horizons and many
    cores (see docs/performance.md, "Threads"); threads + 1 suit `threads` best, 1 and 2 mean one
    sweep, as do bounds on controls; fewer than knots. Gains and values are those of the whole
    horizon, but for rounding"""
    stop_tolerance: float = 1e-9
    """converged if feasible and expected improvement < stop_tolerance (in units of cost)"""
    gap_tolerance: float = 1e-9
    """feasible if every |entry of a gap| <= gap_tolerance"""
    line_search: LineSearch = field(default_factory=LineSearch)
    regularization: Regularization = field(default_factory=Regularization)
    callback: Optional[Callable[[DdpProgress], Optional[bool]]] = None
    """called after each iteration; False stops the solve, None and True go on, and what it raises
    reaches the caller of solve()"""

    def check(self) -> None:
        """Raises Error with a sentence naming the option that is out of range."""
        _core.check_ddp_options(self)


@dataclass(eq=False, repr=False)
class PhaseTimes(Spec):
    """Seconds of a solve by phase."""

    expand: float = 0.0
    """values and derivatives"""
    backward: float = 0.0
    """Riccati recursion"""
    trial: float = 0.0
    """rollouts and evaluations of the line search"""
    total: float = 0.0


@dataclass(eq=False, repr=False)
class DdpSummary(Spec):
    """Why a solve ended and what it reached."""

    reason: StopReason = StopReason.MAX_ITERATIONS
    iterations: int = 0
    """line searches made"""
    cost: float = 0.0
    """of the trajectory that is returned"""
    feasible: bool = False
    expected_improvement: float = 0.0
    """the last one computed"""
    regularization: float = 0.0
    """the last one used"""
    largest_gap: float = 0.0
    """of the trajectory that is returned"""
    gap_knot: int = 0
    """where: the state that the gap leads to, 0 for the initial one"""
    gap_entry: int = 0
    """entry of dx"""
    status: Status = Status.OK
    """NOT_EVALUATED, NOT_POSITIVE_DEFINITE, and NO_STEP where the last trial could not be evaluated:
    where and what"""
    knot: int = -1
    term: int = -1
    """cost term that is not finite, -1: none, a row or the dynamics"""
    row: int = -1
    """row of a constraint that is not finite, -1: none"""
    in_derivatives: bool = False
    """NOT_EVALUATED: values are finite, derivatives are not"""
    control: int = -1
    """NOT_POSITIVE_DEFINITE: the first one whose pivot is not positive"""
    options: DdpOptions = field(default_factory=DdpOptions)
    """those it was solved with, without callback"""
    seconds: PhaseTimes = field(default_factory=PhaseTimes)
    log: List[DdpProgress] = items()
    """an entry per iteration"""

    def text(self, problem: Problem) -> str:
        """One sentence that says why the solver stopped, with names from the problem."""
        return _core.summary_text(self, problem)


@dataclass(eq=False, repr=False)
class CostEntry(Spec):
    """What one cost term adds."""

    name: str
    cost: float


@dataclass(eq=False, repr=False)
class CostKnot(Spec):
    """What one knot costs."""

    name: str
    cost: float
    terms: List[CostEntry]


@dataclass(eq=False, repr=False)
class LimitedRow(Spec):
    """A row of a constraint, where it is furthest outside its limits, or nearest to one of them from
    inside."""

    name: str
    """as Problem.row_names has it"""
    knot: str
    """as Problem.knot_name has it"""
    value: float
    lower: float
    upper: float
    outside: float
    """how far; negative: the least distance to a limit from inside"""


@dataclass(eq=False, repr=False)
class CostReport(Spec):
    """Where a cost comes from."""

    total: float
    terms: List[CostEntry]
    """summed over knots, in order of appearance"""
    knots: List[CostKnot]
    """N + 1"""
    rows: List[LimitedRow]
    """of constraints, over all knots, in order of appearance"""

    def text(self) -> str:
        """A table for people: terms from the largest down, and the five most expensive knots, and the
        five rows that are furthest outside their limits."""
        return _core.cost_report_text(self)


@dataclass(eq=False, repr=False)
class NamedMatrix(Spec):
    """A result with the names of what its rows and columns stand for."""

    rows: List[str]
    columns: List[str]
    values: NDArray[np.float64]
