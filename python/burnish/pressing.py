"""What tasks that press a tool on a surface share: what they tell an MpcController, from which posture
they reach, and what their runs leave."""

from __future__ import annotations

import enum
from dataclasses import dataclass, field
from typing import Callable, List, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._spec import Spec, items, zeros
from .sim import has_mujoco

__all__ = [
    "FoundPosture", "Phase", "PlanRecord", "PlantKind", "PostureLimits", "PostureOptions",
    "PressingTask", "ReachOptions", "ReachProblem", "ReachReport", "SEARCHED_POSTURE", "TaskTarget",
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


class Touch(enum.Enum):
    """What the tool has to do with the surface in a phase."""

    FREE = 0
    """nothing touches: a force is a fault, and what is felt is the sensor's noise"""
    DUE = 1
    """contact is to be made: SchedulePhase.until "contact" """
    WANTED = 2
    """pressed"""
    LEAVING = 3
    """pressed at first; free once the tool has come off, or `release` s are over"""


# Described classes stand here (scripts/describe).


@dataclass(eq=False, repr=False)
class TaskTarget(Spec):
    """What the task asks of the tool at a time of the schedule, for the record. What the controller
    aims at is what the costs of the problem say."""

    p_world: ArrayLike = zeros(3)
    """3, m"""
    force: float = 0.0
    """N, along the normal; 0: no contact wanted"""


@dataclass(eq=False, repr=False)
class PressingTask(Spec):
    """The task of an MpcSpec. Its event is "contact": a measured normal force above the threshold and
    the sensor's noise, which is found out while nothing touches."""

    touch: List[Touch] = items()
    """one for each phase of the schedule"""
    target: Optional[Callable[[float], TaskTarget]] = None
    """by time of the schedule, asked at each tick; must be given"""
    limits: ToolLimits = field(default_factory=ToolLimits)


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


class PlantKind(enum.Enum):
    """What is controlled in a run."""

    MUJOCO = 0
    """an engine that shares no code with this library"""
    IDEAL = 1
    """the library's own contact dynamics, a rigid surface"""


def default_plant() -> PlantKind:
    """MuJoCo where this build has it."""
    return PlantKind.MUJOCO if has_mujoco() else PlantKind.IDEAL


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
