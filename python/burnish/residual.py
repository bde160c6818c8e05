"""Residuals of cost terms: one dataclass per residual, which documents its rows, units and axes.

The size of a target is the size of its residual, unless documented otherwise."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, List, Optional, Protocol, Union

from numpy.typing import ArrayLike

from ._core import NodeView
from ._signal import Signal
from ._spec import Spec, items
from .contact import Reference

__all__ = ["CenterOfMass", "CenterOfPressure", "CentroidalMomentum", "ContactForce", "ContactForceRate",
           "Control", "Custom", "FrameDistance", "FrameHeight", "FrameInclination", "FramePlacement", "FramePosition",
           "FrameRotation", "FrameVelocity", "FrictionCone", "JointPosition", "JointTorque", "JointTorqueRate", "JointVelocity", "Residual",
           "State", "SupportMargin", "UserResidual", "custom"]


# scripts/describe inserts the described classes here.


@dataclass(eq=False, repr=False)
class Custom(Spec):
    """User-defined residual: functions of a NodeView, which is valid only during the call. The threads of the
    solver call these functions. Their exceptions reach the caller of solve()."""

    name: str = ""
    """Name in reports and messages"""
    rows: int = 0
    """Number of rows"""
    frames: List[str] = items()
    """Names of frames that `value` and `jacobian` use, by name or by index in this list"""
    contacts: List[str] = items()
    """Names of contacts that `value` and `jacobian` use, by name or by index in this list"""
    value: Optional[Callable[[NodeView], ArrayLike]] = None
    """Function of a NodeView; returns the residual, shape (rows,)"""
    jacobian: Optional[Callable[[NodeView], ArrayLike]] = None
    """Function of a NodeView; returns d(value)/dz, shape (rows, nz), with z = (du, dq, dv, dtau). None: central
    differences"""


class UserResidual(Protocol):
    """Interface of the argument of custom(). It may also have `name`, `frames`, `contacts` and
    jacobian(at)."""

    rows: int

    def value(self, at: NodeView) -> ArrayLike: ...


def custom(user: UserResidual) -> Custom:
    """Makes a residual from an object of your own. See examples/06_your_own_cost.py.

    Parameters
    ----------
    user : UserResidual
        Object with `rows` and `value(at)`, and optionally `name`, `frames`, `contacts` and `jacobian(at)`.

    Returns
    -------
    Custom
    """
    given: Any = user
    return Custom(
        name=getattr(given, "name", ""),
        rows=given.rows,
        frames=list(getattr(given, "frames", [])),
        contacts=list(getattr(given, "contacts", [])),
        value=given.value,
        jacobian=getattr(given, "jacobian", None),
    )


Residual = Union[
    State, Control, JointPosition, JointVelocity, JointTorque, JointTorqueRate, FramePosition,
    FrameDistance, FrameRotation, FrameInclination, FrameHeight, FramePlacement, FrameVelocity,
    ContactForce, ContactForceRate, FrictionCone, CenterOfPressure, CenterOfMass, SupportMargin, CentroidalMomentum, Custom,
]
