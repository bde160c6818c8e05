"""Where frames are, and what their motions are written in."""

from __future__ import annotations

__all__: list[str] = []
