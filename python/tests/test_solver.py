"""The solver in Python: results, callbacks, exceptions, threads, Ctrl-C, time budgets."""

import _thread
import gc
import math
import pickle
import threading
import time
import weakref

import numpy as np
import pytest

import burnish as bn
from burnish import residual


@pytest.fixture(scope="module")
def robot():
    return bn.load_robot("arm7")


def reaching(robot, goal=(0.55, -0.15, 0.35), knots=40, reach=None, **entries):
    term = reach if reach is not None else residual.FramePosition("tool", goal)
    return bn.ProblemSpec(
        robot.model,
        initial_state=np.concatenate([robot.reference_configuration(), np.zeros(robot.model.nv)]),
        stages=[
            bn.Stage("move", costs=[bn.CostTerm(residual.State(), 0.1), bn.CostTerm(residual.Control(), 1e-4)])
        ],
        horizon=[bn.HorizonSegment("move", knots)],
        terminal=[bn.CostTerm(term, 1e4, "reach"), bn.CostTerm(residual.JointVelocity(), 1e2)],
        **entries,
    )


def solved(spec, **options):
    solver = bn.DdpSolver(bn.Problem(spec), bn.DdpOptions(**options))
    solver.solve()
    return solver


@pytest.mark.parametrize("update", list(bn.StepUpdate))
def test_solve_converges_and_reports_it(robot, update):
    problem = bn.Problem(reaching(robot))
    solver = bn.DdpSolver(problem, bn.DdpOptions(update=update))
    summary = solver.solve()
    assert summary.reason is bn.StopReason.CONVERGED and summary.feasible
    assert summary.iterations == len(summary.log) > 1 and summary.log[-1].iteration == summary.iterations
    assert summary.options.update is update and summary.options.callback is None
    assert solver.summary.cost == summary.cost and summary.seconds.total > 0.0
    assert solver.optimality_error() < 1e-4
    assert solver.text() == summary.text(problem) and "onverged" in solver.text()
    values = problem.evaluate(solver.xs, solver.us)
    assert values.cost == pytest.approx(summary.cost, rel=1e-12)
    np.testing.assert_allclose(values.next_states, solver.xs[1:], atol=1e-8)
    report = solver.cost_report()
    assert report.total == pytest.approx(summary.cost) and len(report.knots) == 41
    assert {t.name for t in report.terms} == {"state", "control", "reach", "joint velocity"}
    assert "reach" in report.text()


def test_solver_arrays_are_copies(robot):
    solver = solved(reaching(robot))
    xs, gain = solver.xs, solver.gain(0)
    xs[:], gain[:] = 0.0, 0.0
    assert solver.xs.any() and solver.gain(0).any()
    kept = solver.xs
    del solver
    gc.collect()
    assert np.isfinite(kept).all()


def test_gains_match_the_value_function(robot):
    solver = solved(reaching(robot))
    problem = solver.problem
    e = problem.expand(solver.xs, solver.us)
    nu = problem.max_controls
    for k in (39, 20, 0):
        F, H = e.dynamics[k], e.hessians[k]
        Q = H + F.T @ solver.value_hessian(k + 1) @ F
        q = e.gradients[k] + F.T @ solver.value_gradient(k + 1)
        np.testing.assert_allclose(solver.gain(k), -np.linalg.solve(Q[:nu, :nu], Q[:nu, nu:]),
                                   rtol=1e-5, atol=1e-5 * np.abs(solver.gain(k)).max())
        assert np.abs(q[:nu]).max() < 1e-3
        np.testing.assert_allclose(solver.feedforward(k), 0.0, atol=2e-3)
    gain, value = solver.named_gain(3), solver.named_value_hessian(40)
    assert gain.rows == problem.control_names and gain.columns == problem.state_names
    np.testing.assert_array_equal(gain.values, solver.gain(3))
    assert value.rows == value.columns == problem.state_names
    np.testing.assert_array_equal(value.values, solver.value_hessian(40))
    with pytest.raises(bn.Error, match="DdpSolver.gain: knot 40 does not exist; wanted 0 to 39"):
        solver.gain(40)
    with pytest.raises(bn.Error, match="DdpSolver.value_gradient: knot -1 does not exist; wanted 0 to 40"):
        solver.value_gradient(-1)


