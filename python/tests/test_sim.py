"""Plants, disturbances and closed loops, of the library and written in Python."""

from __future__ import annotations

import copy
import gc
import os
import pickle
import signal
import threading
import time

import numpy as np
import pytest

import burnish
from burnish import Status


@pytest.fixture(scope="module")
def robot() -> burnish.Robot:
    return burnish.load_robot("arm7")


@pytest.fixture(scope="module")
def q(robot):
    return robot.posture("ready")


@pytest.fixture(scope="module")
def scene(robot, q):
    tip = burnish.TouchSpec("tool")
    return burnish.SceneSpec([burnish.with_surface_at(robot.model, q, [0.1, 0.0, 1.0], tip, clearance=0.005)])


class Posture(burnish.Controller):
    """Controller with a spring and a damper in every joint."""

    def __init__(self, model, q, kp=200.0, kd=20.0):
        self.nv = model.nv
        self.q, self.kp, self.kd = np.array(q), kp, kd
        self.resets, self.ticks = 0, 0

    def reset(self):
        self.resets += 1

    def tick(self, measurement):
        self.ticks += 1
        return burnish.Command(
            tau=self.kp * (self.q - measurement.q) - self.kd * measurement.v,
            phase=burnish.Phase.TRACK,
            tools=[burnish.ToolCommand(target_force=1.5, p_target_world=[1.0, 2.0, 3.0])],
        )


class Wrapped(burnish.Plant):
    """Plant of the library behind the interface of a Python plant."""

    def __init__(self, inner):
        self.inner = inner
        self.model, self.scene, self.dt = inner.model, inner.scene, inner.dt

    def reset(self, q, v=None):
        self.inner.reset(q, v)

    def step(self, tau):
        self.inner.step(tau)

    q = property(lambda self: self.inner.q)
    v = property(lambda self: self.inner.v)
    time = property(lambda self: self.inner.time)
    wrenches = property(lambda self: self.inner.wrenches)
    friction_torque = property(lambda self: self.inner.friction_torque)


def slider():
    """Returns the model of a mass of 2 kg on a rail along z, without gravity."""
    tree = burnish.TreeSpec(
        name="slider",
        links=[
            burnish.LinkSpec("rail"),
            burnish.LinkSpec("tool", burnish.InertiaSpec(2.0, inertia_at_com=np.eye(3))),
        ],
        joints=[burnish.JointSpec("z", "prismatic", "rail", "tool", axis=[0.0, 0.0, 1.0])],
    )
    return burnish.build_model(tree, burnish.ModelOptions(gravity=[0.0, 0.0, 0.0]))


class PointMass:
    """Slider integrated in Python, without a base class of burnish."""

    dt = 1e-3

    def __init__(self, model, scene=None):
        self.model = model
        self.scene = burnish.SceneSpec() if scene is None else scene
        self.q, self.v = np.zeros(1), np.zeros(1)

    def reset(self, q, v):
        self.q, self.v = q, v

    def step(self, tau):
        a = tau / 2.0
        self.q = self.q + self.dt * self.v + 0.5 * self.dt**2 * a
        self.v = self.v + self.dt * a


ALL = burnish.Disturbances(
    seed=7,
    command_delay=2e-3,
    torque_cutoff=300.0,
    torque_scale_range=0.05,
    torque_bias_range=0.2,
    torque_noise=0.01,
    encoder_bits=18,
    position_noise=1e-5,
    velocity_noise=1e-3,
    force_noise=0.1,
    joint_viscous=0.1,
    joint_coulomb=0.05,
    mass_scale=1.02,
    pushes=[burnish.Push(0.1, 0.05, [5.0, 0.0, 0.0])],
)


def make_loop(robot, scene, q, wrap=False, disturbances=ALL, **options):
    plant = burnish.make_ideal_plant(
        burnish.plant_model(robot.model, disturbances), burnish.plant_scene(scene, disturbances))
    controller = Posture(robot.model, q)
    loop = burnish.ClosedLoop(Wrapped(plant) if wrap else plant, controller, disturbances,
                              burnish.ClosedLoopOptions(**options))
    loop.reset(q)
    return loop


def rows(loop):
    return loop.trace.array().tobytes()


