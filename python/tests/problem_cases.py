"""Shared by tests of problems: a robot, a problem with a few costs, a trajectory near its start."""

from __future__ import annotations

import numpy as np
import pytest

import burnish as bn
from burnish import residual


@pytest.fixture(scope="module")
def robot():
    return bn.load_robot("arm7")


def at_rest(robot):
    return np.concatenate([robot.reference_configuration(), np.zeros(robot.model.nv)])


def spec_of(robot, costs, knots=6, terminal=None, **entries):
    entries.setdefault("initial_state", at_rest(robot))
    return bn.ProblemSpec(
        robot.model,
        stages=[bn.Stage("move", costs=costs)],
        horizon=[bn.HorizonSegment("move", knots)],
        terminal=terminal or [],
        **entries,
    )


def base_costs():
    return [bn.CostTerm(residual.State(), 0.1), bn.CostTerm(residual.Control(), 1e-4)]


def random_trajectory(problem, seed=3):
    rng = np.random.default_rng(seed)
    start = np.tile(problem.initial_state, (problem.knots + 1, 1))
    xs = problem.integrate(start, 0.1 * rng.standard_normal((problem.knots + 1, problem.ndx)))
    return xs, rng.standard_normal((problem.knots, problem.max_controls))


def position_targets(robot, target, start_time=0.0, knots=4):
    """Returns the target that the problem uses at each knot."""
    spec = spec_of(
        robot,
        [bn.CostTerm(residual.FramePosition("tool", target), name="reach")],
        knots=knots,
        start_time=start_time,
    )
    problem = bn.Problem(spec)
    p = bn.frame_placement(robot.model, robot.reference_configuration(), "tool")[:3, 3]
    u = np.zeros(problem.max_controls)
    return np.array([p - problem.residual(k, "reach", at_rest(robot), u) for k in range(knots)])


def one_term(robot, term):
    return bn.Problem(spec_of(robot, [bn.CostTerm(term)]))


class Tool:
    """FramePosition as a custom residual."""

    rows = 3
    frames = ["tool"]

    def __init__(self, target):
        self.target = np.asarray(target)
        self.name = "reach"

    def value(self, at):
        return at.placement(0)[:3, 3] - self.target

    def jacobian(self, at):
        J = np.zeros((3, at.layout.nz))
        J[:, at.layout.column_q : at.layout.column_v] = at.jacobian(0, "centered")[:3]
        return J
