"""Contact dynamics of one state: values, derivatives, the checker, the diagnosis."""

from __future__ import annotations

import gc
import os
import signal
import threading
from typing import List, Tuple

import numpy as np
import pytest

import burnish
from burnish import ContactDynamics, ContactSpec, Reference, Status
from dynamics_cases import MODEL, PAD, SOLES, TALOS, TIP, Array, assert_close, differences, state


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

    def test_derivatives_match_finite_differences(self) -> None:
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

    def test_set_reference_rotation_matches_a_rotated_reference(self) -> None:
        turn = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
        robot = burnish.load_robot("arm7")
        q, rest = robot.reference_configuration(), np.zeros(7)
        made = [ContactDynamics(robot.model, [ContactSpec("tip", tool="tool", directions="x", reference=reference)])
                for reference in (Reference.centered(), Reference.centered(turn))]
        made[0].set_reference_rotation("tip", turn)
        for dynamics in made:
            dynamics.forward(q, rest, rest)
        np.testing.assert_array_equal(made[0].lambda_, made[1].lambda_)
        assert made[0].force("tip").reference == Reference.centered(turn)
        with pytest.raises(burnish.Error, match="rotation is not a rotation matrix"):
            made[0].set_reference_rotation("tip", 2.0 * turn)

    @pytest.mark.parametrize("reference", [Reference.local(), Reference.centered(),
                                           Reference.world()])
    def test_wrench_derivatives_match_finite_differences(self, reference: Reference) -> None:
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

    def test_lists_integers_and_slices_are_accepted(self) -> None:
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

    def test_set_active_adds_and_removes_contacts(self) -> None:
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

    def test_arguments_of_wrong_size_raise_with_their_name(self) -> None:
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

    def test_invalid_state_raises_with_its_status(self) -> None:
        dynamics = ContactDynamics(TALOS.model, SOLES)
        q, v, tau = state(TALOS.model)
        not_normalized = q.copy()
        not_normalized[3:7] *= 1.1
        v_nan = v.copy()
        v_nan[3] = np.nan
        for arguments, status in [((not_normalized, v, tau), Status.NOT_NORMALIZED),
                                  ((q, v_nan, tau), Status.NOT_FINITE)]:
            with pytest.raises(burnish.EvaluationError) as failed:
                dynamics.forward(*arguments)
            assert str(failed.value) == "ContactDynamics.forward: " + burnish.describe(status)
        twice = ContactDynamics(MODEL, [TIP, TIP.replace(name="again")])
        with pytest.raises(burnish.EvaluationError, match="redundant"):
            twice.forward(*state())

    def test_results_of_an_earlier_evaluation_raise(self) -> None:
        dynamics = ContactDynamics(MODEL, [TIP])
        q, v, tau = state()
        with pytest.raises(burnish.EvaluationError, match="ContactDynamics.a: this is a result of forward"):
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

    def test_singular_contacts_raise_with_their_name(self) -> None:
        dynamics = ContactDynamics(MODEL, [TIP, TIP.replace(name="again", directions="z")])
        with pytest.raises(burnish.EvaluationError, match="contact row 'again/z' is redundant"):
            dynamics.forward(*state())
        q, v, tau = state()
        batch = burnish.ContactDynamicsBatch(
            MODEL, [TIP, TIP.replace(name="again", directions="z")], 2)
        assert batch.forward(np.tile(q, (2, 1)), np.tile(v, (2, 1)),
                             np.tile(tau, (2, 1))) is Status.SINGULAR_CONTACTS
        assert "'again/z' is redundant" in batch.explanation(1)
        with pytest.raises(burnish.Error, match="no state 2"):
            batch.explanation(2)

    def test_not_converged_is_returned_not_raised(self) -> None:
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

    def test_dynamics_outlive_their_robot(self) -> None:
        robot = burnish.load_robot("arm7")
        q = robot.posture("bent")
        dynamics = ContactDynamics(robot.model, [ContactSpec(tool="tool")])
        del robot
        gc.collect()
        assert dynamics.forward(q, np.zeros(7), np.zeros(7)) is Status.OK