def test_surface_moved_to_a_touch_has_the_given_clearance(robot, q, scene):
    touch = scene.tool()
    assert np.isclose(np.linalg.norm(touch.surface.normal), 1.0)
    body = burnish.RigidBody(robot.model)
    body.update(q, np.zeros(robot.model.nv))
    p_tip = body.placement("tool")[:3, 3]
    assert np.allclose(touch.surface.point + (touch.radius + 0.005) * touch.surface.normal, p_tip)
    assert np.isclose(burnish.gap(touch, p_tip), 0.005)
    with pytest.raises(burnish.Error, match="did you mean 'tool'"):
        burnish.checked_scene(robot.model, burnish.SceneSpec([burnish.TouchSpec("tol")]))
    with pytest.raises(burnish.Error, match="did you mean 'tool'"):
        burnish.with_surface_at(robot.model, q, [0.0, 0.0, 1.0], burnish.TouchSpec("tol"))
    with pytest.raises(burnish.Error, match="two touches with frame 'tool'"):
        burnish.checked_scene(robot.model, burnish.SceneSpec([touch, touch]))


def test_scene_gives_its_tool_supports_and_touches_by_frame():
    foot, other, hand = (burnish.TouchSpec(name, is_support=name != "hand") for name in ("left", "right", "hand"))
    scene = burnish.SceneSpec([foot, other, hand])
    assert scene.tool_index() == 2 and scene.tool() is hand
    assert [touch.frame for touch in scene.supports()] == ["left", "right"] and scene.supports()[0] is foot
    scene.touch("right").surface.friction = 0.7
    assert other.surface.friction == 0.7
    with pytest.raises(burnish.Error, match="no touch 'righ'; did you mean 'right'"):
        scene.touch("righ")
    standing = burnish.SceneSpec([foot])
    assert standing.tool_index() == -1
    with pytest.raises(burnish.Error, match="no tool"):
        standing.tool()
    assert burnish.SceneSpec().touches == []


def test_disturbances_change_model_and_scene(robot, scene):
    d = burnish.Disturbances(mass_scale=1.1, joint_viscous=0.3, surface_height=0.01,
                             surface_friction=0.4, surface_tilt_deg=[0.0, 5.0])
    model, real = burnish.plant_model(robot.model, d), burnish.plant_scene(scene, d)
    assert np.isclose(model.total_mass, 1.1 * robot.model.total_mass)
    assert np.all(model.damping == 0.3) and np.all(model.friction == 0.0)
    surface, nominal = real.tool().surface, scene.tool().surface
    assert surface.friction == 0.4
    assert np.isclose(surface.normal @ nominal.normal, np.cos(np.radians(5.0)))
    assert np.allclose(surface.point - nominal.point, 0.01 * nominal.normal)
    with pytest.raises(burnish.Error, match="torque_scale"):
        burnish.check_disturbances(robot.model, burnish.Disturbances(torque_scale=[1.0]))


def test_invalid_disturbance_raises_with_its_name(robot, scene):
    with pytest.raises(burnish.Error, match="Disturbances.seed: got 'x'; wanted a whole number"):
        burnish.check_disturbances(robot.model, burnish.Disturbances(seed="x"))
    with pytest.raises(AttributeError, match="did you mean 'torque_bias'"):
        burnish.Disturbances().torque_bais = 1.0


def test_circle_path_starts_at_rest_and_becomes_a_circle():
    path = burnish.CirclePath(center_world=[1.0, 0.0, 0.0], radius=0.1, rate=2.0, force=20.0)
    start = path.at(-1.0)
    assert np.allclose(start.p_world, [1, 0, 0]) and np.allclose(start.v_world, 0)
    later = path.at(5.0)
    assert np.isclose(np.linalg.norm(later.p_world - [1, 0, 0]), 0.1)
    assert np.isclose(np.linalg.norm(later.v_world), 0.2) and later.force == 20.0


