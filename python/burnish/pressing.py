"""Tasks that press a tool on a surface: what they tell an MpcController."""

from __future__ import annotations

import enum
from dataclasses import dataclass, field
from typing import Callable, List, Optional

from numpy.typing import ArrayLike

from ._spec import Spec, items, zeros

__all__ = ["Phase", "PressingTask", "TaskTarget", "ToolLimits", "Touch"]


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
