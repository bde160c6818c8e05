"""Common parts of tasks that press a tool on a surface: options for an MpcController, search for postures,
and records of runs."""

from __future__ import annotations

import enum

from dataclasses import dataclass
from typing import List, Optional

import numpy as np
from numpy.typing import NDArray

from . import mpc as _mpc
from ._spec import Spec
from .contact import SurfaceShape
from .mpc import Fallback, SlipOptions

__all__ = [
    "FoundPosture", "HomeMove", "HomeSpec", "Phase", "PlanLimits", "PlanRecord", "PlantKind", "PostureLimits",
    "PostureOptions",
    "PressedSurface", "PressingTask", "ReachOptions", "ReachProblem", "ReachReport", "SEARCHED_POSTURE", "Standing",
    "SurfaceEstimateOptions", "TaskTarget",
    "TickTimes", "ToolLimits", "Touch",
]

SEARCHED_POSTURE = "search"
"""Value of a posture's name in a task, for which find_posture() finds a posture."""


class Phase(enum.IntEnum):
    """Phases of a polishing run: the numbers in Command.phase and in traces.

    The tool approaches a surface, presses on it, follows a path on it, and retreats."""

    REACH = 0
    APPROACH = 1
    RAMP = 2
    TRACK = 3
    RETREAT = 4
    HOME = 5
    """Motion from the home posture, the first phase if a home is set (see HomeSpec)"""


# scripts/describe inserts the described classes here.


@dataclass(eq=False, repr=False)
class ReachReport(Spec):
    @property
    def ok(self) -> bool:
        """True if the check found no problem."""
        return self.problem == ReachProblem.NONE


@dataclass(eq=False, repr=False)
class PlanRecord(Spec):
    """Recorded plans of a model predictive controller; empty without plans."""

    time: NDArray[np.float64]
    """Time of the first knot of each plan [s], shape (plans,)"""
    terms: List[str]
    """Names of the cost terms of all planned stages"""
    costs: NDArray[np.float64]
    """Costs, summed over each plan with its terminal cost, shape (terms, plans)"""
    step: float
    """Time between recorded knots [s]"""
    q: NDArray[np.float32]
    """Configurations, shape (plans, knots, nq)"""
    x: NDArray[np.float64]
    """State at the first knot, from which the plan starts, shape (plans, nx)"""
    u: NDArray[np.float64]
    """Controls at the first knot, shape (plans, nu)"""
    K: NDArray[np.float64]
    """Riccati gains at the first knot, shape (plans, nu, ndx)"""
    Vx: NDArray[np.float64]
    """Gradient of the value function at the first knot, shape (plans, ndx)"""
    Vxx: NDArray[np.float64]
    """Hessian of the value function at the first knot, shape (plans, ndx, ndx)"""


# The annotation of MpcSpec.task names this class. Module mpc is imported before this module.
setattr(_mpc, "PressingTask", PressingTask)