def test_restored_plant_repeats_the_same_states(robot, q, scene):
    plant = burnish.make_ideal_plant(robot.model, scene, burnish.IdealPlantOptions(dt=1e-3))
    assert isinstance(plant, burnish.Plant) and plant.dt == 1e-3
    plant.reset(q)
    assert plant.time == 0.0 and np.array_equal(plant.q, q) and not np.any(plant.v)
    zero = np.zeros(robot.model.nv)
    for _ in range(20):
        assert plant.step(zero) == Status.OK
    assert np.isclose(plant.time, 0.02) and np.any(plant.v != 0.0)
    snapshot = pickle.loads(pickle.dumps(plant.save()))
    body = burnish.RigidBody(robot.model)
    def fall():
        states = []
        for i in range(200):
            body.update(plant.q, plant.v)
            push = body.frame_derivatives("tool", "centered").jacobian[1]  # of 1 N along y
            plant.step(zero + push)
            states.append((plant.q, plant.v, plant.wrenches, plant.friction_torque))
        return states
    first = fall()
    assert all(state[2].shape == (6, 1) for state in first)
    assert any(state[2].any() for state in first), "the tool must touch the surface"
    plant.restore(snapshot)
    assert np.isclose(plant.time, 0.02)
    for a, b in zip(first, fall()):
        assert all(np.array_equal(x, y) for x, y in zip(a, b))
    with pytest.raises(burnish.EvaluationError, match="Plant.restore"):
        plant.restore(burnish.PlantSnapshot([1.0, 2.0]))


def test_invalid_state_or_torque_raises(robot, q, scene):
    plant = burnish.make_ideal_plant(robot.model, scene)
    with pytest.raises(burnish.Error, match=f"Plant.reset: q has 3 entries; wanted {robot.model.nq}"):
        plant.reset(q[:3])
    with pytest.raises(burnish.EvaluationError, match="Plant.reset"):
        plant.reset(np.full(robot.model.nq, np.nan))
    plant.reset(q)
    before = plant.q
    with pytest.raises(burnish.EvaluationError, match="Plant.step"):
        plant.step(np.full(robot.model.nv, np.nan))
    zero = np.zeros(robot.model.nv)
    for push in ({"push_world": [0.0, 1.0, 0.0]}, {"push": None}):
        with pytest.raises(TypeError, match="wanted pushes in Disturbances.pushes of a ClosedLoop, or J"):
            plant.step(zero, **push)
    with pytest.raises(TypeError, match="Disturbances.pushes"):
        plant.step(zero, [0.0, 1.0, 0.0])
    assert np.array_equal(plant.q, before) and plant.time == 0.0
    with pytest.raises(burnish.Error, match="dt"):
        burnish.make_ideal_plant(robot.model, scene, burnish.IdealPlantOptions(dt=0.0))


def test_plant_arrays_are_copies_and_model_outlives_plant(robot, q, scene):
    plant = burnish.make_ideal_plant(robot.model, scene)
    plant.reset(q)
    reading, model = plant.q, plant.model
    reading[:] = 0.0
    assert np.array_equal(plant.q, q)
    name = model.name
    del plant
    gc.collect()
    assert model.name == name and model.nv == robot.model.nv


@pytest.mark.skipif(not burnish.has_mujoco(), reason="this build has no MuJoCo")
def test_mujoco_and_ideal_plant_fall_alike(robot, q, scene):
    ideal = burnish.make_ideal_plant(robot.model, scene)
    mujoco = burnish.make_mujoco_plant(robot.model, scene)
    for plant in (ideal, mujoco):
        plant.reset(q)
        for _ in range(40):
            plant.step(np.zeros(robot.model.nv))
    assert np.allclose(ideal.q, mujoco.q, atol=1e-4) and np.any(np.abs(ideal.q - q) > 1e-4)


@pytest.mark.skipif(burnish.has_mujoco(), reason="this build has MuJoCo")
def test_build_without_mujoco_raises(robot, scene):
    with pytest.raises(burnish.Error, match="no MuJoCo"):
        burnish.make_mujoco_plant(robot.model, scene)


def test_repeated_run_gives_the_same_bits(robot, q, scene):
    first, second = make_loop(robot, scene, q), make_loop(robot, scene, q)
    assert first.run(0.3) == Status.OK
    for _ in range(600):
        second.step()
    assert rows(first) == rows(second) and len(first.trace) == 600
    first.reset(q)
    assert len(first.trace) == 0
    first.run(0.3)
    assert rows(first) == rows(second)
    other = make_loop(robot, scene, q, disturbances=ALL.replace(seed=8))
    other.run(0.3)
    assert rows(other) != rows(first)


