"""Optimal control problems: costs, stages, horizons, the checker. Residuals are in burnish.residual."""

from __future__ import annotations

from dataclasses import dataclass
from typing import List

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._core import Model, NodeView, Problem, check_problem, check_steps, complaints, step_complaints
from ._signal import OverTime, Signal, over_time
from ._spec import Spec
from .base import Status
from .contact import ContactSolver, ContactSpec
from .derivatives import CheckEntry
from .residual import Residual

__all__ = ["ActuationSpec", "Constraint", "CostTerm", "Discretization", "HorizonSegment", "Integrator", "NodeView",
           "OverTime", "Penalty", "PenaltyKind", "Problem", "ProblemCheckOptions", "ProblemCheckRow",
           "ProblemReport", "ProblemSpec", "QuasiStatic", "Residual", "Signal", "Stage",
           "StateLayout", "StepError", "StepReport", "TorqueModel", "TrajectoryExpansion", "TrajectoryValues",
           "check_problem", "check_steps", "complaints", "over_time", "step_complaints"]


# Described classes stand here (scripts/describe).


@dataclass(eq=False, repr=False)
class Penalty(Spec):
    @classmethod
    def square(cls) -> Penalty:
        return cls()

    @classmethod
    def barrier(cls, lower: ArrayLike, upper: ArrayLike) -> Penalty:
        return cls(PenaltyKind.BARRIER, lower, upper)

    @classmethod
    def at_least(cls, lower: float) -> Penalty:
        """A barrier with a lower limit for all rows."""
        return cls(PenaltyKind.BARRIER, np.array([lower], dtype=float))

    @classmethod
    def smooth_absolute(cls, width: float) -> Penalty:
        return cls(PenaltyKind.SMOOTH_ABSOLUTE, width=width)

    @classmethod
    def log_barrier(cls, lower: ArrayLike, upper: ArrayLike, width: float) -> Penalty:
        return cls(PenaltyKind.LOG_BARRIER, lower, upper, width)


@dataclass(eq=False, repr=False)
class StateLayout(Spec):
    @property
    def nx(self) -> int:
        """Entries of a state."""
        return self.nq + self.nv + self.filtered + self.remembered

    @property
    def ndx(self) -> int:
        """Entries of a tangent of a state."""
        return 2 * self.nv + self.filtered + self.remembered

    @property
    def nz(self) -> int:
        return self.nu + self.ndx

    @property
    def acts_from_state(self) -> bool:
        """What acts is the torque in the state."""
        return self.filtered > 0 and not self.holds_torque

    @property
    def column_q(self) -> int:
        """First column of dq in z; column_v, column_tau and column_force likewise."""
        return self.nu

    @property
    def column_v(self) -> int:
        return self.nu + self.nv

    @property
    def column_tau(self) -> int:
        return self.nu + 2 * self.nv

    @property
    def column_force(self) -> int:
        return self.nu + 2 * self.nv + self.filtered


@dataclass(eq=False, repr=False)
class TrajectoryValues(Spec):
    """All knots of a horizon, evaluated at given states and controls."""

    costs: NDArray[np.float64]
    """N + 1, of each knot, the terminal one last"""
    next_states: NDArray[np.float64]
    """N x nx, where the dynamics lead from each knot"""
    statuses: List[Status]
    """N + 1"""
    terms: List[int]
    """N + 1, first cost term that is not finite, -1: none, or the dynamics"""

    @property
    def cost(self) -> float:
        """Of all knots."""
        return float(np.sum(self.costs))


@dataclass(eq=False, repr=False)
class TrajectoryExpansion(TrajectoryValues):
    """Values and derivatives of all knots by z = (du, dx), controls first, dx the right tangent
    increment; nz = nu + ndx. Where a knot has no controls (impacts, the end) their columns are zero."""

    gradients: NDArray[np.float64]
    """(N + 1) x nz: d(cost)/dz"""
    hessians: NDArray[np.float64]
    """(N + 1) x nz x nz: Gauss-Newton, symmetric"""
    dynamics: NDArray[np.float64]
    """N x ndx x nz: d(next state)/dz, in the tangent of the next state"""


@dataclass(eq=False, repr=False)
class ProblemReport(Spec):
    def text(self) -> str:
        """A table of all rows, the worst entries of those that fail, and the verdict."""
        return _core.problem_report_text(self)


@dataclass(eq=False, repr=False)
class StepReport(Spec):
    def text(self) -> str:
        """One sentence with both errors."""
        return _core.step_report_text(self)

    def warning(self) -> str:
        """One sentence that says where and by how much the steps are too coarse; empty: they are not."""
        return _core.step_report_warning(self)
