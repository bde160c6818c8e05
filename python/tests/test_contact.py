"""References, contacts, forces and kinematic loops."""

from __future__ import annotations

import numpy as np
import pytest

import burnish
from burnish import ContactSpec, Reference

ROBOT = burnish.load_robot("talos:right_arm")
REFERENCES = [Reference.local(), Reference.centered(),
              Reference.surface_with_normal([0.2, -0.4, 0.9]), Reference.world()]


def dynamics_of(*contacts: ContactSpec) -> burnish.ContactDynamics:
    dynamics = burnish.ContactDynamics(ROBOT.model, contacts)
    zero = np.zeros(ROBOT.model.nv)
    dynamics.forward(ROBOT.posture("tilt_45"), zero, zero)
    return dynamics


class TestReferences:
    def test_parse_inverts_the_name(self) -> None:
        assert [r.name for r in REFERENCES] == ["local", "centered", "surface", "world"]
        for reference in (Reference.local(), Reference.centered(), Reference.world()):
            assert Reference.parse(reference.name) == reference
        with pytest.raises(burnish.Error, match="did you mean 'centered'"):
            Reference.parse("centred")

    def test_named_references_have_origin_and_axes(self) -> None:
        assert Reference() == Reference.centered()
        assert (Reference.local().origin, Reference.local().axes) == ("tool", "tool")
        assert (Reference.world().origin, Reference.world().axes) == ("world", "world")
        assert Reference.surface(np.eye(3)).axes == "base"

    def test_surface_reference_has_its_normal_as_z(self) -> None:
        normal = np.array([1.0, -2.0, 2.0]) / 3.0
        rotation = np.asarray(Reference.surface_with_normal(3.0 * normal).rotation)
        np.testing.assert_allclose(rotation[:, 2], normal, atol=1e-15)
        np.testing.assert_allclose(rotation.T @ rotation, np.eye(3), atol=1e-15)

    def test_contact_reference_follows_a_curved_surface(self) -> None:
        ball = burnish.Quadric.sphere([0.5, 0.1, -0.3], 0.4)
        near = np.array([0.5, 0.1, 0.1])
        np.testing.assert_allclose(ball.normal(near), [0.0, 0.0, 1.0], atol=1e-15)
        assert ball.value(near) == pytest.approx(0.0, abs=1e-12)
        reference = Reference.on(ball, near)
        assert reference.quadric == ball and reference.name == "surface"
        dynamics = dynamics_of(ContactSpec("pad", tool="tool", directions="z", reference=reference))
        force = dynamics.force("pad")
        np.testing.assert_allclose(force.axes()[:, 2], ball.normal(force.tool_position), atol=1e-12)
        for shape in (burnish.Quadric.plane(near, [0, 0, 2]), burnish.Quadric.cylinder(near, [1, 0, 0], 0.3, True),
                      burnish.Quadric.cone(near, [1, 0, 0], 0.3),
                      burnish.Quadric.ellipsoid(near, np.eye(3), [0.3, 0.2, 0.1]),
                      burnish.Quadric.osculating(near, np.eye(3), -2.0, 0.0, 1.0)):
            np.testing.assert_allclose(shape.Q, np.transpose(shape.Q))
        with pytest.raises(burnish.Error, match="the sphere's radius is -1 m"):
            burnish.Quadric.sphere(near, -1.0)

    def test_frames_and_forces_follow_a_curved_surface(self) -> None:
        ball, near = burnish.Quadric.sphere([0.5, 0.1, -0.3], 0.4), [0.5, 0.1, 0.1]
        curved = Reference.on(ball, near, along=[0.0, 1.0, 0.3])
        np.testing.assert_allclose(np.asarray(curved.rotation)[:, 0], [0.0, 1.0, 0.0], atol=1e-15)
        with pytest.raises(burnish.Error, match="has no tangential part"):
            Reference.on(ball, near, along=[0.0, 0.0, 1.0])
        dynamics = dynamics_of(ContactSpec("pad", tool="tool", reference=Reference.centered()))
        force = dynamics.force("pad")
        there = dynamics.force("pad", curved)
        np.testing.assert_allclose(there.axes()[:, 2], ball.normal(force.tool_position), atol=1e-12)
        np.testing.assert_allclose(there.value, force.in_(curved).value, atol=1e-9)
        flat = curved.at_point(force.tool_position)
        assert flat.quadric is None
        np.testing.assert_allclose(there.axes(), flat.rotation, atol=1e-12)
        body, q, v = burnish.RigidBody(ROBOT.model), ROBOT.posture("tilt_45"), np.full(ROBOT.model.nv, 0.3)
        body.update(q, v)
        np.testing.assert_allclose(body.velocity("tool", curved), body.velocity("tool", flat), atol=1e-12)
        assert np.abs(body.acceleration("tool", curved) - body.acceleration("tool", flat)).max() > 1e-3
        with pytest.raises(burnish.Error, match="fixed to the tool itself"):
            body.velocity("tool", curved.replace(axes="tool"))

    def test_set_surface_changes_the_axes(self) -> None:
        near = np.array([0.5, 0.1, 0.1])
        ball, plane = burnish.Quadric.sphere([0.5, 0.1, -0.3], 0.4), burnish.Quadric.plane(near, [0.0, 0.6, 0.8])
        dynamics = dynamics_of(ContactSpec("pad", tool="tool", directions="z", reference=Reference.on(ball, near)))
        zero = np.zeros(ROBOT.model.nv)
        dynamics.set_surface("pad", plane)
        dynamics.forward(ROBOT.posture("tilt_45"), zero, zero)
        np.testing.assert_allclose(dynamics.force("pad").axes()[:, 2], [0.0, 0.6, 0.8], atol=1e-12)
        flat = dynamics_of(ContactSpec("pad", tool="tool", reference=Reference.centered()))
        with pytest.raises(burnish.Error, match="has no curved surface"):
            flat.set_surface("pad", plane)

    def test_sliding_contact_has_friction_forces(self) -> None:
        assert burnish.SlidingFriction().speed is None
        friction = burnish.SlidingFriction(coefficient=0.3, speed=0.01)
        spec = ContactSpec("pad", tool="tool", directions="z", friction=friction)
        smooth, rough = dynamics_of(spec.replace(friction=None)), dynamics_of(spec)
        q, zero = ROBOT.posture("tilt_45"), np.zeros(ROBOT.model.nv)
        smooth.inverse(q, zero, zero, [30.0])
        v = 0.3 * np.ones(ROBOT.model.nv)
        for dynamics in (smooth, rough):
            dynamics.inverse(q, v, zero, [30.0])
        x, y, z = rough.force("pad").value[:3]
        np.testing.assert_allclose([np.hypot(x, y), z], [9.0, 30.0], rtol=0.02)
        np.testing.assert_allclose(smooth.force("pad").value[:3], [0.0, 0.0, 30.0], atol=1e-12)
        rough.set_friction("pad", 0.0)
        rough.inverse(q, v, zero, [30.0])
        np.testing.assert_allclose(rough.tau, smooth.tau, atol=1e-9)
        with pytest.raises(burnish.Error, match="has no friction"):
            smooth.set_friction("pad", 0.1)
        with pytest.raises(burnish.Error, match="wanted at least 0"):
            rough.set_friction("pad", -0.1)

    def test_rotation_is_copied(self) -> None:
        rotation = np.eye(3)
        reference = Reference.local(rotation)
        rotation[0, 0] = 5.0
        assert np.asarray(reference.rotation)[0, 0] == 1.0


