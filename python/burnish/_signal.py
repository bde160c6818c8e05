"""Targets of costs, constant or as functions of time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Union

from numpy.typing import ArrayLike


@dataclass(frozen=True)
class OverTime:
    """Function of time [s] with `size` values."""

    size: int
    function: Callable[[float], ArrayLike]


Signal = Union[None, ArrayLike, Callable[[float], ArrayLike], OverTime]
"""Number or vector: a constant. Function of time [s]: called once at time 0, to find the number of its
values, and then once for each knot. If the function is not defined at time 0, use over_time(). None: the
entry that holds the signal defines its meaning."""


def over_time(size: int, function: Callable[[float], ArrayLike]) -> OverTime:
    """Makes a signal from a function of time with a stated number of values.

    Parameters
    ----------
    size : int
        Number of values.
    function : callable
        Function of time [s]; returns an array of shape (size,).

    Returns
    -------
    OverTime
        Signal that is not called at time 0 to find its size.
    """
    return OverTime(size, function)
