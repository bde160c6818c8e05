"""Signals: targets that are constant or depend on time."""

from __future__ import annotations

import numpy as np
import pytest
from problem_cases import at_rest, position_targets, robot, spec_of

import burnish as bn
from burnish import residual


def test_target_may_be_numbers_or_a_function_of_time(robot):
    times = 0.01 * np.arange(4)
    still = np.tile([0.4, 0.1, 0.3], (4, 1))
    np.testing.assert_allclose(position_targets(robot, [0.4, 0.1, 0.3]), still, atol=1e-12)
    np.testing.assert_allclose(position_targets(robot, np.array([0.4, 0.1, 0.3])), still, atol=1e-12)
    moving = np.stack([0.4 + times, 0.1 + 0 * times, 0.3 - 2 * times], axis=1)

    def path(t):
        return [0.4 + t, 0.1, 0.3 - 2 * t]

    np.testing.assert_allclose(position_targets(robot, path), moving, atol=1e-12)
    np.testing.assert_allclose(position_targets(robot, bn.over_time(3, path)), moving, atol=1e-12)


def test_over_time_accepts_functions_undefined_at_zero(robot):
    def late(t):
        if t < 1.0:
            raise ValueError("not yet")
        return np.array([t, 0.0, 0.0])

    with pytest.raises(ValueError, match="not yet"):
        position_targets(robot, late, start_time=1.0)
    targets = position_targets(robot, bn.over_time(3, late), start_time=1.0)
    np.testing.assert_allclose(targets[:, 0], 1.0 + 0.01 * np.arange(4), atol=1e-12)


def test_number_is_a_signal_of_one_entry(robot):
    joint = robot.model.v_names[1]
    q = robot.reference_configuration()
    for target in (0.25, lambda t: 0.25, np.float64(0.25)):
        problem = bn.Problem(
            spec_of(robot, [bn.CostTerm(residual.JointPosition([joint], target), name="angle")])
        )
        r = problem.residual(0, "angle", at_rest(robot), np.zeros(7))
        np.testing.assert_allclose(r, [q[1] - 0.25], atol=1e-14)


def test_signals_of_a_problem_read_back_unchanged(robot):
    def path(t):
        return np.array([t, 0.0, 0.5])

    costs = [
        bn.CostTerm(residual.State(), name="a"),
        bn.CostTerm(residual.FramePosition("tool", [1.0, 2.0, 3.0]), name="b"),
        bn.CostTerm(residual.FramePosition("tool", path), name="c"),
    ]
    spec = bn.Problem(spec_of(robot, costs)).spec
    back = [term.residual.target for term in spec.stages[0].costs]
    assert back[0] is None
    np.testing.assert_array_equal(back[1], [1.0, 2.0, 3.0])
    assert back[2] == bn.OverTime(3, path)
    assert bn.Problem(spec).spec.stages == spec.stages


def test_invalid_signal_raises_with_the_reason(robot):
    with pytest.raises(bn.Error, match=r"FramePosition.target: got 'here'; wanted a number, a vector"):
        position_targets(robot, "here")
    with pytest.raises(bn.Error, match=r"shape \(2, 2\) at 0 s; wanted numbers"):
        position_targets(robot, lambda t: np.zeros((2, 2)))
    with pytest.raises(bn.Error, match=r"gave an array of shape \(2,\) at 0.02 s; wanted 3 numbers"):
        position_targets(robot, lambda t: np.zeros(3 if t < 0.015 else 2))


def turn(t):
    """Returns a quaternion of a rotation about z; its sign changes at 1 s."""
    return (1 if t < 1.0 else -1) * np.array([0.0, 0.0, np.sin(0.5 * t), np.cos(0.5 * t)])


def test_rotating_reference_follows_the_time_of_the_knot(robot):
    turning = bn.Reference(rotation_over_time=turn)
    spec = spec_of(robot, [bn.CostTerm(residual.FrameVelocity("tool", turning))], knots=3)
    problem = bn.Problem(spec)
    back = problem.spec.stages[0].costs[0].residual.reference
    assert back == bn.Reference(rotation_over_time=bn.OverTime(4, turn))
    problem.set_knot(2, "move", 1.5)
    x, u = at_rest(robot), np.zeros(7)
    x[7:] = 0.1
    still = turning.at(1.5)
    np.testing.assert_allclose(still.rotation[:, 0], [np.cos(1.5), np.sin(1.5), 0.0], atol=1e-15)
    there = bn.Problem(spec_of(robot, [bn.CostTerm(residual.FrameVelocity("tool", still))], knots=3))
    np.testing.assert_allclose(problem.residual(2, 0, x, u), there.residual(2, 0, x, u), atol=1e-14)
    with pytest.raises(bn.Error, match="length 0.5 at 2 s"):
        bn.Reference(rotation_over_time=lambda t: [0, 0, 0, 0.5]).at(2)


def test_set_knot_with_another_time_evaluates_the_signal_again(robot):
    times_called = []

    def path(t):
        times_called.append(t)
        return [t, 0.0, 0.0]

    problem = bn.Problem(spec_of(robot, [bn.CostTerm(residual.FramePosition("tool", path))], knots=3))
    times_called.clear()
    problem.set_knot(1, "move", 7.0)
    assert times_called == [7.0]
    before = problem.residual(1, 0, at_rest(robot), np.zeros(7))
    problem.set_target(1, "frame position", [1.0, 0.0, 0.0])
    np.testing.assert_allclose(
        problem.residual(1, 0, at_rest(robot), np.zeros(7)) - before, [6.0, 0.0, 0.0]
    )
    problem.advance("move")
    assert problem.time_of(0) == 7.0
