"""Problems in Python: signals of every form, residuals of one's own, trajectories, the checker."""

import copy
import gc
import math
import pickle
import threading

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
    """What the problem makes of a target over its knots."""
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


# Signals


def test_a_signal_is_numbers_or_a_function_of_time(robot):
    times = 0.01 * np.arange(4)
    still = np.tile([0.4, 0.1, 0.3], (4, 1))
    np.testing.assert_allclose(position_targets(robot, [0.4, 0.1, 0.3]), still, atol=1e-12)
    np.testing.assert_allclose(position_targets(robot, np.array([0.4, 0.1, 0.3])), still, atol=1e-12)
    moving = np.stack([0.4 + times, 0.1 + 0 * times, 0.3 - 2 * times], axis=1)

    def path(t):
        return [0.4 + t, 0.1, 0.3 - 2 * t]

    np.testing.assert_allclose(position_targets(robot, path), moving, atol=1e-12)
    np.testing.assert_allclose(position_targets(robot, bn.over_time(3, path)), moving, atol=1e-12)


def test_over_time_takes_functions_that_cannot_be_asked_at_zero(robot):
    def late(t):
        if t < 1.0:
            raise ValueError("not yet")
        return np.array([t, 0.0, 0.0])

    with pytest.raises(ValueError, match="not yet"):
        position_targets(robot, late, start_time=1.0)
    targets = position_targets(robot, bn.over_time(3, late), start_time=1.0)
    np.testing.assert_allclose(targets[:, 0], 1.0 + 0.01 * np.arange(4), atol=1e-12)


def test_a_number_is_a_signal_of_one_entry(robot):
    joint = robot.model.v_names[1]
    q = robot.reference_configuration()
    for target in (0.25, lambda t: 0.25, np.float64(0.25)):
        problem = bn.Problem(
            spec_of(robot, [bn.CostTerm(residual.JointPosition([joint], target), name="angle")])
        )
        r = problem.residual(0, "angle", at_rest(robot), np.zeros(7))
        np.testing.assert_allclose(r, [q[1] - 0.25], atol=1e-14)


def test_signals_come_back_from_a_problem_as_they_went_in(robot):
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


def test_a_signal_that_is_none_is_refused_with_a_sentence(robot):
    with pytest.raises(bn.Error, match=r"FramePosition.target: got 'here', wanted a number, a vector"):
        position_targets(robot, "here")
    with pytest.raises(bn.Error, match=r"shape \(2, 2\) at 0 s; wanted are numbers"):
        position_targets(robot, lambda t: np.zeros((2, 2)))
    with pytest.raises(bn.Error, match=r"gave an array of shape \(2,\) at 0.02 s; wanted are 3 numbers"):
        position_targets(robot, lambda t: np.zeros(3 if t < 0.015 else 2))


def test_a_signal_is_asked_again_when_a_knot_gets_another_time(robot):
    asked = []

    def path(t):
        asked.append(t)
        return [t, 0.0, 0.0]

    problem = bn.Problem(spec_of(robot, [bn.CostTerm(residual.FramePosition("tool", path))], knots=3))
    asked.clear()
    problem.set_knot(1, "move", 7.0)
    assert asked == [7.0]
    before = problem.residual(1, 0, at_rest(robot), np.zeros(7))
    problem.set_target(1, "frame position", [1.0, 0.0, 0.0])
    np.testing.assert_allclose(
        problem.residual(1, 0, at_rest(robot), np.zeros(7)) - before, [6.0, 0.0, 0.0]
    )
    problem.advance("move")
    assert problem.time_of(0) == 7.0


# Residuals of one's own


class Apart:
    """Vector between two frames, m, and the speed of the first one; uses q and v."""

    name = "apart"
    rows = 6
    frames = ["tool", "link_2"]

    def value(self, at):
        apart = at.placement("tool")[:3, 3] - at.placement(1)[:3, 3]
        return np.concatenate([apart, at.velocity("tool", bn.FrameAxes.LOCAL)[3:]])


class Tool:
    """FramePosition once more."""

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


class ToolByDifferences(Tool):
    jacobian = None


def test_own_residuals_agree_with_the_built_in_one(robot):
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


def test_the_checker_finds_a_wrong_derivative(robot):
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


def test_own_residuals_of_forces_have_derivatives():
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


def test_a_node_is_seen_as_it_is(robot):
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


