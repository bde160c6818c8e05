"""Optimal control problems: residuals, costs, stages, horizons, the checker."""

from __future__ import annotations

__all__: list[str] = []
