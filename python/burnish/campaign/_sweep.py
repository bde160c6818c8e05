"""A campaign as values: a task, what its keys take, seeds, figures to keep, when to stop; and its runs."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Dict, List, Mapping, Optional, Union

from .. import _core
from ._points import Point, Values, count, most_runs, nearest, number, only, read_values
from ._results import CampaignError, RunFolder, write_whole
from ._tasks import Machine, Outcome, TaskFile, TaskRun, read_tree

SEED = "disturbances.seed"


@dataclass
class Sweep:
    """What a campaign's file says."""

    text: str
    """of the file"""
    name: str
    task: TaskFile
    values: Values
    seeds: List[int]
    """empty: the task's own"""
    words: List[str]
    """of the program: controller and plant"""
    keep: List[str]
    """figures by their names in metrics.json, `force_rmse_N`; empty: all"""
    stop: Optional[Stop]
    worst: Optional[Worst]

    def points(self) -> List[Point]:
        points = self.values.points()
        if self.seeds:
            points = [{**point, SEED: seed} for point in points for seed in self.seeds]
        if len(points) > most_runs:
            raise CampaignError(f"the campaign has {len(points)} runs; wanted at most {most_runs}")
        return points


@dataclass
class Stop:
    """The campaign ends with the run at which so many, counted in the order of runs, are beyond."""

    figure: str
    above: float
    runs: int


@dataclass
class Worst:
    """Runs with the largest figure, of which the full records are made."""

    figure: str
    count: int


def _as_yaml(key: str, value: Any) -> str:
    """In one line. Raises CampaignError for what files cannot say."""
    try:
        return _core.json_as_yaml(json.dumps(value))
    except (TypeError, ValueError) as error:
        raise CampaignError(f"campaign: {key}: {error}; wanted finite numbers, texts, lists and dictionaries of "
                            "Python's own") from error


def read_sweep(source: Union[str, Path, Mapping[str, Any]], folder: Optional[Path] = None) -> Sweep:
    """From a file, or the same as a dictionary, whose paths are seen from `folder` (None: the current
    one). Raises CampaignError for what does not fit together."""
    if isinstance(source, (str, Path)):
        path = Path(source)
        tree = read_tree(path, "at least task")
        text = path.read_text()
        folder, name = path.parent, path.stem
    else:
        tree, name = dict(source), "campaign"
        text = "".join(f"{key}: {_as_yaml(key, value)}\n" for key, value in tree.items())
    known = ["name", "task", "vary", "samples", "seeds", "controller", "plant", "keep", "stop", "worst"]
    only("campaign", tree, known)
    if not isinstance(tree.get("task"), str):
        raise CampaignError("the campaign names no task; wanted task: FILE")
    task = TaskFile.read((folder or Path()) / tree["task"])
    values = read_values(tree.get("vary"), tree.get("samples"))
    keep = tree.get("keep") or []
    keep = [keep] if isinstance(keep, str) else [str(figure) for figure in keep]
    return Sweep(text, str(tree.get("name", name)), task, values, read_seeds("seeds", tree.get("seeds"), values),
                 program_words(tree, task), keep, _stop(tree.get("stop")), _worst(tree.get("worst")))


def read_seeds(where: str, given: Any, values: Values) -> List[int]:
    if given is None:
        return []
    if SEED in values.listed or SEED in values.drawn:
        raise CampaignError(f"{where} are stated, and vary has '{SEED}' too; wanted one of them")
    if isinstance(given, int):
        given = {"count": given}
    if isinstance(given, dict):
        only(where, given, ["first", "count"])
        first = count(f"{where}.first", given.get("first", 0), 0)
        return list(range(first, first + count(f"{where}.count", given.get("count"), 1)))
    if not isinstance(given, list) or not given:
        raise CampaignError(f"{where} is {given!r}; wanted a number of them, a list, or first and count")
    return [count(where, seed, 0) for seed in given]


def program_words(tree: Mapping[str, Any], task: TaskFile) -> List[str]:
    words = ["polish" if task.polishes else "run"]
    if task.polishes:
        controller = tree.get("controller", "mpc")
        if controller not in ("mpc", "baseline"):
            raise CampaignError(f"controller is {controller!r}; wanted mpc or baseline")
        words += ["--controller", controller]
    elif "controller" in tree:
        raise CampaignError(f"a controller is stated, and the task '{task.path}' has but one; wanted none")
    if "plant" in tree:
        if tree["plant"] not in ("mujoco", "ideal"):
            raise CampaignError(f"plant is {tree['plant']!r}; wanted mujoco or ideal")
        words += ["--plant", tree["plant"]]
    return words


def _stop(given: Any) -> Optional[Stop]:
    if given is None:
        return None
    if not isinstance(given, dict) or "figure" not in given or "above" not in given:
        raise CampaignError(f"stop is {given!r}; wanted figure, above and runs")
    only("stop", given, ["figure", "above", "runs"])
    return Stop(str(given["figure"]), number("stop.above", given["above"]),
                count("stop.runs", given.get("runs", 1), 1))


def _worst(given: Any) -> Optional[Worst]:
    if given is None:
        return None
    if not isinstance(given, dict) or "figure" not in given:
        raise CampaignError(f"worst is {given!r}; wanted figure and count")
    only("worst", given, ["figure", "count"])
    return Worst(str(given["figure"]), count("worst.count", given.get("count", 3), 1))


