"""Errors, statuses, records of runs."""

from __future__ import annotations

import enum

from ._core import Error, EvaluationError, Trace, describe

__all__ = ["Error", "EvaluationError", "Status", "Trace", "describe"]


class Status(enum.Enum):
    """Outcome of an evaluation, ordered by severity."""

    OK = 0
    NOT_CONVERGED = 1
    """proximal iterations stopped at their limit above the tolerance"""
    SINGULAR_CONTACTS = 2
    """contact rows are redundant or not controllable, and mu = 0"""
    SINGULAR_MASS = 3
    """the mass matrix is not positive definite at this posture"""
    NOT_NORMALIZED = 4
    """a quaternion or a (cos, sin) pair is not of unit length to 1e-6"""
    NOT_FINITE = 5
    """an input holds a NaN or an infinity, or is so large that the result does"""
    WRONG_SIZE = 6
    """an argument has the wrong number of entries"""
    NOT_EVALUATED = 7
    """derivatives of an evaluation that was not the last one made"""
