"""What the modules of tasks have in common."""

from __future__ import annotations

from typing import Any, Callable, Mapping, Sequence, TypeVar

AnyTask = TypeVar("AnyTask")


def with_changes(
    task: AnyTask,
    entries: Mapping[str, Any],
    overrides: Sequence[str],
    override_task: Callable[[AnyTask, Sequence[str]], AnyTask],
    check_task: Callable[[AnyTask], None],
) -> AnyTask:
    """The task with entries set, then overrides applied, and checked. Raises Error for what there is
    not, and for what does not fit together."""
    for name, value in entries.items():
        setattr(task, name, value)
    task = override_task(task, overrides)
    check_task(task)
    return task