def one_term(robot, term):
    return bn.Problem(spec_of(robot, [bn.CostTerm(term)]))


def ask(problem, knot=0):
    return problem.residual(knot, 0, problem.initial_state, np.zeros(problem.max_controls))


def test_what_own_residuals_do_wrong_is_said(robot):
    def of(value, jacobian=None, **entries):
        entries.setdefault("rows", 2)
        return residual.Custom("mine", frames=["tool"], value=value, jacobian=jacobian, **entries)

    with pytest.raises(bn.Error, match=r"residual 'mine': value gave an array of shape \(3,\); wanted is \(2,\)"):
        ask(one_term(robot, of(lambda at: np.zeros(3))))
    with pytest.raises(bn.Error, match="residual 'mine': value gave no numbers; wanted is"):
        ask(one_term(robot, of(lambda at: None)))
    problem = one_term(robot, of(lambda at: np.zeros(2), lambda at: np.zeros((2, 3))))
    with pytest.raises(bn.Error, match=r"jacobian gave an array of shape \(2, 3\); wanted is \(2, 21\)"):
        problem.residual_derivative(0, 0, problem.initial_state, np.zeros(7))
    with pytest.raises(bn.Error, match="it does not declare the frame 'tol'; did you mean 'tool'"):
        ask(one_term(robot, of(lambda at: at.placement("tol")[:2, 3])))
    with pytest.raises(bn.Error, match="there is no frame 1; it declares 1"):
        ask(one_term(robot, of(lambda at: at.placement(1)[:2, 3])))
    with pytest.raises(bn.Error, match="value"):
        one_term(robot, residual.Custom("mine", 2))
    with pytest.raises(bn.Error, match="Custom.jacobian: got 3, wanted a function of a NodeView, or None"):
        one_term(robot, of(lambda at: 0.0, 3))
    with pytest.raises(bn.Error, match="Custom.rows: got 'two', wanted a whole number"):
        one_term(robot, of(lambda at: 0.0, rows="two"))


def test_what_own_residuals_raise_is_raised(robot):
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


def test_a_node_cannot_be_used_after_its_call(robot):
    kept = []

    def value(at):
        kept.append(at)
        return 0.0

    ask(one_term(robot, residual.Custom("mine", 1, frames=["tool"], value=value)))
    for use in (lambda at: at.q, lambda at: at.placement(0), lambda at: at.layout):
        with pytest.raises(bn.Error, match="used after the call that it came with"):
            use(kept[-1])


def test_derivatives_of_forces_are_for_jacobians(robot):
    contact = bn.ContactSpec("pad", tool="tool", directions="z")
    spec = spec_of(robot, [bn.CostTerm(residual.Custom(
        "mine", 1, contacts=["pad"], value=lambda at: at.force_derivative("pad")[0, :1]))])
    spec.contacts = [contact]
    spec.stages[0].contacts = ["pad"]
    with pytest.raises(bn.Error, match="only jacobian has it"):
        ask(bn.Problem(spec))


def test_a_problem_keeps_functions_alive(robot):
    def make():
        offset = np.array([1.0])
        return one_term(robot, residual.Custom("mine", 1, value=lambda at: at.q[:1] + offset))

    problem = make()
    gc.collect()
    np.testing.assert_allclose(ask(problem), problem.initial_state[:1] + 1.0)
    del problem
    gc.collect()


# Problems


def test_specs_round_trip_through_a_problem(robot):
    spec = spec_of(
        robot,
        [bn.CostTerm(residual.State(), 0.1, weights=np.arange(14.0)),
         bn.CostTerm(residual.JointPosition(), penalty=bn.Penalty.log_barrier([-1.0], [1.0], 0.1))],
        terminal=[bn.CostTerm(residual.FrameVelocity("tool", "local"))],
        control_lower=-10.0, control_upper=np.full(7, 20.0), torque_model=None,
    )
    spec.stages[0].integrator = bn.Integrator.RUNGE_KUTTA4
    problem = bn.Problem(spec)
    np.testing.assert_array_equal(problem.control_lower(0), np.full(7, -10.0))
    np.testing.assert_array_equal(problem.control_upper(5), np.full(7, 20.0))
    assert problem.control_upper(6) is None
    back = problem.spec
    assert back.stages[0].integrator is bn.Integrator.RUNGE_KUTTA4
    assert back.terminal[0].residual.axes is bn.FrameAxes.LOCAL
    assert back.stages[0].costs[1].penalty == spec.stages[0].costs[1].penalty
    np.testing.assert_array_equal(back.control_lower, [-10.0])


