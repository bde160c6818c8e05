"""What a cost term measures: one dataclass per residual; rows, their units and axes are said in each.

A target may be left None where that is said; its size is the residual's unless said otherwise."""

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


# Described classes stand here (scripts/describe).


@dataclass(eq=False, repr=False)
class Custom(Spec):
    """A residual of one's own: functions of a NodeView, which is valid inside the call only. They are
    called by the threads that solve, and what they raise reaches the caller of solve()."""

    name: str = ""
    rows: int = 0
    frames: List[str] = items()
    """that value and jacobian ask for, by name or by place in this list"""
    contacts: List[str] = items()
    """likewise"""
    value: Optional[Callable[[NodeView], ArrayLike]] = None
    """at -> `rows` numbers"""
    jacobian: Optional[Callable[[NodeView], ArrayLike]] = None
    """at -> d(value)/dz, rows x nz, z = (du, dq, dv, dtau); None: central differences"""


class UserResidual(Protocol):
    """What custom() takes. It may also have `name`, `frames`, `contacts` and jacobian(at)."""

    rows: int

    def value(self, at: NodeView) -> ArrayLike: ...


def custom(user: UserResidual) -> Custom:
    """A residual from any object with `rows` and `value(at)`, and if wanted `name`, `frames`,
    `contacts` and `jacobian(at)`; see Custom and examples/06_your_own_cost.py."""
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
