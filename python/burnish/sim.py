"""Plants, disturbances, closed loops."""

from __future__ import annotations

import abc
import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Callable, List, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

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
    make_ideal_plant,
    make_impedance_controller,
    make_mujoco_plant,
    plant_model,
    plant_scene,
    push_at,
    scene_under_tip,
)
from ._spec import Spec, empty, items, vector, zeros
from .base import Status

__all__ = [
    "Actuation", "ActuationStep", "CirclePath", "ClosedLoop", "ClosedLoopOptions", "Disturbances",
    "IdealPlantOptions", "ImpedanceSpec", "MujocoPlantOptions", "Plant", "PlantSnapshot", "Push",
    "SceneSpec", "Sensing", "SurfaceSpec", "TaskPoint", "ToolTipSpec", "check_disturbances",
    "checked_scene", "gap", "has_mujoco", "make_ideal_plant", "make_impedance_controller",
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
class TaskPoint(Spec):
    """Where the tip frame's origin shall be and how hard the surface shall push back."""

    p_world: ArrayLike = zeros(3)
    """3, m"""
    v_world: ArrayLike = zeros(3)
    """3, m/s"""
    a_world: ArrayLike = zeros(3)
    """3, m/s^2"""
    force: float = 0.0
    """N, along the surface's normal"""


@dataclass(eq=False, repr=False)
class CirclePath(Spec):
    """A circle in a plane. It starts at the centre, at rest, and its radius grows smoothly."""

    center_world: ArrayLike = zeros(3)
    """3, m"""
    normal_world: ArrayLike = vector(0.0, 0.0, 1.0)
    """3, of the plane, any length but zero"""
    radius: float = 0.07
    """m"""
    rate: float = 1.0
    """rad/s, about the normal"""
    start_up: float = 2.0
    """s until the radius is reached; positive"""
    force: float = 30.0
    """N"""

    def at(self, t: float) -> TaskPoint:
        """The task at t s from the start; before it, the start."""
        return _core.circle_path_at(self, t)


@dataclass(eq=False, repr=False)
class ImpedanceSpec(Spec):
    """The baseline without optimal control: an impedance of the tool in the world, the wanted force
    fed forward, its error integrated, a posture in the null space. With e the tool's position error
    along the surface, v_n its velocity along the normal n and f the force along n:
    a = a_path + kp e + kd de/dt - kd_normal v_n n and f = f_path + ki * integral of (f_path -
    f_measured), by the tool's inertia and its Jacobian as torques."""

    tool: str = "tool"
    """frame whose origin follows the path"""
    normal_world: ArrayLike = vector(0.0, 0.0, 1.0)
    """3, of the surface, towards the robot"""
    task: Optional[Callable[[float], TaskPoint]] = None
    """the task at t s after the ramp; before, it stays at its start; must be given"""
    posture: ArrayLike = empty()
    """nq, what the null space is drawn to"""
    period: float = 1e-3
    """s between ticks"""

    kp: float = 900.0
    """1/s^2, along the surface"""
    kd: float = 60.0
    """1/s, along the surface"""
    kd_normal: float = 30.0
    """1/s, along the normal"""
    ki: float = 10.0
    """1/s, of the force error; 0: no force feedback"""
    integral_limit: float = 30.0
    """N, largest correction by the integral"""
    posture_kp: float = 20.0
    """1/s^2"""
    posture_kd: float = 6.0
    """1/s"""
    friction: float = 0.0
    """of the surface, fed forward along the path's velocity"""
    approach_speed: float = 0.05
    """m/s, of a point that draws the tip against the normal"""
    contact_threshold: float = 2.0
    """N of measured normal force that end the approach"""
    ramp: float = 0.5
    """s from the threshold to the task's force"""


@dataclass(eq=False, repr=False)
class MujocoPlantOptions(Spec):
    dt: float = 5e-4
    """s"""
    impedance: float = 0.1
    """d in (0, 1): (1 - d) / d times MuJoCo's inverse inertia of the tip is that of an apparent mass
    at the contact"""
    friction_ratio: float = 10.0
    """how much harder friction is than the normal ("impratio")"""
    tolerance: float = 1e-12
    """of the constraint solver"""
    max_iterations: int = 100
    """of the constraint solver"""
    joint_stops: bool = True
    """revolute and prismatic joints stop at their limits"""