def test_specs_are_copied_and_pickled(robot):
    spec = spec_of(robot, [*base_costs(), bn.CostTerm(residual.custom(Tool([0.5, 0.0, 0.3])), 5.0)])
    problem = bn.Problem(spec)
    xs, us = random_trajectory(problem)
    expected = problem.evaluate(xs, us)
    for other in (pickle.loads(pickle.dumps(spec)), copy.deepcopy(spec), problem.spec):
        assert other.model == spec.model and other.horizon == spec.horizon
        again = bn.Problem(other).evaluate(xs, us)
        np.testing.assert_array_equal(again.costs, expected.costs)
        np.testing.assert_array_equal(again.next_states, expected.next_states)
    plain = spec_of(robot, base_costs())
    assert pickle.loads(pickle.dumps(plain)) == plain == bn.Problem(plain).spec
    other = copy.deepcopy(spec)
    other.stages[0].costs[0].weight = 77.0
    assert spec.stages[0].costs[0].weight == 0.1 and other.stages[0] != spec.stages[0]


def test_names_that_there_are_not_are_answered_with_the_nearest(robot):
    def compile_with(**entries):
        return bn.Problem(spec_of(robot, base_costs()).replace(**entries))

    with pytest.raises(bn.Error, match="unknown stage 'mov'; did you mean 'move'"):
        compile_with(horizon=[bn.HorizonSegment("mov", 3)])
    with pytest.raises(bn.Error, match="stage 'move'.*'tol'.*did you mean 'tool'"):
        compile_with(stages=[bn.Stage("move", costs=[bn.CostTerm(residual.FramePosition("tol", [0, 0, 0]))])])
    with pytest.raises(AttributeError, match="no entry 'horizn'; did you mean 'horizon'"):
        spec_of(robot, []).horizn = []
    with pytest.raises(bn.Error, match="Stage.integrator: |there is no 'runge_kuta4'; did you mean 'runge_kutta4'"):
        compile_with(stages=[bn.Stage("move", integrator="runge_kuta4", costs=base_costs())])
    with pytest.raises(bn.Error, match="CostTerm.residual: got 3, wanted"):
        compile_with(terminal=[bn.CostTerm(3)])
    with pytest.raises(bn.Error, match="ProblemSpec.model: got .*wanted a Model"):
        compile_with(model=robot)
    problem = bn.Problem(spec_of(robot, base_costs()))
    with pytest.raises(bn.Error, match="unknown cost term 'stat'; did you mean 'state'"):
        problem.residual(0, "stat", problem.initial_state, np.zeros(7))
    with pytest.raises(bn.Error, match="unknown stage 'moving'"):
        problem.advance("moving")


def test_places_that_there_are_not_are_refused(robot):
    problem = bn.Problem(spec_of(robot, base_costs()))
    x, u = problem.initial_state, np.zeros(7)
    with pytest.raises(bn.Error, match="Problem.time_of: knot 7; wanted 0 to 6"):
        problem.time_of(7)
    with pytest.raises(bn.Error, match="Problem.residual: term 2; move, knot 0 has 2"):
        problem.residual(0, 2, x, u)
    with pytest.raises(bn.Error, match="Problem.roll: x has 3 entries; wanted 14"):
        problem.roll(0, np.zeros(3), u)
    with pytest.raises(bn.Error, match="Problem.roll: u is missing; wanted are 7"):
        problem.roll(0, x)
    with pytest.raises(bn.Error, match=r"evaluate: us has the shape \(5, 7\); wanted is \(6, 7\)"):
        problem.evaluate(np.zeros((7, 14)), np.zeros((5, 7)))
    with pytest.raises(bn.Error, match="evaluate: threads is 0; wanted at least 1"):
        problem.evaluate(np.zeros((7, 14)), np.zeros((6, 7)), threads=0)
    with pytest.raises(bn.Error, match="Problem.quasi_static: stage 2; wanted 0 to 1"):
        problem.quasi_static(2, x)
    with pytest.raises(bn.Error, match="initial_state: x has 2 entries; wanted 14"):
        problem.set_initial_state([1.0, 2.0])
    with pytest.raises(bn.EvaluationError, match="Problem.set_initial_state: .*NaN"):
        problem.set_initial_state(np.full(14, math.nan))