class TestChecker:
    def test_robot_passes_and_progress_is_reported(self) -> None:
        progress_calls: List[Tuple[int, int]] = []
        options = burnish.CheckOptions(states=2, directions=["z", "pad_z"], accelerations=["spatial"],
                                       progress=lambda done, total: progress_calls.append((done, total)))
        report = burnish.check_derivatives(MODEL, options)
        assert report.pass_ and report.rows and all(row.pass_ for row in report.rows)
        assert progress_calls == [(i + 1, len(report.rows)) for i in range(len(report.rows))]
        assert {row.reference for row in report.rows} >= {"local", "world"}
        assert max(row.worst_error for row in report.rows) < 1e-6
        assert report.rows[0].worst.block and report.robot in report.text()

    def test_curved_surfaces_pass(self) -> None:
        options = burnish.CheckOptions(states=2, references=[], directions=["z"], gains=[burnish.CheckGains()],
                                       surfaces=[burnish.SurfaceShape("sphere", radius=0.2, hollow=True)])
        report = burnish.check_derivatives(MODEL, options)
        assert report.pass_ and [row.reference for row in report.rows] == ["hollow sphere of radius 0.2 m"]
        bad = options.replace(surfaces=[burnish.SurfaceShape("torus", radius=0.6, ring=0.5)])
        with pytest.raises(burnish.Error, match="wanted less than the radius of its ring"):
            burnish.check_derivatives(MODEL, bad)

    def test_unattainable_tolerance_fails(self) -> None:
        report = burnish.check_derivatives(MODEL, burnish.CheckOptions(
            contacts=[TIP], states=2, tolerance=1e-15))
        assert not report.pass_ and len(report.rows) == 1
        assert report.rows[0].worst_error > 1e-15

    def test_default_options_match_the_library(self) -> None:
        options = burnish.CheckOptions()
        assert options.references == burnish.default_check_references()
        assert options.directions == burnish.default_check_directions()
        assert options.gains == burnish.default_check_gains()
        assert options.surfaces == burnish.default_check_surfaces()
        assert "all" in options.directions or "x,y,z,rx,ry,rz" in options.directions

    def test_invalid_options_raise_with_the_reason(self) -> None:
        with pytest.raises(burnish.Error, match="did you mean 'tool'"):
            burnish.check_derivatives(MODEL, burnish.CheckOptions(tool="tol"))
        with pytest.raises(burnish.Error, match="CheckOptions.states: got 'two'; wanted a whole"):
            burnish.check_derivatives(
                MODEL, burnish.CheckOptions(states="two"))  # type: ignore[arg-type]

    def test_exception_in_progress_reaches_the_caller(self) -> None:
        def stop(done: int, total: int) -> None:
            raise RuntimeError(f"stopped at {done} of {total}")

        with pytest.raises(RuntimeError, match="stopped at 1 of"):
            burnish.check_derivatives(MODEL, burnish.CheckOptions(states=1, progress=stop))

    def test_keyboard_interrupt_ends_the_check(self) -> None:
        timer = threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT))
        options = burnish.CheckOptions(states=20, gains=50 * burnish.default_check_gains())
        with pytest.raises(KeyboardInterrupt):
            timer.start()
            burnish.check_derivatives(TALOS.model, options.replace(tool="left_sole_link"))


class TestDiagnosis:
    def test_redundant_rows_are_named(self) -> None:
        q, _, _ = state()
        again = TIP.replace(name="again", directions="z")
        found = burnish.diagnose(MODEL, [TIP, again], q)
        assert [row.text() for row in found.redundant] == [
            "contact 'again', direction z: already held by tip/z"]
        row = found.redundant[0]
        assert (row.contact, row.direction, row.row, row.immovable) == ("again", "z", 3, False)
        assert found.condition == np.inf and found.text() == row.text() + "\n"

    def test_inactive_contacts_are_ignored(self) -> None:
        q, _, _ = state()
        again = TIP.replace(name="again", directions="z")
        for active in (["tip"], [1], ["again"]):
            found = burnish.diagnose(MODEL, [TIP, again], q, active=active)
            assert not found.redundant and np.isfinite(found.condition)
        with pytest.raises(burnish.Error, match="diagnose: unknown contact 'tipp'; did you mean"):
            burnish.diagnose(MODEL, [TIP, again], q, active=["tipp"])
        with pytest.raises(burnish.Error):
            burnish.diagnose(MODEL, [TIP], q[1:])
