"""Robots: descriptions, compiled models, configurations."""

from __future__ import annotations

import enum
import math
from dataclasses import dataclass, field
from typing import Dict, List, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._core import (
    Model,
    Robot,
    build_model,
    check_configuration,
    check_tangent,
    configuration,
    difference,
    integrate,
    load_robot,
    normalized,
    parse_urdf,
    random_configuration,
    read_urdf,
    robot_search_path,
    tangent_map,
)
from ._spec import Spec, identity, items, vector, zeros

__all__ = [
    "Base", "BoxShape", "CylinderShape", "Following", "Frame", "FrameKind", "FrameSpec", "InertiaSpec", "Joint",
    "JointKind", "JointSpec", "JointType", "LinkSpec", "MeshShape", "MimicSpec", "Model",
    "ModelOptions", "Posture", "Robot", "RobotOverrides", "Shape", "SphereShape", "TreeSpec",
    "Visual", "VisualSpec", "build_model", "check_configuration", "check_tangent", "configuration",
    "difference", "integrate", "load_robot", "normalized", "parse_urdf", "placement",
    "random_configuration", "read_urdf", "robot_search_path", "tangent_map",
]

Posture = Dict[str, List[float]]
"""Values of joints by name, a list per joint (URDF coordinates); the free-flyer base goes by
"root_joint"."""


def placement(xyz: ArrayLike = (0.0, 0.0, 0.0), rpy: ArrayLike = (0.0, 0.0, 0.0)) -> NDArray[np.float64]:
    """A placement as a 4 x 4 array: position (m) and roll, pitch, yaw (rad) about the fixed axes x,
    y, z, as URDF has them."""
    r, p, y = (float(a) for a in np.asarray(rpy, dtype=float))
    cr, sr, cp, sp, cy, sy = (math.cos(r), math.sin(r), math.cos(p), math.sin(p), math.cos(y), math.sin(y))
    result = np.eye(4)
    result[:3, :3] = [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ]
    result[:3, 3] = np.asarray(xyz, dtype=float)
    return result


class JointKind(enum.Enum):
    """Kinds of moving joints."""

    REVOLUTE = 0
    """q = angle, v = rate"""
    CONTINUOUS = 1
    """q = (cos, sin), v = rate"""
    PRISMATIC = 2
    """q = displacement, v = rate"""
    PLANAR = 3
    """q = (x, y, cos, sin), v = (v_x, v_y, w_z) in body axes"""
    FREE_FLYER = 4
    """q = (p, quaternion x y z w), v = (v, w) in body axes"""


class JointType(enum.Enum):
    """Joints as a description has them."""

    FIXED = 0
    REVOLUTE = 1
    CONTINUOUS = 2
    PRISMATIC = 3
    PLANAR = 4
    FLOATING = 5


class FrameKind(enum.Enum):
    """What a named frame belongs to."""

    LINK = 0
    JOINT = 1
    USER = 2


class Base(enum.Enum):
    """How the root link stands in the world."""

    FIXED = 0
    FREE_FLYER = 1


@dataclass(eq=False, repr=False)
class InertiaSpec(Spec):
    """Mass distribution of a link, in the link's axes."""

    mass: float = 0.0
    """kg"""
    com: ArrayLike = zeros(3)
    """centre of mass from the link's origin, m"""
    inertia_at_com: ArrayLike = field(default_factory=lambda: np.zeros((3, 3)))
    """3 x 3, about com, kg m^2"""


@dataclass(eq=False, repr=False)
class BoxShape(Spec):
    size: ArrayLike
    """m, full lengths along x, y, z"""


@dataclass(eq=False, repr=False)
class CylinderShape(Spec):
    radius: float
    """m"""
    length: float
    """m, along z, centred"""


@dataclass(eq=False, repr=False)
class SphereShape(Spec):
    radius: float
    """m"""


@dataclass(eq=False, repr=False)
class MeshShape(Spec):
    """A mesh is kept for drawing only."""

    uri: str
    """as written in the file"""
    scale: ArrayLike
    """per axis"""


Shape = Union[BoxShape, CylinderShape, SphereShape, MeshShape]


@dataclass(eq=False, repr=False)
class VisualSpec(Spec):
    """One solid to draw, attached to a link."""

    shape: Shape
    placement: ArrayLike = identity(4)
    """4 x 4, in the link's frame"""
    rgba: ArrayLike = vector(0.7, 0.7, 0.7, 1.0)


@dataclass(eq=False, repr=False)
class LinkSpec(Spec):
    name: str
    inertia: InertiaSpec = field(default_factory=InertiaSpec)
    visuals: List[VisualSpec] = items()
    line: int = 0
    """of the file, for sentences about it; 0: none"""


@dataclass(eq=False, repr=False)
class MimicSpec(Spec):
    """A joint that copies another: q = multiplier * q_leader + offset."""

    leader: str
    multiplier: float = 1.0
    offset: float = 0.0