@pytest.mark.parametrize("update", list(bn.StepUpdate))
def test_solve_with_one_or_two_threads_gives_the_same_bits(robot, update):
    one, two = (solved(reaching(robot), threads=threads, update=update) for threads in (1, 2))
    np.testing.assert_array_equal(one.xs, two.xs)
    np.testing.assert_array_equal(one.us, two.us)
    np.testing.assert_array_equal(one.gain(0), two.gain(0))


class Reach:
    name, rows, frames = "own", 3, ["tool"]

    def __init__(self, goal, jacobian=True):
        self.goal = np.asarray(goal)
        if not jacobian:
            self.jacobian = None

    def value(self, at):
        return at.placement(0)[:3, 3] - self.goal

    def jacobian(self, at):
        out = np.zeros((3, at.layout.nz))
        out[:, at.layout.column_q : at.layout.column_v] = at.jacobian(0, "centered")[:3]
        return out


def test_custom_residual_gives_the_trajectory_of_the_built_in_one(robot):
    goal = (0.55, -0.15, 0.35)
    built_in = solved(reaching(robot, goal))
    for jacobian in (True, False):
        for threads in (1, 2):
            own = solved(reaching(robot, reach=residual.custom(Reach(goal, jacobian))), threads=threads)
            assert own.summary.reason is bn.StopReason.CONVERGED
            assert own.summary.cost == pytest.approx(built_in.summary.cost, rel=1e-9)
            np.testing.assert_allclose(own.xs, built_in.xs, atol=1e-5)


def test_custom_residuals_at_all_knots_work_in_threads(robot):
    goal = (0.55, -0.15, 0.35)
    spec = reaching(robot)
    spec.stages[0].costs.append(bn.CostTerm(residual.custom(Reach(goal)), 10.0))
    one, two = solved(spec, threads=1), solved(spec, threads=2)
    np.testing.assert_array_equal(one.xs, two.xs)
    spec.stages[0].costs[-1].residual = residual.FramePosition("tool", goal)
    np.testing.assert_allclose(one.xs, solved(spec).xs, atol=1e-6)


def test_pickled_problem_solves_to_the_same_bits(robot):
    spec = reaching(robot, reach=residual.custom(Reach((0.5, 0.0, 0.4))))
    first, second = solved(spec), solved(pickle.loads(pickle.dumps(spec)))
    assert first.summary.cost == second.summary.cost
    np.testing.assert_array_equal(first.xs, second.xs)
    summary = pickle.loads(pickle.dumps(first.summary))
    assert summary == first.summary


# Callbacks and exceptions


def test_callback_gets_every_iteration_and_may_stop(robot):
    seen = []
    solver = solved(reaching(robot), callback=seen.append)  # returns None, so the solve continues
    assert solver.summary.reason is bn.StopReason.CONVERGED
    assert [p.iteration for p in seen] == list(range(1, solver.summary.iterations + 1))
    assert seen == solver.summary.log
    assert solver.options.callback == seen.append
    solver = solved(reaching(robot), callback=lambda p: p.iteration < 2)
    assert solver.summary.reason is bn.StopReason.CALLBACK and solver.summary.iterations == 2


class Mine(Exception):
    pass


def test_callback_exception_reaches_the_caller(robot):
    def callback(progress):
        raise Mine(progress.iteration)

    solver = bn.DdpSolver(bn.Problem(reaching(robot)), bn.DdpOptions(callback=callback))
    with pytest.raises(Mine, match="1"):
        solver.solve()
    solver.set_options(bn.DdpOptions())
    assert solver.solve().reason is bn.StopReason.CONVERGED


@pytest.mark.parametrize("threads", [1, 2])
def test_residual_exception_in_any_thread_reaches_the_caller(robot, threads):
    calls, broken = [], [True]

    class Broken(Reach):
        def value(self, at):
            calls.append(threading.get_ident())
            if broken[0] and len(calls) > 100:
                raise Mine("in the middle")
            return super().value(at)

    spec = reaching(robot)
    spec.stages[0].costs.append(bn.CostTerm(residual.custom(Broken((0.5, 0.0, 0.4)))))
    solver = bn.DdpSolver(bn.Problem(spec), bn.DdpOptions(threads=threads))
    for _ in range(2):
        with pytest.raises(Mine, match="in the middle") as caught:
            solver.solve()
        assert any("value" in str(entry) for entry in caught.traceback)
    broken[0] = False
    assert solver.solve().reason is bn.StopReason.CONVERGED


