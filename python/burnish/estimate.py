"""The state of a base on feet."""

from __future__ import annotations

from ._core import BaseEstimator, FootContacts, FootForces

__all__ = [
    "BaseEstimator", "BaseEstimatorOptions", "EstimatorInnovation", "FootContactOptions", "FootContacts", "FootForces",
    "FootKind", "FootSpec", "ImuReading", "UnitWatchOptions",
]


# Described classes stand here (scripts/describe).
