"""Campaigns: task, values of its keys, seeds, figures to keep, condition to stop, and the runs."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple, Union

from .. import _core
from ._points import Point, Values, count, max_runs, nearest, number, only, read_values
from ._results import CampaignError, RunFolder, write_whole
from ._tasks import Machine, Outcome, TaskFile, TaskRun, kernels_of, read_tree

SEED = "disturbances.seed"


@dataclass
class Sweep:
    """Content of a campaign's file."""

    text: str
    """Text of the file"""
    name: str
    task: TaskFile
    values: Values
    seeds: List[int]
    """Seeds of the disturbances; empty: the seed of the task"""
    words: List[str]
    """Arguments of the program: controller and plant"""
    keep: List[str]
    """Names of figures in metrics.json, such as `force_rmse_N`; empty: all"""
    stop: Optional[Stop]
    worst: Optional[Worst]

    def points(self) -> List[Point]:
        points = self.values.points()
        if self.seeds:
            points = [{**point, SEED: seed} for point in points for seed in self.seeds]
        if len(points) > max_runs:
            raise CampaignError(f"the campaign has {len(points)} runs; wanted at most {max_runs}")
        return points


@dataclass
class Stop:
    """Condition to stop: `runs` runs, counted in order, have a figure above a value."""

    figure: str
    above: float
    runs: int


@dataclass
class Worst:
    """Number of runs with the largest figure that get full records."""

    figure: str
    count: int


def _as_yaml(key: str, value: Any) -> str:
    """Value as one line of YAML. Raises CampaignError for a value that YAML cannot express."""
    try:
        return _core.json_as_yaml(json.dumps(value))
    except (TypeError, ValueError) as error:
        raise CampaignError(f"campaign: {key}: {error}; wanted finite numbers, texts, and Python lists "
                            "and dictionaries") from error


def read_sweep(source: Union[str, Path, Mapping[str, Any]], *, task: Optional[Path] = None,
               name: str = "") -> Sweep:
    """Reads a campaign from a file or a dictionary. Paths in a file are relative to it. `task` and `name` replace
    the entries of the file. Raises CampaignError for contradictions."""
    if isinstance(source, (str, Path)):
        path = Path(source)
        tree = read_tree(path, "at least task")
        text = path.read_text()
        folder, own_name = path.parent, path.stem
    else:
        tree, folder, own_name = dict(source), Path(), "campaign"
        text = "".join(f"{key}: {_as_yaml(key, value)}\n" for key, value in tree.items())
    known = ["name", "task", "vary", "samples", "seeds", "controller", "plant", "keep", "stop", "worst"]
    only("campaign", tree, known)
    if not isinstance(tree.get("task"), str):
        raise CampaignError("the campaign names no task; wanted task: FILE")
    task_file = TaskFile.read(task or folder / tree["task"])
    values = read_values(tree.get("vary"), tree.get("samples"))
    keep = tree.get("keep") or []
    keep = [keep] if isinstance(keep, str) else [str(figure) for figure in keep]
    return Sweep(text, name or str(tree.get("name", own_name)), task_file, values,
                 read_seeds("seeds", tree.get("seeds"), values), program_words(tree, task_file), keep,
                 _stop(tree.get("stop")), _worst(tree.get("worst")))


def read_seeds(where: str, given: Any, values: Values) -> List[int]:
    if given is None:
        return []
    if SEED in values.listed or SEED in values.drawn:
        raise CampaignError(f"{where} is given, and 'vary' has '{SEED}' too; wanted one of them")
    if isinstance(given, int):
        given = {"count": given}
    if isinstance(given, dict):
        only(where, given, ["first", "count"])
        first = count(f"{where}.first", given.get("first", 0), 0)
        return list(range(first, first + count(f"{where}.count", given.get("count"), 1)))
    if not isinstance(given, list) or not given:
        raise CampaignError(f"{where} is {given!r}; wanted a number of seeds, a list, or the keys 'first' and 'count'")
    return [count(where, seed, 0) for seed in given]


def program_words(tree: Mapping[str, Any], task: TaskFile) -> List[str]:
    words = ["polish" if task.polishes else "run"]
    if task.polishes:
        controller = tree.get("controller", "mpc")
        if controller not in ("mpc", "baseline", "admittance"):
            raise CampaignError(f"'controller' is {controller!r}; wanted mpc, baseline or admittance")
        words += ["--controller", controller]
    elif "controller" in tree:
        raise CampaignError(f"key 'controller' is given, and the task '{task.path}' has only one controller; wanted "
                            f"no such key")
    if "plant" in tree:
        if tree["plant"] not in ("mujoco", "ideal"):
            raise CampaignError(f"'plant' is {tree['plant']!r}; wanted mujoco or ideal")
        words += ["--plant", tree["plant"]]
    return words


