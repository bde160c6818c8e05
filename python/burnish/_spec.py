"""What all dataclasses of burnish have in common."""

from __future__ import annotations

import copy
import dataclasses
import functools
from typing import Any, ClassVar, Dict, Tuple, TypeVar

import numpy as np

from . import _core

S = TypeVar("S", bound="Spec")


def _same(a: Any, b: Any) -> bool:
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        if a is None or b is None or callable(a) or callable(b):
            return False
        return np.array_equal(np.asarray(a), np.asarray(b))
    if isinstance(a, (list, tuple)) and isinstance(b, (list, tuple)):
        return len(a) == len(b) and all(_same(x, y) for x, y in zip(a, b))
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(_same(a[k], b[k]) for k in a)
    return bool(a == b)


def _default(field: dataclasses.Field[Any]) -> Any:
    if field.default_factory is not dataclasses.MISSING:
        return field.default_factory()
    return field.default


@functools.lru_cache(maxsize=None)
def _names(of: type) -> Tuple[str, ...]:
    return tuple(f.name for f in dataclasses.fields(of))


class Spec:
    """A plain value: compared entry by entry, printed with what differs from the defaults, copied
    and pickled like any dataclass. Entries that it does not have cannot be set."""

    __dataclass_fields__: ClassVar[Dict[str, dataclasses.Field[Any]]]
    __hash__ = None  # type: ignore[assignment]

    def replace(self: S, **changes: Any) -> S:
        """A deep copy with these entries changed."""
        return dataclasses.replace(copy.deepcopy(self), **changes)

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return all(
            _same(getattr(self, f.name), getattr(other, f.name))
            for f in dataclasses.fields(self)
        )

    def __repr__(self) -> str:
        entries = []
        for f in dataclasses.fields(self):
            value = getattr(self, f.name)
            default = _default(f)
            if default is dataclasses.MISSING or not _same(value, default):
                text = np.array2string(value, threshold=20, precision=6, separator=", ") if isinstance(
                    value, np.ndarray) else repr(value)
                entries.append(f"{f.name}={text}")
        return f"{type(self).__name__}({', '.join(entries)})"

    def __setattr__(self, name: str, value: Any) -> None:
        known = _names(type(self))
        if name not in known:
            hint = _core.did_you_mean(name, list(known)) or f"; it has {', '.join(known)}"
            raise AttributeError(f"{type(self).__name__} has no entry '{name}'{hint}")
        object.__setattr__(self, name, value)


def zeros(n: int) -> Any:
    """Default of an entry: n zeros."""
    return dataclasses.field(default_factory=lambda: np.zeros(n))


def identity(n: int) -> Any:
    """Default of an entry: the identity of size n."""
    return dataclasses.field(default_factory=lambda: np.eye(n))


def empty() -> Any:
    """Default of an entry: a vector without entries, which stands for what its comment says."""
    return dataclasses.field(default_factory=lambda: np.zeros(0))


def vector(*values: float) -> Any:
    """Default of an entry: these numbers."""
    return dataclasses.field(default_factory=lambda: np.array(values, dtype=float))


def items() -> Any:
    """Default of an entry: an empty list."""
    return dataclasses.field(default_factory=list)
