"""Contact dynamics with all derivatives, batches of states, the checker."""

from __future__ import annotations

__all__: list[str] = []