def test_a_problem_says_what_it_is(robot):
    problem = bn.Problem(spec_of(robot, base_costs(), terminal=[bn.CostTerm(residual.State(), 3.0)]))
    assert (problem.knots, problem.nx, problem.ndx, problem.max_controls) == (6, 14, 14, 7)
    assert problem.stage_names == ["move", "terminal"] and problem.stage_index("terminal") == 1
    assert problem.term_names(0) == ["state", "control"] and problem.term_index("move", "control") == 1
    assert problem.knot_name(2) == "move, knot 2" and problem.knot_name(6) == "the terminal state"
    assert problem.controls(0) == 7 and problem.controls(6) == 0
    assert problem.step_of(0) == 0.01 and problem.step_of(6) == 0.0
    assert problem.state_names[0] == "q " + robot.model.v_names[0]
    assert problem.control_names == robot.model.v_names
    assert "6 knots" in repr(problem) and "arm7" in repr(problem)
    layout = problem.layout
    assert (layout.nx, layout.nz, layout.column_q, layout.column_v, layout.column_tau) == (14, 21, 7, 14, 21)


def test_trajectories_are_evaluated_as_knots_are(robot):
    spec = spec_of(robot, base_costs(), knots=11, terminal=[bn.CostTerm(residual.State(), 3.0)])
    problem = bn.Problem(spec)
    xs, us = random_trajectory(problem)
    values = problem.evaluate(xs, us)
    for k in range(12):
        next_state, cost = problem.roll(k, xs[k], us[k] if k < 11 else None)
        assert values.costs[k] == pytest.approx(cost, rel=1e-12)
        if k < 11:
            np.testing.assert_allclose(values.next_states[k], next_state, atol=1e-12)
            assert sum(problem.term_costs(k, xs[k], us[k])) == pytest.approx(cost, rel=1e-12)
        else:
            assert next_state is None
    assert values.cost == pytest.approx(np.sum(values.costs))
    assert set(values.statuses) == {bn.Status.OK} and set(values.terms) == {-1}
    two = problem.evaluate(xs, us, threads=2)
    np.testing.assert_array_equal(two.costs, values.costs)
    np.testing.assert_array_equal(two.next_states, values.next_states)
    fortran = problem.evaluate(np.asfortranarray(xs), us[:, ::-1][:, ::-1])
    np.testing.assert_array_equal(fortran.costs, values.costs)


def test_a_knot_that_cannot_be_evaluated_says_so(robot):
    term = bn.CostTerm(residual.Custom("mine", 1, value=lambda at: math.nan if at.time > 0.035 else 0.0))
    problem = bn.Problem(spec_of(robot, [*base_costs(), term]))
    xs, us = random_trajectory(problem)
    values = problem.evaluate(xs, us)
    assert values.statuses[:4] == [bn.Status.OK] * 4 and values.terms[3] == -1
    assert values.statuses[4:6] == [bn.Status.NOT_FINITE] * 2 and values.terms[4] == 2
    with pytest.raises(bn.EvaluationError, match="Problem.roll"):
        problem.roll(5, xs[5], us[5])


