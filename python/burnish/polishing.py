"""The polishing task: what it is, its runs and experiments."""

from __future__ import annotations

__all__: list[str] = []
