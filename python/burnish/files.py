"""Problems in files."""

from __future__ import annotations

import enum
from dataclasses import dataclass, field
from pathlib import Path
from typing import Union

import numpy as np
from numpy.typing import NDArray

from ._core import Robot, make_guess, read_problem_file
from ._spec import Spec
from .ocp import ProblemSpec
from .solver import DdpOptions

__all__ = ["ProblemFile", "TrajectoryGuess", "WarmStart", "WarmStartKind", "make_guess",
           "read_problem_file"]


class WarmStartKind(enum.Enum):
    """Where the solver starts from."""

    HOLD = 0
    """the initial state at every knot, with the controls that hold it in the knot's stage"""
    STILL = 1
    """the initial state at every knot, zero controls"""
    FILE = 2
    """a trajectory.csv of an earlier solve"""


@dataclass(eq=False, repr=False)
class WarmStart(Spec):
    """Where the solver starts from."""

    kind: WarmStartKind = WarmStartKind.HOLD
    file: Union[str, Path] = Path()
    """FILE: where it is"""


@dataclass(eq=False, repr=False)
class ProblemFile(Spec):
    """What a problem file says."""

    description: str
    robot: Robot
    spec: ProblemSpec
    """compiles: it has been tried"""
    solver: DdpOptions = field(default_factory=DdpOptions)
    guess: WarmStart = field(default_factory=WarmStart)


@dataclass(eq=False, repr=False)
class TrajectoryGuess(Spec):
    """States and controls to start from."""

    xs: NDArray[np.float64]
    """(N + 1) x nx"""
    us: NDArray[np.float64]
    """N x max_controls"""
