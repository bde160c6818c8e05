"""Base class of all dataclasses of burnish."""

from __future__ import annotations

import ast
import copy
import dataclasses
import functools
import inspect
import re
import sys
from typing import TYPE_CHECKING, Any, ClassVar, Dict, List, Tuple, TypeVar

import numpy as np

from . import _core
from ._renamed import no_attribute

S = TypeVar("S", bound="Spec")


def _same(a: Any, b: Any) -> bool:
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        if a is None or b is None or callable(a) or callable(b):
            return False
        a, b = np.asarray(a), np.asarray(b)
        return np.array_equal(a, b, equal_nan=a.dtype.kind == b.dtype.kind == "f")
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


@functools.lru_cache(maxsize=None)
def _meanings(module: str) -> Dict[str, Dict[str, str]]:
    """Docstrings of the entries of a module's classes, by class and entry."""
    tree = ast.parse(inspect.getsource(sys.modules[module]))
    classes: Dict[str, Dict[str, str]] = {}
    for node in tree.body:
        if not isinstance(node, ast.ClassDef):
            continue
        texts = classes.setdefault(node.name, {})
        for entry, text in zip(node.body, node.body[1:]):
            if (isinstance(entry, ast.AnnAssign) and isinstance(entry.target, ast.Name)
                    and isinstance(text, ast.Expr) and isinstance(text.value, ast.Constant)):
                texts[entry.target.id] = inspect.cleandoc(str(text.value.value))
    return classes


def _inside(of: type, name: str) -> str:
    """Place of an entry within the entries of a class, such as `tools[...].normal_base`; empty if there is none."""
    package = sys.modules[__package__]
    for field in dataclasses.fields(of):
        for word in re.findall(r"\w+", str(field.type)):
            inner = getattr(package, word, None) if word[0].isupper() else None
            if isinstance(inner, type) and dataclasses.is_dataclass(inner) and name in _names(inner):
                return f"{field.name}[...].{name}" if "List[" in str(field.type) else f"{field.name}.{name}"
    return ""


def _unknown(of: type, name: str) -> str:
    known = _names(of)
    nearest = _core.did_you_mean(name, list(known))
    newer = dict(_core.renames()).get(name, name)
    place = "" if "is now called" in nearest else _inside(of, newer)
    hint = f"; wanted {place}" if place else nearest or f"; it has {', '.join(known)}"
    return f"{of.__name__} has no entry '{name}'{hint}"


def _listed(of: type, values: Dict[str, str]) -> List[str]:
    """Lines with the value of each entry and, below it, its meaning."""
    lines = []
    meanings = _meanings(of.__module__).get(of.__name__, {})
    for name in _names(of):
        lines.append(f"{name}: {values[name]}")
        lines += ["    " + line for line in meanings.get(name, "").splitlines()]
    return lines


def _text(value: Any, brief: bool = False) -> str:
    if isinstance(value, np.ndarray):
        return np.array2string(value, threshold=20, precision=6, separator=", ")
    if brief and isinstance(value, float):
        return f"{value:.6g}"
    if brief and isinstance(value, list) and len(value) > 3 and isinstance(value[0], Spec):
        return f"[{len(value)} of {type(value[0]).__name__}]"
    return repr(value)


class _SpecType(type):
    """Metaclass whose documentation lists the entries. An unknown entry raises a TypeError that names the
    nearest entry."""

    @property
    def __doc__(cls) -> str:  # type: ignore[override]
        summary = inspect.cleandoc(cls.__dict__.get("__doc__") or "")
        if not dataclasses.is_dataclass(cls):
            return summary
        types = {f.name: str(f.type) for f in dataclasses.fields(cls)}
        return "\n".join([summary, "", "Entries:", "", *_listed(cls, types)])

    @property
    def __signature__(cls) -> inspect.Signature:
        whole = inspect.signature(getattr(cls, "__init__"))
        return whole.replace(parameters=list(whole.parameters.values())[1:])

    def __call__(cls, *entries: Any, **named: Any) -> Any:
        if dataclasses.is_dataclass(cls):
            for name in named:
                if name not in _names(cls):
                    raise TypeError(_unknown(cls, name))
        return super().__call__(*entries, **named)

    if not TYPE_CHECKING:  # mypy takes every attribute of a class with __getattr__ as known

        def __getattr__(cls, name: str) -> Any:
            raise no_attribute(cls, cls.__name__, name)


class Spec(metaclass=_SpecType):
    """Base class of values, which are compared entry by entry and can be copied and pickled.

    repr() shows the entries that differ from their defaults; describe() returns all entries. Setting an
    unknown entry raises AttributeError."""

    __dataclass_fields__: ClassVar[Dict[str, dataclasses.Field[Any]]]
    __hash__ = None  # type: ignore[assignment]
    _brief = False
    """True for results: repr() then shows six digits, and only the lengths of long lists."""

    def replace(self: S, **changes: Any) -> S:
        """Returns a deep copy with changed entries.

        Parameters
        ----------
        **changes
            New values of entries, by name.

        Returns
        -------
        Spec
            Copy of the same class.

        Raises
        ------
        TypeError
            If an entry is unknown.
        """
        return dataclasses.replace(copy.deepcopy(self), **changes)

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return all(
            _same(getattr(self, f.name), getattr(other, f.name))
            for f in dataclasses.fields(self)
        )

    def describe(self) -> str:
        """Returns a text with the values and meanings of all entries."""
        values = {name: _text(getattr(self, name)) for name in _names(type(self))}
        return "\n".join(_listed(type(self), values))

    def __repr__(self) -> str:
        entries = []
        for f in dataclasses.fields(self):
            value = getattr(self, f.name)
            default = _default(f)
            if default is dataclasses.MISSING or not _same(value, default):
                entries.append(f"{f.name}={_text(value, self._brief)}")
        return f"{type(self).__name__}({', '.join(entries)})"

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            raise AttributeError(_unknown(type(self), name))

    def __setattr__(self, name: str, value: Any) -> None:
        if name not in _names(type(self)):
            raise AttributeError(_unknown(type(self), name))
        object.__setattr__(self, name, value)


def zeros(n: int) -> Any:
    """Default of an entry: a vector of n zeros."""
    return dataclasses.field(default_factory=lambda: np.zeros(n))


def identity(n: int) -> Any:
    """Default of an entry: the n x n identity matrix."""
    return dataclasses.field(default_factory=lambda: np.eye(n))


def empty() -> Any:
    """Default of an entry: an empty vector, whose meaning the entry documents."""
    return dataclasses.field(default_factory=lambda: np.zeros(0))


def vector(*values: float) -> Any:
    """Default of an entry: a vector of these numbers."""
    return dataclasses.field(default_factory=lambda: np.array(values, dtype=float))


def items() -> Any:
    """Default of an entry: an empty list."""
    return dataclasses.field(default_factory=list)
