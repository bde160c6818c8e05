"""Values and settings with which each key of a task file has an effect.

Keys without an entry have an effect in the shipped file, with a value made from the value there."""

from __future__ import annotations

from typing import Dict, List, NamedTuple, Sequence


class Case(NamedTuple):
    setting: Sequence[str] = ()
    """Overrides before the override of the key."""
    values: Sequence[str] = ()
    """Values in YAML, one of which must have an effect. Empty: made from the value in the file."""
    refused: bool = False
    """Whether the task must refuse the values."""


def at(*setting: str, to: Sequence[str] = (), refused: bool = False) -> Case:
    return Case(setting, to, refused)


def refused(*values: str) -> Case:
    return Case((), values, True)


def push(force: str, duration: float, start: float, frame: str = "tool") -> str:
    return f"disturbances.pushes=[{{start: {start}, duration: {duration}, force: {force}, frame: {frame}}}]"


def loss(joint: str) -> str:
    return f"[{{start: 0.1, duration: 1, joint: {joint}, share: 0}}]"


def slippery(foot: str) -> str:
    return f"[{{start: 0.05, duration: 1, frame: {foot}, friction: 0.01}}]"


UNSEEN: Dict[str, str] = {
    "limits.stale": "a simulated sensor always answers",
    "limits.bad": "a simulated measurement is a state",
    "limits.failed_solves": "no key makes the solver fail for certain",
    "limits.joint_margin": "plans and the check of the start keep joints within their limits",
    "stand: model_error.quiescent_scale": "on feet, the error of some joint drifts during the whole short run",
    "push_wall: model_error.quiescent_scale": "on feet, the error of some joint drifts during the whole short run",
    "disturbances.torque_limits": "no commanded torque exceeds the limits of these robots",
}
"""Keys whose effect a simulated run cannot show, in all tasks or in one, and the reason."""

_NEVER = ("limits.force=never", "limits.tool_speed=never", "limits.joint_speed_ratio=never")
_OF_UNIT = ("gyro_noise", "gyro_bias_range", "gyro_bias_walk", "accelerometer_noise", "accelerometer_bias_range",
            "accelerometer_bias_walk")
_IMU_FAULT = ("[{start: 0.05, duration: 0.1, gyro_offset: [0.1, 0, 0], accelerometer_offset: [0, 0, 0], "
              "frozen: false, silent: false}]")
_PAYLOAD = "{{frame: {}, mass: 1, com: [0, 0, 0], radius: 0.05, mass_range: 0, com_range: 0}}"
_DELAYS = {key: at(to=["0.004"]) for key in (
    "controller.command_delay", "controller.measurement_delay", "disturbances.measurement_delay")}
_MOVES = "{amplitude: 0.001, frequency: 5, drift: 0, start: 0}"


def _shape(kind: str, *more: str, to: Sequence[str] = ()) -> Case:
    return at(f"shape.kind={kind}", *more, to=to)


def _arm(joint: str, joints: int) -> Dict[str, Case]:
    """Keys common to tasks of a pressing arm."""
    each = "[" + ", ".join(["0.9"] * joints) + "]"
    lift = (push("[0, 0, 200]", 0.03, 0.2), *_NEVER)
    return {
        **_DELAYS,
        "tool.axis": at("posture=search", to=["[0, 0.3, -1]"]),
        "posture": at(to=["search"]),
        "search.joint_margin": at("posture=search", to=["1.5"], refused=True),
        "search.body_distance": at("posture=search", to=["5"], refused=True),
        "limits.joint_speed_ratio": at(to=["0.001"]),
        "limits.tool_speed": at(to=["0.001"]),
        "limits.late_contact_travel": at("disturbances.surface_height=-0.01", to=["0.001"]),
        "limits.late_contact_time": at("disturbances.surface_height=-0.01", to=["0.01"]),
        "limits.unexpected_force": at(to=["0.1"]),
        "limits.release": at("limits.unexpected_force=1", to=["0.001"]),
        "limits.contact_lost": at(*lift, to=["0.001"]),
        "limits.contact_threshold": at(to=["20"]),
        "limits.force": at(push("[0, 0, -100]", 0.02, 0.25), "limits.force=never", to=["45"]),
        "limits.force_window": at(push("[0, 0, -300]", 0.004, 0.25), to=["0.05", "0.0005"]),
        "limits.deadline": at(to=["1e-9"]),
        "limits.late_solves": at("limits.deadline=1e-9", to=["20"]),
        "limits.torque_gap": at(f"disturbances.motor_losses={loss(joint)}", "limits.torque_gap=never", to=["0.001"]),
        "constraints.torque": at(to=["0.05", "0.1", "0.2"]),
        "disturbances.torque_scale": at(to=[each]),
        "disturbances.torque_bias": at(to=[each]),
        "disturbances.torque_loop": at("disturbances.joint_coulomb=1"),
        "disturbances.joint_friction_share": at("disturbances.joint_coulomb=1", to=["0.001"]),
        "disturbances.motor_losses": at(to=[loss(joint)]),
        "disturbances.payload": at(to=[_PAYLOAD.format("tool")]),
        "disturbances.surface_motion": at(to=[_MOVES]),
        "disturbances.pushes": at(to=["[{start: 0.1, duration: 0.05, force: [10, 0, 0], frame: tool}]"]),
    }


