"""Contact dynamics and its derivatives, batches, the robot alone, the checker, the diagnosis."""

from __future__ import annotations

import gc
import os
import signal
import threading
import time
import tracemalloc
from typing import Any, Callable, List, Tuple

import numpy as np
import pytest
from numpy.typing import NDArray

import burnish
from burnish import ContactDynamics, ContactDynamicsBatch, ContactSpec, Reference, RigidBody, Status

Array = NDArray[np.float64]
ROBOT = burnish.load_robot("talos:right_arm")
MODEL = ROBOT.model
TALOS = burnish.load_robot("talos")
TIP = ContactSpec(name="tip", tool="tool", directions="linear",
                  reference=Reference.surface_with_normal([0.2, -0.4, 0.9])).with_gains(9.0, 5.0)
PAD = ContactSpec(name="pad", tool="tool", directions="rz")
SOLES = [ContactSpec(name=side, tool=side + "_sole_link") for side in ("left", "right")]


def states(model: burnish.Model, count: int, seed: int = 1) -> Tuple[Array, Array, Array]:
    generator = np.random.default_rng(seed)
    q0 = np.tile(TALOS.reference_configuration() if model.nq > 7 else ROBOT.posture("tilt_45"),
                 (count, 1))
    q = burnish.integrate(model, q0, generator.uniform(-0.3, 0.3, (count, model.nv)))
    v, tau = generator.uniform(-1.0, 1.0, (2, count, model.nv))
    return q, v, 10.0 * tau


def state(model: burnish.Model = MODEL) -> Tuple[Array, Array, Array]:
    q, v, tau = states(model, 1)
    return q[0], v[0], tau[0]


def differences(f: Callable[[Array], Array], size: int, step: float = 1e-6) -> Array:
    """Columns: central differences of f at zero."""
    columns = [(f(h) - f(-h)) / (2.0 * step) for h in step * np.eye(size)]
    return np.transpose(columns)


def assert_close(got: Array, wanted: Array, tolerance: float = 1e-6) -> None:
    assert got.shape == wanted.shape
    assert np.abs(got - wanted).max() <= tolerance * (1.0 + np.abs(wanted).max())


