"""Model predictive control."""

from __future__ import annotations

import abc
from dataclasses import dataclass
from typing import TYPE_CHECKING, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._core import FeedbackPlan, MpcController, Schedule, TorqueErrorObserver, Trace
from ._spec import Spec
from .base import Status
from .estimate import ImuReading
from .ocp import ProblemSpec
from .solver import DdpOptions, LimitOptions, StepUpdate

if TYPE_CHECKING:  # it imports what is here
    from .pressing import PressingTask

__all__ = [
    "Command", "Controller", "Fallback", "FaultKind", "FaultReport", "FeedbackPlan",
    "FrictionEstimateOptions", "GainRange", "LinearFeedback", "LoopMargins", "Measurement", "ModelErrorKind", "ModelErrorOptions", "MpcController",
    "MpcSpec", "PlanTiming", "SafetyLimits", "Schedule", "SchedulePhase", "SlipOptions", "TorqueErrorObserver",
]


# Described classes stand here (scripts/describe).


@dataclass(eq=False, repr=False)
class FaultReport(Spec):
    def text(self) -> str:
        """One sentence, such as "speed limit at 3.2140 s: joint 'wrist_3': 3.9 rad/s, allowed 3.6
        rad/s"."""
        return _core.fault_text(self)


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
