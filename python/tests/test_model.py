"""Robots: descriptions, compiled models, configurations."""

from __future__ import annotations

import copy
import math
import pickle
from pathlib import Path

import numpy as np
import pytest

import burnish
from burnish import JointKind, JointSpec, JointType, LinkSpec, ModelOptions, TreeSpec

TALOS = burnish.load_robot("talos")
ARM = burnish.load_robot("talos:right_arm")


def two_links(joint: JointSpec) -> TreeSpec:
    inertia = burnish.InertiaSpec(mass=2.0, com=[0.0, 0.0, 0.5], inertia_at_com=0.1 * np.eye(3))
    return TreeSpec(name="two", links=[LinkSpec("base"), LinkSpec("body", inertia)], joints=[joint])


def joint(kind: JointType, **entries: object) -> JointSpec:
    return JointSpec(**{"name": "j", "type": kind, "parent_link": "base", "child_link": "body",
                        **entries})  # type: ignore[arg-type]


class TestRobotsByName:
    def test_sizes_match_the_joints(self) -> None:
        model = TALOS.model
        assert model.nq == sum(j.nq for j in model.joints) == len(model.q_names)
        assert model.nv == sum(j.nv for j in model.joints) == len(model.v_names)
        assert model.joints[0].kind is JointKind.FREE_FLYER
        for entries in (model.q_neutral, model.q_lower, model.q_upper):
            assert entries.shape == (model.nq,)
        for entries in (model.velocity_limit, model.effort_limit, model.damping, model.friction,
                        model.armature):
            assert entries.shape == (model.nv,)
        assert model.total_mass == pytest.approx(sum(j.mass for j in model.joints))

    def test_repr_names_robot_and_sizes(self) -> None:
        assert repr(ARM.model) == "<Model 'talos': 6 joints, nq = 6, nv = 6>"
        assert repr(ARM).startswith("<Robot 'talos': ")

    def test_locked_joints_leave_the_model(self) -> None:
        locked = burnish.load_robot("arm7", burnish.RobotOverrides(locked=["joint_7"]))
        free = burnish.load_robot("arm7")
        assert locked.model.nv == free.model.nv - 1
        assert "joint_7" in locked.model.locked_joints

    def test_unknown_name_raises_with_the_nearest(self) -> None:
        with pytest.raises(burnish.Error, match="talos"):
            burnish.load_robot("tallos")
        with pytest.raises(burnish.Error, match="did you mean 'tool'"):
            ARM.model.frame_index("tol")

    def test_postures_are_configurations(self) -> None:
        for name, posture in TALOS.postures.items():
            np.testing.assert_array_equal(TALOS.posture(name),
                                          burnish.configuration(TALOS.model, posture))
        np.testing.assert_array_equal(TALOS.reference_configuration(),
                                      TALOS.posture(TALOS.default_posture))

    def test_search_path_contains_talos(self) -> None:
        assert any((folder / "talos").is_dir() for folder in burnish.robot_search_path())


class TestCopies:
    @pytest.mark.parametrize("make", [copy.copy, copy.deepcopy,
                                      lambda robot: pickle.loads(pickle.dumps(robot))])
    def test_copied_robot_equals_the_original(self, make: object) -> None:
        again = make(TALOS)  # type: ignore[operator]
        assert again is not TALOS and again == TALOS and again.model == TALOS.model
        assert again.postures == TALOS.postures and again.default_posture == TALOS.default_posture
        assert again.model.joints == TALOS.model.joints
        assert again.model.frames == TALOS.model.frames
        assert again.model.visuals == TALOS.model.visuals
        for name in ("q_lower", "effort_limit", "damping", "friction", "armature", "gravity"):
            np.testing.assert_array_equal(getattr(again.model, name), getattr(TALOS.model, name))
        bodies = range(-1, len(TALOS.model.joints))
        assert [again.model.support(b) for b in bodies] == [TALOS.model.support(b) for b in bodies]

    def test_pickled_model_gives_the_same_acceleration(self) -> None:
        model = pickle.loads(pickle.dumps(ARM.model))
        q = ARM.posture("tilt_45")
        results = []
        for each in (ARM.model, model):
            dynamics = burnish.ContactDynamics(each)
            dynamics.forward(q, np.ones(each.nv), np.ones(each.nv))
            results.append(dynamics.a)
        np.testing.assert_array_equal(*results)

    def test_models_with_a_difference_are_unequal(self) -> None:
        tree = two_links(joint(JointType.REVOLUTE))
        model = burnish.build_model(tree)
        assert model == burnish.build_model(tree)
        tree.joints[0].damping = 0.5
        assert model != burnish.build_model(tree)
        assert model != "two" and ARM != TALOS

    def test_model_outlives_its_robot(self) -> None:
        model = burnish.load_robot("arm7").model
        assert model.name == "arm7" and len(model.joints) == model.nv

    def test_arrays_of_a_model_are_copies(self) -> None:
        ARM.model.q_lower[:] = 100.0
        ARM.model.joints[0].mass = 100.0
        assert ARM.model.q_lower[0] != 100.0 and ARM.model.joints[0].mass != 100.0

    def test_model_attributes_are_read_only(self) -> None:
        with pytest.raises(AttributeError):
            ARM.model.nq = 3  # type: ignore[misc]


