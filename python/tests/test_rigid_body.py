"""Quantities of a robot state without contacts: frames, momentum, energy."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import burnish
from burnish import ContactDynamics, RigidBody
from dynamics_cases import MODEL, TALOS, Array, assert_close, differences, state


class TestRigidBody:
    AXES = ["local", "centered", "world"]

    def at(self, q: Array, v: Array, a: Any = None) -> RigidBody:
        body = RigidBody(TALOS.model)
        body.update(q, v, a)
        return body

    def test_energies_and_torques_match_the_free_robot(self) -> None:
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
    def test_frame_derivatives_match_finite_differences(self, axes: str) -> None:
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
            return other.velocity(number, burnish.Reference.parse(axes))

        assert_close(derivatives.velocity_dq, differences(velocity_at, model.nv))
        step = 1e-6
        after = burnish.integrate(model, q, step * v)
        before = burnish.integrate(model, q, -step * v)
        rate = (self.at(after, v + step * a).velocity(name, axes)
                - self.at(before, v - step * a).velocity(name, axes)) / (2.0 * step)
        assert_close(body.acceleration(name, axes), rate, 1e-5)

    def test_placement_error_derivatives_match_finite_differences(self) -> None:
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

    def test_derivatives_of_an_earlier_state_raise(self) -> None:
        q, v, _ = state(TALOS.model)
        body = self.at(q, v)
        with pytest.raises(burnish.EvaluationError, match="update_derivatives"):
            body.com_dq
        body.update_derivatives()
        assert body.com_dq.shape == (3, TALOS.model.nv)
        body.update(q, v)
        with pytest.raises(burnish.EvaluationError, match="update_derivatives"):
            body.com_dq

    def test_update_without_velocity_is_at_rest(self) -> None:
        q, v, _ = state(TALOS.model)
        body = self.at(q, v)
        body.update(q)
        assert body.kinetic_energy == 0.0
        assert body.potential_energy == self.at(q, v).potential_energy

    def test_invalid_state_raises_and_changes_nothing(self) -> None:
        q, v, _ = state(TALOS.model)
        body = self.at(q, v)
        com = body.com
        with pytest.raises(burnish.EvaluationError, match="NaN"):
            body.update(q, np.full_like(v, np.nan))
        with pytest.raises(burnish.Error, match="RigidBody.update: a has 1 entries; wanted"):
            body.update(q, v, [1.0])
        np.testing.assert_array_equal(body.com, com)

    def test_unknown_frames_and_axes_raise(self) -> None:
        body = RigidBody(MODEL)
        np.testing.assert_array_equal(body.placement("world"), np.eye(4))
        with pytest.raises(burnish.Error, match="did you mean 'tool'"):
            body.velocity("tol", "local")
        for number in (-1, 10000):
            with pytest.raises(burnish.Error, match=f"there is no frame {number}"):
                body.placement(number)
        with pytest.raises(burnish.Error, match="unknown name 'locale'.*did you mean"):
            body.velocity("tool", "locale")
        with pytest.raises(burnish.Error, match="slip"):
            RigidBody(MODEL, slip_velocity=0.0)
