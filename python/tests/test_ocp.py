"""Optimal control problems in Python: specifications, knots, trajectories, the checker."""

from __future__ import annotations

import copy
import math
import pickle
import threading

import numpy as np
import pytest
from problem_cases import Tool, at_rest, base_costs, one_term, random_trajectory, robot, spec_of

import burnish as bn
from burnish import residual


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
    assert back.terminal[0].residual.reference.name == "local"
    assert back.stages[0].costs[1].penalty == spec.stages[0].costs[1].penalty
    np.testing.assert_array_equal(back.control_lower, [-10.0])


def test_copied_or_pickled_specs_give_the_same_values(robot):
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


def test_unknown_names_raise_errors_with_the_nearest_name(robot):
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
    with pytest.raises(bn.Error, match="CostTerm.residual: got 3; wanted"):
        compile_with(terminal=[bn.CostTerm(3)])
    with pytest.raises(bn.Error, match="ProblemSpec.model: got .*wanted a Model"):
        compile_with(model=robot)
    problem = bn.Problem(spec_of(robot, base_costs()))
    with pytest.raises(bn.Error, match="unknown term 'stat'; did you mean 'state'"):
        problem.residual(0, "stat", problem.initial_state, np.zeros(7))
    with pytest.raises(bn.Error, match="unknown stage 'moving'"):
        problem.advance("moving")


def test_frame_position_without_reference_is_in_world_axes():
    assert residual.FramePosition().reference.name == residual.FrameDistance().reference.name == "world"
    assert residual.FrameVelocity().reference.name == "centered"


def test_frame_distance_matches_numpy(robot):
    tool = bn.frame_placement(robot.model, robot.reference_configuration(), "tool")[:3, 3]
    point = np.array([0.1, -0.2, 0.3])

    def distance(**entries):
        problem = one_term(robot, residual.FrameDistance("tool", point, **entries))
        return problem.residual(0, 0, at_rest(robot), np.zeros(7))[0]

    assert distance() == pytest.approx(np.linalg.norm(tool - point))
    assert distance(directions="x,z") == pytest.approx(np.hypot(*(tool - point)[[0, 2]]))


def test_support_margin_takes_lists_of_points(robot):
    points = [[-1.0, -1.0], [1.0, -1.0], [0.0, 2.0]]
    spec = spec_of(robot, [*base_costs(), bn.CostTerm(residual.SupportMargin(np.array(points)), name="balance")])
    problem = bn.Problem(spec)
    np.testing.assert_array_equal(problem.spec.stages[0].costs[2].residual.points, points)
    assert problem.residual(0, "balance", at_rest(robot), np.zeros(7)).shape == (3,)
    with pytest.raises(bn.Error, match="SupportMargin.points: got .*wanted a list"):
        one_term(robot, residual.SupportMargin([1.0, 2.0, 3.0]))


def test_invalid_knots_terms_and_shapes_raise(robot):
    problem = bn.Problem(spec_of(robot, base_costs()))
    x, u = problem.initial_state, np.zeros(7)
    with pytest.raises(bn.Error, match="Problem.time_of: knot 7 does not exist; wanted 0 to 6"):
        problem.time_of(7)
    with pytest.raises(bn.Error, match="Problem.residual: term 2 does not exist; move, knot 0 has 2"):
        problem.residual(0, 2, x, u)
    with pytest.raises(bn.Error, match="Problem.roll: x has 3 entries; wanted 14"):
        problem.roll(0, np.zeros(3), u)
    with pytest.raises(bn.Error, match="Problem.roll: u is missing; wanted 7"):
        problem.roll(0, x)
    with pytest.raises(bn.Error, match=r"evaluate: us has the shape \(5, 7\); wanted \(6, 7\)"):
        problem.evaluate(np.zeros((7, 14)), np.zeros((5, 7)))
    with pytest.raises(bn.Error, match="evaluate: threads is 0; wanted at least 1"):
        problem.evaluate(np.zeros((7, 14)), np.zeros((6, 7)), threads=0)
    with pytest.raises(bn.Error, match="Problem.quasi_static: stage 2 does not exist; wanted 0 to 1"):
        problem.quasi_static(2, x)
    with pytest.raises(bn.Error, match="initial_state: x has 2 entries; wanted 14"):
        problem.set_initial_state([1.0, 2.0])
    with pytest.raises(bn.EvaluationError, match="Problem.set_initial_state: .*NaN"):
        problem.set_initial_state(np.full(14, math.nan))


