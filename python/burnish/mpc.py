"""Model predictive control."""

from __future__ import annotations

import abc
import enum
import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, List, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._core import FeedbackPlan, MpcController, Schedule, TorqueErrorObserver, Trace
from ._spec import Spec, empty, items, vector, zeros
from .base import Status
from .ocp import ProblemSpec
from .pressing import PressingTask
from .solver import DdpOptions, StepUpdate

__all__ = [
    "Command", "Controller", "Fallback", "FaultKind", "FaultReport", "FeedbackPlan",
    "LinearFeedback", "Measurement", "ModelErrorKind", "ModelErrorOptions", "MpcController",
    "MpcSpec", "SafetyLimits", "Schedule", "SchedulePhase", "TorqueErrorObserver",
]


class FaultKind(enum.Enum):
    """What can go wrong in a control loop."""

    NONE = 0
    STALE_MEASUREMENT = 1
    """time does not go on"""
    BAD_MEASUREMENT = 2
    """NaN, infinite or of the wrong size, for too long"""
    OUT_OF_RANGE = 3
    """a joint is beyond its position limit"""
    SOLVER_FAILED = 4
    """no usable plan for too many updates in a row, or at the first"""
    SOLVER_LATE = 5
    """too many updates in a row took longer than their deadline"""
    CONTACT_LOST = 6
    """no force for too long while it is wanted"""
    NO_CONTACT = 7
    """the tool went on too far where the surface was expected"""
    CONTACT_LATE = 8
    """the tool took too long to get to the surface"""
    UNEXPECTED_CONTACT = 9
    """a force while the tool moves through free space"""
    FORCE_LIMIT = 10
    """the tool is pushed harder than allowed"""
    SPEED_LIMIT = 11
    """a joint or the tool is faster than allowed"""
    WATCHED = 12
    """a quantity of the task, FaultReport.quantity, is beyond its limit"""


# Described classes stand here (scripts/describe).


@dataclass(eq=False, repr=False)
class Measurement(Spec):
    """What the sensors say at a tick."""

    time: float = 0.0
    """s"""
    q: ArrayLike = empty()
    """nq"""
    v: ArrayLike = empty()
    """nv"""
    tau: ArrayLike = empty()
    """nv, of the torque sensors between motor and link, Nm or N"""
    tool_force_world: ArrayLike = zeros(3)
    """3, of the force sensor: the surface's force on the tool, N, world axes"""


@dataclass(eq=False, repr=False)
class Command(Spec):
    """What a controller sends. Only `tau` reaches the plant; the rest says what the controller aims
    at and how it fares, for the record."""

    tau: ArrayLike = empty()
    """nv, Nm or N; zero for a floating base"""
    phase: int = 0
    """where the task stands: of an MpcController, its place in the schedule"""
    target_force: float = 0.0
    """N, how hard the surface shall push back along its normal"""
    p_target_world: ArrayLike = zeros(3)
    """3, m, of the tip frame's origin"""
    force_estimate_world: ArrayLike = zeros(3)
    """3, what the controller believes the surface's force on the tool to be, N, world axes"""
    status: Status = Status.OK
    solve_time: float = 0.0
    """s of wall clock, where an optimal control problem was solved"""
    iterations: int = 0
    """of its solver"""
    missed_deadline: bool = False
    """its solution came later than it was due"""


@dataclass(eq=False, repr=False)
class SchedulePhase(Spec):
    name: str = ""
    """such as approach"""
    stage: str = ""
    """of the optimal control problem"""
    duration: float = math.inf
    """s; infinite for the last one only"""
    until: str = ""
    """event, such as "contact", that ends it, and not before; empty: its duration does. When the event
    is early, the clock jumps to the end; when it is late, the clock stands still `hold` s before it,
    so that the horizon goes on with the phase and plans the next one soon. Of the last phase it means
    nothing."""
    hold: float = 0.05
    """s; longer than the phase: the clock stands still at its start"""


