"""Model predictive control from Python."""

from __future__ import annotations

import copy
import math
import os
import pickle
import signal
import threading

import numpy as np
import pytest

import burnish
from burnish import FaultKind, Reference, SchedulePhase, Status, Touch, residual

TILTED = [0.2, -0.1, 1.0]


class Press:
    """Arm that approaches a board and presses; attributes hold the parts that tests change."""

    def __init__(self, solver=None):
        self.robot = burnish.load_robot("arm7")
        self.q = self.robot.posture("ready")
        tip = burnish.TouchSpec("tool")
        tip = burnish.with_surface_at(self.robot.model, self.q, TILTED, tip, clearance=0.003)
        self.scene = burnish.SceneSpec([tip])
        surface = burnish.Reference.surface_with_normal(TILTED)
        self.axes = np.asarray(surface.rotation)
        self.n = self.axes[:, 2]
        self.start = tip.surface.point + tip.radius * self.n
        rest = np.concatenate([self.q, np.zeros(self.robot.model.nv)])
        board = burnish.ContactSpec("board", tool="tool", reference=surface, directions="z")
        state = burnish.CostTerm(residual.State(rest), weight=0.1)
        torque = burnish.CostTerm(residual.Control(), weight=1e-4)
        across = burnish.CostTerm(residual.FramePosition("tool", self.start, Reference.world(self.axes)), 1e4,
                                  weights=[1, 1, 0])
        down = burnish.CostTerm(
            residual.FrameVelocity("tool", Reference.centered(self.axes), [0, 0, -0.02, 0, 0, 0]), 1e2,
            weights=[0, 0, 1, 0, 0, 0])
        force = burnish.CostTerm(residual.ContactForce("board", target=self.push))
        self.spec = burnish.MpcSpec(
            problem=burnish.ProblemSpec(
                self.robot.model,
                contacts=[board.with_gains(0.0, 40.0)],
                stages=[burnish.Stage("approach", costs=[state, torque, across, down]),
                        burnish.Stage("press", contacts=["board"],
                                      costs=[state, torque, across, force])],
                terminal=[state, across],
                horizon=[burnish.HorizonSegment("approach", 20)],
                initial_state=rest,
            ),
            schedule=[SchedulePhase("approach", "approach", 0.15, until="contact"),
                      SchedulePhase("press", "press")],
            task=burnish.PressingTask([Touch.DUE, Touch.WANTED], self.target),
            tools=[burnish.ToolSpec("tool", normal_base=TILTED)],
            tick_period=1e-3,
            update_period=5e-3,
            model_error=burnish.ModelErrorOptions(bandwidth=100.0),
        )
        if solver is not None:
            self.spec.solver = self.spec.solver.replace(**solver)

    def push(self, t):
        return 0.0 if t < 0.15 else 10.0

    def target(self, t):
        return burnish.TaskTarget(self.start, self.push(t))

    def plant(self):
        real = burnish.Disturbances(mass_scale=1.03)
        return burnish.make_ideal_plant(burnish.plant_model(self.robot.model, real), self.scene)

    def loop(self, controller=None, plant=None, **options):
        controller = burnish.MpcController(self.spec) if controller is None else controller
        loop = burnish.ClosedLoop(self.plant() if plant is None else plant, controller, None,
                                  burnish.ClosedLoopOptions(**options))
        loop.reset(self.q)
        return loop


@pytest.fixture
def press():
    return Press()


def rows(loop):
    """Returns all columns of the trace except measured times."""
    array = loop.trace.array()
    return {name: array[name].tobytes() for name in loop.trace.columns if name != "solve_time"}


def test_press_reaches_the_force_and_repeats_the_same_bits(press):
    loop = press.loop()
    assert loop.run(0.6) == Status.OK
    controller = loop.controller
    assert controller.fault().kind == FaultKind.NONE and len(controller.fault().last_second) == 0
    force = np.array([loop.trace[f"tool_force_{axis}_world"][-1] for axis in "xyz"])
    assert abs(force @ press.n - 10.0) < 0.2
    assert abs(np.linalg.norm(loop.plant.wrenches[:3, 0]) - np.linalg.norm(force)) < 1e-9
    assert loop.trace["phase"][0] == 0
    assert loop.trace["phase"][-1] == 1 and loop.command.tools[0].target_force == 10.0
    first = rows(loop)
    loop.reset(press.q)
    loop.run(0.6)
    assert rows(loop) == first
    other = Press(solver={"threads": 2}).loop()
    other.run(0.6)
    assert rows(other) == first