@pytest.mark.parametrize("kind", ["arm", "torque model", "runge-kutta", "quadruped"])
def test_expansions_are_derivatives(kind):
    robot = bn.load_robot("quadruped" if kind == "quadruped" else "arm7")
    model = robot.model
    x = np.concatenate([robot.reference_configuration(), np.zeros(model.nv)])
    spec = bn.ProblemSpec(
        model, initial_state=x, stages=[bn.Stage("move", costs=base_costs())],
        horizon=[bn.HorizonSegment("move", 3)], terminal=[bn.CostTerm(residual.State(), 2.0)],
    )
    if kind == "torque model":
        spec.torque_model = bn.TorqueModel(30.0)
        spec.initial_state = np.concatenate([x, np.zeros(7)])
    if kind == "runge-kutta":
        spec.stages[0].integrator = "runge_kutta4"
    problem = bn.Problem(spec)
    xs, us = random_trajectory(problem)
    e = problem.expand(xs, us)
    nu, nz, h = problem.max_controls, problem.layout.nz, 1e-6
    values = problem.evaluate(xs, us)
    np.testing.assert_allclose(e.costs, values.costs, rtol=1e-12)
    np.testing.assert_allclose(e.next_states, values.next_states, atol=1e-12)
    for z in range(nz):
        sides = []
        for step in (h, -h):
            du, dx = np.zeros_like(us), np.zeros((4, problem.ndx))
            if z < nu:
                du[:, z] = step
            else:
                dx[:, z - nu] = step
            sides.append(problem.evaluate(problem.integrate(xs, dx), us + du))
        gradient = (sides[0].costs - sides[1].costs) / (2 * h)
        np.testing.assert_allclose(e.gradients[:, z], gradient, rtol=1e-5, atol=1e-6)
        column = problem.difference(sides[1].next_states, sides[0].next_states) / (2 * h)
        np.testing.assert_allclose(e.dynamics[:, :, z], column, rtol=1e-5, atol=1e-5)
    np.testing.assert_array_equal(e.hessians, np.swapaxes(e.hessians, 1, 2))
    assert not e.gradients[3, :nu].any() and not e.hessians[3, :nu].any()
    assert np.linalg.eigvalsh(e.hessians[0]).min() > -1e-9


def test_states_are_integrated_one_by_one_or_in_rows():
    robot = bn.load_robot("quadruped")
    problem = bn.Problem(bn.ProblemSpec(
        robot.model, initial_state=at_rest(robot), stages=[bn.Stage("move", costs=base_costs())],
        horizon=[bn.HorizonSegment("move", 2)]))
    x = problem.initial_state
    dx = 0.3 * np.random.default_rng(1).standard_normal((5, problem.ndx))
    moved = problem.integrate(np.tile(x, (5, 1)), dx)
    np.testing.assert_array_equal(problem.integrate(x, dx[2]), moved[2])
    np.testing.assert_allclose(problem.difference(np.tile(x, (5, 1)), moved), dx, atol=1e-12)
    with pytest.raises(bn.Error, match="a row of the second has 3 entries"):
        problem.integrate(x, [1.0, 2.0, 3.0])
    with pytest.raises(bn.Error, match="same number of rows"):
        problem.integrate(x, dx)


def test_quasi_static_controls_hold_a_state(robot):
    problem = bn.Problem(spec_of(robot, base_costs()))
    held = problem.quasi_static("move", problem.initial_state)
    assert held.residual < 1e-9 and held.force.shape == (0,)
    next_state, _ = problem.roll(0, problem.initial_state, held.control)
    np.testing.assert_allclose(next_state, problem.initial_state, atol=1e-12)
    problem.set_torque_bias(held.control)
    np.testing.assert_allclose(problem.quasi_static(0, problem.initial_state).control, 0.0, atol=1e-9)


def test_complaints_are_sentences(robot):
    assert bn.complaints(bn.Problem(spec_of(robot, base_costs()))) == []
    far = spec_of(robot, [bn.CostTerm(residual.FramePosition("tool", [9.0, 0.0, 0.0]))])
    assert any("tool" in sentence for sentence in bn.complaints(bn.Problem(far)))


def test_the_check_reports_progress_and_lets_exceptions_through(robot):
    problem = bn.Problem(spec_of(robot, base_costs()))
    calls = []
    bn.check_problem(problem, bn.ProblemCheckOptions(progress=lambda done, total: calls.append((done, total))))
    assert calls[-1] == (2, 2)

    def stop(done, total):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        bn.check_problem(problem, bn.ProblemCheckOptions(progress=stop))
    with pytest.raises(bn.Error, match="check: "):
        bn.check_problem(problem, bn.ProblemCheckOptions(states=0))


def test_one_problem_is_used_by_one_thread(robot):
    inside, go_on = threading.Event(), threading.Event()

    def value(at):
        inside.set()
        go_on.wait(10.0)
        return 0.0

    problem = one_term(robot, residual.Custom("slow", 1, value=value))
    go_on.set()
    xs, us = random_trajectory(problem)
    go_on.clear()
    inside.clear()
    thread = threading.Thread(target=problem.evaluate, args=(xs, us))
    thread.start()
    try:
        assert inside.wait(10.0)
        with pytest.raises(bn.Error, match="Problem.evaluate: in use by another thread"):
            problem.evaluate(xs, us)
    finally:
        go_on.set()
        thread.join()
    problem.evaluate(xs, us)
