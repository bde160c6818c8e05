"""Inertial parameters, and their identification from recorded motions."""

from ._core import (
    EstimatedInertia,
    Identification,
    excitation,
    identify,
    inertia_of,
    inertia_of_body,
    inertia_parameters,
    inertia_problem,
    with_payload,
)

__all__ = [
    "EstimatedInertia", "Identification", "excitation", "identify", "inertia_of", "inertia_of_body",
    "inertia_parameters", "inertia_problem", "with_payload",
]
