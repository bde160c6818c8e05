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


@dataclass(eq=False, repr=False)
class ToolLimits(Spec):
    """When a run is given up for what happens at the tool. Infinite: never."""

    force: float = 100.0
    """N at the tool, mean over force_window. A rigid impact's force at a single instant is its
    impulse over the sampling time and says little."""
    force_window: float = 0.005
    """s; rounded to ticks, one at least"""
    tool_speed: float = 1.0
    """m/s"""
    contact_lost: float = 0.15
    """s without force while it is wanted"""
    late_contact_travel: float = 0.03
    """m that the tool may go on after contact was due. Along the normal, from when the schedule's
    clock began to wait for it (SchedulePhase.hold before it was due): how far the surface may lie
    behind where it is thought to be."""
    late_contact_time: float = 3.0
    """s that contact may come late; from the same moment"""
    unexpected_force: float = 15.0
    """N while moving through free space. Mean over `force_window`, where nothing is to touch, and
    while leaving once the tool has come off (its force fell below the threshold of contact) or
    `release` s are over. More where noise reaches further: six deviations of that mean."""
    release: float = 0.5
    """s into the retreat after which it is free space at the latest"""


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