class TestContacts:
    def test_contact_has_one_row_per_direction_in_order(self) -> None:
        for directions, count in [("z", 1), ("linear", 3), ("z,rx,ry", 3), ("all", 6), ("x, y", 2)]:
            spec = ContactSpec(tool="tool", directions=directions)
            assert burnish.ContactDynamics(ROBOT.model, [spec]).rows == count
        spec = ContactSpec(name="pad", tool="tool", directions="ry,z,rx")
        assert burnish.ContactDynamics(ROBOT.model, [spec]).row_names == ["pad/z", "pad/rx", "pad/ry"]

    def test_unnamed_contact_is_named_after_its_tool(self) -> None:
        (compiled,) = burnish.ContactDynamics(ROBOT.model, [ContactSpec(tool="tool")]).contacts
        assert compiled == ContactSpec(name="tool", tool="tool")

    def test_with_gains_leaves_the_original(self) -> None:
        spec = ContactSpec(tool="tool")
        gains = spec.with_gains(7.0, 3.0)
        assert np.all(np.asarray(spec.kp) == 0.0) and np.all(np.asarray(gains.kp) == 7.0)
        assert np.all(np.asarray(gains.kd) == 3.0) and gains.tool == "tool"

    def test_invalid_contact_raises_with_the_reason(self) -> None:
        for spec, sentence in [
            (ContactSpec(tool="tol"), "did you mean 'tool'"),
            (ContactSpec(tool="tool", directions="zz"), "zz"),
            (ContactSpec(tool="tool", directions=""), "directions"),
            (ContactSpec(tool="tool").with_gains(-1.0, 0.0), "gain"),
            (ContactSpec(tool="tool", reference=Reference(rotation=2.0 * np.eye(3))), "rotation"),
            (ContactSpec(tool="tool", base="tool"), "tool"),
        ]:
            with pytest.raises(burnish.Error, match=sentence):
                burnish.ContactDynamics(ROBOT.model, [spec])
        with pytest.raises(burnish.Error, match="another contact has this name"):
            burnish.ContactDynamics(ROBOT.model, 2 * [ContactSpec(tool="tool")])

    def test_negative_mu_raises(self) -> None:
        with pytest.raises(burnish.Error, match="mu"):
            burnish.ContactDynamics(ROBOT.model, [], burnish.ContactSolver(mu=-1.0))


