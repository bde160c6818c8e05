"""What tasks that press a tool on a surface share: what they tell an MpcController, from which posture
they reach, and what their runs leave."""

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
"""In a task, in place of a posture's name: let find_posture() find one."""


class Phase(enum.IntEnum):
    """The phases of a tool that comes to a surface, presses on it, follows a path there and leaves,
    as Command.phase and traces of polishing count them."""

    REACH = 0
    APPROACH = 1
    RAMP = 2
    TRACK = 3
    RETREAT = 4
    HOME = 5
    """first where there is one: see HomeSpec"""


# Described classes stand here (scripts/describe).


@dataclass(eq=False, repr=False)
class ReachReport(Spec):
    @property
    def ok(self) -> bool:
        """Whether nothing is in the way."""
        return self.problem == ReachProblem.NONE


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
    x: NDArray[np.float64]
    """(plans, nx), of the first knot: the state that the plan was made for"""
    u: NDArray[np.float64]
    """(plans, nu), of the first knot"""
    K: NDArray[np.float64]
    """(plans, nu, ndx), Riccati gains of the first knot"""
    Vx: NDArray[np.float64]
    """(plans, ndx), gradient of the value function at the first knot"""
    Vxx: NDArray[np.float64]
    """(plans, ndx, ndx), its Hessian"""


# What MpcSpec.task says, for who asks for its types: that module is there before this one.
setattr(_mpc, "PressingTask", PressingTask)
