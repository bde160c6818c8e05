"""Plants, disturbances, controllers, closed loops."""

from __future__ import annotations

import abc
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Optional

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._core import (
    Actuation,
    ClosedLoop,
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
    push_at,
    scene_under_tip,
)
from ._spec import Spec
from .base import Status
from .contact import SurfaceShape

__all__ = [
    "Actuation", "ActuationStep", "AdmittanceGains", "AdmittanceSpec", "CirclePath", "ClosedLoop",
    "ClosedLoopOptions", "Disturbances", "HoistSpec", "IdealPlantOptions", "ImpedanceGains", "ImpedanceSpec", "ImuFault",
    "MotorLoss", "MujocoContact", "MujocoPlantOptions", "Plant", "PlantSnapshot", "PressingPath", "Push", "SceneSpec",
    "Sensing", "SlipperyGround", "SupportSpec",
    "SurfaceMotion", "SurfaceSpec", "TaskPoint", "ToolTipSpec", "UnknownPayload", "check_disturbances", "checked_scene", "gap", "has_mujoco",
    "make_admittance_controller", "make_ideal_plant", "make_impedance_controller",
    "make_mujoco_plant", "plant_model", "plant_scene", "push_at", "scene_under_tip",
]


# scripts/describe inserts the described classes here.


class Plant(abc.ABC):
    """Simulation of a robot and a surface with a fixed time step.

    The plants of the library are of this class. Your own plant needs the attributes `model`, `dt`, `q` and
    `v`, and the methods reset() and step(). The other attributes are optional. By default, the scene is
    SceneSpec(), the time is the number of steps times dt, and forces are zero. The frame of the tip in
    `scene` must be a frame of the model.

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
            """True surface and tool tip."""

        @property
        def time(self) -> float:
            """Time since reset() [s]."""

        @property
        def contact_force_world(self) -> NDArray[np.float64]:
            """Force of the surface on the tip during the last step, world axes, shape (3,) [N]."""

        @property
        def in_contact(self) -> bool:
            """True if the surface exerted a force on the tip during the last step."""

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
    def step(self, tau: Any, push_world: Any = None) -> Optional[Status]:
        """Advances by dt, with constant torques and a constant force on the tip.

        Parameters
        ----------
        tau : array_like, shape (nv,)
            Torques [Nm or N]. The entries of a floating base are a wrench in the axes of the base.
        push_world : array_like, shape (3,), or None
            Force at the origin of the tip frame, in world axes [N].

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
