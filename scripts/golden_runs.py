"""Runs that scripts/golden compares, and names that differ between its two programs."""

import dataclasses
import pathlib

# Renamed columns, figures and keys of tasks: {"name in PARENT": "new name"}, or prefixes: {"old_*": "new_*"}.
RENAMES: dict[str, str] = {}

SURFACES = ("table", "board", "board_x", "board_y", "board_minus_y", "tilt_45")  # as burnish polish --help has them
# Settings that shorten shipped tasks without removing phases; polishing uses --duration.
SHORTER = {
    "push_wall": ["phases.hold_duration=0.5", "phases.release_duration=1", "force_search.force_max=80",
                  "force_search.hold_duration=0.5"],
    "stand": ["phases.sway_duration=4"],
}
EXACT = "disturbances.encoder_bits=0"


@dataclasses.dataclass
class Case:
    name: str
    words: list[str]  # command line
    settings: list[str] = dataclasses.field(default_factory=list)  # changes KEY=VALUE of its task
    file: str = "."  # file of the tree that the run needs
    seconds: float = 4.0  # approximate duration [s], for the order (longest first) and the first estimate


def cases(root: pathlib.Path) -> list[Case]:
    common = ["--seed", "1", "--no-page"]
    polish = ["polish", *common, "--duration", "4", "--controller"]
    found = [Case(f"polish {surface}", [*polish, "mpc", "--surface", surface]) for surface in SURFACES]
    found += [
        Case("polish with all controllers", [*polish, "all", "--surface", "table"], seconds=8),
        Case("polish on the ideal plant", [*polish, "mpc", "--surface", "table", "--plant", "ideal"]),
        Case("polish without a force sensor", [*polish, "mpc", "--surface", "board", "--disturbances",
                                               "joint_friction"], ["controller.force_sensor=false"]),
    ]
    for path in sorted(root.glob("tasks/*/*.yaml")):
        task, file = path.parent.name, str(path.relative_to(root))
        words = [*polish, "mpc", file] if task == "polishing" else ["run", file, *common]
        found.append(Case(f"{task} {path.stem}", words, SHORTER.get(task, []), file, seconds=8))
    for path in sorted(root.glob("examples/problems/*.yaml")):
        file = str(path.relative_to(root))
        found.append(Case(f"solve {path.stem}", ["solve", file, "--threads", "2"], [], file, seconds=0.3))
    return sorted(found, key=lambda case: -case.seconds)