def _stop(given: Any) -> Optional[Stop]:
    if given is None:
        return None
    if not isinstance(given, dict) or "figure" not in given or "above" not in given:
        raise CampaignError(f"'stop' is {given!r}; wanted the keys 'figure', 'above' and 'runs'")
    only("stop", given, ["figure", "above", "runs"])
    return Stop(str(given["figure"]), number("stop.above", given["above"]),
                count("stop.runs", given.get("runs", 1), 1))


def _worst(given: Any) -> Optional[Worst]:
    if given is None:
        return None
    if not isinstance(given, dict) or "figure" not in given:
        raise CampaignError(f"'worst' is {given!r}; wanted the keys 'figure' and 'count'")
    only("worst", given, ["figure", "count"])
    return Worst(str(given["figure"]), count("worst.count", given.get("count", 3), 1))


def figure_named(name: str, known: List[str]) -> str:
    """Key of a figure in metrics.json: `force_rmse` and `force_rmse_N` give `force_rmse_N`; `hold.slip` gives
    `slip_m`, a key of the section `hold`. Raises CampaignError with the nearest name."""
    last = name.rpartition(".")[2]
    for figure in known:
        if last in (figure, bare(figure)):
            return figure
    raise CampaignError(f"there is no figure '{name}'{nearest(name, known)}")


UNITS = ("N", "m", "rad", "s")


def bare(figure: str) -> str:
    """Name of a figure without its unit."""
    name, underscore, unit = figure.rpartition("_")
    return name if underscore and unit in UNITS else figure


def unit(figure: str) -> str:
    ending = figure.rpartition("_")[2]
    return ending if ending in UNITS and "_" in figure else ""


@dataclass
class Row:
    """A finished run."""

    number: int
    """Number of the run, from 1"""
    point: Point
    run: TaskRun
    outcome: Outcome


@dataclass
class SweepResult:
    """Result of a campaign or of its shards: runs in order, up to the end of the campaign."""

    sweep: Sweep
    rows: List[Row]
    figures: List[str]
    """Kept figures, by their names in metrics.json"""
    stopped: str
    """Sentence with the reason for an early end; empty: no early end"""
    kernels: str
    """Number of runs for each kind of kernels; empty if all runs have the same kernels"""

    def values(self, figure: str) -> List[float]:
        """Returns the values of a figure.

        Parameters
        ----------
        figure : str
            Name of the figure in metrics.json, such as "force_rmse_N".

        Returns
        -------
        list of float
            Values of the runs that have this figure.
        """
        return [row.outcome.figures[figure] for row in self.rows if figure in row.outcome.figures]

    def worst(self) -> List[Row]:
        """Returns the runs with the largest figure of `worst`. Rejected runs have no figures."""
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


@dataclass(frozen=True)
class Shard:
    """Shards I/N: the runs I, I + N, I + 2N, ... for each I in `numbers`, with N = `count`."""

    numbers: Tuple[int, ...] = (1,)
    """Numbers I, ascending"""
    count: int = 1

    @staticmethod
    def parse(text: str) -> Shard:
        """Parses "2/4" or "1,3/4". Raises CampaignError for another text."""
        before, _, after = text.partition("/")
        words = [*before.split(","), after]
        if all(word.isdecimal() for word in words):
            *numbers, count_of = map(int, words)
            if 1 <= min(numbers) and max(numbers) <= count_of:
                return Shard(tuple(sorted(numbers)), count_of)
        raise CampaignError(f"shard is '{text}'; wanted I/N with I from 1 to N, such as 2/4, or "
                            f"several shards, such as 1,3/4")

    def has(self, index: int) -> bool:
        return index % self.count + 1 in self.numbers