def figure_named(name: str, known: List[str]) -> str:
    """`force_rmse` or `force_rmse_N` as `force_rmse_N`. Raises CampaignError with the nearest one."""
    for figure in known:
        if name == figure or name == bare(figure):
            return figure
    raise CampaignError(f"there is no figure '{name}'{nearest(name, known)}")


UNITS = ("N", "m", "rad", "s")


def bare(figure: str) -> str:
    """Its name without the unit."""
    name, underscore, unit = figure.rpartition("_")
    return name if underscore and unit in UNITS else figure


def unit(figure: str) -> str:
    ending = figure.rpartition("_")[2]
    return ending if ending in UNITS and "_" in figure else ""


@dataclass
class Row:
    """A run that was made."""

    number: int
    """from 1 on"""
    point: Point
    run: TaskRun
    outcome: Outcome


@dataclass
class SweepResult:
    """Runs in order, up to the one that ended the campaign early."""

    sweep: Sweep
    rows: List[Row]
    figures: List[str]
    """those that are kept, by their names in metrics.json"""
    stopped: str
    """why it ended early, one sentence; empty: it did not"""

    def values(self, figure: str) -> List[float]:
        """Of the runs that have it."""
        return [row.outcome.figures[figure] for row in self.rows if figure in row.outcome.figures]

    def worst(self) -> List[Row]:
        """By the figure that the campaign asks for; those without one, which were refused, are none."""
        if self.sweep.worst is None:
            return []
        figure = figure_named(self.sweep.worst.figure, known_figures(self.rows))
        rows = [row for row in self.rows if figure in row.outcome.figures]
        rows.sort(key=lambda row: (-row.outcome.figures[figure], row.number))
        return rows[:self.sweep.worst.count]


def known_figures(rows: List[Row]) -> List[str]:
    known: Dict[str, None] = {}
    for row in rows:
        known.update(dict.fromkeys(row.outcome.figures))
    return list(known)


def make_sweep(sweep: Sweep, machine: Machine, folder: RunFolder,
               progress: Callable[[int, int], None] = lambda done, all: None) -> SweepResult:
    """Makes the runs that the folder has no result of. Raises CampaignError for points that the task
    refuses, and for figures that there are not."""
    points = sweep.points()
    runs = [TaskRun(sweep.task.changed(point), tuple(sweep.words)) for point in points]
    outcomes: Dict[int, Outcome] = {}
    for index, run in enumerate(runs):
        found = find_outcome(folder, run)
        if found is not None:
            outcomes[index] = found
    left = [index for index in range(len(runs)) if index not in outcomes]

    def end() -> Optional[int]:
        """How many runs the campaign has by now, if it is over."""
        beyond = 0
        for index in range(len(runs)):
            if index not in outcomes:
                return None
            if sweep.stop is None:
                continue
            known = list(outcomes[index].figures)
            value = outcomes[index].figures.get(figure_named(sweep.stop.figure, known)) if known else None
            beyond += value is not None and value > sweep.stop.above
            if beyond >= sweep.stop.runs:
                return index + 1
        return len(runs)

    def keep(at: int, outcome: Outcome) -> bool:
        index = left[at]
        if outcome.figures:
            for figure in sweep.keep + [each.figure for each in (sweep.stop, sweep.worst) if each is not None]:
                figure_named(figure, list(outcome.figures))
        outcomes[index] = outcome
        keep_outcome(folder, runs[index], outcome)
        progress(len(outcomes), len(runs))
        return end() is None

    if end() is None:
        machine.make([runs[index] for index in left], keep)
    size = end() or 0
    rows = [Row(index + 1, points[index], runs[index], outcomes[index]) for index in range(size)]
    known = known_figures(rows)
    figures = [figure_named(figure, known) for figure in sweep.keep] if sweep.keep and known else known
    stopped = ""
    if size < len(runs) and sweep.stop is not None:
        stopped = (f"ended after {size} of {len(runs)} runs: {sweep.stop.runs} had {sweep.stop.figure} above "
                   f"{sweep.stop.above:g}")
    return SweepResult(sweep, rows, figures, stopped)


def find_outcome(folder: RunFolder, run: TaskRun) -> Optional[Outcome]:
    """What the folder has of a run, unless its time limit ended that. Raises CampaignError for a file
    that is no result."""
    file = folder.path / "runs" / f"{run.name()}.json"
    if not file.exists():
        return None
    try:
        found = Outcome.parse(file.read_text())
    except (ValueError, KeyError) as error:
        raise CampaignError(f"'{file}' is no result of a run; wanted it whole, or removed to make the run "
                            f"again") from error
    return None if found.late else found


def keep_outcome(folder: RunFolder, run: TaskRun, outcome: Outcome) -> None:
    """Raises CampaignError where the files cannot be written."""
    runs = folder.path / "runs"
    try:
        runs.mkdir(exist_ok=True)
    except OSError as error:
        raise CampaignError(f"cannot make the folder '{runs}': {error.strerror}") from error
    write_whole(runs / f"{run.name()}.times.json", (json.dumps(outcome.times, indent=1) + "\n").encode())
    write_whole(runs / f"{run.name()}.json", outcome.text().encode())
