"""Where frames are, and what their motions are written in."""

from __future__ import annotations

import enum

from ._core import frame_placement, frame_placements

__all__ = ["FrameAxes", "frame_placement", "frame_placements"]


class FrameAxes(enum.Enum):
    """What a frame's motion is written in; its acceleration is everywhere the time derivative of
    those six numbers."""

    LOCAL = 0
    """the frame's own axes and origin (acceleration: its spatial one)"""
    CENTERED = 1
    """world axes, the frame's origin (acceleration: of the material point there)"""
    WORLD = 2
    """world axes, the world's origin (acceleration: spatial, in the world)"""
