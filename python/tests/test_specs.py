"""Properties of all dataclasses and enumerations of the package; new ones are tested automatically."""

from __future__ import annotations

import collections.abc
import copy
import dataclasses
import enum
import importlib
import inspect
import pickle
import pkgutil
import typing
from pathlib import Path
from typing import Any, Dict, List, Type

import numpy as np
import pytest

import burnish
from burnish import _core
from burnish._spec import Spec, _same

MODULES = [importlib.import_module(info.name)
           for info in pkgutil.walk_packages(burnish.__path__, "burnish.")]


def full_name(kind: type) -> str:
    return f"{kind.__module__}.{kind.__qualname__}"


def in_package(base: type) -> Dict[str, type]:
    found = {}
    for module in MODULES:
        for value in vars(module).values():
            if isinstance(value, type) and issubclass(value, base) and value is not base \
                    and value.__module__ == module.__name__:
                found[full_name(value)] = value
    return found


SPECS = in_package(Spec)
IN_CPP = list(SPECS)
ENUMS = in_package(enum.Enum)


def has_defaults(kind: Type[Spec]) -> bool:
    return all(f.default is not dataclasses.MISSING or f.default_factory is not dataclasses.MISSING
               for f in dataclasses.fields(kind) if f.init)


DEFAULTED = [name for name, kind in SPECS.items() if has_defaults(kind)]


def a_value(kind: type) -> Spec:
    """Returns a value of a dataclass: its defaults, or those of C++ if it has none."""
    if has_defaults(kind):
        return kind()
    value: Spec = _core.spec_default(full_name(kind))
    for name, entry in vars(value).items():
        if isinstance(entry, np.ndarray):  # C++ may leave numbers uninitialized
            setattr(value, name, np.eye(*entry.shape) if entry.ndim == 2 else np.zeros(entry.shape))
    return value


class Unknown(Exception):
    """No other value of an entry can be derived from its type."""


def another(value: Any, hint: Any) -> Any:
    """Returns a different value of the same type."""
    origin, arguments = typing.get_origin(hint), typing.get_args(hint)
    if isinstance(value, bool):
        return not value
    if isinstance(value, int):
        return value + 1
    if isinstance(value, float):
        return value + 0.5 if np.isfinite(value) else 2.5
    if isinstance(value, str):
        return "z"  # valid as a direction, too
    if isinstance(value, Path):
        return Path("z")
    if isinstance(value, enum.Enum):
        members = list(type(value))
        return members[(members.index(value) + 1) % len(members)]
    if isinstance(value, np.ndarray):
        value = np.nan_to_num(value)
        if value.shape == (4, 4):
            value = np.eye(4)
            value[:3, 3] = [0.25, 0.5, -1.0]
            return value
        if value.shape == (3, 3):
            return np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
        return value + 0.25 if value.size else np.ones((2, 3)[: value.ndim])
    if isinstance(value, Spec):
        for f, h in typing.get_type_hints(type(value)).items():
            try:
                return value.replace(**{f: another(getattr(value, f), h)})
            except (Unknown, AttributeError):
                continue
    if origin is list and isinstance(value, list):
        return value[1:] if value else [sample(arguments[0])]
    if origin is dict and not value:
        return {sample(arguments[0]): sample(arguments[1])}
    if value is None and origin is typing.Union:
        for argument in arguments:
            if argument is not type(None):
                return sample(argument)
    raise Unknown(f"{value!r} as {hint}")


def sample(hint: Any) -> Any:
    """Returns a value of a type that is not its default."""
    if hint in (bool, int, float, str):
        return {bool: True, int: 3, float: 2.5, str: "z"}[hint]
    if isinstance(hint, type) and issubclass(hint, enum.Enum):
        return list(hint)[-1]
    if isinstance(hint, type) and issubclass(hint, Spec) and has_defaults(hint):
        return hint()
    if typing.get_origin(hint) is list:
        return [sample(typing.get_args(hint)[0])]
    raise Unknown(str(hint))


def test_package_has_dataclasses_and_enumerations() -> None:
    assert len(SPECS) >= 30 and len(ENUMS) >= 10
    assert "burnish.contact.ContactSpec" in DEFAULTED


def test_dataclasses_and_cpp_structs_correspond() -> None:
    assert sorted(IN_CPP) == sorted(_core.spec_names())


def test_enumerations_have_the_members_of_cpp_in_order() -> None:
    # In C++, a Phase is a number in Command.phase.
    assert sorted(set(ENUMS) - {"burnish.pressing.Phase"}) == sorted(_core.enum_words())
    for name, words in _core.enum_words().items():
        members: List[enum.Enum] = list(ENUMS[name])
        assert [m.name.lower() for m in members] == words, name
        assert [m.value for m in members] == list(range(len(members))), name


@pytest.mark.parametrize("name", IN_CPP)
class TestEveryStruct:
    def test_defaults_match_cpp(self, name: str) -> None:
        from_cpp = _core.spec_default(name)
        assert type(from_cpp) is SPECS[name]
        if name in DEFAULTED:
            assert SPECS[name]() == from_cpp
            assert _core.spec_round_trip(SPECS[name]()) == SPECS[name]()

    def test_every_entry_round_trips_through_cpp(self, name: str) -> None:
        value = a_value(SPECS[name])
        hints = typing.get_type_hints(SPECS[name])
        for field in dataclasses.fields(value):
            before = getattr(value, field.name)
            if callable(before) or typing.get_origin(hints[field.name]) is collections.abc.Callable:
                continue
            try:
                changed = value.replace(**{field.name: another(before, hints[field.name])})
            except Unknown:
                continue
            try:
                back = _core.spec_round_trip(changed)
            except burnish.Error as error:  # an invalid sample must raise with the name of its entry
                assert f"{SPECS[name].__name__}.{field.name}" in str(error)
                continue
            got, sent = getattr(back, field.name), getattr(changed, field.name)
            if isinstance(got, Path) or isinstance(sent, Path):
                got, sent = str(got), str(sent)
            assert _same(got, sent), field.name
            assert changed != value, field.name