def test_horizon_knots_have_individual_steps(robot):
    spec = spec_of(robot, base_costs())
    spec = spec.replace(horizon=[bn.HorizonSegment("move", 2), bn.HorizonSegment("move", 4, 0.01, 0.15)])
    problem = bn.Problem(spec)
    wanted = [0.01, 0.01, 0.01, 0.02, 0.04, 0.08]
    np.testing.assert_allclose([problem.step_of(k) for k in range(6)], wanted)
    np.testing.assert_allclose(problem.time_of(6), 0.17)
    assert problem.spec.horizon == spec.horizon
    problem.set_step(1, 0.03)
    assert problem.step_of(1) == 0.03
    with pytest.raises(bn.Error, match="set_step: the step is 0 s; wanted a positive number"):
        problem.set_step(1, 0.0)
    with pytest.raises(bn.Error, match="9 s with 4 knots"):
        bn.Problem(spec.replace(horizon=[bn.HorizonSegment("move", 4, duration=9)]))


def test_problem_reports_its_sizes_and_names(robot):
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


@pytest.mark.parametrize(
    ("model", "acts"), [(bn.TorqueModel(30.0), True), (bn.TorqueModel(discretization="held"), False)])
def test_layout_reports_whether_torque_states_act(robot, model, acts):
    spec = spec_of(robot, base_costs(), torque_model=model)
    spec.initial_state = np.concatenate([spec.initial_state, np.zeros(7)])
    layout = bn.Problem(spec).layout
    assert (layout.nx, layout.filtered) == (21, 7)
    assert layout.holds_torque is not acts and layout.acts_from_state is acts


def test_layout_with_force_states_has_their_column(robot):
    contact = bn.ContactSpec("pad", tool="tool", directions="z")
    spec = spec_of(robot, base_costs(), contacts=[contact], force_states=["pad"])
    spec.stages[0].contacts = ["pad"]
    spec.stages[0].costs.append(bn.CostTerm(residual.ContactForceRate("pad", 5.0), name="rate"))
    spec.initial_state = np.append(spec.initial_state, 3.0)
    problem = bn.Problem(spec)
    layout = problem.layout
    assert (layout.nx, layout.ndx, layout.force_states, layout.column_force) == (15, 15, 1, 21)
    assert problem.state_names[-1] == "force pad/z"
    u = np.ones(7)
    next_state, _ = problem.roll(0, spec.initial_state, u)
    force = problem.forces(0, spec.initial_state, u)
    assert next_state[14] == force[0]
    rate = problem.residual(0, problem.term_index("move", "rate"), spec.initial_state, u)
    assert rate[0] == pytest.approx((force[0] - 3.0) / 0.01 - 5.0, rel=1e-9)


def test_evaluate_trajectory_matches_single_knots(robot):
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


def test_evaluate_nan_knot_reports_status_and_term(robot):
    term = bn.CostTerm(residual.Custom("mine", 1, value=lambda at: math.nan if at.time > 0.035 else 0.0))
    problem = bn.Problem(spec_of(robot, [*base_costs(), term]))
    xs, us = random_trajectory(problem)
    values = problem.evaluate(xs, us)
    assert values.statuses[:4] == [bn.Status.OK] * 4 and values.terms[3] == -1
    assert values.statuses[4:6] == [bn.Status.NOT_FINITE] * 2 and values.terms[4] == 2
    with pytest.raises(bn.EvaluationError, match="Problem.roll"):
        problem.roll(5, xs[5], us[5])