def test_python_plant_gives_the_same_bits(robot, q, scene):
    ours, theirs = make_loop(robot, scene, q, wrap=True), make_loop(robot, scene, q)
    assert isinstance(ours.plant, Wrapped)
    assert ours.run(0.25) == theirs.run(0.25) == Status.OK
    assert rows(ours) == rows(theirs)
    assert ours.trace["tool_force_x_world"].any(), "the tool must touch the surface"
    time, push = ours.trace["time"], ours.trace["push_x_world"]
    assert np.all(push[(time > 0.0998) & (time < 0.1498)] == 5.0), "the push lasts from 0.1 s to 0.15 s"
    assert np.all(push[(time < 0.0998) | (time > 0.1498)] == 0.0)
    assert not ours.trace["push_y_world"].any()


def test_object_with_the_attributes_of_a_plant_is_accepted():
    model = slider()
    scene = burnish.SceneSpec([burnish.TouchSpec("tool", surface=burnish.SurfaceSpec(point=[0, 0, -9.0]))])
    ideal = burnish.make_ideal_plant(model, scene, burnish.IdealPlantOptions(dt=1e-3))
    traces = []
    for plant in (PointMass(model, scene), ideal):
        loop = burnish.ClosedLoop(plant, Posture(model, [0.1], kp=8.0, kd=3.0),
                                  burnish.Disturbances(pushes=[burnish.Push(1.0, 0.2, [0, 0, 4.0])]))
        loop.reset([0.0], [0.5])
        loop.run(3.0)
        traces.append(loop.trace)
    for column in ("time", "q_z", "v_z", "tau_applied_z", "tool_z_world"):
        assert np.allclose(traces[0][column], traces[1][column], atol=1e-12), column
    assert np.ptp(traces[0]["q_z"]) > 0.1


def test_python_controller_keeps_a_posture(robot, q, scene):
    loop = make_loop(robot, scene, q, disturbances=burnish.Disturbances())
    controller = loop.controller
    assert controller.resets == 1
    loop.run(0.5)
    assert controller.ticks == 500
    assert np.abs(loop.plant.q - q).max() < 0.6
    assert np.abs(loop.plant.v).max() < 0.05
    assert loop.command.tools[0].target_force == 1.5 and loop.command.phase == burnish.Phase.TRACK
    assert np.all(loop.trace["target_y_world"] == 2.0)
    assert np.isclose(loop.measurement.time, 0.499)


def test_python_plant_reports_the_wrenches_on_its_touches():
    model = slider()
    scene = burnish.SceneSpec([burnish.TouchSpec("tool", surface=burnish.SurfaceSpec(point=[0, 0, -9.0]),
                                                 sensor=burnish.WrenchSensor.WRENCH)])

    class Touching(PointMass):
        wrenches = np.array([[1.0], [2.0], [3.0], [0.1], [0.2], [0.3]])

    loop = burnish.ClosedLoop(Touching(model, scene), Posture(model, [0.0]))
    loop.reset([0.0])
    loop.run(0.01)
    assert loop.measurement.wrenches.ravel().tolist() == [1.0, 2.0, 3.0, 0.1, 0.2, 0.3]
    force = [loop.trace[f"tool_force_{axis}_world"][-1] for axis in "xyz"]
    assert np.allclose(force, [1.0, 2.0, 3.0]) and np.all(loop.trace["in_contact"] == 1.0)


def test_controller_states_the_wrenches_that_it_reads(robot, q, scene):
    def measured(touches):
        controller = Posture(robot.model, q)
        if touches != "not stated":
            controller.touches = touches
        loop = burnish.ClosedLoop(burnish.make_ideal_plant(robot.model, scene), controller)
        loop.reset(q)
        loop.step()
        return loop.measurement.wrenches

    for touches in ("not stated", None, ["tool"]):
        wrench = measured(touches)
        assert wrench.shape == (6, 1)
        assert np.all(np.isfinite(wrench[:3])) and np.all(np.isnan(wrench[3:])), "only the force is measured"
    assert measured([]).shape == (6, 0)
    with pytest.raises(burnish.Error, match="'tol', which is not a touch of the plant's scene; did you mean 'tool'"):
        measured(["tol"])
    with pytest.raises(burnish.Error, match="Controller.touches: got 'tool'; wanted a list"):
        measured("tool")


def test_controller_may_return_only_its_torque():
    model = slider()

    class Push:
        nv = 1

        def reset(self):
            pass

        def tick(self, measurement):
            return [1.0]

    loop = burnish.ClosedLoop(PointMass(model), Push())
    loop.reset([0.0])
    loop.run(1.0)
    assert np.isclose(loop.plant.v[0], 0.5)


