"""Differential dynamic programming."""

from __future__ import annotations

from dataclasses import dataclass

from . import _core
from ._core import DdpSolver, Problem
from ._spec import Spec
from .base import Status

__all__ = ["ActiveLimit", "CostEntry", "CostKnot", "CostReport", "DdpOptions", "DdpProgress", "DdpSolver",
           "DdpSummary", "LimitOptions", "LimitedRow", "LineSearch", "NamedMatrix", "PhaseTimes", "Regularization",
           "RowPlace", "StartRow", "StepUpdate", "StopReason"]


# Described classes stand here (scripts/describe).


@dataclass(eq=False, repr=False)
class DdpOptions(Spec):
    def check(self) -> None:
        """Raises Error with a sentence naming the option that is out of range."""
        _core.check_ddp_options(self)


@dataclass(eq=False, repr=False)
class DdpSummary(Spec):
    _brief = True

    def text(self, problem: Problem) -> str:
        """One sentence that says why the solver stopped, with names from the problem."""
        return _core.summary_text(self, problem)


@dataclass(eq=False, repr=False)
class CostReport(Spec):
    def text(self) -> str:
        """A table for people: terms from the largest down, and the five most expensive knots, and the
        five rows that are furthest outside their limits."""
        return _core.cost_report_text(self)
