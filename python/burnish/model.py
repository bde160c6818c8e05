"""Robots: descriptions, compiled models, configurations."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Dict, List, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._core import (
    JointOrder,
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
    parse_mjcf,
    parse_urdf,
    random_configuration,
    read_mjcf,
    read_urdf,
    robot_search_path,
    tangent_map,
)
from ._spec import Spec, items

__all__ = [
    "Base", "BoxShape", "CylinderShape", "Following", "Frame", "FrameKind", "FrameSpec", "InertiaSpec", "Joint",
    "JointConvention", "JointKind", "JointOrder", "JointSpec", "JointType", "LinkSpec", "Loop", "LoopSpec",
    "MeshShape", "MimicSpec", "Model", "ModelOptions", "Posture", "Robot", "RobotOverrides", "Shape",
    "SiblingOrder", "SphereShape", "StatedJoint", "Tendon", "TendonEntry", "TendonPart", "TendonSpec",
    "TreeSpec", "Visual", "VisualSpec", "build_model", "check_configuration", "check_tangent", "configuration",
    "difference", "integrate", "load_robot", "normalized", "parse_mjcf", "parse_urdf", "placement",
    "random_configuration", "read_mjcf", "read_urdf", "robot_search_path", "tangent_map",
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


# Described classes stand here (scripts/describe).


Shape = Union[BoxShape, CylinderShape, SphereShape, MeshShape]


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