class TestForces:
    def test_force_names_contact_frames_and_reference(self) -> None:
        force = dynamics_of(ContactSpec(name="pad", tool="tool", directions="linear")).force("pad")
        assert (force.contact, force.on, force.by) == ("pad", "tool", "world")
        assert force.reference == Reference.centered()
        assert "on tool, by the world" in force.text()

    def test_force_is_the_same_wrench_in_every_reference(self) -> None:
        force = dynamics_of(ContactSpec(tool="tool", directions="pad_z")).force(0)
        axes, origin = force.axes(), force.origin()
        f = axes @ force.value[:3]
        at_zero = axes @ force.value[3:] + np.cross(origin, f)
        for reference in REFERENCES:
            other = force.in_(reference)
            axes, origin = other.axes(), other.origin()
            np.testing.assert_allclose(axes @ other.value[:3], f, atol=1e-9)
            np.testing.assert_allclose(
                axes @ other.value[3:] + np.cross(origin, axes @ other.value[:3]), at_zero, atol=1e-9)
            np.testing.assert_allclose(other.in_(force.reference).value, force.value, atol=1e-9)

    def test_force_values_match_wrench(self) -> None:
        dynamics = dynamics_of(ContactSpec(tool="tool", directions="all"))
        for reference in REFERENCES:
            np.testing.assert_allclose(dynamics.wrench("tool", reference),
                                       dynamics.force("tool").in_(reference).value, atol=1e-9)

    def test_unknown_contact_raises(self) -> None:
        dynamics = dynamics_of(ContactSpec(name="pad", tool="tool", directions="z"))
        with pytest.raises(burnish.Error, match="unknown contact 'pat'; did you mean 'pad'"):
            dynamics.force("pat")
        for number in (1, -1):
            with pytest.raises(burnish.Error, match=f"no contact {number}; the set has 1"):
                dynamics.force(number)


class TestLoops:
    ROBOT = burnish.load_robot("four_bar")

    def test_model_lists_its_loops(self) -> None:
        [loop] = self.ROBOT.model.loops
        assert (loop.name, loop.first, loop.second) == ("pin", "pin/first", "pin/second")
        assert loop.directions == "x,y,z"

    def test_loop_contacts_have_independent_rows(self) -> None:
        [contact] = burnish.contact.loop_contacts(self.ROBOT.model)
        assert (contact.tool, contact.base, contact.directions) == ("pin/second", "pin/first", "x,z")
        gains = burnish.contact.LoopGains.for_step(0.02)
        assert burnish.contact.loop_contacts(self.ROBOT.model, gains)[0].kd[0] == pytest.approx(50.0)

    def test_four_bar_has_one_degree_of_freedom(self) -> None:
        freedom = burnish.contact.loop_freedom(self.ROBOT.model, self.ROBOT.reference_configuration())
        assert (freedom.rows, freedom.rank, freedom.freedom) == (3, 2, 1)
        assert [(r.loop, r.directions) for r in freedom.redundant] == [("pin", "y")]

    def test_projection_closes_postures_and_velocities(self) -> None:
        model = self.ROBOT.model
        q = self.ROBOT.reference_configuration() + np.array([0.0, 0.1, -0.1])
        assert burnish.contact.loop_misses(model, q)[0].translation > 1e-2
        found = burnish.contact.project_onto_loops(model, q)
        assert burnish.contact.loop_misses(model, found.q)[0].translation < 1e-8
        assert found.explanation() == ""
        v = burnish.contact.project_velocity_onto_loops(model, found.q, [1.0, 0.0, 0.0], keep=["drive"])
        assert v[0] == pytest.approx(1.0)
        dynamics = burnish.ContactDynamics(model, burnish.contact.loop_contacts(model))
        dynamics.forward(found.q, v, np.zeros(3))
        np.testing.assert_allclose(dynamics.contact_velocity, 0.0, atol=1e-9)
