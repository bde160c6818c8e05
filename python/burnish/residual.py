"""What a cost term measures: one dataclass per residual."""

from __future__ import annotations

__all__: list[str] = []
