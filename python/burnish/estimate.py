"""Estimators of the base state, contacts and forces of robots with feet."""

from __future__ import annotations

from ._core import BaseEstimator, FootContacts, FootForces

__all__ = [
    "BaseEstimator", "BaseEstimatorOptions", "EstimatorInnovation", "FootContactOptions", "FootContacts", "FootForces",
    "FootKind", "FootSpec", "ImuReading", "UnitWatchOptions",
]


# scripts/describe inserts the described classes here.
