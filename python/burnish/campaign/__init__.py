"""Experiments on many machines, by Dask distributed.

    burnish experiment seeds --seeds 2000 --scheduler tcp://192.168.0.5:8786

hands over to `python3 -m burnish.campaign`, which does the same when it is called by itself. From
Python:

    from burnish import campaign
    campaign.experiment(["seeds", "--seeds", "2000"], scheduler="tcp://192.168.0.5:8786")

Workers need Dask distributed and the program burnish of the same version, and no files: results come
back by the scheduler. docs/campaigns.md says more."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import List, Optional, Sequence, Union

from ._dask import Job, dask, hand_over
from ._results import CampaignError, RunFolder, list_runs

__all__ = ["CampaignError", "experiment", "program"]


def program() -> str:
    """The program burnish: the one in BURNISH_PROGRAM, in the build that this package is of, beside
    this Python, or in PATH. Raises CampaignError where there is none."""
    built = Path(__file__).resolve().parents[3] / "apps" / "burnish" / "burnish"
    beside = Path(sys.executable).parent / "burnish"
    found = os.environ.get("BURNISH_PROGRAM") or shutil.which("burnish")
    for place in (beside, built):
        if not os.environ.get("BURNISH_PROGRAM") and os.access(place, os.X_OK):
            found = str(place)
    if not found:
        raise CampaignError("the program burnish is not there (Debian: the package burnish); wanted it in "
                            "PATH, or named by BURNISH_PROGRAM")
    return found


def experiment(
    words: Sequence[str],
    *,
    scheduler: Optional[str] = None,
    out: Union[str, Path, None] = None,
    resume: bool = False,
    mixed: bool = False,
    quiet: bool = False,
    time_limit: float = 0.0,
    patience: float = 600.0,
) -> Path:
    """The folder of an experiment that was performed as `burnish experiment` with these words, its
    name first: `["seeds", "--seeds", "2000"]`.

    scheduler: address of a Dask scheduler, whose workers make the runs; None: the cores here do.
    out: folder; None: a new one. resume: go on with what `out` holds. mixed: take results of kernels
    for different processors. quiet: print nothing. time_limit: s of computing that a run may take; 0:
    20 times the median of those before it. patience: s that a scheduler which is lost is waited for.
    Raises CampaignError for what is refused; runs that did not polish are in the results."""
    folder, _ = _experiment(list(words), scheduler, None if out is None else Path(out), resume, mixed, quiet,
                            time_limit, patience)
    return folder


def _experiment(words: List[str], scheduler: Optional[str], out: Optional[Path], resume: bool, mixed: bool,
                quiet: bool, time_limit: float, patience: float) -> "tuple[Path, int]":
    """The folder and the exit code."""
    burnish = program()
    if not words:
        raise CampaignError("no experiment is named; wanted its name, as burnish experiment --help lists")
    words = ["experiment", *words]
    flags = ["--quiet"] * quiet + ["--mixed"] * mixed
    name = f"experiment_{words[1]}"
    if resume and out is None:
        raise CampaignError("--resume wants --out, the folder to go on with")
    if scheduler is None:
        with RunFolder(out, name, resume) as folder:
            path = folder.path
        limit = ["--time-limit", str(time_limit)] if time_limit > 0 else []
        code = subprocess.run([burnish, *words, *flags, *limit, "--resume", "--out", str(path)]).returncode
    else:
        dask()
        check = ["--resume", "--out", str(out)] if resume else []
        runs = list_runs(burnish, [*words, *check])
        with RunFolder(out, name, resume) as folder:
            path = folder.path
            missing = [run for run in runs if not folder.has(run.name)]
            bar = _Bar(words[1], len(runs), len(runs) - len(missing), quiet)
            hand_over(Job(burnish, words, missing, len(runs), time_limit, folder, bar.say, bar.show),
                      scheduler, patience)
            bar.end()
        merge = [burnish, "merge", str(path), "--out", str(path), *flags]
        code = subprocess.run(merge).returncode
    if code not in (0, 1):
        raise CampaignError(f"the results in '{path}' were not put together, for the reason above")
    return path, code


class _Bar:
    """Progress on a terminal, and sentences."""

    def __init__(self, name: str, count: int, there: int, quiet: bool) -> None:
        self._name, self._count, self._there, self._quiet = name, count, there, quiet
        self._draws = not quiet and sys.stderr.isatty()

    def show(self, made: int, run: str) -> None:
        if self._draws:
            done = self._there + made
            hashes = 30 * done // max(1, self._count)
            print(f"\r\033[K{self._name} [{'#' * hashes:.<30}] {100 * done // max(1, self._count):3d} %  {run}",
                  end="", file=sys.stderr, flush=True)

    def say(self, sentence: str) -> None:
        self.end()
        if not self._quiet:
            print(f"burnish: {sentence}", file=sys.stderr, flush=True)

    def end(self) -> None:
        if self._draws:
            print("\r\033[K", end="", file=sys.stderr, flush=True)
