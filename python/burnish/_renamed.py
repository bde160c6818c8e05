"""Errors for attributes of version 0.3: they name the attribute that replaced the old one."""

from __future__ import annotations

import enum
import functools
from types import ModuleType
from typing import TYPE_CHECKING, Any

from . import _core

# Old and new names; the last ones are old names only as attributes of results.
_RENAMES = [*_core.renames(), ("polished", "succeeded"), ("done", "succeeded")]


def no_attribute(owner: Any, label: str, name: str) -> AttributeError:
    """Makes the error for a missing attribute of a module, a class or an object.

    Parameters
    ----------
    owner : module, class or object
        Owner without the attribute.
    label : str
        Name of the owner in the message.
    name : str
        Missing attribute.

    Returns
    -------
    AttributeError
        Error that names the new attribute if `name` is an old name.
    """
    for old, new in _RENAMES:
        if old == name and hasattr(owner, new):
            return AttributeError(f"{label} has no attribute '{name}'; '{name}' is now called '{new}'")
    return AttributeError(f"{label} has no attribute '{name}'")


def refuse_old_names(*owners: object) -> None:
    """Adds the hook for missing attributes to modules, and to compiled classes for their objects."""
    for owner in owners:
        if isinstance(owner, ModuleType):
            setattr(owner, "__getattr__", functools.partial(_missing_in_module, owner))
        else:
            setattr(owner, "__getattr__", _missing_in_object)


def _missing_in_module(module: ModuleType, name: str) -> Any:
    raise no_attribute(module, module.__name__, name)


def _missing_in_object(self: object, name: str) -> Any:
    raise no_attribute(self, type(self).__name__.rpartition("_")[2], name)  # "stand_RunResult" is RunResult


class EnumType(enum.EnumMeta):
    """Metaclass of enumerations, which refuses old names of members with the new ones."""

    if not TYPE_CHECKING:  # mypy takes every attribute of a class with __getattr__ as known

        def __getattr__(cls, name: str) -> Any:
            members = cls.__dict__.get("_member_map_", {})  # members are not attributes up to Python 3.10
            if name in members:
                return members[name]
            raise no_attribute(cls, cls.__name__, name)
