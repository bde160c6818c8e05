"""Custom residuals written in Python."""

from __future__ import annotations

import gc

import numpy as np
import pytest
from problem_cases import Tool, at_rest, base_costs, one_term, random_trajectory, robot, spec_of

import burnish as bn
from burnish import residual


class Apart:
    """Vector between two frames [m] and the velocity of the first one; uses q and v."""

    name = "apart"
    rows = 6
    frames = ["tool", "link_2"]

    def value(self, at):
        apart = at.placement("tool")[:3, 3] - at.placement(1)[:3, 3]
        return np.concatenate([apart, at.velocity("tool", "local")[3:]])


class ToolByDifferences(Tool):
    jacobian = None


def test_custom_residual_matches_the_built_in_one(robot):
    goal = [0.5, -0.1, 0.3]
    expansions = []
    for reach in (
        residual.FramePosition("tool", goal),
        residual.custom(Tool(goal)),
        residual.custom(ToolByDifferences(goal)),
    ):
        problem = bn.Problem(spec_of(robot, [*base_costs(), bn.CostTerm(reach, 10.0, "reach")]))
        assert bn.check_problem(problem).pass_
        expansions.append(problem.expand(*random_trajectory(problem)))
    built_in, own, differences = expansions
    np.testing.assert_allclose(own.costs, built_in.costs, rtol=1e-13)
    np.testing.assert_allclose(own.gradients, built_in.gradients, rtol=1e-11, atol=1e-12)
    np.testing.assert_allclose(own.hessians, built_in.hessians, rtol=1e-11, atol=1e-12)
    np.testing.assert_allclose(differences.gradients, built_in.gradients, rtol=1e-7, atol=1e-8)


def test_check_problem_finds_a_wrong_derivative(robot):
    class Wrong(Tool):
        def jacobian(self, at):
            return 1.01 * super().jacobian(at)

    problem = bn.Problem(spec_of(robot, [*base_costs(), bn.CostTerm(residual.custom(Wrong([0, 0, 0])))]))
    report = bn.check_problem(problem, bn.ProblemCheckOptions(states=1))
    failed = {row.term for row in report.rows if not row.pass_}
    assert not report.pass_ and failed == {"reach", "all costs"}
    worst = next(row.worst for row in report.rows if row.term == "reach")
    assert worst.block == "dr_dq" and worst.value == pytest.approx(1.01 * worst.expected, rel=1e-3)
    assert "reach" in report.text()


def test_custom_force_residual_matches_the_built_in_one():
    robot = bn.load_robot("arm7")
    contact = bn.ContactSpec("pad", tool="tool", directions="z").with_gains(0.0, 50.0)

    class Push:
        name, rows, contacts = "push", 1, ["pad"]

        def value(self, at):
            return at.force("pad") - 5.0

        def jacobian(self, at):
            return at.force_derivative(0)

    def problem_of(term):
        return bn.Problem(
            bn.ProblemSpec(
                robot.model,
                contacts=[contact],
                initial_state=at_rest(robot),
                stages=[bn.Stage("press", contacts=["pad"], costs=[*base_costs(), bn.CostTerm(term, 1.0, "f")])],
                horizon=[bn.HorizonSegment("press", 4)],
            )
        )

    own = problem_of(residual.custom(Push()))
    built_in = problem_of(residual.ContactForce("pad", target=5.0))
    assert bn.check_problem(own).pass_
    xs, us = random_trajectory(own)
    np.testing.assert_allclose(own.expand(xs, us).gradients, built_in.expand(xs, us).gradients,
                               rtol=1e-10, atol=1e-10)
    assert own.force_names(0) == ["pad/z"]
    np.testing.assert_allclose(own.forces(0, xs[0], us[0]) - 5.0, own.residual(0, "f", xs[0], us[0]))
    assert own.acceleration(0, xs[0], us[0]).shape == (7,)


def test_node_view_gives_the_values_of_its_node(robot):
    seen = {}

    def value(at):
        seen.update(q=at.q, v=at.v, u=at.u, tau=at.tau, a=at.acceleration, time=at.time,
                    layout=at.layout, placement=at.placement("tool"), J=at.jacobian("tool", "local"),
                    velocity=at.velocity(0, "local"))
        return 0.0

    term = bn.CostTerm(residual.Custom("look", 1, frames=["tool"], value=value))
    problem = bn.Problem(spec_of(robot, [term], start_time=2.0))
    xs, us = random_trajectory(problem)
    problem.residual(3, "look", xs[3], us[3])
    np.testing.assert_array_equal(np.concatenate([seen["q"], seen["v"]]), xs[3])
    np.testing.assert_array_equal(seen["u"], us[3])
    np.testing.assert_array_equal(seen["tau"], us[3])
    assert seen["time"] == pytest.approx(2.03) and seen["layout"] == problem.layout
    np.testing.assert_allclose(seen["placement"], bn.frame_placement(robot.model, seen["q"], "tool"),
                               atol=1e-12)
    np.testing.assert_allclose(seen["J"] @ seen["v"], seen["velocity"], atol=1e-12)
    np.testing.assert_allclose(seen["a"], problem.acceleration(3, xs[3], us[3]), atol=1e-9)