class TestContactDynamics:
    @pytest.mark.parametrize("model, contacts", [(MODEL, [TIP]), (TALOS.model, SOLES), (MODEL, [])])
    def test_forward_solves_the_equation_of_motion(self, model: burnish.Model,
                                                   contacts: List[ContactSpec]) -> None:
        dynamics = ContactDynamics(model, contacts)
        q, v, tau = state(model)
        assert dynamics.forward(q, v, tau) is Status.OK
        M, b, J = dynamics.mass_matrix, dynamics.bias, dynamics.jacobian
        a, force = dynamics.a, dynamics.lambda_
        assert M.shape == (model.nv, model.nv) and J.shape == (dynamics.rows, model.nv)
        np.testing.assert_allclose(M @ a + b, tau + J.T @ force, atol=1e-8)
        np.testing.assert_allclose(dynamics.contact_velocity, J @ v, atol=1e-12)
        dynamics.acceleration(q, v, a)
        np.testing.assert_allclose(dynamics.alpha, np.zeros(dynamics.rows), atol=1e-8)
        dynamics.inverse(q, v, a, force)
        np.testing.assert_allclose(dynamics.tau, tau, atol=1e-8)

    def test_derivatives_are_those_of_the_values(self) -> None:
        dynamics = ContactDynamics(MODEL, [TIP])
        q, v, tau = state()
        nv = MODEL.nv

        def forward(q: Array, v: Array, tau: Array) -> Array:
            dynamics.forward(q, v, tau)
            return np.concatenate([dynamics.a, dynamics.lambda_])

        by_q = differences(lambda h: forward(burnish.integrate(MODEL, q, h), v, tau), nv)
        by_v = differences(lambda h: forward(q, v + h, tau), nv)
        by_tau = differences(lambda h: forward(q, v, tau + h), nv)
        dynamics.forward(q, v, tau)
        a, force = dynamics.a, dynamics.lambda_
        dynamics.forward_derivatives()
        assert_close(np.vstack([dynamics.da_dq, dynamics.dlambda_dq]), by_q)
        assert_close(np.vstack([dynamics.da_dv, dynamics.dlambda_dv]), by_v)
        assert_close(np.vstack([dynamics.da_dtau, dynamics.dlambda_dtau]), by_tau)

        def inverse(q: Array, v: Array) -> Array:
            dynamics.inverse(q, v, a, force)
            return dynamics.tau

        by_q = differences(lambda h: inverse(burnish.integrate(MODEL, q, h), v), nv)
        by_v = differences(lambda h: inverse(q, v + h), nv)
        dynamics.inverse(q, v, a, force)
        dynamics.inverse_derivatives()
        assert_close(dynamics.dtau_dq, by_q)
        assert_close(dynamics.dtau_dv, by_v)

        def acceleration(q: Array, v: Array) -> Array:
            dynamics.acceleration(q, v, a)
            return dynamics.alpha

        by_q = differences(lambda h: acceleration(burnish.integrate(MODEL, q, h), v), nv)
        by_v = differences(lambda h: acceleration(q, v + h), nv)
        dynamics.acceleration(q, v, a)
        dynamics.acceleration_derivatives()
        assert_close(dynamics.dalpha_dq, by_q)
        assert_close(dynamics.dalpha_dv, by_v)

    @pytest.mark.parametrize("reference", [Reference.local(), Reference.centered(),
                                           Reference.world()])
    def test_wrench_derivatives_are_those_of_wrenches(self, reference: Reference) -> None:
        dynamics = ContactDynamics(MODEL, [TIP])
        q, v, tau = state()

        def wrench(q: Array, v: Array, tau: Array) -> Array:
            dynamics.forward(q, v, tau)
            return dynamics.wrench("tip", reference)

        nv = MODEL.nv
        by_q = differences(lambda h: wrench(burnish.integrate(MODEL, q, h), v, tau), nv)
        by_v = differences(lambda h: wrench(q, v + h, tau), nv)
        by_tau = differences(lambda h: wrench(q, v, tau + h), nv)
        dynamics.forward(q, v, tau)
        dynamics.forward_derivatives()
        derivatives = dynamics.wrench_derivatives(0, reference)
        assert_close(derivatives.dq, by_q)
        assert_close(derivatives.dv, by_v)
        assert_close(derivatives.dtau, by_tau)

    def test_arguments_may_be_lists_and_whole_numbers_and_slices(self) -> None:
        dynamics = ContactDynamics(MODEL, [TIP])
        q, v, _ = state()
        tau = np.arange(MODEL.nv)
        dynamics.forward(q, v, tau.astype(float))
        wanted = dynamics.a
        dynamics.forward(list(q), np.repeat(v, 2)[::2], tau)
        np.testing.assert_array_equal(dynamics.a, wanted)
        dynamics.forward(tau=tau, q=q, v=np.asfortranarray(v))
        np.testing.assert_array_equal(dynamics.a, wanted)

    def test_results_are_copies(self) -> None:
        dynamics = ContactDynamics(MODEL, [TIP])
        q, v, tau = state()
        dynamics.forward(q, v, tau)
        a = dynamics.a
        a_before = a.copy()
        a_other = dynamics.a
        a_other[:] = 7.0
        dynamics.forward(q, v, 2.0 * tau)
        np.testing.assert_array_equal(a, a_before)
        assert not np.array_equal(dynamics.a, a_before)

    def test_contacts_are_made_and_broken(self) -> None:
        dynamics = ContactDynamics(MODEL, [TIP, PAD])
        q, v, tau = state()
        assert dynamics.row_names == ["tip/x", "tip/y", "tip/z", "pad/rz"]
        dynamics.set_active("tip", False)
        assert not dynamics.is_active("tip") and not dynamics.is_active(0)
        assert dynamics.is_active("pad") and dynamics.row_names == ["pad/rz"]
        dynamics.forward(q, v, tau)
        assert dynamics.lambda_.shape == (1,) and dynamics.jacobian.shape == (1, MODEL.nv)
        assert not dynamics.force("tip").value.any()
        alone = ContactDynamics(MODEL, [PAD])
        alone.forward(q, v, tau)
        np.testing.assert_allclose(dynamics.a, alone.a, atol=1e-10)
        dynamics.set_active(0, True)
        with pytest.raises(burnish.EvaluationError):
            dynamics.lambda_
        with pytest.raises(burnish.Error, match="did you mean 'pad'"):
            dynamics.set_active("pat", True)
        assert "tip/x tip/y tip/z pad/rz" in repr(dynamics)

    def test_arguments_of_the_wrong_size_are_named(self) -> None:
        dynamics = ContactDynamics(MODEL, [TIP])
        q, v, tau = state()
        for call, sentence in [
            (lambda: dynamics.forward(q[1:], v, tau), "forward: q has 5 entries; wanted 6"),
            (lambda: dynamics.forward(q, v[1:], tau), "forward: v has 5 entries; wanted 6"),
            (lambda: dynamics.forward(q, v, tau[1:]), "forward: tau has 5 entries; wanted 6"),
            (lambda: dynamics.inverse(q, v, v, [1.0]), "inverse: lambda_ has 1 entries; wanted 3"),
            (lambda: dynamics.acceleration(q, v, []), "acceleration: a has 0 entries; wanted 6"),
        ]:
            with pytest.raises(burnish.Error, match="^ContactDynamics." + sentence + "$"):
                call()
        with pytest.raises(TypeError):
            dynamics.forward(q, v, "none")

    def test_states_that_cannot_be_evaluated_raise_what_the_status_says(self) -> None:
        dynamics = ContactDynamics(TALOS.model, SOLES)
        q, v, tau = state(TALOS.model)
        bent = q.copy()
        bent[3:7] *= 1.1
        v_nan = v.copy()
        v_nan[3] = np.nan
        for arguments, status in [((bent, v, tau), Status.NOT_NORMALIZED),
                                  ((q, v_nan, tau), Status.NOT_FINITE)]:
            with pytest.raises(burnish.EvaluationError) as failed:
                dynamics.forward(*arguments)
            assert str(failed.value) == "ContactDynamics.forward: " + burnish.describe(status)
        twice = ContactDynamics(MODEL, [TIP, TIP.replace(name="again")])
        with pytest.raises(burnish.EvaluationError, match="redundant"):
            twice.forward(*state())

    def test_results_belong_to_the_last_evaluation(self) -> None:
        dynamics = ContactDynamics(MODEL, [TIP])
        q, v, tau = state()
        with pytest.raises(burnish.EvaluationError, match="ContactDynamics.a: a result of forward"):
            dynamics.a
        with pytest.raises(burnish.EvaluationError, match="last evaluation"):
            dynamics.forward_derivatives()
        dynamics.forward(q, v, tau)
        with pytest.raises(burnish.EvaluationError, match="a result of forward_derivatives()"):
            dynamics.da_dq
        with pytest.raises(burnish.EvaluationError):
            dynamics.inverse_derivatives()
        dynamics.forward_derivatives()
        dynamics.da_dq
        dynamics.forward(q, v, tau)
        with pytest.raises(burnish.EvaluationError):
            dynamics.da_dq
        with pytest.raises(burnish.EvaluationError, match="a result of inverse()"):
            dynamics.tau
        with pytest.raises(burnish.EvaluationError):
            dynamics.forward(q, np.full_like(v, np.inf), tau)
        with pytest.raises(burnish.EvaluationError):
            dynamics.a

    def test_not_converged_is_returned_and_not_raised(self) -> None:
        contacts = [TIP, TIP.replace(name="again")]
        solver = burnish.ContactSolver(mu=1e-4, max_proximal_iterations=30,
                                       proximal_tolerance=1e-11)
        dynamics = ContactDynamics(MODEL, contacts, solver)
        assert dynamics.forward(*state()) is Status.OK
        assert 0 < dynamics.proximal_iterations <= 30
        assert dynamics.proximal_residual <= 1e-11
        once = ContactDynamics(MODEL, [TIP])
        once.forward(*state())
        np.testing.assert_allclose(dynamics.a, once.a, atol=1e-7)
        impatient = ContactDynamics(MODEL, contacts,
                                    solver.replace(mu=1.0, max_proximal_iterations=1))
        assert impatient.forward(*state()) is Status.NOT_CONVERGED
        assert impatient.forward_derivatives() is Status.NOT_CONVERGED

    def test_the_robot_may_go_while_its_dynamics_stay(self) -> None:
        robot = burnish.load_robot("arm7")
        q = robot.posture("bent")
        dynamics = ContactDynamics(robot.model, [ContactSpec(tool="tool")])
        del robot
        gc.collect()
        assert dynamics.forward(q, np.zeros(7), np.zeros(7)) is Status.OK


