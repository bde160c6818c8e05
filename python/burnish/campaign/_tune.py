"""Tuning of keys of a task by a derivative-free optimizer, with different seeds for training and test."""

from __future__ import annotations

import csv
import importlib
import io
import json
import math
import statistics
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from .. import _core
from ._points import Point, count, nearest, number, only, read_values
from ._results import CampaignError, RunFolder, write_whole
from ._sweep import (SEED, bare, figure_named, find_outcome, keep_outcome, known_figures, program_words, read_seeds,
                     unit, Row)
from ._tasks import Machine, Outcome, TaskFile, TaskRun, kernels_of, read_tree

Vector = NDArray[np.float64]

_FAILED = 1e3
"""Objective and excess of an evaluation with a failed run, relative to the start"""


@dataclass
class Key:
    """A tuned key, its range, and its start value."""

    name: str
    low: float
    high: float
    log: bool
    start: float

    def value(self, fraction: float) -> float:
        """Value at a fraction of the range, 0 to 1, rounded to four digits."""
        u = min(max(fraction, 0.0), 1.0)
        exact = self.low * (self.high / self.low) ** u if self.log else self.low + (self.high - self.low) * u
        return min(max(float(f"{exact:.4g}"), self.low), self.high)

    def fraction(self, value: float) -> float:
        """Inverse of value(), without rounding."""
        if self.log:
            return math.log(value / self.low) / math.log(self.high / self.low)
        return (value - self.low) / (self.high - self.low)


@dataclass
class Tuning:
    """Content of a tuning's file."""

    name: str
    task: TaskFile
    keys: List[Key]
    minimise: str
    not_worse: List[str]
    slack: float
    """Allowed increase of `not_worse`, as a fraction of the start"""
    per: List[str]
    """Keys of `vary` that form groups: runs with equal values are a group. All groups have equal weight. In no
    group may `minimise` or a figure of `not_worse` get worse. Empty: all runs are one group"""
    train: List[Point]
    test: List[Point]
    evaluations: int
    words: List[str]
    weights: Dict[str, float] = field(default_factory=dict)
    """Weights of a sum of figures, per SI unit; empty: `minimise` is a figure"""


def read_tuning(source: Union[str, Path, Mapping[str, Any]]) -> Tuning:
    """Reads a tuning from a file or a dictionary. Raises CampaignError for contradictions."""
    if isinstance(source, (str, Path)):
        path = Path(source)
        tree = read_tree(path, "at least task, tune, minimise, train and test")
        folder, name = path.parent, path.stem
    else:
        tree, folder, name = dict(source), Path(), "tuning"
    only("tuning", tree, ["name", "task", "tune", "minimise", "not_worse", "slack", "per", "vary", "train",
                          "test", "evaluations", "controller", "plant"])
    if not isinstance(tree.get("task"), str):
        raise CampaignError("the tuning names no task; wanted task: FILE")
    weights = _weights(tree.get("minimise"))
    task = TaskFile.read(folder / tree["task"])
    keys = _keys(tree.get("tune"), task)
    train, test = (_conditions(tree, which, keys) for which in ("train", "test"))
    both = [point for point in train if point in test]
    if both:
        raise CampaignError(f"train and test have {both[0] or 'the unchanged task'} in common; wanted different seeds "
                            f"or samples")
    not_worse, per = (_texts(tree.get(key)) for key in ("not_worse", "per"))
    for key in per:
        if key not in train[0]:
            raise CampaignError(f"'per' names '{key}', which is not in 'vary'{nearest(key, list(train[0]))}")
    minimise = " + ".join(f"{weight:g} {figure}" for figure, weight in weights.items()) or tree["minimise"]
    return Tuning(str(tree.get("name", name)), task, keys, minimise, not_worse,
                  number("slack", tree.get("slack", 0.0)), per, train, test,
                  count("evaluations", tree.get("evaluations", 60), len(keys) + 2), program_words(tree, task),
                  weights)


def _weights(given: Any) -> Dict[str, float]:
    """Weights of a sum of figures; empty for one figure."""
    if isinstance(given, str):
        return {}
    if not isinstance(given, dict) or not given:
        raise CampaignError("the tuning has no key 'minimise'; wanted minimise: FIGURE, such as force_rmse, or "
                            "several figures with weights, such as {force_rmse: 1, position_rmse: 1000}")
    weights = {str(figure): number(f"minimise.{figure}", weight) for figure, weight in given.items()}
    for figure, weight in weights.items():
        if weight <= 0:
            raise CampaignError(f"minimise.{figure} is {weight:g}; wanted a weight above 0")
    return weights