class TestWarnings:
    XML = ("<robot><link name='base'/><link name='tip'/><joint name='hinge' type='continuous'>"
           "<parent link='base'/><child link='tip'/></joint></robot>")

    def test_loaded_robot_lists_its_warnings(self, tmp_path: Path) -> None:
        file = tmp_path / "finger.urdf"
        file.write_text(self.XML)
        robot = burnish.load_robot(str(file))
        assert robot.model.name == "finger"
        assert len(robot.warnings) == 2 and robot.warnings == robot.model.warnings
        assert "no name" in robot.warnings[0] and "'hinge' moves no mass" in robot.warnings[1]
        assert len(burnish.read_urdf(file).warnings) == 1
        assert pickle.loads(pickle.dumps(robot)).warnings == robot.warnings
        assert TALOS.warnings == []
        with pytest.raises(burnish.Error, match="2 problems.*moves no mass.*strict"):
            burnish.load_robot(str(file), burnish.RobotOverrides(strict=True))

    def test_strict_build_raises_on_warnings(self) -> None:
        tree = burnish.parse_urdf(self.XML, "finger.urdf")
        assert tree.joints[0].line == 1
        assert len(burnish.build_model(tree).warnings) == 2
        with pytest.raises(burnish.Error, match="no name"):
            burnish.build_model(tree, ModelOptions(strict=True))

    def test_several_problems_are_in_one_error(self) -> None:
        tree = burnish.parse_urdf(self.XML)
        tree.links[1].inertia.mass = -1.0
        tree.joints[0].parent_link = "bas"
        with pytest.raises(burnish.Error, match=r"2 problems: \(1\) .*'base'\?.* \(2\) .*negative"):
            burnish.build_model(tree)