def _polishing() -> Dict[str, Case]:
    two = ("robot=talos:two_arms", "posture=two_arms", "force=25", "surface.frame=plate", "surface.normal=[0, 0, 1]",
           "surface.point=[0, 0, 0]", "surface.extent=0.03", "waving.shift=[0, 0.05, 0]", "waving.turn=[0, 0, 0.17]",
           "path.radius=0.02", "waving.start_up=0.1")
    feet = ("robot=talos", "surface=board", "posture=standing_board",
            "standing.feet=[left_sole_link, right_sole_link]", "controller.solver_delay=0.005",
            "controller.horizon=0.3", "controller.knots=8", "model_error.bandwidth=60", "model_error.transient_scale=2",
            "weights.velocity=5", "limits.force=200", "standing.settle=0.1", "standing.hoist=0.05")
    resting = (*feet, "posture=standing_rest", "rest.frame=left_tool")
    slips = (*feet, f"disturbances.slippery_ground={slippery('left_sole_link')}")
    sine = ("force_profile.kind=sine", "force_profile.frequency=10")
    steps = "force_profile.points=[[0.02, 20], [0.05, 30]]"
    cases = {
        **_arm("arm_right_2_joint", 6),
        "robot": at("posture=search", to=["talos:two_arms", "arm7"]),
        "tool.frame": at("posture=search", "search.tilt=1.2", to=["gripper_right_base_link"]),
        "surface.friction": at(to=["0", "0.8"]),
        "surface.extent": at("path.radius=0.02", to=["0"]),
        "surface.point": at(to=["[0.5, -0.3, 1.0]"]),
        "surface.frame": at(*two, to=["arm_left_7_link"], refused=True),
        "search.tilt": at("tool.axis=[0, 0.3, -1]", to=["0.01"], refused=True),
        "shape.kind": at(to=["sphere"]),
        "shape.radius": _shape("sphere"), "shape.ring": _shape("torus"), "shape.half_angle": _shape("cone"),
        "shape.semi_axes": _shape("ellipsoid"), "shape.curvature": _shape("saddle"),
        "shape.edge": _shape("ridge", "shape.edge=0.004", to=["0.01"]),
        "shape.slope": _shape("ridge", "shape.edge=0.004"), "shape.hollow": _shape("sphere"),
        "shape.turn_deg": _shape("cylinder", to=["30"]),
        **{f"waving.{key}": at(*two) for key in ("shift", "turn", "frequency", "position", "rotation")},
        "waving.start_up": at(*two, to=["0.2"]),
        **{f"standing.{key}": at(*feet) for key in (
            "half_x", "half_y", "friction", "stiffness", "damping", "balance", "base", "momentum",
            "internal_forces", "contact_kd", "estimate", "hoist", "settle", "force_sensors")},
        "standing.plan_friction": at(*feet, to=["0.01"]), "standing.plan_sole": at(*feet, to=["0.05"]),
        "standing.min_load": at(*feet, to=["420"]),
        "standing.radius": at(*feet, "standing.half_x=0", "standing.half_y=0"),
        "standing.feet": at(*feet, to=["[left_sole_link]"]),
        "standing.fallback": at(*feet, to=["{stiffness: 50, damping: 15, saturation_fraction: 0.5}"]),
        "standing.after_fault": at(*feet, "limits.joint_speed_ratio=0.0001", "standing.after_fault=0.1", to=["0.2"]),
        "standing.slip": at(*slips, to=["{distance: 1e-5, speed: 1e-4, load: 1}"]),
        "limits.support_slip": at(*slips, to=["0.0001"]),
        "limits.base_lost": at(*feet, "disturbances.imu_faults=[{start: 0.05, duration: 1, gyro_offset: [0, 0, 0], "
                               "accelerometer_offset: [0, 0, 0], frozen: false, silent: true}]", *_NEVER,
                               push("[0, 0, 6000]", 0.2, 0.12, "base_link"), to=["0.001"]),
        "rest.frame": at(*feet, "posture=standing_rest", to=["left_tool"]),
        **{f"rest.{key}": at(*resting) for key in ("force", "radius", "stiffness", "weight")},
        "rest.normal": at(*resting, to=["[0.1, 0, 1]"]), "rest.friction": at(*resting, to=["0"]),
        "rest.plan_friction": at(*resting, to=["0.001"]), "rest.slip": at(*resting, to=["1e-7"]),
        "path.kind": at(to=["spiral"]),
        "path.pitch": at("path.kind=spiral"),
        **{f"path.{key}": at("path.kind=zigzag") for key in ("width", "height", "rows", "speed")},
        "path.points": at("path.kind=points", "path.points=[[0.02, 0]]", to=["[[0, 0.02]]"]),
        "force_profile.kind": at(steps, to=["steps"]),
        "force_profile.points": at(steps, "force_profile.kind=steps", to=["[[0.02, 25]]"]),
        "force_profile.amplitude": at(*sine), "force_profile.frequency": at(*sine, to=["20"]),
        "force_profile.start": at(*sine, to=["0.05"]), "force_profile.preview": at(*sine),
        "verdict.contact_share": at(push("[0, 0, 200]", 0.03, 0.2), *_NEVER, "verdict.contact_share=0.1",
                                    "verdict.path_share=0", "verdict.force_rmse=never", to=["1"]),
        "verdict.force_rmse": at(to=["0.001"]),
        "controller.step": at(to=["0.05"]), "controller.horizon": at(to=["0.14"]), "controller.knots": at("controller.horizon=0.14", to=["5"]),
        "controller.tick_rate": at(to=["2000"]), "controller.timing": at(to=["thread"]),
        "controller.solver_delay": at(to=["0.002"]), "controller.slowdown": at("controller.timing=measured", to=["50"]),
        "controller.solver": at(to=["rollout"]),
        "controller.friction_speed": at("friction_estimate.coefficient=0.3"),
        "controller.axes": at(to=["local"]),
        "constraints.joint_torque_rate": at("controller.torque_cutoff=60", to=["1"]),
        "constraints.joint_margin": at(to=["0.5"], refused=True),
        "model_error.kind": at(to=["none"]),
        "model_error.quiescent_scale": at("phases.reach_duration=0.3"),
        "model_error.lag": at(to=["0.004"]), "model_error.force_gain": at(to=["0.5"]),
        **{f"friction_estimate.{key}": at("friction_estimate.enabled=true") for key in (
            "deviation", "wander", "force_noise", "noise_time", "speed")},
        **{f"fallback.{key}": at("limits.tool_speed=0.01") for key in ("stiffness", "damping")},
        "fallback.saturation_fraction": at("limits.tool_speed=0.01", to=["0.0001"]),
        **{f"disturbances.{key}": at(*feet, to=["2"]) for key in (
            *_OF_UNIT, "support_force_noise", "support_moment_noise")},
        "disturbances.gyro_step": at(*feet, to=["0.01"]), "disturbances.accelerometer_step": at(*feet, to=["0.1"]),
        "disturbances.imu_faults": at(*feet, to=[_IMU_FAULT]),
        "disturbances.surface_curvature": _shape("sphere", to=["2"]),
        "disturbances.surface_shape": at(to=["{kind: sphere, radius: 0.3}"]),
        "disturbances.slippery_ground": at(*feet, to=[slippery("left_sole_link")]),
    }
    return cases