class Broken(Exception):
    pass


@pytest.mark.parametrize("part", ["plant", "controller", "attribute"])
def test_python_exception_comes_out_of_run(robot, q, scene, part):
    class Plant(Wrapped):
        def step(self, tau):
            if part == "plant" and self.inner.time > 0.0495:
                raise Broken("at 0.05")
            super().step(tau)

        @property
        def v(self):
            if part == "attribute" and self.inner.time > 0.0505:
                raise Broken("at 0.05")
            return self.inner.v

    class Controller(Posture):
        def tick(self, measurement):
            if part == "controller" and measurement.time > 0.0495:
                raise Broken("at 0.05")
            return super().tick(measurement)

    loop = burnish.ClosedLoop(Plant(burnish.make_ideal_plant(robot.model, scene)),
                              Controller(robot.model, q))
    loop.reset(q)
    with pytest.raises(Broken, match="at 0.05"):
        loop.run(1.0)
    assert 100 <= len(loop.trace) <= 102
    if part != "attribute":  # the exception is raised again, because its cause persists
        with pytest.raises(Broken):
            loop.run(0.01) if part == "plant" else loop.run(1.0)
    loop.reset(q)
    assert loop.run(0.04) == Status.OK


def test_signals_of_a_controller_are_columns_of_the_trace(robot, q, scene):
    class Counting(Posture):
        signals = {"ticks": "-", "last": "s"}
        signal_values = {}

        def reset(self):
            super().reset()
            self.count = 0

        def tick(self, measurement):
            self.count += 1
            self.signal_values = {"last": measurement.time, "ticks": self.count}
            return super().tick(measurement)

    plant = burnish.make_ideal_plant(robot.model, scene)
    loop = burnish.ClosedLoop(plant, Counting(robot.model, q))
    loop.reset(q)
    loop.run(0.01)
    trace = loop.trace
    assert trace["signal_ticks"][-1] == sum(trace["tick"])
    assert trace["signal_last"][-1] == trace["time"][np.flatnonzero(trace["tick"])[-1]]
    assert trace.units["signal_last"] == "s"

    class Forgetful(Counting):
        def tick(self, measurement):
            return Posture.tick(self, measurement)

    loop = burnish.ClosedLoop(plant, Forgetful(robot.model, q))
    loop.reset(q)
    with pytest.raises(burnish.Error, match="got no value for signal 'last'"):
        loop.step()

    class Misspelt(Posture):
        @property
        def signals(self):
            return self.signls

    with pytest.raises(AttributeError, match="signls"):
        burnish.ClosedLoop(plant, Misspelt(robot.model, q))


def test_python_exception_comes_out_of_reset_and_step(robot, q, scene):
    class Plant(Wrapped):
        def reset(self, q, v=None):
            raise Broken("reset")

    class Controller(Posture):
        def reset(self):
            raise Broken("reset")

        def tick(self, measurement):
            raise Broken("tick")

    plant = burnish.make_ideal_plant(robot.model, scene)
    with pytest.raises(Broken, match="reset"):
        burnish.ClosedLoop(Plant(plant), Posture(robot.model, q)).reset(q)
    loop = burnish.ClosedLoop(plant, Controller(robot.model, q))
    with pytest.raises(Broken, match="reset"):
        loop.reset(q)
    with pytest.raises(Broken, match="tick"):
        loop.step()