@pytest.mark.parametrize("kind", ["arm", "torque model", "runge-kutta", "quadruped"])
def test_expand_matches_finite_differences(kind):
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


def test_integrate_single_state_matches_rows():
    robot = bn.load_robot("quadruped")
    problem = bn.Problem(bn.ProblemSpec(
        robot.model, initial_state=at_rest(robot), stages=[bn.Stage("move", costs=base_costs())],
        horizon=[bn.HorizonSegment("move", 2)]))
    x = problem.initial_state
    dx = 0.3 * np.random.default_rng(1).standard_normal((5, problem.ndx))
    moved = problem.integrate(np.tile(x, (5, 1)), dx)
    np.testing.assert_array_equal(problem.integrate(x, dx[2]), moved[2])
    np.testing.assert_allclose(problem.difference(np.tile(x, (5, 1)), moved), dx, atol=1e-12)
    with pytest.raises(bn.Error, match="a row of the second array has 3 entries"):
        problem.integrate(x, [1.0, 2.0, 3.0])
    with pytest.raises(bn.Error, match="equal numbers of rows"):
        problem.integrate(x, dx)


def test_quasi_static_control_keeps_the_state(robot):
    problem = bn.Problem(spec_of(robot, base_costs()))
    statics = problem.quasi_static("move", problem.initial_state)
    assert statics.residual < 1e-9 and statics.force.shape == (0,)
    next_state, _ = problem.roll(0, problem.initial_state, statics.control)
    np.testing.assert_allclose(next_state, problem.initial_state, atol=1e-12)
    problem.set_torque_bias(statics.control)
    np.testing.assert_allclose(problem.quasi_static(0, problem.initial_state).control, 0.0, atol=1e-9)


def test_complaints_name_an_unreachable_target(robot):
    assert bn.complaints(bn.Problem(spec_of(robot, base_costs()))) == []
    far = spec_of(robot, [bn.CostTerm(residual.FramePosition("tool", [9.0, 0.0, 0.0]))])
    assert any("tool" in sentence for sentence in bn.complaints(bn.Problem(far)))


def test_check_steps_with_a_coarse_step_gives_a_warning(robot):
    def report_of(step):
        spec = spec_of(robot, base_costs(), knots=3)
        spec.stages[0].step = step
        problem = bn.Problem(spec)
        us = np.tile(problem.quasi_static(0, problem.initial_state).control + 3.0, (3, 1))
        xs = [problem.initial_state]
        for knot in range(3):
            xs.append(problem.roll(knot, xs[-1], us[knot])[0])
        assert bn.step_complaints(problem) == []
        return bn.check_steps(problem, np.array(xs), us)

    fine, coarse = report_of(0.001), report_of(0.3)
    assert fine.status == bn.Status.OK and not fine.coarse and fine.warning() == ""
    assert fine.position.unit == "rad" and fine.velocity.unit == "rad/s" and "largest error" in fine.text()
    assert coarse.coarse and coarse.position.error > coarse.position.limit
    assert "too coarse" in coarse.warning() and 0.0 < coarse.sufficient_step < 0.3
    with pytest.raises(bn.Error, match="check_steps: xs is 2 x"):
        problem = bn.Problem(spec_of(robot, base_costs()))
        bn.check_steps(problem, np.zeros((2, 14)), np.zeros((6, 7)))


def above_a_sphere(robot, below=0.4):
    """Returns a problem with a contact and costs that follow a sphere, its top `below` the tool [m]."""
    tool = bn.frame_placement(robot.model, robot.reference_configuration(), "tool")[:3, 3]
    ball = bn.Quadric.sphere(tool - [0.0, 0.0, 0.3 + below], 0.3)
    on = bn.Reference.on(ball, tool)
    costs = [bn.CostTerm(residual.FrameHeight("tool", on), name="height"),
             bn.CostTerm(residual.FrameInclination("tool", on, axis=[0, 0, 1]), name="incline"),
             bn.CostTerm(residual.FrameRotation("tool", [0, 0, 0, 1], on), name="turn")]
    spec = spec_of(robot, costs)
    spec.contacts = [bn.ContactSpec("pad", tool="tool", directions="z", reference=on)]
    spec.stages[0].contacts = ["pad"]
    return spec