class TestBatches:
    N = 45  # not a multiple of any pack

    @pytest.mark.parametrize("model, contacts", [(MODEL, [TIP]), (TALOS.model, SOLES), (MODEL, [])])
    @pytest.mark.parametrize("threads", [1, 2])
    def test_hold_the_results_of_single_states(self, model: burnish.Model,
                                               contacts: List[ContactSpec], threads: int) -> None:
        single = ContactDynamics(model, contacts)
        batch = ContactDynamicsBatch(model, contacts, capacity=self.N + 3, threads=threads)
        assert (batch.rows, batch.capacity, batch.threads) == (single.rows, self.N + 3, threads)
        q, v, tau = states(model, self.N)
        assert batch.forward_with_derivatives(q, v, tau) is Status.OK
        assert batch.status is Status.OK
        assert batch.statuses.dtype == np.uint8 and not batch.statuses.any()
        names = ["a", "lambda_", "da_dq", "da_dv", "da_dtau", "dlambda_dq", "dlambda_dv",
                 "dlambda_dtau"]
        results = {name: getattr(batch, name) for name in names}
        for i in range(self.N):
            single.forward(q[i], v[i], tau[i])
            single.forward_derivatives()
            for name in names:
                wanted = getattr(single, name)
                assert results[name].shape == (self.N, *wanted.shape)
                if wanted.size:
                    assert_close(results[name][i], wanted, 1e-9)
        forward_only = ContactDynamicsBatch(model, contacts, self.N)
        forward_only.forward(q, v, tau)
        np.testing.assert_array_equal(forward_only.a, results["a"])

    def test_of_one_state_and_of_fewer_than_before(self) -> None:
        batch = ContactDynamicsBatch(MODEL, [TIP], 10)
        q, v, tau = states(MODEL, 10)
        batch.forward_with_derivatives(q, v, tau)
        a, da_dq = batch.a.copy(), batch.da_dq.copy()
        batch.forward_with_derivatives(q[3:4], v[3:4], tau[3:4])
        assert batch.a.shape == (1, MODEL.nv) and batch.da_dq.shape == (1, MODEL.nv, MODEL.nv)
        np.testing.assert_allclose(batch.a, a[3:4], rtol=1e-12)
        np.testing.assert_allclose(batch.da_dq, da_dq[3:4], rtol=1e-9, atol=1e-9)

    def test_results_are_read_only_views_that_keep_their_memory(self) -> None:
        batch = ContactDynamicsBatch(MODEL, [TIP], 10)
        q, v, tau = states(MODEL, 10)
        batch.forward_with_derivatives(q, v, tau)
        a, dlambda_dq = batch.a, batch.dlambda_dq
        assert np.shares_memory(a, batch.a)
        for view in (a, dlambda_dq):
            with pytest.raises(ValueError):
                view[0] = 1.0
        batch.forward(q, v, 2.0 * tau)
        doubled = batch.a.copy()
        np.testing.assert_array_equal(a, doubled)  # written over, as the docstring says
        del batch
        gc.collect()
        np.testing.assert_array_equal(a, doubled)
        assert np.isfinite(dlambda_dq).all()

    def test_rows_of_float64_are_read_without_a_copy(self) -> None:
        n = 4000
        batch = ContactDynamicsBatch(MODEL, [], n)
        arguments = states(MODEL, n)

        def allocated(*given: Array) -> int:
            tracemalloc.start()
            batch.forward(*given)
            peak = tracemalloc.get_traced_memory()[1]
            tracemalloc.stop()
            return peak

        assert allocated(*arguments) < 8 * n
        assert allocated(*(x[:, :].astype(np.float32) for x in arguments)) > 8 * n * MODEL.nq
        batch.forward(*arguments)
        a = batch.a.copy()
        batch.forward(*(np.asfortranarray(x) for x in arguments))
        np.testing.assert_array_equal(batch.a, a)

    def test_states_that_fail_say_so_and_leave_the_others(self) -> None:
        batch = ContactDynamicsBatch(MODEL, [TIP], 20)
        q, v, tau = states(MODEL, 20)
        batch.forward(q, v, tau)
        wanted = batch.a.copy()
        v[7, 2] = np.nan
        assert batch.forward(q, v, tau) is Status.NOT_FINITE
        assert batch.status is Status.NOT_FINITE
        assert list(np.flatnonzero(batch.statuses)) == [7]
        assert Status(batch.statuses[7]) is Status.NOT_FINITE
        assert not batch.a[7].any()
        others = np.arange(20) != 7
        np.testing.assert_array_equal(batch.a[others], wanted[others])

    def test_arguments_of_the_wrong_shape_are_named(self) -> None:
        batch = ContactDynamicsBatch(MODEL, [TIP], 10)
        q, v, tau = states(MODEL, 11)
        for given, sentence in [
            ((q[:5, 1:], v[:5], tau[:5]), "q is 5 x 5; wanted 5 x 6, a row per state"),
            ((q[:5], v[:4], tau[:5]), "v is 4 x 6; wanted 5 x 6, a row per state"),
            ((q[:5], v[:5], tau[:5].T), "tau is 6 x 5; wanted 5 x 6, a row per state"),
            ((q, v, tau), "11 states; wanted 1 to the capacity of 10"),
            ((q[:0], v[:0], tau[:0]), "0 states; wanted 1 to the capacity of 10"),
        ]:
            with pytest.raises(burnish.Error, match="^ContactDynamicsBatch.forward: " + sentence):
                batch.forward(*given)
        for bad in ({"capacity": 0}, {"capacity": 5, "threads": 0}):
            with pytest.raises(burnish.Error):
                ContactDynamicsBatch(MODEL, [TIP], **bad)

    def test_results_belong_to_the_last_call(self) -> None:
        batch = ContactDynamicsBatch(MODEL, [TIP, PAD], 10)
        with pytest.raises(burnish.EvaluationError, match="ContactDynamicsBatch.a: a result of"):
            batch.a
        batch.forward(*states(MODEL, 10))
        with pytest.raises(burnish.EvaluationError, match="forward_with_derivatives"):
            batch.da_dq
        batch.set_active("tip", False)
        with pytest.raises(burnish.EvaluationError):
            batch.lambda_
        batch.forward_with_derivatives(*states(MODEL, 10))
        assert batch.lambda_.shape == (10, 1) and batch.dlambda_dq.shape == (10, 1, MODEL.nv)

    def test_other_threads_run_during_a_call_and_may_not_use_the_same_object(self) -> None:
        n = 20000
        batch = ContactDynamicsBatch(MODEL, [TIP], n)
        arguments = states(MODEL, n)
        stop = threading.Event()

        def work() -> None:
            while not stop.is_set():
                batch.forward_with_derivatives(*arguments)

        batch.forward_with_derivatives(*arguments)
        wanted = batch.a.copy()
        thread = threading.Thread(target=work)
        thread.start()
        refused = ""
        end = time.monotonic() + 60.0
        try:
            while not refused and time.monotonic() < end:
                try:
                    batch.a
                except burnish.Error as error:
                    refused = str(error)
        finally:
            stop.set()
            thread.join()
        assert "in use by another thread" in refused
        np.testing.assert_array_equal(batch.a, wanted)

    def test_pack_width_is_a_power_of_two(self) -> None:
        assert burnish.pack_width() in (1, 2, 4, 8)