def test_invalid_python_plant_or_controller_raises_with_the_reason(robot, q, scene):
    model = slider()

    def run(plant, controller):
        loop = burnish.ClosedLoop(plant, controller)
        loop.reset([0.0])
        loop.run(0.01)

    class Wide(PointMass):
        def step(self, tau):
            self.q = np.zeros(3)

    class Pushed(PointMass):
        contact_force_world = np.zeros(3)

    class Late(PointMass):
        def reset(self, q, v):
            super().reset(q, v)
            self.contact_force_world = np.zeros(3)

    class Touched(PointMass):
        wrenches = np.zeros((6, 1))

    class Text(Posture):
        def tick(self, measurement):
            return "full speed"

    class Long(Posture):
        def tick(self, measurement):
            return np.zeros(4)

    with pytest.raises(burnish.Error, match="Plant.q: got 3 numbers; wanted 1"):
        run(Wide(model), Posture(model, [0.0]))
    for old in (Pushed, Late):
        with pytest.raises(burnish.Error, match=f"{old.__name__} has 'contact_force_world'; wanted 'wrenches'"):
            run(old(model), Posture(model, [0.0]))
    with pytest.raises(burnish.Error, match="Plant.wrenches: got 6 x 1 numbers; wanted 6 x 0, one column per touch"):
        run(Touched(model), Posture(model, [0.0]))
    with pytest.raises(burnish.Error, match="Controller.tick: got 'full speed'; wanted a Command"):
        run(PointMass(model), Text(model, [0.0]))
    with pytest.raises(burnish.Error, match="torque has 4 entries; wanted 1"):
        run(PointMass(model), Long(model, [0.0]))
    with pytest.raises(burnish.Error, match="Plant: object has no 'model'"):
        run(object(), Posture(model, [0.0]))
    with pytest.raises(burnish.Error, match="Controller: PointMass has no 'nv'"):
        run(PointMass(model), PointMass(model))
    with pytest.raises(burnish.Error, match="7 torques; wanted 1, as the plant has"):
        run(PointMass(model), Posture(robot.model, q))
    with pytest.raises(TypeError, match="abstract"):
        burnish.Plant()  # type: ignore[abstract]


def test_status_of_a_python_plant_ends_the_run():
    class Stuck(PointMass):
        steps = 0

        def step(self, tau):
            self.steps += 1
            return Status.OK if self.steps < 5 else Status.NOT_FINITE

    model = slider()
    loop = burnish.ClosedLoop(Stuck(model), Posture(model, [0.0]))
    loop.reset([0.0])
    with pytest.raises(burnish.EvaluationError, match="ClosedLoop.run"):
        loop.run(1.0)
    assert loop.trace["plant_status"].tolist() == [0, 0, 0, 0, Status.NOT_FINITE.value]


def test_baseline_presses_and_task_exception_comes_out(robot, q, scene):
    tool = scene.tool()
    n = tool.surface.normal
    path = burnish.CirclePath(center_world=tool.surface.point + tool.radius * n,
                              normal_world=n, radius=0.0, force=12.0)
    spec = burnish.ImpedanceSpec(burnish.PressingPath(normal_world=n, task=path.at, posture=q))
    controller = burnish.make_impedance_controller(robot.model, spec)
    assert isinstance(controller, burnish.Controller) and controller.nv == robot.model.nv
    assert controller.touches == ["tool"]
    plant = burnish.make_ideal_plant(burnish.plant_model(robot.model, burnish.Disturbances()), scene)
    loop = burnish.ClosedLoop(plant, controller)
    loop.reset(q)
    loop.run(2.0)
    force = np.array([loop.trace[f"tool_force_{axis}_world"][-1] for axis in "xyz"])
    assert abs(force @ n - 12.0) < 0.1
    body = burnish.RigidBody(robot.model)
    body.update(plant.q, plant.v)
    assert np.allclose(body.placement("tool")[:3, :3] @ plant.wrenches[:3, 0], force, atol=1e-3)
    assert np.allclose(plant.wrenches[3:, 0], 0.0, atol=1e-9), "without friction the force passes through the centre"

    def task(t):
        if t > 0.3005:
            raise Broken(f"{t:.3f}")
        return path.at(t)

    spec.path.task = task
    loop = burnish.ClosedLoop(plant, burnish.make_impedance_controller(robot.model, spec))
    loop.reset(q)
    with pytest.raises(Broken, match="0.301"):
        loop.run(5.0)
    assert loop.trace["phase"][-1] == burnish.Phase.TRACK.value
    spec.path.task = None
    with pytest.raises(burnish.Error, match="task"):
        burnish.make_impedance_controller(robot.model, spec)