def _texts(given: Any) -> List[str]:
    return [given] if isinstance(given, str) else [str(each) for each in given or []]


def groups_of(points: Sequence[Point], per: Sequence[str]) -> Dict[str, List[int]]:
    """Indices of the points in each group; the name of a group has the values of the keys `per`."""
    groups: Dict[str, List[int]] = {}
    for index, point in enumerate(points):
        name = ", ".join(f"{key} {value if isinstance(value, str) else json.dumps(value)}"
                         for key, value in point.items() if key in per)
        groups.setdefault(name, []).append(index)
    return groups


def _start(task: TaskFile, key: str) -> float:
    """Value of a key in the task. Raises CampaignError if it is not a number."""
    tree = _core.parse_yaml(task.changed({}))
    for part in key.split("."):
        tree = tree.get(part) if isinstance(tree, dict) else None
    if isinstance(tree, bool) or not isinstance(tree, (int, float)):
        given = "nothing" if tree is None else repr(tree)
        raise CampaignError(f"tune.{key}: its value in the task '{task.path}' is {given}; wanted a number, or "
                            f"the key 'start' beside 'from' and 'to'")
    return float(tree)


def _keys(given: Any, task: TaskFile) -> List[Key]:
    if not isinstance(given, dict) or not given:
        raise CampaignError(f"tune is {given!r}; wanted keys with their ranges, such as force: {{from: 20, to: 40}}")
    keys = []
    for name, span in given.items():
        where = f"tune.{name}"
        if not isinstance(span, dict) or "from" not in span or "to" not in span:
            raise CampaignError(f"{where} is {span!r}; wanted the keys 'from' and 'to'")
        only(where, span, ["from", "to", "log", "start"])
        low, high, log = number(where, span["from"]), number(where, span["to"]), bool(span.get("log", False))
        if not low < high:
            raise CampaignError(f"{where} goes from {low:g} to {high:g}; wanted the lower limit first")
        if log and low <= 0:
            raise CampaignError(f"{where} is a logarithmic range from {low:g}; wanted a lower limit above 0")
        task.changed({str(name): low}), task.changed({str(name): high})
        start = number(where, span["start"]) if "start" in span else _start(task, str(name))
        if not low <= start <= high:
            raise CampaignError(f"{where} goes from {low:g} to {high:g} and starts at {start:g}; wanted a range that "
                                f"contains the start")
        keys.append(Key(str(name), low, high, log, start))
    return keys


def _conditions(tree: Mapping[str, Any], which: str, keys: List[Key]) -> List[Point]:
    """Points of the training or the test: samples of the distributions in `vary`, and seeds."""
    given = tree.get(which)
    if not isinstance(given, dict):
        raise CampaignError(f"{which} is {given!r}; wanted the key 'seeds', or 'samples' of the distributions in "
                            f"'vary'")
    only(which, given, ["seeds", "samples"])
    samples = given.get("samples")
    samples = {"count": samples} if isinstance(samples, int) else samples
    # Different default seeds, so that training and test have different samples.
    if isinstance(samples, dict):
        samples = {"seed": 0 if which == "train" else 1, **samples}
    values = read_values(tree.get("vary"), samples)
    for key in keys:
        for name in [*values.listed, *values.drawn]:
            if name == key.name or name.startswith(key.name + ".") or key.name.startswith(name + "."):
                raise CampaignError(f"'{name}' is in 'vary', and '{key.name}' is in 'tune'; wanted one of them")
    points = values.points()
    seeds = read_seeds(f"{which}.seeds", given.get("seeds"), values)
    return [{**point, SEED: seed} for point in points for seed in seeds] if seeds else points