def test_residual_of_wrong_size_in_a_solve_raises(robot):
    count = [0]

    class Broken(Reach):
        def value(self, at):
            count[0] += 1
            return super().value(at)[: 3 if count[0] < 20 else 2]

    with pytest.raises(bn.Error, match=r"residual 'own': value gave an array of shape \(2,\); wanted \(3,\)"):
        solved(reaching(robot, reach=residual.custom(Broken((0.5, 0.0, 0.4)))))


def test_nan_residual_ends_the_solve_with_a_reason(robot):
    spec = reaching(robot, reach=residual.Custom("nothing", 1, value=lambda at: math.nan))
    summary = solved(spec).summary
    assert summary.reason is bn.StopReason.NOT_EVALUATED and summary.status is bn.Status.NOT_FINITE
    assert summary.knot == 40 and summary.term == 0
    assert "reach" in summary.text(bn.Problem(spec))


def long_options(**more):
    """Returns options with which a solve would take minutes."""
    return bn.DdpOptions(max_iterations=10**6, stop_tolerance=1e-300, gap_tolerance=1e-300, **more)


def test_ctrl_c_ends_a_solve(robot):
    solver = bn.DdpSolver(
        bn.Problem(reaching(robot, knots=200)),
        long_options(line_search=bn.LineSearch(halvings=0, rounding=1e-3)),
    )
    finished = []
    timer = threading.Timer(0.3, _thread.interrupt_main)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        finished.append(solver.solve())
        timer.join()
        time.sleep(1.0)
    assert not finished
    solver.set_options(bn.DdpOptions(max_iterations=1))
    solver.solve()


def test_time_budget_ends_the_solve(robot):
    solver = bn.DdpSolver(bn.Problem(reaching(robot)))
    solver.set_time_budget(0.0)
    assert solver.options.time_budget == 0.0
    summary = solver.solve()
    assert summary.reason is bn.StopReason.TIME_BUDGET and math.isfinite(summary.cost)
    solver.set_time_budget(math.inf)
    solver.set_max_iterations(2)
    assert solver.solve().reason is bn.StopReason.MAX_ITERATIONS


# Threads and lifetimes


def test_solve_lets_other_threads_run(robot):
    stamps, over = [], threading.Event()

    def count():
        while not over.is_set():
            stamps.append(time.monotonic())
            time.sleep(0.001)

    solver = bn.DdpSolver(
        bn.Problem(reaching(robot, knots=200)),
        long_options(time_budget=0.5, line_search=bn.LineSearch(halvings=0, rounding=1e-3)),
    )
    thread = threading.Thread(target=count)
    thread.start()
    began = time.monotonic()
    reason = solver.solve().reason
    ended = time.monotonic()
    over.set()
    thread.join()
    assert reason is bn.StopReason.TIME_BUDGET
    assert any(began + 0.1 < stamp < ended - 0.1 for stamp in stamps)


def test_solvers_in_two_threads_are_independent(robot):
    goals = [(0.5, 0.1, 0.4), (0.4, -0.2, 0.3)]
    reaches = [residual.FramePosition("tool", goals[0]), residual.custom(Reach(goals[1]))]
    expected = [solved(reaching(robot, reach=reach)) for reach in reaches]
    solvers = [bn.DdpSolver(bn.Problem(reaching(robot, reach=reach))) for reach in reaches]
    guess = bn.make_guess(solvers[0].problem, bn.WarmStart("still"))
    barrier, reasons = threading.Barrier(2), []

    def work(solver):
        for _ in range(3):
            solver.set_guess(guess.xs, guess.us)
            barrier.wait(20.0)
            reasons.append(solver.solve().reason)

    threads = [threading.Thread(target=work, args=(solver,)) for solver in solvers]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(60.0)
    assert reasons == [bn.StopReason.CONVERGED] * 6
    for solver, alone in zip(solvers, expected):
        np.testing.assert_array_equal(solver.xs, alone.xs)


def test_solver_and_problem_are_locked_during_a_solve(robot):
    answers = []

    def callback(progress):
        for call in (solver.solve, lambda: solver.xs, lambda: problem.advance("move"),
                     lambda: other.solve(), lambda: solver.set_time_budget(1.0)):
            try:
                call()
            except bn.Error as error:
                answers.append(str(error))
        return False

    problem = bn.Problem(reaching(robot))
    other = bn.DdpSolver(problem)
    solver = bn.DdpSolver(problem, bn.DdpOptions(callback=callback))
    solver.solve()
    assert [a.split(":")[0] for a in answers] == [
        "DdpSolver.solve", "DdpSolver.xs", "Problem.advance", "DdpSolver.solve", "DdpSolver.set_time_budget"]
    assert other.solve().reason is bn.StopReason.CONVERGED


