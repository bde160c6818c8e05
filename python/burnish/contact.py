"""Contacts, references, curved surfaces, kinematic loops, and contact forces."""

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


# scripts/describe inserts the described classes here.


@dataclass(eq=False, repr=False)
class Quadric(Spec):
    @classmethod
    def plane(cls, point: ArrayLike, normal: ArrayLike) -> Quadric:
        """Makes a plane.

        Parameters
        ----------
        point : array_like, shape (3,)
            Point of the plane [m].
        normal : array_like, shape (3,)
            Normal out of the material, of any length.

        Returns
        -------
        Quadric

        Raises
        ------
        Error
            If an argument is not finite, or the normal has length 0.
        """
        return _core.quadric_plane(point, normal)

    @classmethod
    def sphere(cls, center: ArrayLike, radius: float, hollow: bool = False) -> Quadric:
        """Makes a sphere.

        Parameters
        ----------
        center : array_like, shape (3,)
            Centre [m].
        radius : float
            Radius [m], above 0.
        hollow : bool
            If True, the material is outside, and the normal points to the centre.

        Returns
        -------
        Quadric

        Raises
        ------
        Error
            If an argument is not finite, or the radius is not positive.
        """
        return _core.quadric_sphere(center, radius, hollow)

    @classmethod
    def cylinder(cls, point: ArrayLike, axis: ArrayLike, radius: float, hollow: bool = False) -> Quadric:
        """Makes a cylinder.

        Parameters
        ----------
        point : array_like, shape (3,)
            Point of the axis [m].
        axis : array_like, shape (3,)
            Direction of the axis, of any length.
        radius : float
            Radius [m], above 0.
        hollow : bool
            If True, the material is outside.

        Returns
        -------
        Quadric

        Raises
        ------
        Error
            If an argument is not finite, the axis has length 0, or the radius is not positive.
        """
        return _core.quadric_cylinder(point, axis, radius, hollow)

    @classmethod
    def cone(cls, apex: ArrayLike, axis: ArrayLike, half_angle: float, hollow: bool = False) -> Quadric:
        """Makes a double cone, with material on both sides of the apex.

        Parameters
        ----------
        apex : array_like, shape (3,)
            Apex [m].
        axis : array_like, shape (3,)
            Direction of the axis, of any length.
        half_angle : float
            Angle between axis and surface [rad], above 0 and below 1.57.
        hollow : bool
            If True, the material is outside.

        Returns
        -------
        Quadric

        Raises
        ------
        Error
            If an argument is not finite, the axis has length 0, or the angle is out of range.
        """
        return _core.quadric_cone(apex, axis, half_angle, hollow)

    @classmethod
    def ellipsoid(cls, center: ArrayLike, axes: ArrayLike, semi_axes: ArrayLike, hollow: bool = False) -> Quadric:
        """Makes an ellipsoid.

        Parameters
        ----------
        center : array_like, shape (3,)
            Centre [m].
        axes : array_like, shape (3, 3)
            Rotation matrix; its columns are the directions of the semi-axes.
        semi_axes : array_like, shape (3,)
            Lengths of the semi-axes [m], above 0.
        hollow : bool
            If True, the material is outside.

        Returns
        -------
        Quadric

        Raises
        ------
        Error
            If `axes` is not a rotation matrix, or a length is not positive.
        """
        return _core.quadric_ellipsoid(center, axes, semi_axes, hollow)

    @classmethod
    def osculating(cls, point: ArrayLike, axes: ArrayLike, k_xx: float, k_xy: float, k_yy: float) -> Quadric:
        """Makes the second-order approximation of a surface at a point.

        The height along the normal is (k_xx x^2 + 2 k_xy x y + k_yy y^2) / 2.

        Parameters
        ----------
        point : array_like, shape (3,)
            Point of the surface [m].
        axes : array_like, shape (3, 3)
            Rotation matrix. x and y are coordinates along its first two columns; the third column is the
            normal.
        k_xx, k_xy, k_yy : float
            Curvatures [1/m]: k_xx = k_yy = -1/R for a ball of radius R, positive for a bowl.

        Returns
        -------
        Quadric

        Raises
        ------
        Error
            If `axes` is not a rotation matrix, or an argument is not finite.
        """
        return _core.quadric_osculating(point, axes, k_xx, k_xy, k_yy)

    def value(self, x: ArrayLike) -> float:
        """Evaluates phi at a point.

        Parameters
        ----------
        x : array_like, shape (3,)
            Point [m].

        Returns
        -------
        float
            phi(x); 0 on the surface, positive outside the material.
        """
        return _core.quadric_value(self, x)

    def normal(self, x: ArrayLike) -> NDArray[np.float64]:
        """Returns the unit normal at a point.

        Parameters
        ----------
        x : array_like, shape (3,)
            Point [m].

        Returns
        -------
        ndarray, shape (3,)

        Raises
        ------
        Error
            If the gradient of phi is zero, for example on the axis of a cylinder.
        """
        return _core.quadric_normal(self, x)