def test_controller_exposes_plan_feedback_and_estimates(press):
    loop = press.loop()
    loop.run(0.5)
    controller = loop.controller
    assert isinstance(controller, burnish.Controller) and controller.nv == 7
    assert controller.touches == controller.tools == ["tool"] and loop.measurement.wrenches.shape == (6, 1)
    feedback = controller.feedback()
    assert feedback.feedforward.shape == (7,) and feedback.gain.shape == (7, 14)
    assert feedback.state.shape == (14,) and np.any(feedback.gain != 0.0)
    # The command is this policy at the measured state, which is near the planned one.
    x = np.concatenate([loop.measurement.q, loop.measurement.v])
    policy = feedback.feedforward + feedback.gain @ (x - feedback.state)
    assert np.allclose(policy, loop.command.tau, atol=1e-9)
    plan = controller.plan()
    assert plan.shape == (21, 14) and np.allclose(plan[0], x, atol=0.05)
    assert 0.1 < np.abs(controller.torque_error).max() < 5.0 and list(controller.force_error) == [0.0]
    costs = controller.plan_costs(0)
    assert list(costs) == ["state", "control", "frame position", "contact force"]
    assert controller.problem.term_names(0)[-1] == "frame velocity", "the specified horizon starts with the approach"
    assert all(cost >= 0.0 for cost in costs.values())
    with pytest.raises(burnish.Error, match="knot 21"):
        controller.plan_costs(21)
    schedule = controller.schedule
    assert schedule.phase == 1 and schedule.phases == press.spec.schedule
    schedule.reset()
    assert controller.schedule.phase == 1, "a copy must not change"
    assert controller.spec.update_period == 5e-3
    assert controller.spec.task.target == press.target
    assert controller.spec.problem.stages[1].contacts == ["board"]
    controller.reset()
    assert controller.schedule.time == 0.0


def test_tick_matches_the_command_of_the_loop(press):
    controller = burnish.MpcController(press.spec)
    loop = press.loop()
    loop.step()
    command = controller.tick(loop.measurement)
    assert command.replace(solve_time=0.0) == loop.command.replace(solve_time=0.0)
    assert command.iterations > 1 and command.solve_time > 0.0
    bad = loop.measurement.replace(time=1e-3, q=np.full(7, np.nan))
    again = controller.tick(bad)
    assert again.status != Status.OK and np.all(np.isfinite(again.tau))


def test_payload_of_a_loop_reaches_the_controller(press):
    brick = burnish.InertiaSpec(mass=2.0, com=[0.0, 0.0, 0.05], inertia_at_com=2e-3 * np.eye(3))
    torques = []
    for payload in (None, brick):
        loop = press.loop()
        if payload is not None:
            loop.set_payload("tool", payload)
        loop.step()
        torques.append(loop.command.tau)
    assert np.abs(torques[1] - torques[0]).max() > 1.0
    with pytest.raises(burnish.Error, match="ClosedLoop.set_payload: the mass is -1"):
        loop.set_payload("tool", burnish.InertiaSpec(mass=-1.0))
    with pytest.raises(burnish.Error, match="tool"):
        loop.set_payload("tole", brick)


def test_fault_is_reported_and_pickles_unchanged(press):
    press.spec.task.limits.force = 3.0
    loop = press.loop()
    loop.run(0.5)
    fault = loop.controller.fault()
    assert fault.kind == FaultKind.FORCE_LIMIT and fault.limit == 3.0 and fault.value > 3.0
    assert fault.text().startswith(f"force limit at {fault.time:.4f} s")
    record = fault.last_second
    assert math.isclose(record["time"][-1], fault.time) and len(record) > 50
    back = pickle.loads(pickle.dumps(fault))
    assert back == fault and copy.deepcopy(fault) == fault
    loop.controller.reset()
    assert len(record) > 50, "a copy must not change"
    assert loop.controller.fault().kind == FaultKind.NONE


class Broken(Exception):
    pass


def test_exception_in_target_ends_the_run(press):
    def target(t):
        if t > 0.1:
            raise Broken("no such target")
        return press.target(t)

    press.spec.task.target = target
    loop = press.loop()
    with pytest.raises(Broken, match="no such target"):
        loop.run(5.0)
    assert np.flatnonzero(loop.trace["status"]).tolist() == [len(loop.trace) - 1]
    assert loop.command.status == Status.NOT_EVALUATED
    assert loop.controller.fault().kind == FaultKind.NONE
    assert np.all(np.isfinite(loop.command.tau))
    with pytest.raises(Broken):
        loop.run(0.01)