class SweepRuns:
    """Runs of a campaign, the selection of some shards, and the outcomes so far."""

    def __init__(self, sweep: Sweep, shard: Shard, mixed: bool) -> None:
        self.sweep, self.mixed = sweep, mixed
        self.points = sweep.points()
        self.runs = [TaskRun(sweep.task.changed(point), tuple(sweep.words)) for point in self.points]
        self.wanted = [index for index in range(len(self.runs)) if shard.has(index)]
        self.outcomes: Dict[int, Outcome] = {}
        # Number of selected runs with an outcome, in order without a gap, and how many of them exceed the limit.
        self._seen, self._beyond = 0, 0

    def find(self, folders: Sequence[Path]) -> int:
        """Reads existing results; returns their number."""
        for index in self.wanted:
            found = find_outcome(folders, self.runs[index])
            if found is not None:
                self.outcomes[index] = found
        kernels_of(self.outcomes.values(), self.mixed)
        return len(self.outcomes)

    def missing(self) -> List[int]:
        return [index for index in self.wanted if index not in self.outcomes]

    def size(self) -> Optional[int]:
        """Number of the selected runs in the campaign if the campaign has ended, else None. If the selected runs of
        a shard fulfil the condition to stop, those of all shards together fulfil it no later."""
        stop = self.sweep.stop
        while self._seen < len(self.wanted) and (stop is None or self._beyond < stop.runs):
            if self.wanted[self._seen] not in self.outcomes:
                return None
            figures = self.outcomes[self.wanted[self._seen]].figures
            if stop is not None and figures:
                self._beyond += figures[figure_named(stop.figure, list(figures))] > stop.above
            self._seen += 1
        return self._seen

    def take(self, index: int, outcome: Outcome) -> None:
        """Adds an outcome. Raises CampaignError for unknown figures, and for different kernels."""
        asked = [each.figure for each in (self.sweep.stop, self.sweep.worst) if each is not None]
        if outcome.figures:
            for figure in self.sweep.keep + asked:
                figure_named(figure, list(outcome.figures))
        first = next((other for other in self.outcomes.values() if other.kernels), outcome)
        self.outcomes[index] = outcome
        kernels_of([first, outcome], self.mixed)

    def result(self) -> SweepResult:
        """Returns the result; the campaign must have ended."""
        size = self.size() or 0
        rows = [Row(index + 1, self.points[index], self.runs[index], self.outcomes[index])
                for index in self.wanted[:size]]
        known, sweep = known_figures(rows), self.sweep
        figures = [figure_named(figure, known) for figure in sweep.keep] if sweep.keep and known else known
        stopped = ""
        if size < len(self.wanted) and sweep.stop is not None:
            stopped = (f"ended after {size} of {len(self.wanted)} runs: {sweep.stop.runs} had {sweep.stop.figure} "
                       f"above {sweep.stop.above:g}")
        return SweepResult(sweep, rows, figures, stopped, kernels_of((row.outcome for row in rows), self.mixed))


def make_sweep(sweep: Sweep, machine: Machine, folder: RunFolder,
               progress: Callable[[int, int], None] = lambda done, all: None, shard: Shard = Shard(),
               mixed: bool = False) -> SweepResult:
    """Makes the runs that have no result in the folder. Raises CampaignError for points that the task rejects, and
    for unknown figures."""
    plan = SweepRuns(sweep, shard, mixed)
    plan.find([folder.path])
    left = plan.missing()

    def keep(at: int, outcome: Outcome) -> bool:
        plan.take(left[at], outcome)
        keep_outcome(folder, plan.runs[left[at]], outcome)
        progress(len(plan.outcomes), len(plan.wanted))
        return plan.size() is None

    if plan.size() is None:
        machine.make([plan.runs[index] for index in left], keep)
    return plan.result()


def find_outcome(folders: Sequence[Path], run: TaskRun) -> Optional[Outcome]:
    """Outcome of a run in the folders, unless its time limit ended it; None if there is none. Raises CampaignError
    for an invalid file."""
    for folder in folders:
        file = folder / "runs" / f"{run.name()}.json"
        if not file.exists():
            continue
        try:
            found = Outcome.parse(file.read_text(), file.with_suffix(".times.json").read_text())
        except (OSError, ValueError, KeyError) as error:
            raise CampaignError(f"'{file}' is not the result of a run; wanted a complete file, or no file, to repeat "
                                f"the run") from error
        if not found.late:
            return found
    return None


def keep_outcome(folder: RunFolder, run: TaskRun, outcome: Outcome) -> None:
    """Writes an outcome. Raises CampaignError if the files cannot be written."""
    runs = folder.path / "runs"
    try:
        runs.mkdir(exist_ok=True)
    except OSError as error:
        raise CampaignError(f"cannot make the folder '{runs}': {error.strerror}") from error
    # Writes the result last, so that a result always has its times.
    write_whole(runs / f"{run.name()}.times.json", outcome.times_text().encode())
    write_whole(runs / f"{run.name()}.json", outcome.text().encode())