@dataclass(eq=False, repr=False)
class Reference(Spec):
    """Origin and axes in which motions and forces are written. See docs/frames.md."""

    origin: str = "tool"
    """"tool", "base", "world", or the name of a frame; "frame tool" for a frame named "tool\""""
    axes: str = "world"
    """Frame in which the axes are fixed: "tool", "base", "world", or the name of a frame"""
    rotation: ArrayLike = identity(3)
    """Rotation matrix (3 x 3) from the axes of the reference to those of the frame `axes`"""
    rotation_over_time: Signal = None
    """Rotation as a function of time, in place of `rotation`, for the knots of a problem. Values: unit
    quaternions x, y, z, w; q and -q are the same rotation. None: `rotation`"""
    quadric: Optional[Quadric] = None
    """Curved surface, in the frame `axes`, whose normal n the axes follow as the tool moves. At each point,
    the axes are `rotation`, turned by the smallest rotation that maps its third column to n. In contacts,
    `origin` must be "tool" and `axes` must be "base". In other uses, `axes` must not be "tool\""""

    @classmethod
    def local(cls, rotation: ArrayLike = np.eye(3)) -> Reference:
        """Makes a reference at the origin of the tool, with the axes of the tool (LOCAL in the paper).

        Parameters
        ----------
        rotation : array_like, shape (3, 3)
            Rotation of the axes relative to the tool.

        Returns
        -------
        Reference
        """
        return cls("tool", "tool", np.array(rotation, dtype=float))

    @classmethod
    def centered(cls, rotation: ArrayLike = np.eye(3)) -> Reference:
        """Makes a reference at the origin of the tool, with world axes (the heart frame of the paper).

        Parameters
        ----------
        rotation : array_like, shape (3, 3)
            Rotation matrix; its columns are the axes, in the world.

        Returns
        -------
        Reference
        """
        return cls("tool", "world", np.array(rotation, dtype=float))

    @classmethod
    def surface(cls, rotation: ArrayLike) -> Reference:
        """Makes a reference at the origin of the tool, with axes fixed in the base frame.

        Parameters
        ----------
        rotation : array_like, shape (3, 3)
            Rotation matrix; its columns are the axes of the surface, in the base.

        Returns
        -------
        Reference
        """
        return cls("tool", "base", np.array(rotation, dtype=float))

    @classmethod
    def surface_with_normal(cls, normal: ArrayLike) -> Reference:
        """Makes a reference at the origin of the tool, with the z axis along a normal of the base.

        Parameters
        ----------
        normal : array_like, shape (3,)
            Normal in the axes of the base, of any length. The x axis is perpendicular to it and to the z
            axis of the base.

        Returns
        -------
        Reference

        Raises
        ------
        Error
            If the normal has length 0.
        """
        return _core.surface_with_normal(normal)

    @classmethod
    def on(cls, surface: Quadric, near: ArrayLike, along: Optional[ArrayLike] = None) -> Reference:
        """Makes a reference whose axes follow a curved surface of the base.

        Parameters
        ----------
        surface : Quadric
            Surface, in the axes of the base.
        near : array_like, shape (3,)
            Point where the tool will touch [m], in the axes of the base. There, the axes are those of
            surface_with_normal(). At other points, they turn with the normal.
        along : array_like, shape (3,), optional
            Direction of the x axis at `near`, such as the direction of travel.

        Returns
        -------
        Reference

        Raises
        ------
        Error
            If `along` is parallel to the normal.
        """
        return _core.reference_on(surface, near, along)

    @classmethod
    def world(cls, rotation: ArrayLike = np.eye(3)) -> Reference:
        """Makes a reference at the origin of the world, with world axes.

        Parameters
        ----------
        rotation : array_like, shape (3, 3)
            Rotation matrix; its columns are the axes, in the world.

        Returns
        -------
        Reference
        """
        return cls("world", "world", np.array(rotation, dtype=float))

    def at(self, time: float) -> Reference:
        """Returns a copy with the constant rotation of one time.

        Parameters
        ----------
        time : float
            Time [s] at which `rotation_over_time` is evaluated.

        Returns
        -------
        Reference

        Raises
        ------
        Error
            If the value is not a quaternion of unit length, to 1e-6.
        """
        return _core.reference_at(self, time)

    def at_point(self, point: ArrayLike) -> Reference:
        """Returns a copy with the constant axes of one point; they no longer follow the surface.

        Parameters
        ----------
        point : array_like, shape (3,)
            Point [m], in the frame `axes`.

        Returns
        -------
        Reference

        Raises
        ------
        Error
            If the surface has no normal at the point, or a normal opposite to the third column of
            `rotation`.
        """
        return _core.reference_at_point(self, point)

    @classmethod
    def parse(cls, name: str) -> Reference:
        """Makes a reference from its name.

        Parameters
        ----------
        name : str
            "local", "centered", "surface" (with the identity as rotation), or "world".

        Returns
        -------
        Reference

        Raises
        ------
        Error
            If the name is unknown; the message has the nearest name.
        """
        return _core.parse_reference(name)

    @property
    def name(self) -> str:
        """Name: "local", "centered", "surface" or "world", or a text such as "axes of torso at the tool"."""
        return _core.reference_name(self)