class TestDescriptions:
    def test_built_model_has_the_values_of_the_description(self) -> None:
        tree = two_links(joint(JointType.REVOLUTE, axis=[0.0, 1.0, 0.0], lower=-1.0, upper=2.0,
                               armature=0.25))
        model = burnish.build_model(tree, ModelOptions(gravity=[0.0, 0.0, -10.0]))
        assert (model.nq, model.nv, model.name) == (1, 1, "two")
        assert (model.q_lower[0], model.q_upper[0], model.armature[0]) == (-1.0, 2.0, 0.25)
        dynamics = burnish.ContactDynamics(model)
        dynamics.forward([math.pi / 2], [0.0], [0.0])
        # The centre of mass is 0.5 m from the axis, at its height.
        assert dynamics.a[0] == pytest.approx(2.0 * 10.0 * 0.5 / (0.1 + 2.0 * 0.25 + 0.25))

    def test_ball_joints_springs_and_tendons_are_compiled(self) -> None:
        model = burnish.build_model(two_links(joint(JointType.BALL, stiffness=2.0)))
        assert (model.nq, model.nv) == (4, 3)
        assert model.joints[0].kind is JointKind.BALL
        np.testing.assert_array_equal(model.stiffness, [2.0, 2.0, 2.0])
        body = burnish.RigidBody(model)
        body.update(np.array([0.0, 0.0, np.sin(0.1), np.cos(0.1)]), np.zeros(3))
        np.testing.assert_allclose(body.passive_torque, [0.0, 0.0, -0.4], atol=1e-12)
        assert body.spring_energy == pytest.approx(0.04)
        tree = two_links(joint(JointType.REVOLUTE))
        part = burnish.TendonPart(tree.joints[0].name, 3.0)
        tree.tendons = [burnish.TendonSpec("cord", [part], stiffness=5.0)]
        model = burnish.build_model(tree)
        assert [(t.name, t.parts[0].coefficient) for t in model.tendons] == [("cord", 3.0)]
        assert pickle.loads(pickle.dumps(model)) == model

    def test_mimic_joint_compiles_to_a_follower(self) -> None:
        tree = two_links(joint(JointType.REVOLUTE))
        tree.links.append(LinkSpec("third", tree.links[1].inertia))
        second = joint(JointType.REVOLUTE)
        second.name, second.parent_link, second.child_link = "follower", "body", "third"
        second.mimic = burnish.MimicSpec(tree.joints[0].name, -2.0, 0.5)
        tree.joints.append(second)
        model = burnish.build_model(tree)
        assert (model.nq, model.nv, len(model.joints)) == (1, 1, 2)
        assert model.joints[0].follows is None
        follows = model.joints[1].follows
        assert follows is not None
        assert (follows.leader, follows.multiplier, follows.offset) == (0, -2.0, 0.5)
        assert pickle.loads(pickle.dumps(model)) == model
        dynamics = burnish.ContactDynamics(model)
        dynamics.forward([0.3], [0.1], [1.0])
        assert dynamics.mass_matrix.shape == (1, 1)

    def test_joint_type_is_accepted_by_name_or_refused(self) -> None:
        assert burnish.build_model(two_links(joint("continuous"))).nq == 2  # type: ignore[arg-type]
        with pytest.raises(burnish.Error, match="JointType: there is no 'revolut'; did you mean"):
            burnish.build_model(two_links(joint("revolut")))  # type: ignore[arg-type]

    def test_invalid_description_raises_with_the_reason(self) -> None:
        tree = two_links(joint(JointType.REVOLUTE, child_link="bodi"))
        with pytest.raises(burnish.Error, match="bodi"):
            burnish.build_model(tree)
        tree = two_links(joint(JointType.REVOLUTE, axis=[0.0, 1.0]))
        with pytest.raises(burnish.Error, match=r"JointSpec.axis: got \[0.0, 1.0\]; wanted 3 num"):
            burnish.build_model(tree)
        tree = two_links(joint(JointType.REVOLUTE, placement=np.ones((4, 4))))
        with pytest.raises(burnish.Error, match="rotation"):
            burnish.build_model(tree)

    def test_urdf_is_read_from_text_and_file(self, tmp_path: Path) -> None:
        text = ('<robot name="r"><link name="a"/><link name="b"><inertial><mass value="1"/><inertia '
                'ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link><joint name="j" '
                'type="prismatic"><parent link="a"/><child link="b"/><limit lower="0" upper="2" '
                'effort="3" velocity="4"/></joint></robot>')
        file = tmp_path / "r.urdf"
        file.write_text(text)
        for tree in (burnish.parse_urdf(text), burnish.read_urdf(file),
                     burnish.read_urdf(str(file))):
            assert tree.joints[0].type is JointType.PRISMATIC
            assert burnish.build_model(tree).effort_limit[0] == 3.0
        with pytest.raises(burnish.Error, match="here.urdf"):
            burnish.parse_urdf("<robot", source="here.urdf")

    def test_mjcf_is_read_from_text_and_file(self, tmp_path: Path) -> None:
        text = ('<mujoco model="m"><option gravity="0 0 -2"/><worldbody><light/><body name="b"><joint name="j" '
                'type="slide" range="0 2"/><geom size="0.1"/><site name="tip" pos="0 0 1"/></body>'
                '</worldbody><actuator><motor joint="j" ctrlrange="-3 3"/></actuator><keyframe><key '
                'name="home" qpos="1"/></keyframe></mujoco>')
        file = tmp_path / "m.xml"
        file.write_text(text)
        for tree in (burnish.parse_mjcf(text), burnish.read_mjcf(file)):
            assert tree.joints[0].type is JointType.PRISMATIC
            assert [frame.name for frame in tree.frames] == ["tip"]
            assert tree.postures == {"home": {"j": [1.0]}}
            np.testing.assert_array_equal(tree.gravity, [0.0, 0.0, -2.0])
            assert burnish.build_model(tree).effort_limit[0] == 3.0
        robot = burnish.load_robot(str(file))
        assert robot.default_posture == "home"
        assert robot.model.gravity[2] == -2.0
        assert robot.warnings == [] and robot.notes == robot.model.notes
        assert len(robot.notes) == 1 and "1 <light>" in robot.notes[0]
        strict = burnish.load_robot(str(file), burnish.RobotOverrides(strict=True))
        assert strict.notes == robot.notes
        with pytest.raises(burnish.Error, match="here.xml"):
            burnish.parse_mjcf("<mujoco", source="here.xml")

    def test_mjcf_model_has_the_order_of_qpos(self) -> None:
        tree = burnish.parse_mjcf(
            '<mujoco><worldbody><body name="z"><freejoint name="base"/><geom size="0.1"/><body name="y">'
            '<joint name="first"/><geom size="0.1"/></body><body name="x"><joint name="afterwards"/>'
            '<geom size="0.1"/></body><body name="w"><joint name="held"/><geom size="0.1"/></body></body>'
            '</worldbody><equality><joint joint1="held" polycoef="0.3 0 0 0 0"/></equality></mujoco>')
        assert tree.sibling_order is burnish.SiblingOrder.AS_LISTED
        model = burnish.build_model(tree)
        assert [j.name for j in model.joints] == ["base", "first", "afterwards"]
        assert [j.name for j in model.file_joints] == ["base", "first", "afterwards", "held"]
        assert model.file_joints[3].joint == -1 and model.file_joints[3].held == [0.3]
        order = burnish.JointOrder.mujoco(model)
        qpos = np.array([1.0, 2.0, 3.0, 0.8, 0.0, 0.0, 0.6, 0.1, 0.2, 0.3])
        q = order.q_from(qpos)
        np.testing.assert_allclose(q, [1.0, 2.0, 3.0, 0.0, 0.0, 0.6, 0.8, 0.1, 0.2])
        np.testing.assert_allclose(order.q_to(q), qpos)
        v = order.v_from(np.arange(9.0), q)
        np.testing.assert_allclose(order.v_to(v, q), [0, 1, 2, 3, 4, 5, 6, 7, 0], atol=1e-14)
        assert pickle.loads(pickle.dumps(model)) == model

    def test_joint_order_converts_vectors_by_name(self) -> None:
        model = burnish.load_robot("arm7").model
        names = [f"joint_{k}" for k in (7, 6, 5, 4, 3, 2, 1)]
        order = burnish.JointOrder(model, names)
        values = np.arange(7.0) / 10.0
        np.testing.assert_array_equal(order.q_from(values), values[::-1])
        np.testing.assert_array_equal(order.tau_to(values, model.q_neutral), values[::-1])
        part = burnish.JointOrder(model, names[:2], "mujoco")
        np.testing.assert_array_equal(part.tau_from([1.0, 2.0], model.q_neutral), [0, 0, 0, 0, 0, 2, 1])
        with pytest.raises(burnish.Error, match="leaves out joints 'joint_1'"):
            part.q_from([0.0, 0.0])
        with pytest.raises(burnish.Error, match="did you mean 'joint_1'"):
            burnish.JointOrder(model, ["jiont_1"])

    def test_visual_shapes_are_kept(self) -> None:
        tree = two_links(joint(JointType.FIXED))
        shapes = [burnish.BoxShape([1.0, 2.0, 3.0]), burnish.CylinderShape(0.5, 2.0),
                  burnish.SphereShape(0.25), burnish.MeshShape("part.stl", [1.0, 1.0, 2.0])]
        tree.links[0].visuals = [burnish.VisualSpec(shape) for shape in shapes]
        assert [visual.shape for visual in burnish.build_model(tree).visuals] == shapes


