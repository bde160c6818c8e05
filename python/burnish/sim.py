"""Plants, disturbances, closed loops."""

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


# Described classes stand here (scripts/describe).


class Plant(abc.ABC):
    """A robot and a surface, advanced by a fixed step. The library's plants are of this class; so is
    one of your own, which has the attributes below and the methods reset() and step(). Only `model`,
    `dt`, `q` and `v` have to be there; the scene is otherwise SceneSpec(), time counts steps, and
    there are no forces. The tip's frame in `scene` has to be one of the model's.

    A loop asks for `model`, `dt` and `scene` when it is made, and for the rest after every reset and
    step. What a method raises ends the run, and is raised by the loop's methods. A step in Python
    takes some 10 us besides what it computes."""

    if TYPE_CHECKING:

        @property
        def model(self) -> Model:
            """The robot as it is."""

        @property
        def dt(self) -> float:
            """s, of a step."""

        @property
        def q(self) -> NDArray[np.float64]:
            """Configuration (nq,)."""

        @property
        def v(self) -> NDArray[np.float64]:
            """Velocity (nv,)."""

        @property
        def scene(self) -> SceneSpec:
            """Surface and tip as they are."""

        @property
        def time(self) -> float:
            """s since reset()."""

        @property
        def contact_force_world(self) -> NDArray[np.float64]:
            """Force of the surface on the tip during the last step (3,), N, world axes."""

        @property
        def in_contact(self) -> bool:
            """Whether the surface pushed during the last step."""

        @property
        def friction_torque(self) -> NDArray[np.float64]:
            """Torque of joint friction during the last step (nv,), Nm or N: against the motion."""

    @abc.abstractmethod
    def reset(self, q: Any, v: Any = None) -> Optional[Status]:
        """Starts at the configuration q (nq,) with the velocity v (nv,), None: at rest, at time zero,
        without force. A Status above NOT_CONVERGED, or an exception, says that it did not."""

    @abc.abstractmethod
    def step(self, tau: Any, push_world: Any = None) -> Optional[Status]:
        """Advances by dt with the torques tau (nv,; Nm, N; entries of a floating base act as a wrench
        in its body axes) and a force on the tip (3,; N, world axes, at the tip frame's origin), held
        over the step. A Status above NOT_CONVERGED, or an exception, says that it did not."""

    def save(self) -> PlantSnapshot:
        """A snapshot of all that the future depends on, and of the readings."""
        raise NotImplementedError(f"{type(self).__name__} cannot be saved")

    def restore(self, snapshot: PlantSnapshot) -> None:
        """Goes back: the same torques then give the same bits."""
        raise NotImplementedError(f"{type(self).__name__} cannot be restored")


Plant.register(_core.CompiledPlant)


@dataclass(eq=False, repr=False)
class CirclePath(Spec):
    def at(self, t: float) -> TaskPoint:
        """The task at t s from the start; before it, the start."""
        return _core.circle_path_at(self, t)