@pytest.mark.parametrize("threads", [1, 2])
def test_exception_in_residual_fails_the_update(press, threads):
    """The run may continue: the last plan bridges failed updates until a fault."""

    class Throwing:
        rows = 1

        def value(self, at):
            if at.time > 0.3:
                raise Broken("no such entry")
            return at.q[:1]

    press.spec.solver.threads = threads
    for stage in press.spec.problem.stages:
        stage.costs = stage.costs + [
            burnish.CostTerm(residual.custom(Throwing()), 1e-6, name="throwing")]
    loop = press.loop()
    raised = 0
    while loop.controller.fault().kind == FaultKind.NONE:
        try:
            loop.run(1e-3)
        except Broken:
            raised += 1
        assert loop.plant.time < 1.0
    assert raised >= press.spec.limits.failed_solves
    assert loop.controller.fault().kind == FaultKind.SOLVER_FAILED
    assert 0.1 < loop.controller.fault().time < 0.2  # when the end of the horizon approaches 0.3 s
    assert loop.run(0.1) == Status.OK, "the fallback must keep the robot in place"


def test_exception_in_signal_at_the_first_solve_reaches_the_caller(press):
    class Wild:
        calls = 0

        def __call__(self, t):
            self.calls += 1
            if self.calls > 40:
                raise Broken("no signal")
            return 10.0

    press.spec.problem.stages[1].costs[3].residual.target = Wild()
    press.spec.schedule = [SchedulePhase("track", "press")]
    press.spec.task.touch = ["wanted"]
    with pytest.raises(Broken, match="no signal"):
        burnish.MpcController(press.spec).tick(
            burnish.Measurement(0.0, press.q, np.zeros(7), np.zeros(7)))
        press.loop().run(1.0)


def test_target_of_wrong_type_raises_with_its_value(press):
    press.spec.task.target = lambda t: 3.0
    with pytest.raises(burnish.Error, match="gave 3.0 at 0.0 s; wanted a TaskTarget"):
        press.loop().run(0.1)
    press.spec.task.target = 3.0
    with pytest.raises(burnish.Error, match=r"PressingTask.target: got 3.0; wanted Callable"):
        burnish.MpcController(press.spec)


def test_invalid_spec_raises_with_the_reason(press):
    for changes, sentence in (
        ({"task": press.spec.task.replace(target=None)}, "target is empty"),
        ({"task": press.spec.task.replace(touch=[])}, "0 entries; wanted 2"),
        ({"task": None}, "waits for 'contact', which is not an event of its task"),
        ({"update_period": 7.5e-4}, "multiple of tick_period"),
        ({"tools": [burnish.ToolSpec("tol")]}, "did you mean 'tool'"),
        ({"tools": []}, "contact 'board' of stage 'press' is neither at a tool nor a support"),
        ({"schedule": [], "task": None}, "no phases"),
        ({"solver_delay": 1.0}, "solver_delay is 1 s"),
        ({"tools": [burnish.ToolSpec(normal_base=[0, 0, 0])]}, "normal"),
    ):
        with pytest.raises(burnish.Error, match=sentence):
            burnish.MpcController(press.spec.replace(**changes))
    with pytest.raises(burnish.Error, match="MpcSpec.tick_period: got 'fast'; wanted a number"):
        burnish.MpcController(press.spec.replace(tick_period="fast"))
    with pytest.raises(burnish.Error, match="SafetyLimits.bad: got None"):
        burnish.MpcController(press.spec.replace(limits=burnish.SafetyLimits(bad=None)))


def test_python_plant_gives_the_same_bits(press):
    class Wrapped(burnish.Plant):
        def __init__(self, inner):
            self.inner = inner
            self.model, self.scene, self.dt = inner.model, inner.scene, inner.dt

        def reset(self, q, v=None):
            self.inner.reset(q, v)
            self.take()

        def step(self, tau):
            self.inner.step(tau)
            self.take()

        def take(self):
            for name in ("q", "v", "time", "wrenches", "friction_torque"):
                setattr(self, name, getattr(self.inner, name))

    ours, theirs = press.loop(plant=Wrapped(press.plant())), press.loop()
    ours.run(0.3), theirs.run(0.3)
    assert rows(ours) == rows(theirs) and ours.trace["in_contact"].any()