class TestRigidBody:
    AXES = list(burnish.FrameAxes)

    def at(self, q: Array, v: Array, a: Any = None) -> RigidBody:
        body = RigidBody(TALOS.model)
        body.update(q, v, a)
        return body

    def test_agrees_with_the_free_robot(self) -> None:
        q, v, tau = state(TALOS.model)
        body, free = self.at(q, v), ContactDynamics(TALOS.model)
        free.forward(q, v, tau)
        M = free.mass_matrix
        assert body.kinetic_energy == pytest.approx(0.5 * v @ M @ v)
        assert body.mass == pytest.approx(TALOS.model.total_mass)
        np.testing.assert_allclose(body.passive_torque.shape, (TALOS.model.nv,))
        free.forward(q, 0.0 * v, tau)
        np.testing.assert_allclose(body.gravity_torque, free.bias, atol=1e-8)
        body.update_derivatives()
        np.testing.assert_allclose(body.kinetic_energy_dv, M @ v, atol=1e-9)
        np.testing.assert_allclose(body.potential_energy_dq, body.gravity_torque, atol=1e-8)
        np.testing.assert_allclose(body.centroidal_momentum_dv @ v, body.centroidal_momentum,
                                   atol=1e-9)
        np.testing.assert_allclose(body.mass * body.com_velocity, body.momentum[:3], atol=1e-9)

    @pytest.mark.parametrize("axes", AXES)
    def test_frames_move_as_their_derivatives_say(self, axes: burnish.FrameAxes) -> None:
        model = TALOS.model
        q, v, a = state(model)
        body, name = self.at(q, v, a), "left_sole_link"
        number = body.frame(name)
        np.testing.assert_array_equal(body.placement(name), burnish.frame_placement(model, q, name))
        np.testing.assert_array_equal(body.placement(number), body.placement(name))
        derivatives = body.frame_derivatives(name, axes)
        np.testing.assert_allclose(derivatives.jacobian @ v, body.velocity(name, axes), atol=1e-9)
        other = self.at(q, v, a)

        def velocity_at(h: Array) -> Array:
            other.update(burnish.integrate(model, q, h), v)
            return other.velocity(number, axes.name.lower())

        assert_close(derivatives.velocity_dq, differences(velocity_at, model.nv))
        step = 1e-6
        after = burnish.integrate(model, q, step * v)
        before = burnish.integrate(model, q, -step * v)
        rate = (self.at(after, v + step * a).velocity(name, axes)
                - self.at(before, v - step * a).velocity(name, axes)) / (2.0 * step)
        assert_close(body.acceleration(name, axes), rate, 1e-5)

    def test_placement_errors_move_as_their_derivatives_say(self) -> None:
        model = TALOS.model
        q, v, _ = state(model)
        body, other = self.at(q, v), self.at(q, v)
        target = burnish.model.placement([0.1, 0.2, 0.3], [0.2, -0.1, 0.4])
        derivatives = body.placement_derivatives("left_sole_link", target)

        def error_at(h: Array) -> Array:
            other.update(burnish.integrate(model, q, h), v)
            return other.placement_error("left_sole_link", target)

        assert_close(derivatives.placement_error, differences(error_at, model.nv))
        assert derivatives.position.shape == derivatives.rotation.shape == (3, model.nv)
        at_target = body.placement_error("left_sole_link", body.placement("left_sole_link"))
        np.testing.assert_allclose(at_target, np.zeros(6), atol=1e-12)

    def test_derivatives_belong_to_the_last_state(self) -> None:
        q, v, _ = state(TALOS.model)
        body = self.at(q, v)
        with pytest.raises(burnish.EvaluationError, match="update_derivatives"):
            body.com_dq
        body.update_derivatives()
        assert body.com_dq.shape == (3, TALOS.model.nv)
        body.update(q, v)
        with pytest.raises(burnish.EvaluationError, match="update_derivatives"):
            body.com_dq

    def test_a_state_that_is_refused_changes_nothing(self) -> None:
        q, v, _ = state(TALOS.model)
        body = self.at(q, v)
        com = body.com
        with pytest.raises(burnish.EvaluationError, match="NaN"):
            body.update(q, np.full_like(v, np.nan))
        with pytest.raises(burnish.Error, match="RigidBody.update: a has 1 entries; wanted"):
            body.update(q, v, [1.0])
        np.testing.assert_array_equal(body.com, com)

    def test_frames_and_axes_that_there_are_not_are_refused(self) -> None:
        body = RigidBody(MODEL)
        np.testing.assert_array_equal(body.placement("world"), np.eye(4))
        with pytest.raises(burnish.Error, match="did you mean 'tool'"):
            body.velocity("tol", "local")
        for number in (-1, 10000):
            with pytest.raises(burnish.Error, match=f"there is no frame {number}"):
                body.placement(number)
        with pytest.raises(burnish.Error, match="FrameAxes: there is no 'locale'; did you mean"):
            body.velocity("tool", "locale")
        with pytest.raises(burnish.Error, match="slip"):
            RigidBody(MODEL, slip_velocity=0.0)


