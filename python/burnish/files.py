"""Optimal control problems in files."""

from __future__ import annotations

from pathlib import Path

from ._core import Robot, make_guess, read_problem_file
from .ocp import ProblemSpec
from .solver import DdpOptions

__all__ = ["ProblemFile", "TrajectoryGuess", "WarmStart", "WarmStartKind", "make_guess",
           "read_problem_file"]


# scripts/describe inserts the described classes here.