def test_solver_keeps_its_problem_alive(robot):
    problem = bn.Problem(reaching(robot))
    solver = bn.DdpSolver(problem)
    assert solver.problem is problem
    del problem
    gc.collect()
    assert solver.solve().reason is bn.StopReason.CONVERGED


def test_custom_residual_is_released_after_a_solve(robot):
    reach = Reach((0.5, 0.0, 0.4))
    alive = weakref.ref(reach)
    solved(reaching(robot, reach=residual.custom(reach)), threads=2)
    del reach
    gc.collect()
    assert alive() is None


# Guesses, changes between solves, options


def test_guess_of_a_solution_converges_in_one_iteration(robot):
    first = solved(reaching(robot))
    second = bn.DdpSolver(bn.Problem(reaching(robot)))
    second.set_guess(first.xs, first.us)
    assert second.solve().iterations <= 1
    with pytest.raises(bn.Error, match="guess of states is 40 x 14; wanted 41 x 14"):
        second.set_guess(first.xs[1:], first.us)
    with pytest.raises(TypeError):
        second.set_guess("xs", first.us)


def test_changed_target_and_state_take_effect_in_the_next_solve(robot):
    solver = solved(reaching(robot))
    problem = solver.problem
    problem.set_target(problem.knots, "reach", [0.4, 0.2, 0.4])
    solver.solve()
    np.testing.assert_allclose(solver.xs, solved(reaching(robot, (0.4, 0.2, 0.4))).xs, atol=1e-3)
    x = problem.initial_state
    x[0] += 0.1
    problem.set_initial_state(x)
    solver.solve()
    np.testing.assert_allclose(solver.xs[0], x, atol=1e-9)


def test_control_bounds_limit_the_solution(robot):
    free = solved(reaching(robot))
    limit = 0.8 * np.abs(free.us).max()
    bounded = solved(reaching(robot, control_lower=-limit, control_upper=limit))
    assert np.abs(bounded.us).max() <= limit < np.abs(free.us).max()
    assert bounded.summary.cost > free.summary.cost


def test_segments_give_the_gains_of_the_whole_horizon(robot):
    whole = solved(reaching(robot), max_iterations=1)
    cut = solved(reaching(robot), max_iterations=1, threads=2, segments=4, share_knots=False)
    assert cut.options.segments == 4
    scale = np.abs(whole.gain(0)).max()
    np.testing.assert_allclose(cut.gain(0), whole.gain(0), atol=1e-8 * scale)
    np.testing.assert_allclose(cut.us, whole.us, atol=1e-8 * np.abs(whole.us).max())
    with pytest.raises(bn.Error, match="1000 segments are too many for a horizon"):
        solved(reaching(robot), segments=1000)


def test_invalid_options_raise(robot):
    problem = bn.Problem(reaching(robot))
    with pytest.raises(bn.Error, match="threads"):
        bn.DdpSolver(problem, bn.DdpOptions(threads=0))
    with pytest.raises(bn.Error, match="max_iterations"):
        bn.DdpOptions(max_iterations=-1).check()
    with pytest.raises(bn.Error, match="'multiple_shotting'; did you mean 'multiple_shooting'"):
        bn.DdpSolver(problem, bn.DdpOptions(update="multiple_shotting"))
    with pytest.raises(bn.Error, match="DdpOptions.callback: got 3"):
        bn.DdpSolver(problem, bn.DdpOptions(callback=3))
    with pytest.raises(AttributeError, match="no entry 'max_iteration'; did you mean 'max_iterations'"):
        bn.DdpOptions().max_iteration = 3
    with pytest.raises(bn.Error, match="thread pool: 1024 workers are to be pinned|does not report its cores"):
        bn.DdpSolver(problem, bn.DdpOptions(threads=1024, pin_threads=True))
    solver = bn.DdpSolver(problem, bn.DdpOptions(max_iterations=7))
    with pytest.raises(bn.Error):
        solver.set_options(bn.DdpOptions(threads=-1))
    assert solver.options.max_iterations == 7