def test_set_surface_changes_costs_and_contacts_of_a_knot(robot):
    problem = bn.Problem(above_a_sphere(robot))
    x, u = at_rest(robot), np.zeros(7)
    np.testing.assert_allclose(problem.residual(2, "height", x, u), [0.4], atol=1e-12)
    assert problem.residual(2, "incline", x, u).shape == (2,) and problem.residual(2, "turn", x, u).shape == (3,)
    tool = bn.frame_placement(robot.model, robot.reference_configuration(), "tool")[:3, 3]
    problem.set_term_surface(2, "height", bn.Quadric.plane(tool - [0.0, 0.0, 0.1], [0, 0, 1]))
    np.testing.assert_allclose(problem.residual(2, "height", x, u), [0.1], atol=1e-12)
    np.testing.assert_allclose(problem.residual(3, "height", x, u), [0.4], atol=1e-12)
    plane = bn.Quadric.plane(tool, [0, 0, 1])
    problem.set_surface(2, "pad", plane)
    problem.set_surface(2, 0, plane)
    with pytest.raises(bn.Error, match="unknown contact 'pd'; did you mean 'pad'"):
        problem.set_surface(2, "pd", plane)
    flat = bn.Problem(spec_of(robot, base_costs()))
    with pytest.raises(bn.Error, match="has no curved surface"):
        flat.set_term_surface(0, 0, plane)
    with pytest.raises(bn.Error, match="has no curved surface"):
        one_term(robot, residual.FrameHeight("tool"))


def pressing_with_an_input(robot, **entries):
    """Returns a problem whose cost 'force' has a target of 5 N, with the given entries."""
    cost = bn.CostTerm(residual.ContactForce("pad", target=5.0), name="force", **entries)
    spec = spec_of(robot, [cost], contacts=[bn.ContactSpec("pad", tool="tool", directions="z")])
    spec.stages[0].contacts = ["pad"]
    spec.inputs = [bn.InputSpec("unused", "vector", [1.0, 2.0]), bn.InputSpec("force_error")]
    return spec


def test_offset_input_moves_the_target_of_a_force(robot):
    problem = bn.Problem(pressing_with_an_input(robot, offset_input="force_error"))
    assert problem.input_names == ["unused", "force_error"] and problem.input_index("force_error") == 1
    x, u = at_rest(robot), np.ones(7)
    force = problem.forces(0, x, u)
    np.testing.assert_allclose(problem.residual(3, "force", x, u), force - 5.0)
    assert problem.input_at("force_error", 3).shape == (0,)
    problem.set_input("force_error", -2.0)
    np.testing.assert_allclose(problem.residual(3, "force", x, u), force - 3.0)
    np.testing.assert_array_equal(problem.input_at(1, 3), [-2.0])
    problem.set_input(1, [1.0], decaying=[4.0], decay_time=0.02)
    for knot in range(problem.knots):
        offset = 1.0 + 4.0 * math.exp(-problem.time_of(knot) / 0.02)
        np.testing.assert_allclose(problem.input_at("force_error", knot), [offset])
        np.testing.assert_allclose(problem.residual(knot, "force", x, u), force - 5.0 - offset)
    problem.reset_input("force_error")
    np.testing.assert_allclose(problem.residual(3, "force", x, u), force - 5.0)
    np.testing.assert_array_equal(problem.input_at("unused", problem.knots), [1.0, 2.0])


def test_input_with_a_function_of_time_has_its_value_at_each_knot(robot):
    spec = pressing_with_an_input(robot, offset_input="force_error")
    spec.inputs[1].value = lambda time: 100.0 * time
    problem = bn.Problem(spec)
    np.testing.assert_allclose([problem.input_at("force_error", k)[0] for k in range(7)], np.arange(7.0))
    assert problem.spec.inputs[1].kind is bn.InputKind.SCALAR
    problem.set_input("force_error", 3.0)
    np.testing.assert_array_equal(problem.input_at("force_error", 4), [3.0])


