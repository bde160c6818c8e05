"""Contact dynamics with all derivatives, batches of states, the state of a robot alone, the checker
of derivatives and the diagnosis of contacts."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Callable, List, Optional

from numpy.typing import ArrayLike, NDArray
import numpy as np

from . import _core
from ._core import (
    ContactDynamics,
    ContactDynamicsBatch,
    RigidBody,
    check_derivatives,
    default_check_directions,
    default_check_gains,
    default_check_references,
    diagnose,
    pack_width,
)
from ._spec import Spec, items, zeros
from .contact import Acceleration, ContactSpec, PoseError, Reference

__all__ = [
    "CheckEntry", "CheckGains", "CheckOptions", "CheckReport", "CheckRow", "ContactDiagnosis",
    "ContactDynamics", "ContactDynamicsBatch", "FrameDerivatives", "PlacementDerivatives",
    "RedundantRow", "RigidBody", "WrenchDerivatives", "check_derivatives",
    "default_check_directions", "default_check_gains", "default_check_references", "diagnose",
    "pack_width",
]


@dataclass(eq=False, repr=False)
class WrenchDerivatives(Spec):
    """Derivatives of a wrench in a reference: (6, nv) each, force rows first."""

    dq: NDArray[np.float64]
    """N/rad (N/m), Nm/rad (Nm/m), by the right tangent increment of q"""
    dv: NDArray[np.float64]
    dtau: NDArray[np.float64]
    """1/m (force per torque), dimensionless (moment per torque)"""


@dataclass(eq=False, repr=False)
class FrameDerivatives(Spec):
    """Derivatives of a frame's motion, (6, nv) each, linear rows first, in the axes that were asked
    for."""

    jacobian: NDArray[np.float64]
    """d(velocity)/dv, and d(acceleration)/da"""
    velocity_dq: NDArray[np.float64]
    acceleration_dq: NDArray[np.float64]
    """v and a held"""
    acceleration_dv: NDArray[np.float64]
    """q and a held"""


@dataclass(eq=False, repr=False)
class PlacementDerivatives(Spec):
    """Derivatives of a frame's placement, nv columns each."""

    position: NDArray[np.float64]
    """(3, nv), world axes, m/rad (m/m)"""
    rotation: NDArray[np.float64]
    """(3, nv), R^T dR/dq_k = [column k x], the frame's own axes"""
    rotation_error: NDArray[np.float64]
    """(3, nv), of log(R_target^T R)"""
    placement_error: NDArray[np.float64]
    """(6, nv), of the SE(3) logarithm of the frame in the target"""


@dataclass(eq=False, repr=False)
class CheckGains(Spec):
    """Gains that a check tries, and the error that they act on."""

    kp: ArrayLike = zeros(6)
    """1/s^2, by direction"""
    kd: ArrayLike = zeros(6)
    """1/s, by direction"""
    error: PoseError = PoseError.SPLIT


@dataclass(eq=False, repr=False)
class CheckOptions(Spec):
    """What check_derivatives() checks: one tool in every combination of references, directions,
    accelerations and gains, or the contacts given."""

    tool: str = ""
    """frame; empty: the frame named "tool" if it moves, or else the last frame of the model that is
    fixed to a body without children"""
    base: str = "world"
    """frame; on a moving body, every row is a contact between two bodies"""
    references: List[Reference] = field(default_factory=lambda: default_check_references())
    directions: List[str] = field(default_factory=lambda: default_check_directions())
    accelerations: List[Acceleration] = field(default_factory=lambda: [Acceleration.TIME_DERIVATIVE])
    gains: List[CheckGains] = field(default_factory=lambda: default_check_gains())
    contacts: List[ContactSpec] = items()
    """when not empty: these, all at once, in one row instead of the sweep"""
    states: int = 20
    """random states per row, at least 1"""
    seed: int = 1
    """the same seed gives the same states on every machine"""
    tolerance: float = 1e-6
    """on |derivative - difference| over the block's largest entry"""
    progress: Optional[Callable[[int, int], None]] = None
    """called after each row with the number of rows done and the number of all rows"""


@dataclass(eq=False, repr=False)
class CheckEntry(Spec):
    """One entry of one block: a derivative, and what differences say."""

    block: str = ""
    """such as "da_dq\""""
    row: str = ""
    """entry of v, or contact and direction such as "tool/z\""""
    column: str = ""
    """what it is differentiated by: an entry of v, or of lambda"""
    value: float = 0.0
    """computed analytically"""
    expected: float = 0.0
    """from differences"""
    state: int = -1
    """which of the random states, from 0"""


@dataclass(eq=False, repr=False)
class CheckRow(Spec):
    """One set of contacts at all states. Words that differ between contacts are joined by " + "."""

    reference: str = ""
    directions: str = ""
    bodies: str = ""
    """ "tool on base" """
    acceleration: str = ""
    error: str = ""
    """ "split" or "log6"; "-" without a proportional gain"""
    gains: str = ""
    """ "none", or such as "kp 7..12, kd 2..7" """
    states: int = 0
    mu: float = 0.0
    """m/s^2 per N: compliance that the row was checked with, positive where the joints cannot hold
    the contact rigidly at most postures"""
    worst_error: float = 0.0
    """relative to the block's largest entry; infinite after a NaN"""
    worst: CheckEntry = field(default_factory=CheckEntry)
    pass_: bool = False
    """worst_error <= tolerance"""


@dataclass(eq=False, repr=False)
class CheckReport(Spec):
    """What check_derivatives() found."""

    robot: str = ""
    rows: List[CheckRow] = items()
    tolerance: float = 0.0
    singular_mass: str = ""
    """why there is no forward dynamics to check, naming the joints that move no mass; empty: there
    is"""
    pass_: bool = False
    """there are rows, all of them pass, and the mass matrix is not singular"""

    def text(self) -> str:
        """A table of all rows, the worst entries of those that fail, and the verdict."""
        return _core.check_report_text(self)


@dataclass(eq=False, repr=False)
class RedundantRow(Spec):
    """A row of the contact Jacobian that depends on rows before it."""

    contact: str
    """name of the contact"""
    direction: str
    """ "x" ... "rz" in its reference"""
    row: int
    """index among all rows of the set"""
    immovable: bool
    """no joint moves it at this posture: its Jacobian row is zero"""
    implied_by: List[str]
    """ "contact/direction" of the rows that already hold it"""

    def text(self) -> str:
        """Such as "contact 'pad_b', direction z: already held by pad_a/z"."""
        return _core.redundant_row_text(self)


@dataclass(eq=False, repr=False)
class ContactDiagnosis(Spec):
    """What diagnose() found: no redundant rows means that the contacts are independent."""

    redundant: List[RedundantRow]
    condition: float
    """of J M^-1 J^T scaled to a unit diagonal; infinite when redundant"""

    def text(self) -> str:
        """One line per row."""
        return _core.contact_diagnosis_text(self)