class TestConfigurations:
    def test_difference_inverts_integrate_for_one_state_and_rows(self) -> None:
        model = TALOS.model
        q = burnish.random_configuration(model, seed=3, count=5)
        dq = np.random.default_rng(1).uniform(-1.0, 1.0, (5, model.nv))
        moved = burnish.integrate(model, q, dq)
        assert moved.shape == q.shape
        np.testing.assert_allclose(burnish.difference(model, q, moved), dq, atol=1e-12)
        np.testing.assert_array_equal(burnish.integrate(model, q[2], dq[2]), moved[2])
        np.testing.assert_allclose(burnish.integrate(model, q[2].tolist(), list(dq[2])), moved[2])

    def test_tangent_map_is_the_derivative_of_integrate(self) -> None:
        model = TALOS.model
        q = burnish.random_configuration(model, seed=4)
        step = 1e-6 * np.eye(model.nv)
        columns = [(burnish.integrate(model, q, h) - burnish.integrate(model, q, -h)) / 2e-6
                   for h in step]
        np.testing.assert_allclose(burnish.tangent_map(model, q), np.transpose(columns), atol=1e-8)

    def test_random_configurations_depend_on_the_seed_and_keep_limits(self) -> None:
        model = ARM.model
        rows = burnish.random_configuration(model, seed=7, count=20)
        np.testing.assert_array_equal(rows, burnish.random_configuration(model, 7, 20))
        np.testing.assert_array_equal(rows[0], burnish.random_configuration(model, 7))
        assert not np.array_equal(rows, burnish.random_configuration(model, 8, 20))
        assert (rows >= model.q_lower).all() and (rows <= model.q_upper).all()
        assert burnish.random_configuration(model, 7, 0).shape == (0, model.nq)
        with pytest.raises(burnish.Error, match="count is -1"):
            burnish.random_configuration(model, 7, -1)

    def test_failed_check_names_the_argument(self) -> None:
        model = TALOS.model
        q = model.q_neutral
        burnish.check_configuration(model, q)
        q[3:7] *= 1.1
        with pytest.raises(burnish.Error, match="q_start"):
            burnish.check_configuration(model, q, "q_start")
        burnish.check_configuration(model, burnish.normalized(model, q))
        v = np.zeros(model.nv)
        burnish.check_tangent(model, v)
        v[5] = np.nan
        with pytest.raises(burnish.Error, match="v_start"):
            burnish.check_tangent(model, v, argument="v_start")
        with pytest.raises(burnish.Error):
            burnish.integrate(model, q, np.zeros(3))
        with pytest.raises(burnish.Error, match="equal numbers of rows"):
            burnish.integrate(model, np.zeros((2, model.nq)), np.zeros((3, model.nv)))

    def test_placement_matches_the_conventions_of_urdf(self) -> None:
        X = burnish.model.placement([1.0, 2.0, 3.0], [0.1, 0.2, 0.3])
        text = ('<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="fixed">'
                '<parent link="a"/><child link="b"/><origin xyz="1 2 3" rpy="0.1 0.2 0.3"/></joint>'
                '</robot>')
        np.testing.assert_allclose(burnish.parse_urdf(text).joints[0].placement, X, atol=1e-15)


