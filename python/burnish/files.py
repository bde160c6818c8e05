"""Problems in files."""

from __future__ import annotations

from pathlib import Path

from ._core import Robot, make_guess, read_problem_file
from .ocp import ProblemSpec
from .solver import DdpOptions

__all__ = ["ProblemFile", "TrajectoryGuess", "WarmStart", "WarmStartKind", "make_guess",
           "read_problem_file"]


# Described classes stand here (scripts/describe).