@pytest.mark.parametrize("name", sorted({*IN_CPP, *DEFAULTED}))
class TestEveryDataclass:
    def test_copies_are_equal_and_independent(self, name: str) -> None:
        value = a_value(SPECS[name])
        for copied in (copy.deepcopy(value), pickle.loads(pickle.dumps(value)), value.replace()):
            for field in dataclasses.fields(value):
                ours, theirs = getattr(value, field.name), getattr(copied, field.name)
                if isinstance(ours, np.ndarray):
                    np.testing.assert_array_equal(ours, theirs)
                    assert not np.shares_memory(ours, theirs) or ours.size == 0
                elif isinstance(ours, (list, dict, Spec)):
                    assert ours is not theirs
            assert copied == value

    def test_repr_lists_changed_entries_only(self, name: str) -> None:
        value = a_value(SPECS[name])
        short = SPECS[name].__name__
        assert repr(value).startswith(short + "(")
        if name in DEFAULTED:
            assert repr(value) == short + "()"
            for field in dataclasses.fields(value):
                if isinstance(getattr(value, field.name), (bool, int, float)):
                    changed = value.replace(
                        **{field.name: another(getattr(value, field.name), None)})
                    assert repr(changed) == f"{short}({field.name}={getattr(changed, field.name)})"

    def test_unknown_entry_raises(self, name: str) -> None:
        value = a_value(SPECS[name])
        first = dataclasses.fields(value)[0].name
        with pytest.raises(AttributeError, match="did you mean '"):
            setattr(value, first + "_", 1)
        with pytest.raises(AttributeError, match="has no entry 'qqqqqq'"):
            setattr(value, "qqqqqq", 1)

    def test_help_and_describe_have_every_entry(self, name: str) -> None:
        value = a_value(SPECS[name])
        lines = value.describe().splitlines()
        listed = (SPECS[name].__doc__ or "").split("Entries:")[1].splitlines()
        for field in dataclasses.fields(value):
            assert any(line.startswith(field.name + ": ") for line in lines)
            assert f"{field.name}: {field.type}" in listed

    def test_value_differs_from_other_objects(self, name: str) -> None:
        assert a_value(SPECS[name]) != object()

def test_entry_of_wrong_type_raises_with_value_and_requirement() -> None:
    contact = burnish.ContactSpec(tool="tool", kp=[1.0, 2.0])
    with pytest.raises(burnish.Error) as refused:
        _core.spec_round_trip(contact)
    assert str(refused.value) == "ContactSpec.kp: got [1.0, 2.0]; wanted 6 numbers"


def test_unknown_enumeration_name_raises_with_the_nearest() -> None:
    contact = burnish.ContactSpec(error="log5")  # type: ignore[arg-type]
    with pytest.raises(burnish.Error, match="PoseError: there is no 'log5'; did you mean 'log6'"):
        _core.spec_round_trip(contact)


def test_unknown_keyword_raises_with_the_nearest() -> None:
    with pytest.raises(TypeError, match="ContactSpec has no entry 'directons'; did you mean 'directions'"):
        burnish.ContactSpec(directons="z")  # type: ignore[call-arg]
    with pytest.raises(TypeError, match="did you mean 'tool'"):
        burnish.ContactSpec().replace(toool="hand")


def test_keyword_of_an_inner_entry_raises_with_its_place() -> None:
    with pytest.raises(TypeError, match=r"MpcSpec has no entry 'normal_base'; wanted tools\[...\].normal_base"):
        burnish.MpcSpec(normal_base=[0, 0, 1])  # type: ignore[call-arg]
    with pytest.raises(AttributeError, match=r"Command has no entry 'target_force'; wanted tools\[...\].target_force"):
        burnish.Command().target_force  # type: ignore[attr-defined]
    with pytest.raises(TypeError, match="MpcSpec has no entry 'bandwidth'; wanted model_error.bandwidth"):
        burnish.MpcSpec(bandwidth=100.0)  # type: ignore[call-arg]
    with pytest.raises(TypeError, match=r"wanted tools\[...\].normal_base"):
        burnish.MpcSpec(normal_world=[0, 0, 1])  # type: ignore[call-arg]
    with pytest.raises(TypeError, match="did you mean 'tools'"):
        burnish.MpcSpec(tool="hand")  # type: ignore[call-arg]


def test_help_contains_the_meaning_of_entries() -> None:
    assert "Coefficient of friction" in (burnish.SlidingFriction.__doc__ or "")
    assert "coefficient" in str(inspect.signature(burnish.SlidingFriction))
    assert "Speed below which friction fades out" in burnish.SlidingFriction().describe()


def test_repr_of_a_summary_is_short() -> None:
    summary = burnish.DdpSummary(cost=1.0 / 3.0, log=[burnish.DdpProgress()] * 5)
    assert repr(summary) == "DdpSummary(cost=0.333333, log=[5 of DdpProgress])"


def test_lists_of_a_value_can_be_changed_in_place() -> None:
    options = burnish.ModelOptions()
    options.locked.append("elbow")
    options.posture["wrist"] = [0.5]
    back = _core.spec_round_trip(options)
    assert back.locked == ["elbow"] and back.posture == {"wrist": [0.5]}
    assert burnish.ModelOptions().locked == []
