"""Quantities that costs aim at, constant or over time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Union

from numpy.typing import ArrayLike


@dataclass(frozen=True)
class OverTime:
    """A function of time (s) that gives `size` numbers."""

    size: int
    function: Callable[[float], ArrayLike]


Signal = Union[None, ArrayLike, Callable[[float], ArrayLike], OverTime]
"""None: what that means is said where the signal is used. A number or a vector: constant. A function
of time (s): asked once at time 0 for how many numbers it gives, and later whenever a knot is given its
time; over_time() where it cannot be asked at 0."""


def over_time(size: int, function: Callable[[float], ArrayLike]) -> OverTime:
    """A signal of `size` entries that a function of time (s) gives."""
    return OverTime(size, function)