@dataclass
class Tuned:
    """Result of a tuning."""

    tuning: Tuning
    start: Dict[str, float]
    best: Dict[str, float]
    evaluated: List[Tuple[Dict[str, float], float, float]]
    """Evaluations: values of the keys, objective, and largest excess of `not_worse`, both relative to the start"""
    table: List[Dict[str, Any]]
    """Row for each figure on the test runs: start, tuned, difference with the half width of its 95 % interval"""
    groups: Dict[str, List[Dict[str, Any]]]
    """Such rows for `minimise` and `not_worse`, by groups of the test runs"""
    matters: List[Dict[str, Any]]
    """Row for each key: change of `minimise` on the training runs if the key returns to its start"""
    text: str
    """Text of the tuned task"""
    kernels: str
    """Number of runs for each kind of kernels; empty if all runs have the same kernels"""

    @property
    def better(self) -> bool:
        """True if `minimise` is significantly better on the test runs, and no figure of `not_worse` is
        significantly worse."""
        rows = {row["figure"]: row for row in self.table}
        gained: bool = rows[self.tuning.minimise]["verdict"] == "better"
        kept = [rows[figure] for figure in [*self.tuning.not_worse, FAILURES]]
        for group in self.groups.values():
            kept += group
        return gained and all(row["verdict"] not in ("worse", "unknown") for row in kept)


FAILURES = "runs that failed"


class _Enough(Exception):
    """Raised after the last evaluation."""


class Tuner:
    """Makes the runs of a tuning and stores their outcomes."""

    def __init__(self, tuning: Tuning, machine: Machine, folder: RunFolder, mixed: bool = False) -> None:
        self.tuning, self.machine, self.folder, self.mixed = tuning, machine, folder, mixed
        self.kernels = ""
        """Number of runs for each kind of kernels; empty if all runs have the same kernels"""
        self.seen: Dict[TaskRun, Outcome] = {}
        """Outcomes of all runs so far"""
        self.start = {key.name: key.start for key in tuning.keys}
        self.evaluated: Dict[Tuple[float, ...], Tuple[float, List[float]]] = {}
        first = self.outcomes(self.start, tuning.train)
        failed = [outcome for outcome in first if not outcome.succeeded]
        if failed:
            raise CampaignError(f"the unchanged task fails on a training run: {failed[0].outcome}; wanted a task whose "
                                f"training runs succeed")
        known = list(first[0].figures)
        if tuning.weights:
            tuning.weights = {figure_named(figure, known): weight for figure, weight in tuning.weights.items()}
            first = [self._with_sum(outcome) for outcome in first]
        else:
            tuning.minimise = figure_named(tuning.minimise, known)
        tuning.not_worse = [figure_named(figure, known) for figure in tuning.not_worse]
        self.groups = list(groups_of(tuning.train, tuning.per).values())
        self.means = {figure: self._means(first, figure) for figure in [tuning.minimise, *tuning.not_worse]}
        # With groups, `minimise` must not get worse in any group either.
        self.kept = [*tuning.not_worse, *[tuning.minimise] * bool(tuning.per)]

    def _means(self, outcomes: Sequence[Outcome], figure: str) -> List[float]:
        """Means of a figure, one per group."""
        return [statistics.fmean(outcomes[index].figures[figure] for index in group) for group in self.groups]

    @property
    def constraints(self) -> int:
        return len(self.kept) * len(self.groups)

    def outcomes(self, values: Mapping[str, float], points: Sequence[Point]) -> List[Outcome]:
        """Outcomes of the runs at some points, in order."""
        runs = [TaskRun(self.tuning.task.changed({**values, **point}), tuple(self.tuning.words)) for point in points]
        made: Dict[int, Outcome] = {}
        for index, run in enumerate(runs):
            found = find_outcome([self.folder.path], run)
            if found is not None:
                made[index] = found
                self._take(run, found)
        left = [index for index in range(len(runs)) if index not in made]

        def keep(at: int, outcome: Outcome) -> bool:
            made[left[at]] = outcome
            self._take(runs[left[at]], outcome)
            keep_outcome(self.folder, runs[left[at]], outcome)
            return True

        if left:
            self.machine.make([runs[index] for index in left], keep)
        return [self._with_sum(made[index]) for index in range(len(runs))]

    def _with_sum(self, outcome: Outcome) -> Outcome:
        """Adds the weighted sum `minimise` to the figures."""
        weights = self.tuning.weights
        if not weights or not all(figure in outcome.figures for figure in weights):
            return outcome
        total = sum(weight * outcome.figures[figure] for figure, weight in weights.items())
        return replace(outcome, figures={self.tuning.minimise: total, **outcome.figures})

    def _take(self, run: TaskRun, outcome: Outcome) -> None:
        """Stores an outcome. Raises CampaignError if its kernels differ from those of previous runs."""
        self.seen[run] = outcome
        self.kernels = kernels_of(self.seen.values(), self.mixed)

    def values(self, fractions: Vector) -> Dict[str, float]:
        return {key.name: key.value(float(u)) for key, u in zip(self.tuning.keys, fractions)}

    def evaluate(self, fractions: Vector) -> Tuple[float, List[float]]:
        """Objective and excesses, relative to the start. Raises _Enough after the last evaluation."""
        values = self.values(fractions)
        at = tuple(values.values())
        if at not in self.evaluated:
            if len(self.evaluated) >= self.tuning.evaluations:
                raise _Enough
            outcomes = self.outcomes(values, self.tuning.train)
            if all(outcome.succeeded for outcome in outcomes):
                self.evaluated[at] = (statistics.fmean(self._ratios(outcomes, self.tuning.minimise)), [
                    ratio - 1.0 - self.tuning.slack
                    for figure in self.kept for ratio in self._ratios(outcomes, figure)])
            else:
                self.evaluated[at] = (_FAILED, [_FAILED] * self.constraints)
            self.machine.say(f"evaluation {len(self.evaluated)} of {self.tuning.evaluations}: "
                             f"{bare(self.tuning.minimise)} is {self.evaluated[at][0]:.4g} times that of the start")
        return self.evaluated[at]

    def _ratios(self, outcomes: Sequence[Outcome], figure: str) -> List[float]:
        """Ratios of the mean of a figure to that of the start, one per group."""
        return [mean / start if start > 0 else 1.0 + mean - start
                for mean, start in zip(self._means(outcomes, figure), self.means[figure])]

    def best(self) -> Dict[str, float]:
        """Values with the lowest objective among those without excess, which include the start."""
        kept = [(objective, at) for at, (objective, excess) in self.evaluated.items()
                if all(each <= 1e-9 for each in excess)]
        at = min(kept)[1] if kept else tuple(self.start.values())
        return dict(zip(self.start, at))