@dataclass(eq=False, repr=False)
class JointSpec(Spec):
    name: str
    type: JointType = JointType.FIXED
    parent_link: str = ""
    child_link: str = ""
    placement: ArrayLike = identity(4)
    """4 x 4, of the child link's frame in the parent link's frame when the joint is at zero"""
    axis: ArrayLike = vector(1.0, 0.0, 0.0)
    """in the child link's frame (for PLANAR the normal of the plane)"""
    lower: float = -math.inf
    """rad or m"""
    upper: float = math.inf
    """rad or m"""
    velocity_limit: float = math.inf
    """rad/s or m/s"""
    effort_limit: float = math.inf
    """Nm or N"""
    damping: float = 0.0
    """Nms/rad or Ns/m"""
    friction: float = 0.0
    """Nm or N, Coulomb"""
    armature: float = 0.0
    """kg m^2 or kg"""
    mimic: Optional[MimicSpec] = None
    line: int = 0
    """of the file, for sentences about it; 0: none"""


@dataclass(eq=False, repr=False)
class TreeSpec(Spec):
    """A robot as its description states it: links and joints as plain values. build_model()
    compiles it."""

    name: str = ""
    source: str = ""
    """file it was read from, used in error sentences"""
    links: List[LinkSpec] = items()
    joints: List[JointSpec] = items()
    warnings: List[str] = items()
    """what was odd about the file but stopped nothing; a Model gets them too"""


@dataclass(eq=False, repr=False)
class FrameSpec(Spec):
    """A frame to add while compiling."""

    name: str
    parent: str
    """name of an existing frame"""
    placement: ArrayLike = identity(4)
    """4 x 4, in the parent frame"""


@dataclass(eq=False, repr=False)
class ModelOptions(Spec):
    """How a TreeSpec becomes a Model."""

    base: Base = Base.FIXED
    base_placement: ArrayLike = identity(4)
    """4 x 4, of the root link in the world; with a free-flyer only the neutral posture uses it"""
    locked: List[str] = items()
    """joints to lock, at their value in `posture` or at zero"""
    free: List[str] = items()
    """when not empty: every joint that is not listed here is locked"""
    posture: Posture = field(default_factory=dict)
    """where locked joints are held"""
    frames: List[FrameSpec] = items()
    """added in this order; a parent may be an earlier one"""
    gravity: ArrayLike = vector(0.0, 0.0, -9.81)
    """m/s^2, world"""
    strict: bool = False
    """refuse what would be a warning"""


@dataclass(eq=False, repr=False)
class Following(Spec):
    """How a joint moves with another one: multiplier * value of the leader + offset, rad or m."""

    leader: int = 0
    """index of a joint that follows no other"""
    multiplier: float = 1.0
    offset: float = 0.0


@dataclass(eq=False, repr=False)
class Joint(Spec):
    """A moving joint of a Model and the rigid body that it carries. One that follows another has no
    entries of its own in q and v: its leader's move both."""

    name: str
    kind: JointKind
    parent: int
    """index of the joint that carries this one, -1 for the world"""
    q_index: int
    """first entry in q; of a follower that of its leader"""
    v_index: int
    """first entry in v; of a follower that of its leader"""
    nq: int
    nv: int
    placement: NDArray[np.float64]
    """4 x 4, joint frame at zero in the parent body's frame"""
    mass: float
    """of the body, kg"""
    com: NDArray[np.float64]
    """of the body, in the joint frame, m"""
    inertia_at_com: NDArray[np.float64]
    """3 x 3, of the body, about com, joint axes, kg m^2"""
    follows: Optional[Following] = None
    """the joint that it mimics, directly or through others"""


@dataclass(eq=False, repr=False)
class Frame(Spec):
    """A named frame fixed to a body of a Model."""

    name: str
    kind: FrameKind
    body: int
    """index of the joint whose body carries it, -1 for the world"""
    placement: NDArray[np.float64]
    """4 x 4, in the body's frame (in the world if body is -1)"""


@dataclass(eq=False, repr=False)
class Visual(Spec):
    """A solid to draw, fixed to a body of a Model."""

    link: str
    body: int
    placement: NDArray[np.float64]
    shape: Shape
    rgba: NDArray[np.float64]


@dataclass(eq=False, repr=False)
class RobotOverrides(Spec):
    """Changes to what a robot's settings file says."""

    base: Optional[Base] = None
    locked: List[str] = items()
    """in addition to what the settings lock"""
    free: List[str] = items()
    """these alone move, whatever the settings lock or free"""
    carrying: str = ""
    """a link or joint: of a robot without settings only what carries it moves; empty or unknown: all"""
    posture: str = ""
    """named posture at which joints are locked; empty: the settings' own"""
    srdf: str = ""
    """file whose group_states are postures too; empty: the one that the settings name or that lies beside
    the URDF file"""
    strict: bool = False
    """refuse what would be a warning"""