def test_surface_input_replaces_the_surface_of_a_cost(robot):
    spec = above_a_sphere(robot)
    spec.inputs = [bn.InputSpec("surface", "surface")]
    spec.stages[0].costs[0].surface_input = "surface"
    spec.contacts[0].surface_input = "surface"
    problem = bn.Problem(spec)
    x, u = at_rest(robot), np.zeros(7)
    tool = bn.frame_placement(robot.model, robot.reference_configuration(), "tool")[:3, 3]
    np.testing.assert_allclose(problem.residual(2, "height", x, u), [0.4], atol=1e-12)
    problem.set_input("surface", bn.Quadric.plane(tool - [0.0, 0.0, 0.1], [0, 0, 1]))
    np.testing.assert_allclose(problem.residual(2, "height", x, u), [0.1], atol=1e-12)
    problem.reset_input("surface")
    np.testing.assert_allclose(problem.residual(2, "height", x, u), [0.4], atol=1e-12)
    with pytest.raises(bn.Error, match="Problem.set_input: depth is -0.1 m; wanted at least 0 m"):
        problem.set_input("surface", bn.Quadric.plane(tool, [0, 0, 1]), depth=-0.1)
    with pytest.raises(bn.Error, match="Problem.set_input: .*not symmetric"):
        problem.set_input("surface", bn.Quadric([[1, 2, 0], [0, 1, 0], [0, 0, 1]], [0, 0, 1], 0.0))


def test_surface_input_moves_a_target_position_into_the_surface(robot):
    tool = bn.frame_placement(robot.model, robot.reference_configuration(), "tool")[:3, 3]
    spec = spec_of(robot, [bn.CostTerm(residual.FramePosition("tool", tool), name="point", surface_input="ground")])
    spec.inputs = [bn.InputSpec("ground", bn.InputKind.SURFACE)]
    problem = bn.Problem(spec)
    x, u = at_rest(robot), np.zeros(7)
    problem.set_input("ground", bn.Quadric.plane(tool, [0, 0, 2]), depth=0.02)
    np.testing.assert_allclose(problem.residual(1, "point", x, u), [0.0, 0.0, 0.02], atol=1e-12)


def test_inertia_input_matches_set_payload(robot):
    spec = spec_of(robot, base_costs())
    spec.inputs = [bn.InputSpec("load", "inertia", frame="tool")]
    loaded, other, empty = bn.Problem(spec), bn.Problem(spec), bn.Problem(spec)
    brick = bn.InertiaSpec(1.5, com=[0.0, 0.02, 0.05])
    loaded.set_input("load", brick)
    other.set_payload("tool", brick)
    x, u = at_rest(robot), np.ones(7)
    acceleration = loaded.acceleration(0, x, u)
    np.testing.assert_array_equal(acceleration, other.acceleration(0, x, u))
    assert np.abs(acceleration - empty.acceleration(0, x, u)).max() > 1e-3
    loaded.reset_input("load")
    np.testing.assert_allclose(loaded.acceleration(0, x, u), empty.acceleration(0, x, u), atol=1e-12)
    with pytest.raises(bn.Error, match="Problem.set_input: the mass is -1"):
        loaded.set_input("load", bn.InertiaSpec(-1.0))