_GAIN = 0.01
"""Relative decrease of the objective below which the optimizer is not restarted; chosen by hand"""


def optimise(tuner: Tuner) -> None:
    """Runs COBYLA from the start, and again from the best point until the objective decreases by less than 1 %.
    In a narrow valley, the first linear models show the steep walls, but not the direction of the valley. Raises
    CampaignError without NLopt and SciPy."""
    constraints = range(tuner.constraints)
    try:
        first = np.array([key.fraction(key.start) for key in tuner.tuning.keys])
        lowest = tuner.evaluate(first)[0]
        while True:
            _once(tuner, first, constraints)
            best = tuner.best()
            first = np.array([key.fraction(best[key.name]) for key in tuner.tuning.keys])
            objective = tuner.evaluated[tuple(best.values())][0]
            if objective > (1.0 - _GAIN) * lowest:
                return
            lowest = objective
    except _Enough:
        pass


def _once(tuner: Tuner, first: Vector, constraints: range) -> None:
    """Runs COBYLA of NLopt if installed, else of SciPy. Raises _Enough after the last evaluation."""
    try:
        nlopt: Any = importlib.import_module("nlopt")
    except ImportError:
        _by_scipy(tuner, first, constraints)
    else:
        _by_nlopt(nlopt, tuner, first, constraints)


def _by_nlopt(nlopt: Any, tuner: Tuner, first: Vector, constraints: range) -> None:
    thrown: List[BaseException] = []

    def guarded(pick: Callable[[Tuple[float, List[float]]], float]) -> Callable[[Vector, Vector], float]:
        def call(x: Vector, gradient: Vector) -> float:
            try:
                return pick(tuner.evaluate(np.array(x)))
            except BaseException as error:
                thrown.append(error)
                raise nlopt.ForcedStop() from error
        return call

    optimiser = nlopt.opt(nlopt.LN_COBYLA, len(first))
    optimiser.set_lower_bounds(0.0)
    optimiser.set_upper_bounds(1.0)
    optimiser.set_initial_step(0.15)
    optimiser.set_xtol_abs(2e-3)
    optimiser.set_maxeval(20 * tuner.tuning.evaluations)
    optimiser.set_min_objective(guarded(lambda result: result[0]))
    for i in constraints:
        optimiser.add_inequality_constraint(guarded(lambda result, i=i: result[1][i]), 0.0)  # type: ignore[misc]
    try:
        optimiser.optimize(first)
    except (nlopt.ForcedStop, nlopt.RoundoffLimited):
        pass
    if thrown:
        raise thrown[0]


