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

__all__ = ["Base", "BoxShape", "CylinderShape", "FileJoint", "Following", "Frame", "FrameKind", "FrameSpec",
           "InertiaSpec", "Joint", "JointConvention", "JointKind", "JointOrder", "JointSpec", "JointType", "LinkSpec",
           "Loop", "LoopSpec", "MeshShape", "MimicSpec", "Model", "ModelOptions", "Posture", "Robot", "RobotOverrides",
           "Shape", "SiblingOrder", "SphereShape", "Tendon", "TendonEntry", "TendonPart", "TendonSpec", "TreeSpec",
           "Visual", "VisualSpec", "build_model", "check_configuration", "check_tangent", "configuration",
           "difference", "integrate", "load_robot", "normalized", "parse_mjcf", "parse_urdf", "placement",
           "random_configuration", "read_mjcf", "read_urdf", "robot_search_path", "tangent_map"]

Posture = Dict[str, List[float]]
"""Joint coordinates by name: a list per joint, as in URDF. The name of a free-flyer base is
"root_joint"."""


def placement(xyz: ArrayLike = (0.0, 0.0, 0.0), rpy: ArrayLike = (0.0, 0.0, 0.0)) -> NDArray[np.float64]:
    """Makes a placement from a position and roll-pitch-yaw angles, as in URDF.

    Parameters
    ----------
    xyz : array_like, shape (3,)
        Position [m].
    rpy : array_like, shape (3,)
        Roll, pitch, yaw [rad] about the fixed axes x, y, z.

    Returns
    -------
    ndarray, shape (4, 4)
        Homogeneous transformation matrix.
    """
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


# scripts/describe inserts the described classes here.


Shape = Union[BoxShape, CylinderShape, SphereShape, MeshShape]


@dataclass(eq=False, repr=False)
class RobotOverrides(Spec):
    """Changes to the settings file of a robot."""

    base: Optional[Base] = None
    locked: List[str] = items()
    """Joints to lock in addition to the locked joints of the settings"""
    free: List[str] = items()
    """The only joints that move; replaces `lock` and `free` of the settings"""
    carrying: str = ""
    """Link, joint or frame to which a tool is attached. For a robot without a settings file, joints that do
    not move the tool are locked. Empty or unknown: all joints move"""
    posture: str = ""
    """Name of the posture in which joints are locked; empty: the posture of the settings"""
    srdf: str = ""
    """SRDF file whose group_states become postures; empty: the file that the settings name, or an SRDF file
    beside the URDF file"""
    strict: bool = False
    """Treat warnings about the robot as errors"""
