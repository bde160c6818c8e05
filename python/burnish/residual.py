"""What a cost term measures: one dataclass per residual; rows, their units and axes are said in each.

A target may be left None where that is said; its size is the residual's unless said otherwise."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Callable, List, Optional, Protocol, Union

from numpy.typing import ArrayLike

from ._core import NodeView
from ._signal import Signal
from ._spec import Spec, items
from .contact import Reference

__all__ = ["CenterOfMass", "CenterOfPressure", "CentroidalMomentum", "ContactForce", "Control",
           "Custom", "FramePlacement", "FramePosition", "FrameRotation", "FrameVelocity",
           "FrictionCone", "JointPosition", "JointTorque", "JointVelocity", "Residual", "State",
           "UserResidual", "custom"]


@dataclass(eq=False, repr=False)
class State(Spec):
    """x (-) target, ndx rows: dq (rad, m), dv (rad/s, m/s), dtau (Nm, N)."""

    target: Signal = None
    """a state of nx entries; None: the initial state of the problem"""


@dataclass(eq=False, repr=False)
class Control(Spec):
    """u - target, nu rows, Nm (N)."""

    target: Signal = None
    """None: zero"""


@dataclass(eq=False, repr=False)
class JointPosition(Spec):
    """q_j - target for revolute and prismatic joints, one row each, rad or m."""

    joints: List[str] = items()
    """none: all of them that have a limit"""
    target: Signal = None
    """None: zero, as limits want it"""


@dataclass(eq=False, repr=False)
class JointVelocity(Spec):
    """v - target for the entries of the named joints, rad/s or m/s."""

    joints: List[str] = items()
    """none: all but the free-flying base"""
    target: Signal = None
    """None: zero"""


@dataclass(eq=False, repr=False)
class JointTorque(Spec):
    """What the actuators apply to the named joints minus the target, Nm or N: the control, or with a
    torque model the torque state."""

    joints: List[str] = items()
    """none: all actuated ones"""
    target: Signal = None
    """None: zero"""


@dataclass(eq=False, repr=False)
class FramePosition(Spec):
    """Origin of a frame minus the target, 3 rows, m, written in the axes of the reference, whose
    base is the world. Its origin must not be the frame itself."""

    frame: str = ""
    target: Signal = None
    """3, m: from the reference's origin, in the axes that its rotation is fixed in; of
    Reference.world(...) a point of the world"""
    reference: Reference = field(default_factory=Reference.world)


@dataclass(eq=False, repr=False)
class FrameRotation(Spec):
    """log(R_target^T R), 3 rows, rad, target axes."""

    frame: str = ""
    target: Signal = None
    """quaternion x, y, z, w, of unit length"""


@dataclass(eq=False, repr=False)
class FramePlacement(Spec):
    """SE(3) logarithm of the frame in the target: 3 rows m, 3 rows rad, target axes."""

    frame: str = ""
    target: Signal = None
    """7: position (m), quaternion x, y, z, w"""


@dataclass(eq=False, repr=False)
class FrameVelocity(Spec):
    """Velocity of a frame in the world minus the target, 6 rows: m/s, rad/s, written in the
    reference, whose tool is the frame and whose base is the world."""

    frame: str = ""
    reference: Reference = field(default_factory=Reference.centered)
    target: Signal = None
    """None: zero"""


@dataclass(eq=False, repr=False)
class ContactForce(Spec):
    """Force of an active contact minus the target, N and Nm: the held rows in the contact's own
    reference, or six rows in another one."""

    contact: str = ""
    reference: Optional[Reference] = None
    target: Signal = None
    """None: zero"""


@dataclass(eq=False, repr=False)
class FrictionCone(Spec):
    """Two rows, N: friction * f_n - |f_t| (smoothed over 1e-3 N) and f_n, both to be kept above a
    limit: the default penalty is a barrier at 0."""

    contact: str = ""
    friction: float = 0.5
    normal: int = 2
    """f_n is the force along this axis of the reference (0, 1, 2: x, y, z), f_t what stands at a
    right angle to it"""
    reference: Optional[Reference] = None
    """None: the contact's own"""


@dataclass(eq=False, repr=False)
class CenterOfPressure(Spec):
    """Four rows, Nm: how far the centre of pressure is inside a rectangle of the tool's axes, times the
    normal force f_z: half_x f_z -+ (-m_y), half_y f_z -+ m_x. Default penalty: a barrier at 0."""

    contact: str = ""
    half_x: float = 0.1
    """m"""
    half_y: float = 0.05
    """m"""


@dataclass(eq=False, repr=False)
class CenterOfMass(Spec):
    """Centre of mass minus the target, 3 rows, m, world."""

    target: Signal = None


@dataclass(eq=False, repr=False)
class CentroidalMomentum(Spec):
    """Momentum about the centre of mass minus the target, 6 rows: kg m/s, kg m^2/s, world axes."""

    target: Signal = None
    """None: zero"""


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
    State, Control, JointPosition, JointVelocity, JointTorque, FramePosition, FrameRotation,
    FramePlacement, FrameVelocity, ContactForce, FrictionCone, CenterOfPressure, CenterOfMass,
    CentroidalMomentum, Custom,
]