def _by_scipy(tuner: Tuner, first: Vector, constraints: range) -> None:
    try:
        scipy: Any = importlib.import_module("scipy.optimize")
    except ImportError as missing:
        raise CampaignError("neither NLopt nor SciPy is installed (Debian: apt install python3-nlopt); tuning needs "
                            "one of them") from missing
    limits: List[Dict[str, Any]] = [
        {"type": "ineq", "fun": lambda x, i=i: -tuner.evaluate(x)[1][i]} for i in constraints]
    for i in range(len(first)):
        limits.append({"type": "ineq", "fun": lambda x, i=i: x[i]})
        limits.append({"type": "ineq", "fun": lambda x, i=i: 1.0 - x[i]})
    scipy.minimize(lambda x: tuner.evaluate(x)[0], first, method="COBYLA", constraints=limits,
                   options={"rhobeg": 0.15, "tol": 2e-3, "maxiter": 20 * tuner.tuning.evaluations})


def _t_quantile(freedom: int) -> float:
    """97.5 % quantile of Student's distribution, by its expansion about the normal quantile (Abramowitz and Stegun
    26.7.5)."""
    few = (12.706, 4.303, 3.182, 2.776)  # exact values, where the expansion is inaccurate
    if freedom <= len(few):
        return few[freedom - 1]
    z = statistics.NormalDist().inv_cdf(0.975)
    first, second = (z**3 + z) / 4.0, (5.0 * z**5 + 16.0 * z**3 + 3.0 * z) / 96.0
    third = (3.0 * z**7 + 19.0 * z**5 + 17.0 * z**3 - 15.0 * z) / 384.0
    return float(z + first / freedom + second / freedom**2 + third / freedom**3)


def difference(before: Sequence[float], after: Sequence[float]) -> Tuple[float, float]:
    """Mean of the differences of pairs, and the half width of its 95 % interval (inf for one pair)."""
    changes = [b - a for a, b in zip(before, after)]
    if len(changes) < 2:
        return statistics.fmean(changes), math.inf
    return statistics.fmean(changes), _t_quantile(len(changes) - 1) * statistics.stdev(changes) / math.sqrt(
        len(changes))


def compare(before: Sequence[Outcome], after: Sequence[Outcome], figures: Sequence[str],
            slack: Mapping[str, float]) -> List[Dict[str, Any]]:
    """Row for each figure, over the pairs of runs that both succeeded. `slack` has the figures for which lower is
    better, and the allowed increase as a fraction of the mean before. Other figures are only lower or higher."""
    pairs = [(a, b) for a, b in zip(before, after) if a.succeeded and b.succeeded]
    rows = []
    for figure in figures:
        a, b = ([outcome.figures.get(figure, math.nan) for outcome in side] for side in (
            [pair[0] for pair in pairs], [pair[1] for pair in pairs]))
        if not pairs or any(math.isnan(value) for value in [*a, *b]):
            rows.append({"figure": figure, "start": math.nan, "tuned": math.nan, "change": math.nan,
                         "half": math.inf, "verdict": "unknown"})
            continue
        change, half = difference(a, b)
        allowed = slack.get(figure, 0.0) * statistics.fmean(a)
        low, high = ("better", "worse") if figure in slack else ("lower", "higher")
        verdict = low if change < -half else high if change - half > allowed else "no sure difference" if (
            change <= half) else "within the slack"
        rows.append({"figure": figure, "start": statistics.fmean(a), "tuned": statistics.fmean(b),
                     "change": change, "half": half, "verdict": verdict})
    return rows


def tune(tuner: Tuner) -> Tuned:
    """Optimizes on the training runs, compares on the test runs, and returns each key alone to its start."""
    tuning = tuner.tuning
    optimise(tuner)
    best = tuner.best()
    before, after = (tuner.outcomes(values, tuning.test) for values in (tuner.start, best))
    figures = list(dict.fromkeys([tuning.minimise, *tuning.not_worse, *known_figures(
        [Row(0, {}, TaskRun("", ()), outcome) for outcome in before])]))
    asked = {**{figure: tuning.slack for figure in tuning.not_worse}, tuning.minimise: 0.0}
    table = compare(before, after, figures, asked)
    failed = [sum(not outcome.succeeded for outcome in side) for side in (before, after)]
    table.append({"figure": FAILURES, "start": failed[0], "tuned": failed[1],
                  "change": failed[1] - failed[0], "half": 0.0,
                  "verdict": "worse" if failed[1] > failed[0] else "better" if failed[1] < failed[0] else "the same"})
    trained = tuner.outcomes(best, tuning.train)
    matters = []
    for key in tuning.keys:
        row: Dict[str, Any] = {"key": key.name, "start": key.start, "tuned": best[key.name]}
        if best[key.name] != key.start:
            back = tuner.outcomes({**best, key.name: key.start}, tuning.train)
            row.update(compare(trained, back, [tuning.minimise], asked)[0])
        matters.append({**row, "start": key.start, "tuned": best[key.name]})
    evaluated = [(dict(zip(tuner.start, at)), objective, max(excess, default=0.0))
                 for at, (objective, excess) in tuner.evaluated.items()]
    groups = _by_group(tuning, before, after)
    return Tuned(tuning, tuner.start, best, evaluated, table, groups, matters, tuning.task.changed(best),
                 tuner.kernels)


