"""Helper of the modules of tasks."""

from __future__ import annotations

from typing import Any, Callable, Mapping, Sequence, TypeVar

from ._core import Error

AnyTask = TypeVar("AnyTask")


def with_changes(
    task: AnyTask,
    entries: Mapping[str, Any],
    overrides: Sequence[str],
    override_task: Callable[[AnyTask, Sequence[str]], AnyTask],
    check_task: Callable[[AnyTask], None],
) -> AnyTask:
    """Sets entries of a task, applies overrides, and checks the result. Raises Error for unknown keys and
    for values that contradict each other."""
    if isinstance(overrides, str):
        raise Error(f"overrides: got {overrides!r}; wanted a list of texts, such as ['force=10']")
    for name, value in entries.items():
        setattr(task, name, value)
    task = override_task(task, overrides)
    check_task(task)
    return task