def _press_hold() -> Dict[str, Case]:
    ball = "{kind: sphere, radius: 0.05}"
    return {
        **_arm("joint_2", 7),
        "tool.axis": at("posture=search", to=["[0, 0.1, 1]", "[0, 0.3, 1]"]),
        "robot": at("posture=search", "aside={}", to=["talos:right_arm"]),
        "tool.frame": at("posture=search", to=["link_7"]),
        "aside": at(to=["{joint_1: 0.2}"]), "search.joint_margin": at("posture=search", to=["3"], refused=True),
        "surface.friction": at(to=["0.8"]),
        "surface.extent": at("aside={joint_1: 1}", "constraints.joint_speed=never", to=["1e-6"]),
        "search.tilt": at("tool.axis=[0, 0.3, 1]", to=["0.01"], refused=True),
        "constraints.joint_margin": at(to=["0.5"], refused=True),
        "constraints.joint_speed": at(to=["0.05"]),
        "limits.slip": at(to=["1e-7"]),
        "disturbances.seed": at("disturbances=sensors", to=["3"]),
        "disturbances.velocity_cutoff": at("disturbances.finite_difference_velocity=true", to=["100"]),
        "disturbances.surface_shape": at(to=[ball]),
        "disturbances.surface_curvature": at(f"disturbances.surface_shape={ball}", to=["3"]),
    }