@dataclass(eq=False, repr=False)
class FaultReport(Spec):
    """The first fault of a run, and the ticks that led to it."""

    kind: FaultKind = FaultKind.NONE
    time: float = 0.0
    """s, of the measurement, or when it was due if there was none"""
    joint: int = -1
    """entry of v that it is about, or -1"""
    value: float = 0.0
    """what was measured: s, updates, N, m, m/s, or of a joint rad (m) and rad/s"""
    limit: float = 0.0
    """what was allowed, in the same unit"""
    quantity: str = ""
    """of FaultKind.WATCHED: its name and unit"""
    last_second: Trace = field(default_factory=Trace)
    """oldest row first, the fault's tick last; empty while there is no fault"""

    def text(self) -> str:
        """One sentence, such as "contact lost at 3.2140 s: no force for 0.1505 s while it was wanted;
        allowed are 0.15 s"."""
        return _core.fault_text(self)


@dataclass(eq=False, repr=False)
class LinearFeedback(Spec):
    """u = feedforward + gain (x (-) state): the triple that linear feedback controllers take."""

    feedforward: NDArray[np.float64] = empty()
    """nu, Nm (N)"""
    gain: NDArray[np.float64] = field(default_factory=lambda: np.zeros((0, 0)))
    """nu x ndx: by position, velocity and, with a torque model, torque"""
    state: NDArray[np.float64] = empty()
    """nx, (q, v) or (q, v, tau)"""


@dataclass(eq=False, repr=False)
class MpcSpec(Spec):
    """Model predictive control of a task: a horizon that moves with time, solved again and
    again from the measured state, and its policy in between."""

    problem: ProblemSpec
    """horizon, stages, costs. The horizon's stages are replaced by what the schedule says, so its
    segments matter for the number of knots alone; all stages have the same step."""
    schedule: List[SchedulePhase] = items()
    task: Optional[PressingTask] = None
    """events of the schedule, what is watched; None: neither"""
    tool: str = "tool"
    """frame that Measurement.tool_force_world acts at"""
    normal_world: ArrayLike = vector(0.0, 0.0, 1.0)
    """3, that the tool presses along: of the surface, towards the robot"""
    contact_threshold: float = 2.0
    """N along the normal that count as contact"""
    tick_period: float = 5e-4
    """s"""
    update_period: float = 0.01
    """s between solves, a multiple of the tick"""
    solver_delay: float = 0.0
    """s from a measurement to the use of the plan that starts from it, at most the update period. The
    plan is made for the state that the policy in use leads to by then."""
    solver: DdpOptions = field(default_factory=lambda: DdpOptions(
        update=StepUpdate.MULTIPLE_SHOOTING, max_iterations=1))
    first_iterations: int = 100
    """of the first solve"""
    jump_iterations: int = 3
    """of one after the schedule's clock jumped or stood still"""
    model_error: ModelErrorOptions = field(default_factory=ModelErrorOptions)
    limits: SafetyLimits = field(default_factory=SafetyLimits)
    fallback: Fallback = field(default_factory=Fallback)
    feedback: bool = True
    """the Riccati policy between solves; without, the planned torque is held"""


class Controller(abc.ABC):
    """What a controller is to the simulation: measurements in, a torque out, at a fixed period. The
    library's controllers are of this class; so is one of your own, which has the attribute `nv` and
    these two methods. What they raise ends the run and is raised by the loop's methods."""

    if TYPE_CHECKING:

        @property
        def nv(self) -> int:
            """Torques of a command."""

    @abc.abstractmethod
    def reset(self) -> None:
        """Forgets all ticks before."""

    @abc.abstractmethod
    def tick(self, measurement: Measurement) -> Union[Command, NDArray[np.float64]]:
        """The command that follows a measurement; the torque (nv,; Nm, N) alone will do."""


Controller.register(_core.CompiledController)
