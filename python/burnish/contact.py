"""Contacts: what is held, in which reference, and forces that say what they are."""

from __future__ import annotations

import enum
from dataclasses import dataclass, field
from typing import ClassVar, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._signal import Signal
from ._spec import Spec, identity, zeros

__all__ = ["Acceleration", "ContactForce", "ContactSolver", "ContactSpec", "PoseError", "Reference"]


@dataclass(eq=False, repr=False)
class Reference(Spec):
    """Where motions and forces are written: an origin and axes. See docs/frames.md."""

    origin: str = "tool"
    """"tool", "base", "world" or the name of a frame; a frame called so itself: "frame tool\""""
    axes: str = "world"
    """what the axes are fixed in, likewise"""
    rotation: ArrayLike = identity(3)
    """3 x 3, from the reference's axes to the axes that it is fixed in"""
    rotation_over_time: Signal = None
    """quaternions x, y, z, w of length 1 in place of `rotation`, of which q and -q are one rotation. For
    the knots of a problem, each of which holds the rotation of its time; None: `rotation`"""

    @classmethod
    def local(cls, rotation: ArrayLike = np.eye(3)) -> Reference:
        """The tool's own axes at the tool's origin (the paper's LOCAL), turned by `rotation`."""
        return cls("tool", "tool", np.array(rotation, dtype=float))

    @classmethod
    def centered(cls, rotation: ArrayLike = np.eye(3)) -> Reference:
        """World axes at the tool's origin (the paper's heart frame), or the columns of `rotation`."""
        return cls("tool", "world", np.array(rotation, dtype=float))

    @classmethod
    def surface(cls, rotation: ArrayLike) -> Reference:
        """Axes fixed in the base frame, at the tool's origin; the columns of `rotation` (3 x 3) are
        the axes of the surface in the base."""
        return cls("tool", "base", np.array(rotation, dtype=float))

    @classmethod
    def surface_with_normal(cls, normal: ArrayLike) -> Reference:
        """A surface with the given normal (3) as its z axis; x is the horizontal-most tangent."""
        return _core.surface_with_normal(normal)

    @classmethod
    def world(cls, rotation: ArrayLike = np.eye(3)) -> Reference:
        """The same at the world's origin."""
        return cls("world", "world", np.array(rotation, dtype=float))

    def at(self, time: float) -> Reference:
        """As it is at a time, s, with that rotation. Raises Error where it has none there, to 1e-6."""
        return _core.reference_at(self, time)

    @classmethod
    def parse(cls, name: str) -> Reference:
        """Reads "local", "centered", "surface" (with the identity) or "world"."""
        return _core.parse_reference(name)

    @property
    def name(self) -> str:
        """ "local", "centered", "surface" or "world"; of others such as "axes of torso at the tool"."""
        return _core.reference_name(self)


class Acceleration(enum.Enum):
    """Which acceleration of the tool a contact prescribes."""

    TIME_DERIVATIVE = 0
    """the true derivative of the constraint velocity"""
    SPATIAL = 1
    """the tool's local spatial acceleration carried into the axes (Proposition 3)"""
    CLASSICAL = 2
    """of the material point, written in the axes"""


class PoseError(enum.Enum):
    """Position-level error that the proportional gain acts on."""

    SPLIT = 0
    """position error, and the logarithm of the rotation error"""
    LOG6 = 1
    """the SE(3) logarithm in tool axes, carried into the contact's axes"""


@dataclass(eq=False, repr=False)
class ContactSpec(Spec):
    """A tool frame tied to a base frame along some directions: alpha + kd nu + kp e = 0, nu and
    alpha being velocity and acceleration of the tool relative to the base, in the reference."""

    name: str = ""
    """unique; the tool's name if left empty"""
    tool: str = ""
    """frame C2"""
    base: str = "world"
    """frame C1"""
    reference: Reference = field(default_factory=Reference)
    directions: str = "x,y,z,rx,ry,rz"
    """"all", "linear", "angular", "pad_x|y|z", or names separated by commas such as "z,rx,ry\""""
    acceleration: Acceleration = Acceleration.TIME_DERIVATIVE
    error: PoseError = PoseError.SPLIT
    kp: ArrayLike = zeros(6)
    """1/s^2, by direction; only entries of held directions are used"""
    kd: ArrayLike = zeros(6)
    """1/s, by direction"""
    target: ArrayLike = identity(4)
    """4 x 4, placement of C2 in C1 that the error is measured from"""

    def with_gains(self, kp_all: float, kd_all: float) -> ContactSpec:
        """A copy with the same gains in every direction: kp in 1/s^2, kd in 1/s."""
        return self.replace(kp=np.full(6, float(kp_all)), kd=np.full(6, float(kd_all)))


@dataclass(eq=False, repr=False)
class ContactSolver(Spec):
    """The KKT system of eq. (3) and its relaxation."""

    mu: float = 0.0
    """compliance, m/s^2 per unit force; 0: the exact system, which needs independent rows"""
    max_proximal_iterations: int = 0
    """refinements with mu > 0 that remove the compliance"""
    proximal_tolerance: float = 1e-9
    """m/s^2, of what is left of the contact acceleration"""


@dataclass(eq=False, repr=False)
class ContactForce(Spec):
    """The wrench that the base exerts on the tool, at one state."""

    DIRECTIONS: ClassVar[Tuple[str, ...]] = ("x", "y", "z", "rx", "ry", "rz")

    contact: str
    """name of the contact"""
    on: str
    """tool frame: the body acted on"""
    by: str
    """base frame: the body that acts, "world" for the environment"""
    reference: Reference
    """in which `value` is written"""
    value: NDArray[np.float64]
    """6: force (N), then moment about the reference's origin (Nm)"""
    tool_rotation: NDArray[np.float64]
    """3 x 3, world axes, at that state"""
    base_rotation: NDArray[np.float64]
    """3 x 3, world axes, at that state"""
    tool_position: NDArray[np.float64]
    """3, m, world"""
    base_position: NDArray[np.float64]
    """3, m, world"""
    frame_rotation: NDArray[np.float64]
    """3 x 3, world axes, of what the reference's axes are fixed in"""
    frame_position: NDArray[np.float64]
    """3, m, world, of the reference's origin"""

    def in_(self, other: Reference) -> ContactForce:
        """The same wrench written in another reference. Raises Error where that names a frame: ask
        ContactDynamics.force(contact, reference)."""
        return _core.force_in(self, other)

    def axes(self) -> NDArray[np.float64]:
        """3 x 3, rotation of the reference's axes to the world."""
        return _core.force_axes(self)

    def origin(self) -> NDArray[np.float64]:
        """3, origin of the reference in the world, m."""
        return _core.force_origin(self)

    def text(self) -> str:
        """A sentence such as "30.0 N along +z of the world, on tool, by the world, ..."."""
        return _core.force_text(self)
