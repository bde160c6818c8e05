"""Optimal control problems: costs, stages, horizons, checks. Residuals are in burnish.residual."""

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

__all__ = ["ActuationSpec", "Constraint", "CostTerm", "Discretization", "HorizonSegment", "InputKind", "InputSpec",
           "Integrator", "NodeView", "OverTime", "Penalty", "PenaltyKind", "Problem", "ProblemCheckOptions",
           "ProblemCheckRow", "ProblemReport", "ProblemSpec", "QuasiStatic", "Residual", "Signal", "Stage",
           "StateLayout", "StepError", "StepReport", "TorqueModel", "TrajectoryExpansion", "TrajectoryValues",
           "check_problem", "check_steps", "complaints", "over_time", "step_complaints"]


# scripts/describe inserts the described classes here.


@dataclass(eq=False, repr=False)
class Penalty(Spec):
    @classmethod
    def quadratic(cls) -> Penalty:
        """Makes a quadratic penalty."""
        return cls()

    @classmethod
    def barrier(cls, lower: ArrayLike, upper: ArrayLike) -> Penalty:
        """Makes a quadratic barrier, which is zero between its limits.

        Parameters
        ----------
        lower, upper : array_like, shape (rows,) or (1,)
            Limits of the rows, or one limit for all rows.

        Returns
        -------
        Penalty
        """
        return cls(PenaltyKind.BARRIER, lower, upper)

    @classmethod
    def at_least(cls, lower: float) -> Penalty:
        """Makes a quadratic barrier with one lower limit for all rows.

        Parameters
        ----------
        lower : float
            Limit of all rows.

        Returns
        -------
        Penalty
        """
        return cls(PenaltyKind.BARRIER, np.array([lower], dtype=float))

    @classmethod
    def smooth_absolute(cls, width: float) -> Penalty:
        """Makes a smooth absolute value.

        Parameters
        ----------
        width : float
            Width of the smooth region around 0, in the unit of the rows.

        Returns
        -------
        Penalty
        """
        return cls(PenaltyKind.SMOOTH_ABSOLUTE, width=width)

    @classmethod
    def log_barrier(cls, lower: ArrayLike, upper: ArrayLike, width: float) -> Penalty:
        """Makes a relaxed logarithmic barrier.

        Parameters
        ----------
        lower, upper : array_like, shape (rows,) or (1,)
            Limits of the rows, or one limit for all rows.
        width : float
            Distance from a limit below which the barrier is quadratic, in the unit of the rows.

        Returns
        -------
        Penalty
        """
        return cls(PenaltyKind.LOG_BARRIER, lower, upper, width)


@dataclass(eq=False, repr=False)
class StateLayout(Spec):
    @property
    def nx(self) -> int:
        """Number of entries of a state."""
        return self.nq + self.nv + self.filtered + self.force_states

    @property
    def ndx(self) -> int:
        """Number of entries of a tangent vector of the state."""
        return 2 * self.nv + self.filtered + self.force_states

    @property
    def nz(self) -> int:
        """Number of entries of z = (du, dx)."""
        return self.nu + self.ndx

    @property
    def acts_from_state(self) -> bool:
        """True if the torques that act are entries of the state."""
        return self.filtered > 0 and not self.holds_torque

    @property
    def column_q(self) -> int:
        """First column of dq in z."""
        return self.nu

    @property
    def column_v(self) -> int:
        """First column of dv in z."""
        return self.nu + self.nv

    @property
    def column_tau(self) -> int:
        """First column of dtau in z, the torques in the state."""
        return self.nu + 2 * self.nv

    @property
    def column_force(self) -> int:
        """First column of the force states in z."""
        return self.nu + 2 * self.nv + self.filtered


@dataclass(eq=False, repr=False)
class TrajectoryValues(Spec):
    """Values of all knots of a horizon at given states and controls."""

    costs: NDArray[np.float64]
    """Costs of the knots, N + 1 entries; the terminal cost is the last one"""
    next_states: NDArray[np.float64]
    """Next states according to the dynamics, N x nx"""
    statuses: List[Status]
    """Status of each knot, N + 1 entries"""
    terms: List[int]
    """Index of the first cost term that is not finite, N + 1 entries; -1: none, or the dynamics"""

    @property
    def cost(self) -> float:
        """Sum of the costs of all knots."""
        return float(np.sum(self.costs))


@dataclass(eq=False, repr=False)
class TrajectoryExpansion(TrajectoryValues):
    """Values of all knots of a horizon, and their derivatives with respect to z = (du, dx).

    du is an increment of the controls, dx a right tangent increment of the state; nz = nu + ndx. For knots
    without controls (impacts, the last knot), the columns of du are zero."""

    gradients: NDArray[np.float64]
    """(N + 1) x nz: d(cost)/dz"""
    hessians: NDArray[np.float64]
    """(N + 1) x nz x nz: Gauss-Newton, symmetric"""
    dynamics: NDArray[np.float64]
    """N x ndx x nz: d(next state)/dz, in the tangent of the next state"""


@dataclass(eq=False, repr=False)
class ProblemReport(Spec):
    def text(self) -> str:
        """Returns a table of all rows, the worst entries of failed rows, and the verdict."""
        return _core.problem_report_text(self)


@dataclass(eq=False, repr=False)
class StepReport(Spec):
    def text(self) -> str:
        """Returns a sentence with both errors."""
        return _core.step_report_text(self)

    def warning(self) -> str:
        """Returns a sentence with the place and the size of the largest error; empty if all steps are short
        enough."""
        return _core.step_report_warning(self)