def test_loop_keeps_plant_and_controller_alive(press):
    loop = press.loop()
    loop.run(0.01)
    expected = press.loop()
    expected.run(0.02)
    del press  # the loop has the only references to its plant and controller
    loop.run(0.01)
    assert rows(loop) == rows(expected)


def test_ctrl_c_ends_a_run(press):
    loop = press.loop()
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        loop.run(1e6)
    timer.join()


def test_schedule_waits_for_contact():
    schedule = burnish.Schedule([
        SchedulePhase("near", "a", 0.5, until="contact", hold=0.1),
        SchedulePhase("far", "b")])
    assert schedule.events == ["contact"]
    assert schedule.start_of(1) == 0.5 and schedule.phase_at(0.6) == 1
    for _ in range(60):
        moved = schedule.advance(0.01, False)
    assert moved and schedule.waits and math.isclose(schedule.time, 0.4)
    assert schedule.advance(0.01, True) and schedule.phase == 1
    assert math.isclose(schedule.time, 0.5)
    schedule.jump_to(0)
    assert schedule.time == 0.0
    kept = copy.copy(schedule)
    schedule.advance(0.1, False)
    assert kept.time == 0.0
    with pytest.raises(burnish.Error):
        burnish.Schedule([])
    for index in (-1, 2):
        with pytest.raises(burnish.Error, match="no phase"):
            schedule.start_of(index)


def test_observer_estimates_a_constant_torque_error(press):
    """At rest with the gravity torque plus 2 Nm at one joint, the estimated error is -2 Nm there."""
    model, q = press.robot.model, press.q
    observer = burnish.TorqueErrorObserver(
        model, options=burnish.ModelErrorOptions(bandwidth=50.0))
    dynamics = burnish.ContactDynamics(model, [])
    zero = np.zeros(model.nv)
    dynamics.forward(q, zero, zero)
    tau = np.array(dynamics.bias)
    tau[3] += 2.0
    for i in range(2000):
        observer.update(q, zero, tau, np.zeros(3), 1e-3)
    wanted = zero.copy()
    wanted[3] = -2.0
    assert np.allclose(observer.torque_error, wanted, atol=1e-6)
    with pytest.raises(burnish.EvaluationError, match="TorqueErrorObserver.update"):
        observer.update(q, zero, tau[:2], np.zeros(3), 1e-3)
    observer.reset()
    assert not np.any(observer.torque_error)
    with pytest.raises(burnish.Error, match="bandwidth"):
        burnish.TorqueErrorObserver(model, options=burnish.ModelErrorOptions(bandwidth=-1.0))


def test_feedback_plan_interpolates_states_and_applies_gains(press):
    problem = burnish.Problem(press.spec.problem)
    solver = burnish.DdpSolver(problem, press.spec.solver.replace(max_iterations=50))
    plan = burnish.FeedbackPlan(problem, 5, 0.01)
    assert plan.empty and plan.knots == 5
    with pytest.raises(burnish.Error, match="no plan"):
        plan.at(0.0)
    solver.solve()
    plan.load(solver, 2.0)
    assert plan.start == 2.0 and not plan.empty
    feedback = plan.at(2.013)
    assert np.array_equal(feedback.feedforward, solver.us[1])
    assert np.array_equal(feedback.gain, solver.gain(1))
    assert np.allclose(feedback.state, 0.7 * solver.xs[1] + 0.3 * solver.xs[2], atol=1e-12)
    x = solver.xs[1] + 0.01
    wanted = feedback.feedforward + feedback.gain @ (x - feedback.state)
    assert np.allclose(plan.control(2.013, x), wanted)
    with pytest.raises(burnish.Error, match="3 entries; wanted 14"):
        plan.control(2.0, [1.0, 2.0, 3.0])
    small = burnish.Problem(press.spec.problem.replace(
        horizon=[burnish.HorizonSegment("approach", 2)]))
    with pytest.raises(burnish.Error, match="another problem"):
        plan.load(burnish.DdpSolver(small), 0.0)
    uneven = burnish.FeedbackPlan(problem, [0.01, 0.02, 0.04])
    uneven.load(solver, 1.0)
    assert uneven.knots == 3 and np.isclose(uneven.time_of(3), 1.07)
    assert np.array_equal(uneven.at(1.02).gain, solver.gain(1))
    with pytest.raises(burnish.Error, match="wanted 0 to 3"):
        uneven.time_of(4)
    with pytest.raises(burnish.Error, match="no steps"):
        burnish.FeedbackPlan(problem, [])
    del problem
    assert plan.at(2.0).gain.shape == (7, 14)
