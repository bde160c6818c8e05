"""Errors, statuses, records of runs."""

from __future__ import annotations

from ._core import Error, EvaluationError, Trace, describe

__all__ = ["Error", "EvaluationError", "Status", "Trace", "describe"]


# Described classes stand here (scripts/describe).
