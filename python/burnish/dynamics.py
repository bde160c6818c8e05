"""Placements of frames."""

from __future__ import annotations

from ._core import frame_placement, frame_placements

__all__ = ["frame_placement", "frame_placements"]
