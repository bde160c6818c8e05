"""Plants, disturbances, controllers, closed loops."""

from __future__ import annotations

import abc
import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, List, Optional

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._core import (
    Actuation,
    ClosedLoop,
    Error,
    Model,
    Sensing,
    check_disturbances,
    checked_scene,
    gap,
    has_mujoco,
    make_admittance_controller,
    make_ideal_plant,
    make_impedance_controller,
    make_mujoco_plant,
    plant_model,
    plant_scene,
    with_surface_at,
)
from ._renamed import refuse_old_names
from ._spec import Spec
from .base import Status
from .contact import SurfaceShape
from .mpc import WrenchSensor

__all__ = [
    "Actuation", "ActuationStep", "AdmittanceGains", "AdmittanceSpec", "CirclePath", "ClosedLoop",
    "ClosedLoopOptions", "Disturbances", "HoistSpec", "IdealPlantOptions", "ImpedanceGains", "ImpedanceSpec", "ImuFault",
    "MotorLoss", "MujocoContact", "MujocoPlantOptions", "Plant", "PlantSnapshot", "PressingPath", "Push", "SceneSpec",
    "Sensing", "SlipperyGround", "SurfaceMotion", "SurfaceSpec", "TaskPoint", "TouchSpec", "UnknownPayload",
    "check_disturbances", "checked_scene", "gap", "has_mujoco", "make_admittance_controller", "make_ideal_plant",
    "make_impedance_controller", "make_mujoco_plant", "plant_model", "plant_scene", "with_surface_at",
]


# scripts/describe inserts the described classes here.


class Plant(abc.ABC):
    """Simulation of a robot and its scene with a fixed time step.

    The plants of the library are of this class. Your own plant needs the attributes `model`, `dt`, `q` and
    `v`, and the methods reset() and step(). The other attributes are optional. By default, the scene is
    SceneSpec() without touches, the time is the number of steps times dt, and wrenches and friction are
    zero. The frames of `scene` must be frames of the model.

    A loop adds the torques of pushes to the torques of step(). Without a loop, add J^T f, with the Jacobian J
    of the frame and the force f on it.

    A loop reads `model`, `dt` and `scene` when it is made, and the other attributes after each reset and
    step. An exception of a method ends the run, and the methods of the loop raise it. A call of step() takes
    about 10 us in addition to its own computing time."""

    if TYPE_CHECKING:

        @property
        def model(self) -> Model:
            """True model of the robot."""

        @property
        def dt(self) -> float:
            """Time step [s]."""

        @property
        def q(self) -> NDArray[np.float64]:
            """Configuration, shape (nq,)."""

        @property
        def v(self) -> NDArray[np.float64]:
            """Velocity, shape (nv,)."""

        @property
        def scene(self) -> SceneSpec:
            """True touches and their surfaces."""

        @property
        def time(self) -> float:
            """Time since reset() [s]."""

        @property
        def wrenches(self) -> NDArray[np.float64]:
            """Wrenches of the surfaces on the touches of `scene` during the last step, shape (6, touches):
            force [N], then moment [Nm] about the origin of the touch's frame, in the axes of this frame at the
            start of the step. Zero without contact."""

        @property
        def friction_torque(self) -> NDArray[np.float64]:
            """Torques of joint friction during the last step, against the motion, shape (nv,) [Nm or N]."""

    @abc.abstractmethod
    def reset(self, q: Any, v: Any = None) -> Optional[Status]:
        """Sets the state, at time zero and without forces.

        Parameters
        ----------
        q : array_like, shape (nq,)
            Configuration.
        v : array_like, shape (nv,), or None
            Velocity; None: at rest.

        Returns
        -------
        Status or None
            A Status above NOT_CONVERGED reports a failure.
        """

    @abc.abstractmethod
    def step(self, tau: Any) -> Optional[Status]:
        """Advances by dt, with constant torques.

        Parameters
        ----------
        tau : array_like, shape (nv,)
            Torques [Nm or N]. The entries of a floating base are a wrench in the axes of the base.

        Returns
        -------
        Status or None
            A Status above NOT_CONVERGED reports a failure.
        """

    def save(self) -> PlantSnapshot:
        """Returns a snapshot: all data on which future steps depend, and the forces of the last step."""
        raise NotImplementedError(f"{type(self).__name__} has no method save()")

    def restore(self, snapshot: PlantSnapshot) -> None:
        """Restores a saved state. The same torques then give the same motion, bit by bit.

        Parameters
        ----------
        snapshot : PlantSnapshot
            Result of save() of this plant.
        """
        raise NotImplementedError(f"{type(self).__name__} has no method restore()")


Plant.register(_core.CompiledPlant)
refuse_old_names(sys.modules[__name__], _core.CompiledPlant)


@dataclass(eq=False, repr=False)
class SceneSpec(Spec):
    def tool_index(self) -> int:
        """Returns the index of the first touch that is not a support; -1 if there is none.

        This touch is the tool in traces."""
        return next((i for i, touch in enumerate(self.touches) if not touch.is_support), -1)

    def tool(self) -> TouchSpec:
        """Returns the entry of `touches` at tool_index(), not a copy.

        Raises
        ------
        Error
            If all touches are supports.
        """
        if self.tool_index() < 0:
            raise Error("the scene has no tool; wanted a touch that is not a support")
        return self.touches[self.tool_index()]

    def supports(self) -> List[TouchSpec]:
        """Returns the entries of `touches` that are supports, not copies."""
        return [touch for touch in self.touches if touch.is_support]

    def touch(self, frame: str) -> TouchSpec:
        """Returns the entry of `touches` with a frame, not a copy.

        Parameters
        ----------
        frame : str

        Raises
        ------
        Error
            If no touch has this frame.
        """
        for touch in self.touches:
            if touch.frame == frame:
                return touch
        hint = _core.did_you_mean(frame, [touch.frame for touch in self.touches])
        raise Error(f"the scene has no touch '{frame}'{hint}")


@dataclass(eq=False, repr=False)
class CirclePath(Spec):
    def at(self, t: float) -> TaskPoint:
        """Returns the point of the path at a time.

        Parameters
        ----------
        t : float
            Time since the start of the path [s]; the first point for t < 0.

        Returns
        -------
        TaskPoint
        """
        return _core.circle_path_at(self, t)