def test_same_seed_draws_the_same_numbers(robot, q, scene):
    one = burnish.Actuation(robot.model, ALL, 5e-4)
    two = burnish.Actuation(robot.model, ALL.replace(force_noise=0.0), 5e-4)
    assert np.array_equal(one.scale, two.scale) and np.array_equal(one.bias, two.bias)
    assert np.ptp(one.scale) > 0.0 and np.abs(one.scale - 1.0).max() <= 0.05
    assert one.delay_steps == 4
    tau = np.arange(7.0)
    given = [one.apply(tau) for _ in range(10)]
    one.reset()
    assert all(np.array_equal(one.apply(tau), before) for before in given)
    step = one.last_step
    assert np.array_equal(step.command, tau) and np.array_equal(step.applied, given[-1])
    with pytest.raises(burnish.Error, match="wanted 7"):
        one.apply([1.0])
    loop = make_loop(robot, scene, q)
    assert np.array_equal(loop.actuation.scale, one.scale)

    sensing = burnish.Sensing(robot.model, ALL, scene)
    plant = burnish.make_ideal_plant(robot.model, scene)
    plant.reset(q)
    seen = sensing.measure(plant, np.zeros(7))
    assert np.any(seen.q != q) and np.abs(seen.q - q).max() < 1e-3
    assert seen.wrenches.shape == (6, 1) and 0.0 < np.abs(seen.wrenches[:3]).max() < 1.0
    sensing.reset()
    assert sensing.measure(plant, np.zeros(7)) == seen
    assert burnish.Sensing(robot.model, ALL, scene, touches=[]).measure(plant, np.zeros(7)).wrenches.shape == (6, 0)
    with pytest.raises(burnish.Error, match="no touch 'tol'; did you mean 'tool'"):
        burnish.Sensing(robot.model, ALL, scene, ["tol"])
    with pytest.raises(burnish.Error, match="differ from those of the scene"):
        burnish.Sensing(robot.model, ALL, burnish.SceneSpec()).measure(plant, np.zeros(7))


def test_trace_views_keep_their_loop_alive(robot, q, scene):
    loop = make_loop(robot, scene, q)
    loop.run(0.05)
    times, everything = loop.trace["time"], loop.trace.array()
    kept, row = copy.copy(loop.trace), everything["time"].copy()
    del loop
    gc.collect()
    junk = [np.full(100_000, 3.0) for _ in range(20)]
    assert np.array_equal(times, row) and np.array_equal(everything["time"], row)
    assert np.array_equal(kept["time"], row) and len(junk) == 20
    assert not times.flags.writeable and not everything.flags.writeable
    assert np.allclose(np.diff(times), 5e-4)


def test_full_trace_counts_dropped_rows(robot, q, scene):
    loop = make_loop(robot, scene, q, max_duration=0.01, record_every=2)
    loop.run(0.1)
    assert len(loop.trace) == 12 and loop.trace.dropped == 88


def test_invalid_periods_and_durations_raise(robot, q, scene):
    with pytest.raises(burnish.Error, match="control period"):
        make_loop(robot, scene, q, control_period=7e-4)
    loop = make_loop(robot, scene, q)
    for duration in (-1.0, np.nan):
        with pytest.raises(burnish.Error, match="ClosedLoop.run"):
            loop.run(duration)


def baseline_loop(robot, q, scene):
    """Returns a loop of C++ parts; only its task is a Python function, called at every tick."""
    tool = scene.tool()
    n = tool.surface.normal
    point = burnish.TaskPoint(p_world=tool.surface.point + tool.radius * n, force=10.0)
    controller = burnish.make_impedance_controller(
        robot.model, burnish.ImpedanceSpec(burnish.PressingPath(normal_world=n, task=lambda t: point, posture=q)))
    loop = burnish.ClosedLoop(burnish.make_ideal_plant(robot.model, scene), controller)
    loop.reset(q)
    return loop


def test_loop_in_use_by_a_thread_refuses_another(robot, q, scene):
    loop = baseline_loop(robot, q, scene)
    refused = []

    def knock():
        time.sleep(0.05)
        for call in (loop.step, lambda: loop.plant.step(np.zeros(7)), loop.controller.reset):
            try:
                call()
            except burnish.Error as error:
                refused.append(str(error))

    thread = threading.Thread(target=knock)
    thread.start()
    loop.run(8.0)
    thread.join()
    assert len(refused) == 3 and all("in use by another thread" in text for text in refused)


def test_ctrl_c_ends_a_long_run(robot, q, scene):
    loop = baseline_loop(robot, q, scene)
    timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        loop.run(1e6)
    timer.join()
    assert len(loop.trace) > 10


def test_trace_array_becomes_a_pandas_table(robot, q, scene):
    pandas = pytest.importorskip("pandas")
    loop = make_loop(robot, scene, q)
    loop.run(0.05)
    table = pandas.DataFrame(loop.trace.array())
    assert list(table.columns) == loop.trace.columns and len(table) == 100
    assert np.array_equal(table["time"], loop.trace["time"])
