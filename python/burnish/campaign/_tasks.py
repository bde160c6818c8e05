"""Runs of any task by the program burnish, from the text of a task to its figures, on this machine or on workers."""

from __future__ import annotations

import hashlib
import json
import os
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Dict, Iterable, List, Mapping, Optional, Sequence, Tuple

import burnish

from .. import _core
from ._dask import Job, Limit, Result, find_program, hand_over
from ._results import CampaignError, Listed


def read_tree(path: Path, wanted: str) -> Dict[str, Any]:
    """Reads the keys of a YAML file. Raises CampaignError if the file is unreadable, not YAML, or has no keys."""
    try:
        tree = _core.read_yaml(path)
    except UnicodeDecodeError as error:
        raise CampaignError(f"{path}: the text is not UTF-8; wanted {wanted}") from error
    except burnish.Error as error:
        raise CampaignError(str(error)) from error
    if not isinstance(tree, dict):
        raise CampaignError(f"'{path}' has no keys; wanted {wanted}")
    return tree


# Names of tasks in task files; each is a module of the package.
NAMED_TASKS: List[str] = [task["name"] for task in _core.named_tasks()]


@dataclass
class TaskFile:
    """Task file of polishing, or of the task that it names."""

    path: Path
    tree: Dict[str, Any]
    text: str
    """Original text of the file"""

    @staticmethod
    def read(path: Path) -> TaskFile:
        file = TaskFile(path, read_tree(path, "a task file"), path.read_text())
        file.changed({})  # rejects an invalid task
        return file

    @property
    def polishes(self) -> bool:
        return bool(self.tree.get("task", "polishing") == "polishing")

    @property
    def module(self) -> Any:
        """Module of the task. For an unknown task, returns the first module, which then rejects the file."""
        if self.polishes:
            return burnish.polishing
        name = str(self.tree["task"])
        return getattr(burnish, name if name in NAMED_TASKS else NAMED_TASKS[0])

    def units(self) -> Dict[str, str]:
        """Units of the keys that have one."""
        units: Dict[str, str] = self.module.task_units()
        return units

    def changed(self, values: Mapping[str, Any]) -> str:
        """Returns the text of the task with changed values. Raises CampaignError for unknown keys."""
        words = [f"{key}={json.dumps(value)}" for key, value in values.items()]
        try:
            task = self.module
            if self.polishes:
                return str(task.task_text(task.read_task(self.path, words)))
            # The run, not the campaign, rejects contradictory values, which may affect one point of many.
            return str(task.task_text(task.override_task(task.read_task(self.path), words)))
        except burnish.Error as error:
            raise CampaignError(str(error)) from error


@dataclass(frozen=True)
class TaskRun:
    """A run: its task with all keys, and the arguments of the program."""

    text: str
    words: Tuple[str, ...]
    """Arguments of the program: "polish" or "run", and options, without the task file"""

    def name(self) -> str:
        """Hash of everything that affects the result, 32 digits: version, arguments, task, file of the robot."""
        digest = hashlib.sha256()
        for part in (burnish.__version__, *self.words, self.text):
            digest.update(f"{len(part)}:{part}".encode())
        robot = str(_core.parse_yaml(self.text)["robot"]).partition(":")[0]
        if os.path.isfile(robot):
            digest.update(Path(robot).read_bytes())
        return digest.hexdigest()[:32]


def make_task_run(program: str, words: List[str], text: str, folder: str, clock: float,
                  name: str) -> Dict[str, Result]:
    """Makes a run on a worker; returns the result by its name. A run that is rejected, or exceeds its limit, has no
    figures."""
    import json
    import os
    import pathlib
    import subprocess
    import tempfile

    found = program if os.access(program, os.X_OK) else find_program("burnish")
    if found is None:
        raise RuntimeError(f"the worker on {os.uname().nodename} has no program burnish; wanted it in its PATH, "
                           f"or as '{program}'")
    with tempfile.TemporaryDirectory(prefix="burnish_") as scratch:
        task = pathlib.Path(scratch) / "task.yaml"
        task.write_text(text)
        words_said = pathlib.Path(scratch) / "said"
        with open(words_said, "w") as errors:
            process = subprocess.Popen(
                [find_program("timeout") or "/usr/bin/timeout", "-k", "10", str(clock), found, words[0], str(task),
                 *words[1:], "--no-page", "--quiet", "--record-every", "1000000",
                 "--out", str(pathlib.Path(scratch) / "out")],
                cwd=folder if os.path.isdir(folder) else None, stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL, stderr=errors)
            status, usage = os.wait4(process.pid, 0)[1:]
        process.returncode = os.waitstatus_to_exitcode(status)
        files = sorted(pathlib.Path(scratch).glob("out/**/metrics.json"))
        said = [line for line in words_said.read_text().splitlines() if ": note: " not in line]
        late = process.returncode in (124, 137, -9)
        if late:
            run = {"outcome": "ended by its time limit"}
        elif files:
            run = json.loads(files[0].read_text())
        else:
            sentence = said[-1] if said else f"burnish ended with code {process.returncode}"
            run = {"outcome": sentence.replace("burnish: ", "", 1).replace(str(task), "the task")}
        seconds = usage.ru_utime + usage.ru_stime
        return {name: {"run": json.dumps(run).encode(), "late": b"1" if late else b"",
                       "computing": str(seconds).encode()}}


