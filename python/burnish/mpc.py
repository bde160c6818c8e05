"""Model predictive control."""

from __future__ import annotations

import abc
from dataclasses import dataclass
from typing import TYPE_CHECKING, Dict, List, Optional, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._core import FeedbackPlan, MpcController, Schedule, TorqueErrorObserver, Trace
from ._spec import Spec
from .base import Status
from .estimate import ImuReading
from .ocp import ProblemSpec
from .solver import DdpOptions, LimitOptions, StepUpdate

if TYPE_CHECKING:  # .pressing imports this module
    from .pressing import PressingTask

__all__ = [
    "Command", "Controller", "Fallback", "FaultKind", "FaultReport", "FeedbackPlan",
    "FrictionEstimateOptions", "GainRange", "LinearFeedback", "LoopMargins", "Measurement", "ModelErrorKind", "ModelErrorOptions", "MpcController",
    "MpcSpec", "PlanTiming", "SafetyLimits", "Schedule", "SchedulePhase", "SlipOptions", "ToolCommand", "ToolSpec",
    "TorqueErrorObserver", "TouchSensor", "WrenchSensor",
]


# scripts/describe inserts the described classes here.


@dataclass(eq=False, repr=False)
class FaultReport(Spec):
    def text(self) -> str:
        """Returns a sentence such as "speed limit at 3.2140 s: joint 'wrist_3': 3.9 rad/s, allowed 3.6
        rad/s"."""
        return _core.fault_text(self)


class Controller(abc.ABC):
    """Controller of the simulation, which maps measurements to torques at a fixed period.

    The controllers of the library are of this class. Your own controller needs the attribute `nv` and
    the two methods below. An exception of a method ends the run, and the methods of the loop raise it.

    The attributes `touches`, `tools`, `signals` and `signal_values` are optional; each may be a property. A loop
    reads `signal_values` after each tick, and the others when it is made. A controller around another one returns
    the `touches` and `tools` of the other one, and adds its own signals to those of the other one."""

    if TYPE_CHECKING:

        @property
        def nv(self) -> int:
            """Number of torques in a command."""

        @property
        def touches(self) -> Optional[List[str]]:
            """Frames of the columns of Measurement.wrenches, which the controller reads. None, or without the
            attribute: all touches of the plant's scene, in their order."""

        @property
        def tools(self) -> List[str]:
            """Frames of the tools of Command.tools, in the same order. An empty list, or without the attribute: one
            entry, which belongs to the first tool of the plant's scene."""

        @property
        def signals(self) -> Dict[str, str]:
            """Units of the values that the controller publishes, by name, such as {"gain": "-"}. A loop reads the
            attribute when it is made, and records each value in a column "signal_<name>" of its trace."""

        @property
        def signal_values(self) -> Dict[str, float]:
            """Values of `signals` at the last tick, by name."""

    @abc.abstractmethod
    def reset(self) -> None:
        """Resets the controller to its state before the first tick."""

    @abc.abstractmethod
    def tick(self, measurement: Measurement) -> Union[Command, NDArray[np.float64]]:
        """Computes the command for a measurement.

        Parameters
        ----------
        measurement : Measurement

        Returns
        -------
        Command or ndarray, shape (nv,)
            Command, or only its torques [Nm or N].
        """


Controller.register(_core.CompiledController)