def _by_group(tuning: Tuning, before: Sequence[Outcome],
              after: Sequence[Outcome]) -> Dict[str, List[Dict[str, Any]]]:
    """Rows of compare() for `minimise` and `not_worse`, by groups of the test runs; empty without `per`."""
    if not tuning.per:
        return {}
    allowed = dict.fromkeys([tuning.minimise, *tuning.not_worse], tuning.slack)
    groups = groups_of(tuning.test, tuning.per)
    return {name: compare([before[i] for i in at], [after[i] for i in at], list(allowed), allowed)
            for name, at in groups.items()}


def _label(figure: str) -> str:
    return f"{bare(figure)} [{unit(figure)}]" if unit(figure) else figure


def _changes(row: Mapping[str, Any]) -> str:
    """Last columns of a row of the report's tables."""
    return (f"| {row['start']:.5g} | {row['tuned']:.5g} | {row['change']:.3g} +- "
            f"{row['half']:.2g} | {row['verdict']} |")


def report_text(tuned: Tuned) -> str:
    """Returns the report as Markdown."""
    tuning = tuned.tuning
    verdict = ("significantly better on the test runs, and no figure of not_worse is significantly worse"
               if tuned.better else "not significantly better on the test runs: keep the original task")
    lines = [f"# {tuning.name}", "", f"The tuned task is {verdict}.", "",
             f"{len(tuned.evaluated)} evaluations on {len(tuning.train)} training runs, verdict on {len(tuning.test)} "
             f"test runs. Differences are means over pairs, with 95 % intervals.",
             *[f"The runs used different kernels, whose results differ in their last digits: {tuned.kernels}."]
             * bool(tuned.kernels),
             "", "## Tuned keys", "",
             f"| key | start | tuned | change of {_label(tuning.minimise)} if the key returns to its start, "
             "training runs |",
             "| --- | ---: | ---: | --- |"]
    for row in tuned.matters:
        cost = f"{row['change']:.4g} +- {row['half']:.2g}" + (
            "" if row["verdict"] == "worse" else ": not significant") if "change" in row else "not changed"
        lines.append(f"| {row['key']} | {row['start']:.6g} | {row['tuned']:.6g} | {cost} |")
    lines += ["", "## Figures on test runs", "", "| figure | start | tuned | change | verdict |",
              "| --- | ---: | ---: | ---: | --- |"]
    for row in tuned.table:
        asked = " (minimised)" if row["figure"] == tuning.minimise else (
            " (may not get worse)" if row["figure"] in tuning.not_worse else "")
        lines.append(f"| {_label(row['figure'])}{asked} {_changes(row)}")
    if tuned.groups:
        lines += ["", "## Figures on test runs, by group", "",
                  "| group | figure | start | tuned | change | verdict |",
                  "| --- | --- | ---: | ---: | ---: | --- |"]
        lines += [f"| {name} | {_label(row['figure'])} {_changes(row)}"
                  for name, rows in tuned.groups.items() for row in rows]
    return "\n".join(lines) + "\n"


def write_tuned(tuned: Tuned, folder: RunFolder) -> List[str]:
    """Writes the task, the report and all evaluations; returns the names of the files."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([*tuned.start, f"{bare(tuned.tuning.minimise)}, share of the start", "largest excess"])
    for values, objective, excess in tuned.evaluated:
        writer.writerow([json.dumps(value) for value in [*values.values(), objective, excess]])
    files = {"tuned.yaml": tuned.text, "tuning.md": report_text(tuned), "evaluations.csv": text.getvalue()}
    for name, content in files.items():
        write_whole(folder.path / name, content.encode())
    return list(files)
