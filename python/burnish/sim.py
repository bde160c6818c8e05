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


@dataclass(eq=False, repr=False)
class Push(Spec):
    """A force on the tool for a while."""

    start: float = 0.0
    """s"""
    duration: float = 0.0
    """s"""
    force_world: ArrayLike = zeros(3)
    """3, N, world axes, at the tip frame's origin"""


@dataclass(eq=False, repr=False)
class Disturbances(Spec):
    """All that makes a plant differ from what its controller believes. Nothing is switched on
    unless it is named: zero, empty, false or "no value" is off. What is drawn at random comes from
    the seed. Joints are the entries of v; those of a floating base have neither motors nor encoders
    and are spared. Units are those of revolute joints; prismatic ones have m and N in place of rad
    and Nm."""

    seed: int = 0
    """of everything that is drawn at random"""

    # From command to joint torque, in the order in which they act.
    command_delay: float = 0.0
    """s from the controller to the motors; rounded to plant steps"""
    torque_cutoff: float = 0.0
    """rad/s, first-order lag of the motors; 0: none; dtau/dt = cutoff (command - tau)"""
    torque_scale_range: float = 0.0
    """each joint gives 1 + r times its torque, |r| <= this"""
    torque_scale: ArrayLike = empty()
    """nv factors in place of drawn ones, or empty"""
    torque_bias_range: float = 0.0
    """Nm: each joint adds b, |b| <= this"""
    torque_bias: ArrayLike = empty()
    """nv, Nm (N), in place of drawn ones, or empty"""
    torque_noise: float = 0.0
    """Nm, deviation; new at every plant step"""
    torque_limits: bool = True
    """joints give no more than the robot's effort limits"""
    torque_loop: bool = False
    """a loop around a torque sensor takes away scale, bias and joint friction; ideal in its
    bandwidth; it follows the sensor's noise instead"""
    torque_sensor_noise: float = 0.0
    """Nm, deviation"""

    # In the joints of the plant.
    joint_coulomb: float = 0.0
    """Nm, joint friction"""
    joint_viscous: float = 0.0
    """Nms/rad, joint friction"""

    # From plant to measurement.
    encoder_bits: int = 0
    """per turn; 0: exact; of revolute and continuous joints"""
    position_noise: float = 0.0
    """rad, deviation, before the encoder rounds"""
    velocity_noise: float = 0.0
    """rad/s, deviation"""
    finite_difference_velocity: bool = False
    """velocities from measured positions; in place of the true ones"""
    velocity_cutoff: float = 0.0
    """rad/s, low-pass on those; 0: none"""
    force_noise: float = 0.0
    """N, deviation per axis of the force sensor"""
    force_cutoff: float = 0.0
    """rad/s, low-pass behind the noise; 0: none"""

    # In the plant's model and scene: plant_model() and plant_scene().
    mass_scale: float = 1.0
    """of all masses and inertias of the plant"""
    surface_tilt_deg: ArrayLike = zeros(2)
    """2, degrees about the surface's two tangents, unknown to the controller; through its point,
    about the first tangent after the second"""
    surface_height: float = 0.0
    """m along the normal; before the tilt"""
    surface_friction: Optional[float] = None
    """Coulomb coefficient in place of the scene's"""
    pushes: List[Push] = items()
    """on the tool"""


@dataclass(eq=False, repr=False)
class SurfaceSpec(Spec):
    """A plane, or a square of one. All vectors in the world."""

    point: ArrayLike = zeros(3)
    """3, any point on it, m; of a square, its middle"""
    normal: ArrayLike = vector(0.0, 0.0, 1.0)
    """3, out of the material, towards the robot"""
    friction: float = 0.0
    """Coulomb coefficient mu"""
    stiffness: float = 100000.0
    """N/m; rigid plants pass it over"""
    damping: float = 500.0
    """Ns/m; rigid plants pass it over. MuJoCo's convex friction cone lifts a sliding tip by mu *
    damping * speed: contact is lost unless damping < force / (mu * speed), and below a third of
    that the force is clean."""
    extent: float = math.inf
    """m, half the side of the square about `point` that is there to be touched, its sides along the
    columns of Reference.surface_with_normal(); infinite: the plane has no end"""
    half_size: float = 0.4
    """m, of the square that is drawn where the plane has no end"""


@dataclass(eq=False, repr=False)
class ToolTipSpec(Spec):
    """A sphere about the origin of a frame. It touches a plane at one point, and the normal force
    passes through the frame's origin."""

    frame: str = "tool"
    radius: float = 0.02
    """m"""


@dataclass(eq=False, repr=False)
class SceneSpec(Spec):
    """What the tool meets: a flat surface, and a round tip."""

    surface: SurfaceSpec = field(default_factory=SurfaceSpec)
    tip: ToolTipSpec = field(default_factory=ToolTipSpec)


@dataclass(eq=False, repr=False)
class PlantSnapshot(Spec):
    """A moment of a plant, to go back to. What it holds belongs to the kind of plant that saved
    it."""

    numbers: ArrayLike = empty()


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
class ActuationStep(Spec):
    """One plant step of the actuation: the torque after each part, nv each, Nm or N."""

    command: NDArray[np.float64] = empty()
    """as it came"""
    delayed: NDArray[np.float64] = empty()
    tracked: NDArray[np.float64] = empty()
    """behind the first-order lag"""
    noise: NDArray[np.float64] = empty()
    """added to what follows scale and bias"""
    applied: NDArray[np.float64] = empty()
    """to the plant: scaled, biased, noisy, within the limits"""
    limited: int = 0
    """joints at their effort limit"""
    held: bool = False
    """the command was not finite: the one before it was taken"""


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
class IdealPlantOptions(Spec):
    """How make_ideal_plant()'s plant steps."""

    dt: float = 0.0005
    """s"""
    tip_viscous: float = 0.0
    """Ns/m, against the contact point's sliding, besides Coulomb"""
    stabilize_kp: float = 10000.0
    """1/s^2, on the gap while in contact"""
    stabilize_kd: float = 200.0
    """1/s, on its rate"""


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


@dataclass(eq=False, repr=False)
class ClosedLoopOptions(Spec):
    """How a ClosedLoop runs, and what it records."""

    control_period: float = 0.001
    """s, a multiple of the plant's step"""
    max_duration: float = 20.0
    """s that the trace has room for"""
    record_every: int = 1
    """plant steps per row of the trace"""
