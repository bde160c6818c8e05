"""Payloads, the regressor, and identification of masses from recorded motions."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Tuple

import numpy as np
import pytest

import burnish
from burnish import ContactDynamics, InertiaSpec, RigidBody
from dynamics_cases import Array

ARM = burnish.load_robot("arm7")


def state() -> Tuple[Array, Array, Array]:
    generator = np.random.default_rng(1)
    offsets = generator.uniform(-0.3, 0.3, ARM.model.nv)
    v, tau = generator.uniform(-1.0, 1.0, (2, ARM.model.nv))
    return burnish.integrate(ARM.model, ARM.reference_configuration(), offsets), v, 10.0 * tau


def brick() -> InertiaSpec:
    return InertiaSpec(mass=1.2, com=[0.01, -0.02, 0.06], inertia_at_com=np.diag([3e-3, 4e-3, 2e-3]))


class TestPayload:
    def test_set_payload_matches_a_model_with_payload(self) -> None:
        q, v, tau = state()
        with_payload, compiled = ContactDynamics(ARM.model), ContactDynamics(burnish.with_payload(ARM.model, "tool", brick()))
        with_payload.set_payload("tool", brick())
        with_payload.forward(q, v, tau)
        compiled.forward(q, v, tau)
        np.testing.assert_allclose(with_payload.a, compiled.a, rtol=1e-12)
        body = RigidBody(ARM.model)
        body.set_payload("tool", brick())
        body.update(q, v)
        assert body.mass == pytest.approx(ARM.model.total_mass + 1.2)

    def test_impossible_inertia_raises(self) -> None:
        dynamics = ContactDynamics(ARM.model)
        with pytest.raises(burnish.Error, match="mass is -1"):
            dynamics.set_payload("tool", InertiaSpec(mass=-1.0))
        with pytest.raises(burnish.Error, match="no solid"):
            dynamics.set_payload("tool", InertiaSpec(mass=1.0, inertia_at_com=np.diag([1.0, 1.0, 9.0])))
        with pytest.raises(burnish.Error, match="'tool'"):
            dynamics.set_payload("tol", brick())

    def test_inertia_parameters_round_trip(self) -> None:
        theta = burnish.inertia_parameters(brick())
        assert theta[0] == 1.2
        back = burnish.inertia_of(theta)
        np.testing.assert_allclose(back.inertia_at_com, brick().inertia_at_com, atol=1e-15)


def test_regressor_times_parameters_is_the_torque() -> None:
    q, v, tau = state()
    dynamics = ContactDynamics(ARM.model)
    bodies = list(range(len(ARM.model.joints)))
    with pytest.raises(burnish.EvaluationError):
        dynamics.regressor(bodies)
    dynamics.forward(q, v, tau)
    theta = np.concatenate([burnish.inertia_parameters(burnish.inertia_of_body(ARM.model, b)) for b in bodies])
    np.testing.assert_allclose(
        dynamics.regressor(bodies) @ theta + ARM.model.armature * dynamics.a, tau, atol=1e-9)
    dynamics.forward_derivatives()
    by_a, by_lambda = dynamics.inertia_derivatives(bodies)
    assert by_a.shape == (7, 70) and by_lambda.shape == (0, 70)
    # The torque is linear in the parameters: (da/dtheta) theta = -(da/dtau) Y theta.
    np.testing.assert_allclose(by_a @ theta, -dynamics.da_dtau @ (tau - ARM.model.armature * dynamics.a), atol=1e-7)


def test_payload_is_identified_from_exact_torques() -> None:
    motion = burnish.excitation(ARM.model, ARM.reference_configuration())
    columns = {name: motion[name] for name in motion.columns}
    joints = [j.name for j in ARM.model.joints]
    q, v, a = (np.column_stack([columns[f"{x}_{j}"] for j in joints]) for x in "qva")
    dynamics = ContactDynamics(ARM.model)
    dynamics.set_payload("tool", brick())
    tau = np.empty_like(v)
    for i in range(len(q)):
        dynamics.inverse(q[i], v[i], a[i], np.zeros(0))
        tau[i] = dynamics.tau
    found = burnish.identify(ARM.model, q, tau, 1e-3)
    assert found.converged
    one = found.inertias[0]
    assert one.values["mass"] == pytest.approx(1.2, rel=1e-3)
    assert one.values["com z"] == pytest.approx(0.06, abs=1e-3)
    assert one.sigma["mass"] < 0.01
    with pytest.raises(burnish.Error, match="'tool'"):
        burnish.identify(ARM.model, q, tau, 1e-3, payload="tol")


def test_implausible_record_raises_with_the_likely_cause() -> None:
    motion = burnish.excitation(ARM.model, ARM.reference_configuration())
    columns = {name: motion[name] for name in motion.columns}
    joints = [j.name for j in ARM.model.joints]
    q, v, a = (np.column_stack([columns[f"{x}_{j}"] for j in joints])[::4] for x in "qva")
    dynamics = ContactDynamics(ARM.model)
    dynamics.set_payload("tool", brick())
    tau = np.empty_like(v)
    for i in range(len(q)):
        dynamics.inverse(q[i], v[i], a[i], np.zeros(0))
        tau[i] = dynamics.tau
    found = burnish.identify(ARM.model, q, tau, 4e-3)
    assert not found.warnings
    assert np.all(found.rms_after < 2.0 * found.rms_expected)
    for words, q_of, tau_of in (("Nmm", q, 1e3 * tau), ("degrees", np.degrees(q), tau), ("at rest", q[:1] + 0.0 * q, tau),
                                ("no torque ever changes", q, 0.0 * tau)):
        with pytest.raises(burnish.Error, match=words):
            burnish.identify(ARM.model, q_of, tau_of, 4e-3)


def weak_arm(folder: Path, settings: str) -> burnish.Robot:
    arm = Path(os.environ.get("BURNISH_ROBOTS", burnish.robot_search_path()[0])) / "arm7"
    text = (arm / "robot.yaml").read_text().replace("arm7.urdf", str(arm / "arm7.urdf"))
    (folder / "robot.yaml").write_text(text + settings)
    return burnish.load_robot(str(folder))


def test_excitation_reduced_by_an_effort_limit_warns(tmp_path: Path) -> None:
    robot = weak_arm(tmp_path, "limits: {joint_2: {effort: 37}}\n")
    with pytest.warns(UserWarning, match="is reduced to .* joint 'joint_2' would need"):
        burnish.excitation(robot.model, robot.reference_configuration())


def test_excitation_with_an_unsupportable_start_raises(tmp_path: Path) -> None:
    robot = weak_arm(tmp_path, "limits: {joint_2: {effort: 3}}\n")
    with pytest.raises(burnish.Error, match="'joint_2' needs .* to hold the start posture"):
        burnish.excitation(robot.model, robot.reference_configuration())


def test_identify_accepts_wrapped_angles_of_continuous_joints(tmp_path: Path) -> None:
    arm = Path(os.environ.get("BURNISH_ROBOTS", burnish.robot_search_path()[0])) / "arm7"
    text = (arm / "arm7.urdf").read_text().replace('type="revolute"', 'type="continuous"')
    (tmp_path / "endless.urdf").write_text(text)
    model = burnish.load_robot(str(tmp_path / "endless.urdf")).model
    assert (model.nq, model.nv) == (14, 7)
    start = burnish.integrate(model, model.q_neutral, np.array([3.1, 0.4, 0.0, -1.2, 0.1, 0.3, 0.2]))
    motion = burnish.excitation(model, start, "flange", range=0.4)
    angles, v, a = (np.column_stack([motion[f"{x}_{j.name}"] for j in model.joints])[::4] for x in "qva")
    dynamics = ContactDynamics(burnish.with_payload(model, "flange", brick()))
    tau = np.empty_like(v)
    for i in range(len(v)):
        q = burnish.integrate(model, model.q_neutral, angles[i])
        dynamics.inverse(q, v[i], a[i], np.zeros(0))
        tau[i] = dynamics.tau
    wrapped = np.remainder(angles + np.pi, 2.0 * np.pi) - np.pi
    assert np.ptp(wrapped[:, 0]) > 6.0
    found = burnish.identify(model, wrapped, tau, 4e-3, payload="flange")
    assert found.inertias[0].values["mass"] == pytest.approx(1.2, rel=1e-3)