def ask(problem, knot=0):
    return problem.residual(knot, 0, problem.initial_state, np.zeros(problem.max_controls))


def test_invalid_custom_residual_raises_with_the_reason(robot):
    def custom(value, jacobian=None, **entries):
        entries.setdefault("rows", 2)
        return residual.Custom("mine", frames=["tool"], value=value, jacobian=jacobian, **entries)

    with pytest.raises(bn.Error, match=r"residual 'mine': value gave an array of shape \(3,\); wanted \(2,\)"):
        ask(one_term(robot, custom(lambda at: np.zeros(3))))
    with pytest.raises(bn.Error, match="residual 'mine': value gave no numbers; wanted"):
        ask(one_term(robot, custom(lambda at: None)))
    problem = one_term(robot, custom(lambda at: np.zeros(2), lambda at: np.zeros((2, 3))))
    with pytest.raises(bn.Error, match=r"jacobian gave an array of shape \(2, 3\); wanted \(2, 21\)"):
        problem.residual_derivative(0, 0, problem.initial_state, np.zeros(7))
    with pytest.raises(bn.Error, match="it does not declare the frame 'tol'; did you mean 'tool'"):
        ask(one_term(robot, custom(lambda at: at.placement("tol")[:2, 3])))
    with pytest.raises(bn.Error, match="there is no frame 1; the number of declared frames is 1"):
        ask(one_term(robot, custom(lambda at: at.placement(1)[:2, 3])))
    with pytest.raises(bn.Error, match="value"):
        one_term(robot, residual.Custom("mine", 2))
    with pytest.raises(bn.Error, match="Custom.jacobian: got 3; wanted a function of a NodeView, or None"):
        one_term(robot, custom(lambda at: 0.0, 3))
    with pytest.raises(bn.Error, match="Custom.rows: got 'two'; wanted a whole number"):
        one_term(robot, custom(lambda at: 0.0, rows="two"))


def test_exception_in_a_custom_residual_reaches_the_caller(robot):
    class Mine(Exception):
        pass

    def value(at):
        raise Mine("from inside", 42)

    problem = one_term(robot, residual.Custom("mine", 1, value=value))
    xs, us = random_trajectory(problem)
    for call in (
        lambda: ask(problem),
        lambda: problem.evaluate(xs, us),
        lambda: problem.evaluate(xs, us, threads=2),
        lambda: problem.term_costs(0, xs[0], us[0]),
        lambda: bn.check_problem(problem),
    ):
        with pytest.raises(Mine) as caught:
            call()
        assert caught.value.args == ("from inside", 42)


def test_node_view_after_its_call_raises(robot):
    kept = []

    def value(at):
        kept.append(at)
        return 0.0

    ask(one_term(robot, residual.Custom("mine", 1, frames=["tool"], value=value)))
    for use in (lambda at: at.q, lambda at: at.placement(0), lambda at: at.layout):
        with pytest.raises(bn.Error, match="used after the call that received it"):
            use(kept[-1])


def test_force_derivative_outside_jacobian_raises(robot):
    contact = bn.ContactSpec("pad", tool="tool", directions="z")
    spec = spec_of(robot, [bn.CostTerm(residual.Custom(
        "mine", 1, contacts=["pad"], value=lambda at: at.force_derivative("pad")[0, :1]))])
    spec.contacts = [contact]
    spec.stages[0].contacts = ["pad"]
    with pytest.raises(bn.Error, match=r"wanted a call in jacobian\(\)"):
        ask(bn.Problem(spec))


def test_problem_keeps_functions_alive(robot):
    def make():
        offset = np.array([1.0])
        return one_term(robot, residual.Custom("mine", 1, value=lambda at: at.q[:1] + offset))

    problem = make()
    gc.collect()
    np.testing.assert_allclose(ask(problem), problem.initial_state[:1] + 1.0)
    del problem
    gc.collect()