@dataclass
class Outcome:
    """Outcome of a run."""

    succeeded: bool
    outcome: str
    figures: Dict[str, float]
    """Figures by their names in metrics.json, such as `force_rmse_N`, without measured times"""
    times: Dict[str, float]
    late: bool = False
    kernels: str = ""
    """Kernels of the run, such as `AVX2`; empty without a run"""

    def text(self) -> str:
        """Returns the data that are equal on all machines with the same kernels, as JSON."""
        return json.dumps({"succeeded": self.succeeded, "outcome": self.outcome, "late": self.late,
                           "figures": self.figures}, indent=1) + "\n"

    def times_text(self) -> str:
        """Returns measured times and the kernels, as JSON."""
        return json.dumps({"kernels": self.kernels, **self.times}, indent=1) + "\n"

    @staticmethod
    def parse(text: str, times_text: str) -> Outcome:
        """Makes an outcome from the texts of text() and times_text().

        Parameters
        ----------
        text, times_text : str
            JSON texts.

        Returns
        -------
        Outcome
        """
        tree, times = json.loads(text), json.loads(times_text)
        kernels = times.pop("kernels")
        return Outcome(tree["succeeded"], tree["outcome"], tree["figures"], times, tree["late"], kernels)


def kernels_of(outcomes: Iterable[Outcome], mixed: bool) -> str:
    """Number of runs per kind of kernels, such as "3 with AVX2, 5 with AVX-512"; empty for one kind. Raises
    CampaignError for several kinds if `mixed` is False."""
    counts: Dict[str, int] = {}
    for outcome in outcomes:
        if outcome.kernels:
            counts[outcome.kernels] = counts.get(outcome.kernels, 0) + 1
    if len(counts) < 2:
        return ""
    text = ", ".join(f"{runs} with {kernels}" for kernels, runs in sorted(counts.items()))
    if not mixed:
        raise CampaignError(f"the runs used kernels for different processors ({text}), whose results differ "
                            f"in their last digits; wanted equal kernels, or --mixed")
    return text


def outcome_of(result: Result) -> Outcome:
    run: Dict[str, Any] = json.loads(result["run"])
    figures, times = {}, {"computing_s": float(result["computing"])}
    own = run.get(str(run.get("figures", ""))) or {}
    for key, value in {**(run.get("metrics") or {}), **own}.items():
        if isinstance(value, (int, float)) and not isinstance(value, bool):
            figures[key] = float(value)
    for group in ("solver", "ticks"):
        tree = (run.get("metrics") or {}).get(group) if group == "solver" else run.get(group)
        for key, value in (tree or {}).items():
            times[f"{group}.{key}"] = float(value)
    outcome = str(run["outcome"]).partition(", simulated in")[0]
    return Outcome(bool(run.get("succeeded", False)), outcome, figures, times,
                   bool(result["late"]), str(run.get("kernels", "")))


@dataclass
class Machine:
    """Machines that make the runs: the workers of a scheduler, or this machine."""

    program: str
    scheduler: Optional[str] = None
    threads: int = 0
    """Number of parallel runs without a scheduler; 0: one per core"""
    time_limit: float = 0.0
    patience: float = 600.0
    say: Callable[[str], None] = lambda sentence: None

    def make(self, runs: Sequence[TaskRun], keep: Callable[[int, Outcome], bool]) -> None:
        """Makes runs. Calls `keep` with the index and outcome of each finished run; ends if it returns False."""
        by_name = {run.name(): index for index, run in reversed(list(enumerate(runs)))}
        listed = [Listed(index + 1, name, f"number {index + 1}") for name, index in sorted(
            by_name.items(), key=lambda item: item[1])]
        same = {index: by_name[run.name()] for index, run in enumerate(runs)}
        copies: Dict[int, List[int]] = {}
        for index, first in same.items():
            copies.setdefault(first, []).append(index)

        def arguments(some: List[Listed], limit: float, clock: float) -> Tuple[Any, ...]:
            one = runs[some[0].number - 1]
            return self.program, list(one.words), one.text, str(Path.cwd()), clock, some[0].name

        def kept(run: Listed, result: Result) -> Optional[float]:
            outcome = outcome_of(result)
            for index in copies[run.number - 1]:
                if not keep(index, outcome):
                    raise Ended
            return None if outcome.late or not outcome.figures else outcome.times["computing_s"]

        try:
            if self.scheduler is not None:
                hand_over(Job(listed, make_task_run, arguments, kept, self.time_limit, self.say,
                              lambda made, run: None), self.scheduler, self.patience)
            else:
                self._make_here(listed, arguments, kept)
        except Ended:
            pass

    def _make_here(self, listed: List[Listed], arguments: Callable[[List[Listed], float, float], Tuple[Any, ...]],
                   kept: Callable[[Listed, Result], Optional[float]]) -> None:
        limit = Limit(self.time_limit)
        threads = self.threads or len(os.sched_getaffinity(0))
        waiting = list(listed)
        pending: Dict[Future[Dict[str, Result]], Listed] = {}
        pool = ThreadPoolExecutor(threads)
        try:
            while waiting or pending:
                while waiting and len(pending) < 2 * threads:
                    run = waiting.pop(0)
                    pending[pool.submit(make_task_run, *arguments([run], limit.seconds(), limit.clock()))] = run
                for future in wait(pending, return_when=FIRST_COMPLETED).done:
                    run = pending.pop(future)
                    seconds = kept(run, future.result()[run.name])
                    if seconds is not None:
                        limit.note(seconds)
        finally:
            pool.shutdown(wait=True, cancel_futures=True)


class Ended(Exception):
    """Raised to end the runs early."""
