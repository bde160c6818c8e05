"""A campaign as values: a task, what its keys take, seeds, figures to keep, when to stop; and its runs."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple, Union

from .. import _core
from ._points import Point, Values, count, most_runs, nearest, number, only, read_values
from ._results import CampaignError, RunFolder, write_whole
from ._tasks import Machine, Outcome, TaskFile, TaskRun, kernels_of, read_tree

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


def read_sweep(source: Union[str, Path, Mapping[str, Any]], *, task: Optional[Path] = None,
               name: str = "") -> Sweep:
    """From a file, which its paths are seen from, or the same as a dictionary. `task`, `name`: in place of
    what it says. Raises CampaignError for what does not fit together."""
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
                 read_seeds("seeds", tree.get("seeds"), values), program_words(tree, task_file), keep, _stop(tree.get("stop")), _worst(tree.get("worst")))


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
        if controller not in ("mpc", "baseline", "admittance"):
            raise CampaignError(f"controller is {controller!r}; wanted mpc, baseline or admittance")
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
    """`force_rmse` or `force_rmse_N` as `force_rmse_N`, and `hold.slip` of metrics.json's section `hold` as `slip_m`.
    Raises CampaignError with the nearest one."""
    last = name.rpartition(".")[2]
    for figure in known:
        if last in (figure, bare(figure)):
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
    """Runs in order, up to the one that ended the campaign early; of shards, their own."""

    sweep: Sweep
    rows: List[Row]
    figures: List[str]
    """those that are kept, by their names in metrics.json"""
    stopped: str
    """why it ended early, one sentence; empty: it did not"""
    kernels: str
    """where they are of several kinds, how many runs are of which"""

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


@dataclass(frozen=True)
class Shard:
    """Every count-th run, from each of the numbers on."""

    numbers: Tuple[int, ...] = (1,)
    """ascending"""
    count: int = 1

    @staticmethod
    def parse(text: str) -> Shard:
        """Of "2/4", or several, "1,3/4". Raises CampaignError for another text."""
        before, _, after = text.partition("/")
        words = [*before.split(","), after]
        if all(word.isdecimal() for word in words):
            *numbers, count_of = map(int, words)
            if 1 <= min(numbers) and max(numbers) <= count_of:
                return Shard(tuple(sorted(numbers)), count_of)
        raise CampaignError(f"shard is '{text}'; wanted I/N with I from 1 to N, such as 2/4, or "
                            f"several, 1,3/4")

    def has(self, index: int) -> bool:
        return index % self.count + 1 in self.numbers


class SweepRuns:
    """The runs of a campaign, those of some shards, and what came out of them so far."""

    def __init__(self, sweep: Sweep, shard: Shard, mixed: bool) -> None:
        self.sweep, self.mixed = sweep, mixed
        self.points = sweep.points()
        self.runs = [TaskRun(sweep.task.changed(point), tuple(sweep.words)) for point in self.points]
        self.wanted = [index for index in range(len(self.runs)) if shard.has(index)]
        self.outcomes: Dict[int, Outcome] = {}
        self._seen, self._beyond = 0, 0  # of the wanted ones in their order, without a gap

    def find(self, folders: Sequence[Path]) -> int:
        """Takes the results that are there; how many."""
        for index in self.wanted:
            found = find_outcome(folders, self.runs[index])
            if found is not None:
                self.outcomes[index] = found
        kernels_of(self.outcomes.values(), self.mixed)
        return len(self.outcomes)

    def missing(self) -> List[int]:
        return [index for index in self.wanted if index not in self.outcomes]

    def size(self) -> Optional[int]:
        """How many of the wanted runs the campaign has by now, if it is over. Where a shard counts enough
        that are beyond, all of them together do so by then: what the others lack is not needed."""
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
        """Raises CampaignError for figures that there are not, and for kernels that do not go together."""
        asked = [each.figure for each in (self.sweep.stop, self.sweep.worst) if each is not None]
        if outcome.figures:
            for figure in self.sweep.keep + asked:
                figure_named(figure, list(outcome.figures))
        first = next((other for other in self.outcomes.values() if other.kernels), outcome)
        self.outcomes[index] = outcome
        kernels_of([first, outcome], self.mixed)

    def result(self) -> SweepResult:
        """Once it is over."""
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
    """Makes the runs that the folder has no result of. Raises CampaignError for points that the task
    refuses, and for figures that there are not."""
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
    """What the folders have of a run, unless its time limit ended that. Raises CampaignError for a file
    that is no result."""
    for folder in folders:
        file = folder / "runs" / f"{run.name()}.json"
        if not file.exists():
            continue
        try:
            found = Outcome.parse(file.read_text(), file.with_suffix(".times.json").read_text())
        except (OSError, ValueError, KeyError) as error:
            raise CampaignError(f"'{file}' is no result of a run; wanted it whole, or removed to make the run "
                                f"again") from error
        if not found.late:
            return found
    return None


def keep_outcome(folder: RunFolder, run: TaskRun, outcome: Outcome) -> None:
    """Raises CampaignError where the files cannot be written."""
    runs = folder.path / "runs"
    try:
        runs.mkdir(exist_ok=True)
    except OSError as error:
        raise CampaignError(f"cannot make the folder '{runs}': {error.strerror}") from error
    # The result comes last: where it is, so are its times.
    write_whole(runs / f"{run.name()}.times.json", outcome.times_text().encode())
    write_whole(runs / f"{run.name()}.json", outcome.text().encode())