def test_invalid_inputs_raise_errors(robot):
    spec = pressing_with_an_input(robot, offset_input="force_error")
    problem = bn.Problem(spec)
    plane = bn.Quadric.plane([0.0, 0.0, 0.0], [0, 0, 1])
    with pytest.raises(bn.Error, match="unknown input 'force_eror'; did you mean 'force_error'"):
        problem.set_input("force_eror", 1.0)
    with pytest.raises(bn.Error, match="Problem.set_input: input 2 does not exist; wanted 0 to 1"):
        problem.set_input(2, 1.0)
    with pytest.raises(bn.Error, match="input 'force_error' is a scalar; wanted a surface"):
        problem.set_input("force_error", plane)
    with pytest.raises(bn.Error, match="Problem.set_input: value has 2 entries; wanted 1"):
        problem.set_input("force_error", [1.0, 2.0])
    with pytest.raises(bn.Error, match="Problem.set_input: decay_time is missing"):
        problem.set_input("force_error", 1.0, [2.0])
    with pytest.raises(bn.Error, match="Problem.set_input: decay_time is .*wanted a positive number"):
        problem.set_input("force_error", 1.0, 2.0, 0.0)
    with pytest.raises(bn.EvaluationError, match="Problem.set_input: .*NaN"):
        problem.set_input("force_error", math.nan)
    with pytest.raises(bn.Error, match="Problem.input_at: knot 7 does not exist; wanted 0 to 6"):
        problem.input_at("force_error", 7)
    with pytest.raises(bn.Error, match="stage 'move'.*'force'.*unknown input 'force_eror'; did you mean"):
        bn.Problem(pressing_with_an_input(robot, offset_input="force_eror"))
    with pytest.raises(bn.Error, match="Problem.reset_input: input 0 does not exist; the problem has no inputs"):
        bn.Problem(spec_of(robot, base_costs())).reset_input(0)
    spec.inputs[0].name = "force_error"
    with pytest.raises(bn.Error, match="input 'force_error': the name is used twice"):
        bn.Problem(spec)


def test_complaints_with_a_start_off_its_surface_name_the_distance(robot):
    assert bn.complaints(bn.Problem(above_a_sphere(robot, 0.0))) == []
    off = bn.complaints(bn.Problem(above_a_sphere(robot, 0.02)))
    assert len(off) == 1 and "0.02 m above the surface of contact 'pad'" in off[0], off
    assert "m below the surface" in bn.complaints(bn.Problem(above_a_sphere(robot, -0.01)))[0]


def test_check_problem_reports_progress_and_passes_exceptions_on(robot):
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


def test_problem_in_use_by_one_thread_refuses_another(robot):
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


def test_constraints_give_rows_with_limits_and_a_report(robot):
    spec = spec_of(robot, base_costs())
    spec.stages[0].constraints = [
        bn.ocp.Constraint(residual.JointVelocity(), name="slowly", lower=-0.5, upper=0.5)]
    spec.terminal_constraints = [
        bn.ocp.Constraint(residual.JointVelocity(), name="stopped", lower=0.0, upper=0.0)]
    problem = bn.Problem(spec)
    names = problem.row_names(0)
    assert names[0].startswith("slowly/") and len(names) == robot.model.nv
    np.testing.assert_array_equal(problem.row_upper(0), np.full(robot.model.nv, 0.5))
    x = problem.initial_state.copy()
    x[-robot.model.nv:] = 0.25
    np.testing.assert_allclose(problem.row_values(0, x, np.zeros(robot.model.nv)), 0.25)
    solver = bn.DdpSolver(problem)
    summary = solver.solve()
    assert summary.reason == bn.StopReason.CONVERGED and summary.violation_knot == -1
    assert np.abs(solver.xs[:, -robot.model.nv:]).max() <= 0.5 * (1 + 1e-6)
    assert np.abs(solver.xs[-1, -robot.model.nv:]).max() <= 1e-6 * max(robot.model.velocity_limit)
    report = solver.cost_report()
    rows = {row.name: row for row in report.rows}
    assert set(names) < set(rows)
    assert rows["stopped/" + names[0].split("/")[1]].upper == 0.0
    assert len(report.limits) == sum(row.active for row in report.rows) > 0
    for limit in report.limits:
        row = problem.row_names(limit.knot).index(limit.row)
        assert limit.multiplier == solver.multipliers(limit.knot)[row] != 0.0
        assert limit.value == pytest.approx(limit.upper if limit.multiplier > 0.0 else limit.lower, abs=1e-6)