@dataclass(eq=False, repr=False)
class ContactSpec(Spec):
    def with_gains(self, kp_all: float, kd_all: float) -> ContactSpec:
        """Returns a copy with equal gains in all six directions.

        Parameters
        ----------
        kp_all : float
            Position gain [1/s^2].
        kd_all : float
            Velocity gain [1/s].

        Returns
        -------
        ContactSpec
        """
        return self.replace(kp=np.full(6, float(kp_all)), kd=np.full(6, float(kd_all)))


@dataclass(eq=False, repr=False)
class LoopGains(Spec):
    @classmethod
    def for_step(cls, step: float) -> LoopGains:
        """Makes gains that remove the error of a loop in one semi-implicit Euler step.

        Parameters
        ----------
        step : float
            Length of the step [s].

        Returns
        -------
        LoopGains
        """
        return _core.loop_gains_for_step(step)


@dataclass(eq=False, repr=False)
class LoopProjection(Spec):
    def explanation(self) -> str:
        """Returns a sentence with the open loops and their errors; empty if all loops are closed."""
        return _core.loop_projection_explanation(self)


@dataclass(eq=False, repr=False)
class ContactForce(Spec):
    DIRECTIONS: ClassVar[Tuple[str, ...]] = ("x", "y", "z", "rx", "ry", "rz")

    def in_(self, other: Reference) -> ContactForce:
        """Returns the same wrench in another reference.

        Parameters
        ----------
        other : Reference
            Reference without the name of a frame.

        Returns
        -------
        ContactForce

        Raises
        ------
        Error
            If the reference names a frame; use ContactDynamics.force(contact, reference) instead.
        """
        return _core.force_in(self, other)

    def axes(self) -> NDArray[np.float64]:
        """Returns the rotation matrix (3 x 3) from the axes of the reference to the world."""
        return _core.force_axes(self)

    def origin(self) -> NDArray[np.float64]:
        """Returns the origin of the reference in the world, shape (3,) [m]."""
        return _core.force_origin(self)

    def text(self) -> str:
        """Returns a sentence such as "30.0 N along +z of the world, on tool, by the world, ..."."""
        return _core.force_text(self)