def _on_feet(foot: str, joint: str, joints: int, frame: str) -> Dict[str, Case]:
    """Keys common to tasks on feet."""
    each = "[" + ", ".join(["0.9"] * joints) + "]"
    fault = ("limits.joint_speed_ratio=0.0001", "standing.after_fault=0.1")
    slips = f"disturbances.slippery_ground={slippery(foot)}"
    return {
        **_DELAYS,
        "standing.fallback": at(to=["{stiffness: 50, damping: 15, saturation_fraction: 0.5}"]),
        "standing.after_fault": at(*fault, to=["0.2"]),
        "standing.slip": at(slips, to=["{distance: 1e-5, speed: 1e-4, load: 1}"]),
        "controller.tick_rate": at(to=["2000"]),
        "model_error.kind": at(to=["none"]), "model_error.lag": at(to=["0.004"]),
        "constraints.joint_margin": at(to=["3"], refused=True),
        "constraints.joint_speed": at(to=["0.01"]),
        "limits.slip": at(slips, to=["1e-5"]), "limits.support_slip": at(slips, to=["1e-5"]),
        "limits.joint_speed_ratio": at(to=["0.001"]),
        "limits.deadline": at(to=["1e-9"]), "limits.late_solves": at("limits.deadline=1e-9", to=["20"]),
        "limits.torque_gap": at(f"disturbances.motor_losses={loss(joint)}", "limits.torque_gap=never", to=["0.001"]),
        "disturbances.torque_scale": at(to=[each]), "disturbances.torque_bias": at(to=[each]),
        "disturbances.torque_loop": at("disturbances.joint_coulomb=1"),
        "disturbances.joint_friction_share": at("disturbances.joint_coulomb=1", to=["0.001"]),
        "disturbances.motor_losses": at(to=[loss(joint)]),
        "disturbances.imu_faults": at(to=[_IMU_FAULT]),
        "disturbances.payload": at(to=[_PAYLOAD.format(frame)]),
        "disturbances.slippery_ground": at(to=[slippery(foot)]),
        "disturbances.pushes": at(to=[f"[{{start: 0.1, duration: 0.05, force: [10, 0, 0], frame: {frame}}}]"]),
    }


def _stand() -> Dict[str, Case]:
    hit = "disturbances.pushes=[{start: 0.4, duration: 0.1, force: [0, 100, 0], frame: trunk}]"
    soles = ("robot=talos", "posture=standing_board", "standing.feet=[left_sole_link, right_sole_link]",
             "standing.half_x=0.1", "standing.half_y=0.065", "standing.stiffness=2e6", "standing.damping=1e5")
    # Friction of joints between the feet cannot be identified; the arms of Talos move freely.
    with_friction = (*soles, "disturbances=joint_friction")
    return {
        **_on_feet("fl_foot", "fl_hip", 18, "trunk"),
        "robot": at("posture=search", to=["talos"], refused=True),
        "crouch": at("posture=search", to=["0.3"]),
        "standing.feet": at(to=["[fl_foot, fr_foot, rl_foot]"]),
        "standing.half_x": at(to=["0.02"], refused=True), "standing.half_y": at(to=["0.02"], refused=True),
        "standing.plan_sole": at(*soles, to=["0.05"]),
        "model_error.transient_scale": at(hit, "phases.rest_duration=0.5", to=["1"]),
        "model_error.limit": at(to=["0.001"]),
        "model_error.joint_friction": at(*with_friction), "model_error.friction_speed": at(*with_friction),
        "limits.base_lost": at("disturbances.imu_faults=[{start: 0.05, duration: 1, gyro_offset: [0, 0, 0], "
                               "accelerometer_offset: [0, 0, 0], frozen: false, silent: true}]",
                               push("[0, 0, 1500]", 0.2, 0.15, "trunk"), "limits.joint_speed_ratio=never",
                               to=["0.001"]),
        "limits.sink": at(to=["1e-6"]), "limits.tilt": at(to=["1e-6"]),
    }