class TestChecker:
    def test_passes_on_a_robot_and_tells_how_far_it_is(self) -> None:
        told: List[Tuple[int, int]] = []
        options = burnish.CheckOptions(states=2, directions=["z", "pad_z"], accelerations=["spatial"],
                                       progress=lambda done, total: told.append((done, total)))
        report = burnish.check_derivatives(MODEL, options)
        assert report.pass_ and report.rows and all(row.pass_ for row in report.rows)
        assert told == [(i + 1, len(report.rows)) for i in range(len(report.rows))]
        assert {row.reference for row in report.rows} >= {"local", "world"}
        assert max(row.worst_error for row in report.rows) < 1e-6
        assert report.rows[0].worst.block and report.robot in report.text()

    def test_fails_where_the_tolerance_is_out_of_reach(self) -> None:
        report = burnish.check_derivatives(MODEL, burnish.CheckOptions(
            contacts=[TIP], states=2, tolerance=1e-15))
        assert not report.pass_ and len(report.rows) == 1
        assert report.rows[0].worst_error > 1e-15

    def test_has_the_defaults_of_the_library(self) -> None:
        options = burnish.CheckOptions()
        assert options.references == burnish.default_check_references()
        assert options.directions == burnish.default_check_directions()
        assert options.gains == burnish.default_check_gains()
        assert "all" in options.directions or "x,y,z,rx,ry,rz" in options.directions

    def test_refuses_options_with_a_sentence(self) -> None:
        with pytest.raises(burnish.Error, match="did you mean 'tool'"):
            burnish.check_derivatives(MODEL, burnish.CheckOptions(tool="tol"))
        with pytest.raises(burnish.Error, match="CheckOptions.states: got 'two', wanted a whole"):
            burnish.check_derivatives(
                MODEL, burnish.CheckOptions(states="two"))  # type: ignore[arg-type]

    def test_lets_an_exception_of_its_progress_through(self) -> None:
        def stop(done: int, total: int) -> None:
            raise RuntimeError(f"stopped at {done} of {total}")

        with pytest.raises(RuntimeError, match="stopped at 1 of"):
            burnish.check_derivatives(MODEL, burnish.CheckOptions(states=1, progress=stop))

    def test_lets_the_keyboard_interrupt_it(self) -> None:
        timer = threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT))
        options = burnish.CheckOptions(states=20, gains=50 * burnish.default_check_gains())
        with pytest.raises(KeyboardInterrupt):
            timer.start()
            burnish.check_derivatives(TALOS.model, options.replace(tool="left_sole_link"))


class TestDiagnosis:
    def test_names_rows_that_are_held_already(self) -> None:
        q, _, _ = state()
        again = TIP.replace(name="again", directions="z")
        found = burnish.diagnose(MODEL, [TIP, again], q)
        assert [row.text() for row in found.redundant] == [
            "contact 'again', direction z: already held by tip/z"]
        row = found.redundant[0]
        assert (row.contact, row.direction, row.row, row.immovable) == ("again", "z", 3, False)
        assert found.condition == np.inf and found.text() == row.text() + "\n"

    def test_examines_active_contacts_alone(self) -> None:
        q, _, _ = state()
        again = TIP.replace(name="again", directions="z")
        for active in (["tip"], [1], ["again"]):
            found = burnish.diagnose(MODEL, [TIP, again], q, active=active)
            assert not found.redundant and np.isfinite(found.condition)
        with pytest.raises(burnish.Error, match="diagnose: unknown contact 'tipp'; did you mean"):
            burnish.diagnose(MODEL, [TIP, again], q, active=["tipp"])
        with pytest.raises(burnish.Error):
            burnish.diagnose(MODEL, [TIP], q[1:])
