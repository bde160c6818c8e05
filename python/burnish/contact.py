"""Contacts: what is held, in which reference, and forces that say what they are."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._core import (
    closed_configuration,
    loop_contacts,
    loop_freedom,
    loop_misses,
    project_onto_loops,
    project_velocity_onto_loops,
)
from ._signal import Signal
from ._spec import Spec, identity
from .base import Status

__all__ = ["Acceleration", "ContactForce", "ContactSolver", "ContactSpec", "LoopFreedom", "LoopGains", "LoopMetric",
           "LoopMiss", "LoopProjection", "LoopProjectionOptions", "PoseError", "Quadric", "RedundantLoop",
           "Reference", "SlidingFriction", "SurfaceKind", "SurfaceShape", "closed_configuration", "loop_contacts",
           "loop_freedom", "loop_misses", "project_onto_loops", "project_velocity_onto_loops"]


# Described classes stand here (scripts/describe).


@dataclass(eq=False, repr=False)
class Quadric(Spec):
    @classmethod
    def plane(cls, point: ArrayLike, normal: ArrayLike) -> Quadric:
        """Through a point, with a normal of any length out of the material."""
        return _core.quadric_plane(point, normal)

    @classmethod
    def sphere(cls, center: ArrayLike, radius: float, hollow: bool = False) -> Quadric:
        """Material inside, or outside of a hollow one: then the normal is towards the centre."""
        return _core.quadric_sphere(center, radius, hollow)

    @classmethod
    def cylinder(cls, point: ArrayLike, axis: ArrayLike, radius: float, hollow: bool = False) -> Quadric:
        """About the axis through a point, likewise."""
        return _core.quadric_cylinder(point, axis, radius, hollow)

    @classmethod
    def cone(cls, apex: ArrayLike, axis: ArrayLike, half_angle: float, hollow: bool = False) -> Quadric:
        """On both sides of the apex; half_angle between axis and surface, rad."""
        return _core.quadric_cone(apex, axis, half_angle, hollow)

    @classmethod
    def ellipsoid(cls, center: ArrayLike, axes: ArrayLike, semi_axes: ArrayLike, hollow: bool = False) -> Quadric:
        """semi_axes (3, m) along the columns of `axes` (3 x 3)."""
        return _core.quadric_ellipsoid(center, axes, semi_axes, hollow)

    @classmethod
    def osculating(cls, point: ArrayLike, axes: ArrayLike, k_xx: float, k_xy: float, k_yy: float) -> Quadric:
        """A surface to second order at its point: (k_xx x^2 + 2 k_xy x y + k_yy y^2) / 2 along the
        third column of `axes` (3 x 3) over the first two; 1/m, -1/R for a ball of radius R."""
        return _core.quadric_osculating(point, axes, k_xx, k_xy, k_yy)

    def value(self, x: ArrayLike) -> float:
        """phi at a point (3)."""
        return _core.quadric_value(self, x)

    def normal(self, x: ArrayLike) -> NDArray[np.float64]:
        """Of unit length (3). Raises Error where the surface has none, as on the axis of a cylinder."""
        return _core.quadric_normal(self, x)


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
    quadric: Optional[Quadric] = None
    """a surface in the frame that the axes are fixed in, which they follow as the tool moves over it: at a
    normal n they are `rotation` turned by the least rotation that takes its third column to n. Those of
    contacts are at the tool, with axes fixed in the base; others may have any origin, and axes fixed in
    all but the tool"""

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
    def on(cls, surface: Quadric, near: ArrayLike, along: Optional[ArrayLike] = None) -> Reference:
        """Axes that follow a curved surface of the base: those of surface_with_normal() at `near` (3), a
        point in the axes of the base where the tool is to be, and turned with the normal elsewhere.
        `along` (3): the tangent that leads along it, as the first axis at `near`."""
        return _core.reference_on(surface, near, along)

    @classmethod
    def world(cls, rotation: ArrayLike = np.eye(3)) -> Reference:
        """The same at the world's origin."""
        return cls("world", "world", np.array(rotation, dtype=float))

    def at(self, time: float) -> Reference:
        """As it is at a time, s, with that rotation. Raises Error where it has none there, to 1e-6."""
        return _core.reference_at(self, time)

    def at_point(self, point: ArrayLike) -> Reference:
        """As it is with the tool at a point (3) of the frame that the axes are fixed in, m: axes that
        follow no surface. Raises Error where that has no normal, or one half a turn away."""
        return _core.reference_at_point(self, point)

    @classmethod
    def parse(cls, name: str) -> Reference:
        """Reads "local", "centered", "surface" (with the identity) or "world"."""
        return _core.parse_reference(name)

    @property
    def name(self) -> str:
        """ "local", "centered", "surface" or "world"; of others such as "axes of torso at the tool"."""
        return _core.reference_name(self)


@dataclass(eq=False, repr=False)
class ContactSpec(Spec):
    def with_gains(self, kp_all: float, kd_all: float) -> ContactSpec:
        """A copy with the same gains in every direction: kp in 1/s^2, kd in 1/s."""
        return self.replace(kp=np.full(6, float(kp_all)), kd=np.full(6, float(kd_all)))


@dataclass(eq=False, repr=False)
class LoopGains(Spec):
    @classmethod
    def for_step(cls, step: float) -> LoopGains:
        """For semi-implicit Euler steps of that length, s: a step takes away what the loop misses at its start."""
        return _core.loop_gains_for_step(step)


@dataclass(eq=False, repr=False)
class LoopProjection(Spec):
    def explanation(self) -> str:
        """Which loop is not closed, and what is left of it; empty where all are."""
        return _core.loop_projection_explanation(self)


@dataclass(eq=False, repr=False)
class ContactForce(Spec):
    DIRECTIONS: ClassVar[Tuple[str, ...]] = ("x", "y", "z", "rx", "ry", "rz")

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