def _push_wall() -> Dict[str, Case]:
    unit = ("standing.estimate=true",)
    return {
        **_on_feet("left_sole_link", "arm_left_2_joint", 36, "base_link"),
        "robot": at(to=["quadruped"], refused=True), "posture": at(to=["standing_board"], refused=True),
        "model_error.force_gain": at(to=["0.5"]),
        "hands": at(to=["[tool, left_tool]"]), "wall.normal": at(to=["[-1, 0, 0.01]"]),
        "wall.friction": at(to=["0.05"]),
        "standing.feet": at(to=["[left_sole_link]"]),
        "standing.radius": at("standing.half_x=0", "standing.half_y=0"),
        "standing.force_sensors": at(to=["false"], refused=True),
        "force_search.force_max": at(to=["60"]), "force_search.reserve": at("force_search.rate=100", to=["5"]),
        "force_search.force_tolerance": at("force_search.rate=100", to=["0.01"]), "force_search.slip": at("force_search.rate=100", to=["1e-6"]),
        "limits.sink": at(to=["1e-6"]), "limits.late_contact": at("disturbances.surface_height=-0.01", to=["0.001"]),
        "limits.contact_lost": at("limits.contact_threshold=24", to=["0.001"]),
        "limits.contact_threshold": at(to=["45"]),
        "limits.force": at(push("[500, 0, 0]", 0.15, 0.6, "left_tool"), "limits.slip=never", to=["75"]),
        **{f"disturbances.{key}": at(*unit, to=["0.5"]) for key in _OF_UNIT},
        "disturbances.gyro_step": at(*unit, to=["0.01"]), "disturbances.accelerometer_step": at(*unit, to=["0.1"]),
        "disturbances.imu_faults": at(*unit, to=[_IMU_FAULT]),
        "standing.settle": at(*unit),
    }


class Task(NamedTuple):
    module: str
    file: str
    short: List[str]
    """Overrides that shorten a run of the file."""
    cases: Dict[str, Case]


TASKS: Dict[str, Task] = {
    "polishing": Task("polishing", "polishing/table.yaml", [
        "phases.clearance=0.002", "phases.reach_duration=0.05", "phases.ramp_duration=0.05",
        "phases.polish_duration=0.12", "phases.retreat_duration=0.1", "controller.horizon=0.1", "controller.step=0.02",
        "controller.update_rate=200", "controller.tick_rate=1000", "path.start_up=0.05",
        "weights.position=1e4", "model_error.transient_scale=6", "model_error.bandwidth=120"], _polishing()),
    "press_hold": Task("press_hold", "press_hold/arm7.yaml", [
        "phases.clearance=0.002", "phases.ramp_duration=0.05", "phases.aside_duration=0.4", "phases.hold_duration=0.1",
        "phases.retreat_duration=0.1", "controller.tick_rate=500"], _press_hold()),
    "stand": Task("stand", "stand/quadruped.yaml", [
        "phases.settle_duration=0.1", "phases.sway_duration=0.25", "phases.rest_duration=0.05", "sway.rise=0.1",
        "controller.horizon=0.3", "controller.knots=6", "standing.settle=0.1", "standing.hoist=0.05"], _stand()),
    "push_wall": Task("push_wall", "push_wall/talos.yaml", [
        "phases.settle_duration=0.1", "phases.clearance=0.003", "phases.approach_speed=0.02",
        "phases.ramp_duration=0.1", "phases.hold_duration=0.4", "force_search.rate=1000", "force_search.hold_duration=0.4",
        "phases.release_duration=0.1", "phases.retreat_duration=0.1", "standing.settle=0.2", "standing.hoist=0.1",
        "controller.update_rate=100", "controller.solver_delay=0.01", "force_search.force_max=70", "controller.horizon=0.6",
        "controller.knots=10", "standing.estimate=false"], _push_wall()),
}
