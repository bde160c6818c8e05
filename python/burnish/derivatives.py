"""Contact dynamics with all derivatives, batches of states, the state of a robot alone, the checker
of derivatives and the diagnosis of contacts."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Callable, List, Optional

from . import _core
from ._core import (
    ContactDynamics,
    ContactDynamicsBatch,
    RigidBody,
    check_derivatives,
    default_check_directions,
    default_check_gains,
    default_check_references,
    default_check_surfaces,
    diagnose,
    pack_width,
)
from ._spec import Spec, items
from .contact import Acceleration, ContactSpec, PoseError, Reference, SurfaceShape

__all__ = [
    "CheckEntry", "CheckGains", "CheckOptions", "CheckReport", "CheckRow", "ContactDiagnosis",
    "ContactDynamics", "ContactDynamicsBatch", "FrameDerivatives", "PlacementDerivatives",
    "RedundantRow", "RigidBody", "WrenchDerivatives", "check_derivatives",
    "default_check_directions", "default_check_gains", "default_check_references",
    "default_check_surfaces", "diagnose", "pack_width",
]


# Described classes stand here (scripts/describe).


@dataclass(eq=False, repr=False)
class CheckOptions(Spec):
    """What check_derivatives() checks: one tool in every combination of references or surfaces,
    directions, accelerations and gains, or the contacts given."""

    tool: str = ""
    """frame; empty: the frame named "tool" if it moves, or else the last frame of the model that is
    fixed to a body without children"""
    base: str = "world"
    """frame; on a moving body, every row is a contact between two bodies"""
    references: List[Reference] = field(default_factory=lambda: default_check_references())
    surfaces: List[SurfaceShape] = field(default_factory=lambda: default_check_surfaces())
    """curved surfaces of the base, which the axes of further contacts follow: at each state one of that
    shape is within 2 cm of the tool"""
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
class CheckReport(Spec):
    def text(self) -> str:
        """A table of all rows, the worst entries of those that fail, and the verdict."""
        return _core.check_report_text(self)


@dataclass(eq=False, repr=False)
class RedundantRow(Spec):
    def text(self) -> str:
        """Such as "contact 'pad_b', direction z: already held by pad_a/z"."""
        return _core.redundant_row_text(self)


@dataclass(eq=False, repr=False)
class ContactDiagnosis(Spec):
    def text(self) -> str:
        """One line per row."""
        return _core.contact_diagnosis_text(self)