class TestFrames:
    def test_frame_placements_are_in_the_order_of_frames(self) -> None:
        model, q = TALOS.model, TALOS.reference_configuration()
        placements = burnish.frame_placements(model, q)
        assert placements.shape == (len(model.frames), 4, 4)
        for name in ("left_sole_link", "right_sole_link"):
            np.testing.assert_array_equal(placements[model.frame_index(name)],
                                          burnish.frame_placement(model, q, name))
        np.testing.assert_array_equal(burnish.frame_placement(model, q, "world"), np.eye(4))

    def test_unknown_frame_raises_with_the_nearest(self) -> None:
        q = ARM.posture("tilt_45")
        with pytest.raises(burnish.Error, match="did you mean 'tool'"):
            burnish.frame_placement(ARM.model, q, "tol")
        with pytest.raises(burnish.Error):
            burnish.frame_placements(ARM.model, q[:3])
        assert ARM.model.has_frame("tool") and not ARM.model.has_frame("tol")


def test_robots_with_equal_contents_are_equal() -> None:
    again = burnish.load_robot("talos:right_arm")
    assert again == ARM and again.model == ARM.model == copy.deepcopy(ARM.model)
    assert ARM.model != TALOS.model and ARM != TALOS and ARM.model != "right_arm"
    light = two_links(joint(JointType.REVOLUTE))
    heavy = copy.deepcopy(light)
    heavy.links[1].inertia.mass = 3.0
    assert burnish.build_model(light) == burnish.build_model(light) != burnish.build_model(heavy)
