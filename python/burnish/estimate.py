"""The state of a base on feet."""

from __future__ import annotations

from ._core import BaseEstimator

__all__ = [
    "BaseEstimator", "BaseEstimatorOptions", "EstimatorInnovation", "FootContactOptions", "FootKind", "FootSpec",
    "ImuReading",
]


# Described classes stand here (scripts/describe).
