"""Differential dynamic programming (DDP) for optimal control problems."""

from __future__ import annotations

from dataclasses import dataclass

from . import _core
from ._core import DdpSolver, Problem
from ._spec import Spec
from .base import Status

__all__ = ["ActiveLimit", "CostEntry", "CostKnot", "CostReport", "DdpOptions", "DdpProgress", "DdpSolver",
           "DdpSummary", "LimitOptions", "LimitedRow", "LineSearch", "NamedMatrix", "PhaseTimes", "Regularization",
           "RowPlace", "StartRow", "StepUpdate", "StopReason"]


# scripts/describe inserts the described classes here.


@dataclass(eq=False, repr=False)
class DdpOptions(Spec):
    def check(self) -> None:
        """Checks the options.

        Raises
        ------
        Error
            If an option is out of range; the message names the option.
        """
        _core.check_ddp_options(self)


@dataclass(eq=False, repr=False)
class DdpSummary(Spec):
    _brief = True

    def text(self, problem: Problem) -> str:
        """Returns a sentence with the reason why the solver stopped.

        Parameters
        ----------
        problem : Problem
            Problem that was solved; the sentence uses its names.

        Returns
        -------
        str
        """
        return _core.summary_text(self, problem)


@dataclass(eq=False, repr=False)
class CostReport(Spec):
    def text(self) -> str:
        """Returns a text: the cost terms in descending order, the five knots with the largest costs, and the five
        constraint rows with the largest violations."""
        return _core.cost_report_text(self)
