"""Contact dynamics with all derivatives, batches of states, kinematics and dynamics without contacts,
the check of derivatives, and the diagnosis of contacts."""

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


# scripts/describe inserts the described classes here.


@dataclass(eq=False, repr=False)
class CheckOptions(Spec):
    """Options of check_derivatives(). It checks one tool in all combinations of references or surfaces,
    directions, accelerations and gains. If `contacts` is set, it checks these contacts instead."""

    tool: str = ""
    """Tool frame. Empty: the frame "tool" if it moves, else the last frame on a body without children"""
    base: str = "world"
    """Base frame. If it is on a moving body, every row is a contact between two bodies"""
    references: List[Reference] = field(default_factory=lambda: default_check_references())
    surfaces: List[SurfaceShape] = field(default_factory=lambda: default_check_surfaces())
    """Shapes of curved surfaces of the base, whose normals the axes of further contacts follow. In each
    state, the surface is within 2 cm of the tool"""
    directions: List[str] = field(default_factory=lambda: default_check_directions())
    accelerations: List[Acceleration] = field(default_factory=lambda: [Acceleration.TIME_DERIVATIVE])
    gains: List[CheckGains] = field(default_factory=lambda: default_check_gains())
    contacts: List[ContactSpec] = items()
    """Contacts to check simultaneously, in one row; empty: the combinations above"""
    states: int = 20
    """Number of random states per row, at least 1"""
    seed: int = 1
    """Seed of the random states, which are the same on every machine"""
    tolerance: float = 1e-6
    """Largest |derivative - finite difference|, relative to the largest entry of the block"""
    progress: Optional[Callable[[int, int], None]] = None
    """Function that is called after each row, with the number of finished rows and of all rows"""


@dataclass(eq=False, repr=False)
class CheckReport(Spec):
    def text(self) -> str:
        """Returns a table of all rows, the worst entries of failed rows, and the verdict."""
        return _core.check_report_text(self)


@dataclass(eq=False, repr=False)
class RedundantRow(Spec):
    def text(self) -> str:
        """Returns a text such as "contact 'pad_b', direction z: already held by pad_a/z"."""
        return _core.redundant_row_text(self)


@dataclass(eq=False, repr=False)
class ContactDiagnosis(Spec):
    def text(self) -> str:
        """Returns a text with one line per row."""
        return _core.contact_diagnosis_text(self)
