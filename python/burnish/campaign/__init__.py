"""Experiments, campaigns and tunings on one machine, or on many machines with Dask distributed.

    burnish experiment seeds --seeds 2000 --scheduler tcp://192.168.0.5:8786

calls `python3 -m burnish.campaign` with the same arguments. The equivalent in Python is:

    from burnish import campaign
    campaign.experiment(["seeds", "--seeds", "2000"], scheduler="tcp://192.168.0.5:8786")

Workers need Dask distributed and the program burnish of the same version, but no common files. The scheduler
transfers the results. See docs/campaigns.md."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Any, List, Mapping, Optional, Sequence, Union

from . import _parts
from ._bar import Bar
from ._dask import TOGETHER, Job, dask, find_program, hand_over, make_runs
from ._points import Point
from ._results import CampaignError, RunFolder, list_runs
from ._sweep import Row, Shard, SweepResult, make_sweep, read_sweep
from ._tables import write_sweep
from ._tasks import Machine, Outcome
from ._tune import Tuned, Tuner, read_tuning, report_text, write_tuned
from ._tune import tune as tune_by

__all__ = ["CampaignError", "Outcome", "Point", "Row", "SweepResult", "Tuned", "experiment", "merge",
           "program", "sweep", "tune"]


def program() -> str:
    """Finds the program burnish.

    Searches in this order: the variable BURNISH_PROGRAM, the build of this package, the folder of this Python,
    absolute folders of PATH.

    Returns
    -------
    str
        Path of the program.

    Raises
    ------
    CampaignError
        If the program is not found.
    """
    package = Path(__file__).resolve().parents[1]
    build = package.parents[1] if package.parent.name == "python" else None
    places = [build / "apps" / "burnish" / "burnish"] if build and (build / "CMakeCache.txt").is_file() else []
    if sys.executable:
        places.append(Path(sys.executable).parent / "burnish")
    beside = [str(place) for place in places if place.is_file() and os.access(place, os.X_OK)]
    found = os.environ.get("BURNISH_PROGRAM") or (beside[0] if beside else find_program("burnish"))
    if not found:
        raise CampaignError("the program burnish was not found (Debian: the package burnish); wanted it in "
                            "PATH, or its path in BURNISH_PROGRAM")
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
    """Performs an experiment of `burnish experiment`.

    Parameters
    ----------
    words : sequence of str
        Name and options of the experiment, such as ["seeds", "--seeds", "2000"].
    scheduler : str, optional
        Address of a Dask scheduler, whose workers make the runs; default: the cores of this machine.
    out : str or Path, optional
        Folder for results; default: a new folder.
    resume : bool
        If True, keep the results in `out` and make only the missing runs.
    mixed : bool
        If True, accept results of kernels for different processors.
    quiet : bool
        If True, print nothing.
    time_limit : float
        Largest computing time of a run [s]; 0: 10 times the time of 95 % of the earlier runs, at least 120 s.
    patience : float
        Longest wait for a lost scheduler [s].

    Returns
    -------
    Path
        Folder with the results. Runs that did not polish are in the results.

    Raises
    ------
    CampaignError
        If an argument is rejected, or the scheduler is lost.
    """
    folder, _ = _experiment(list(words), scheduler, None if out is None else Path(out), resume, mixed, quiet,
                            time_limit, patience)
    return folder


def _experiment(words: List[str], scheduler: Optional[str], out: Optional[Path], resume: bool, mixed: bool,
                quiet: bool, time_limit: float, patience: float) -> "tuple[Path, int]":
    """Returns the folder and the exit code."""
    burnish = program()
    if not words:
        raise CampaignError("no experiment is named; wanted a name from burnish experiment --help")
    words = ["experiment", *words]
    flags = ["--quiet"] * quiet + ["--mixed"] * mixed
    name = f"experiment_{words[1]}"
    if resume and out is None:
        raise CampaignError("--resume requires --out, the folder of the earlier results")
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
            bar = Bar(words[1], len(runs), len(runs) - len(missing), quiet)
            hand_over(Job(
                missing, make_runs,
                lambda some, limit, clock: (burnish, words, str(Path.cwd()), [run.number for run in some], len(runs),
                                            [run.name for run in some], limit, clock),
                lambda run, result: folder.keep(run.name, result), time_limit, bar.say, bar.show, TOGETHER),
                scheduler, patience)
            bar.end()
        merge = [burnish, "merge", str(path), "--out", str(path), *flags]
        code = subprocess.run(merge).returncode
    if code not in (0, 1):
        raise CampaignError(f"burnish merge failed for the results in '{path}', with the message above")
    return path, code


def sweep(
    campaign: Union[str, Path, Mapping[str, Any]],
    *,
    scheduler: Optional[str] = None,
    out: Union[str, Path, None] = None,
    resume: bool = False,
    shard: Optional[str] = None,
    mixed: bool = False,
    quiet: bool = False,
    threads: int = 0,
    time_limit: float = 0.0,
    patience: float = 600.0,
) -> SweepResult:
    """Makes the runs of a campaign and writes its table and page. See docs/campaigns.md.

    Parameters
    ----------
    campaign : str, Path or mapping
        YAML file of the campaign, or its content as a dictionary.
    scheduler, out, resume, mixed, quiet, time_limit, patience
        Arguments of experiment().
    shard : str, optional
        "I/N" makes the runs I, I + N, I + 2N, ... without a table, which merge() makes. "1,3/4" makes several
        shards.
    threads : int
        Number of parallel runs without a scheduler; 0: one per core.

    Returns
    -------
    SweepResult
        Results of the runs. Failed runs are in the table.

    Raises
    ------
    CampaignError
        If the campaign or an argument is rejected, or the scheduler is lost.
    """
    plan = read_sweep(campaign)
    plan.points()
    which = Shard() if shard is None else Shard.parse(shard)
    if scheduler is not None:
        dask()
    if resume and out is None:
        raise CampaignError("--resume requires --out, the folder of the earlier results")
    bar = Bar(plan.name, 1, 0, quiet)
    machine = Machine(program(), scheduler, threads, time_limit, patience, bar.say)
    command = f"burnish sweep {campaign if isinstance(campaign, (str, Path)) else 'FILE'}"
    name = f"{plan.name}_campaign"
    if shard is not None:
        name += f"_{'_'.join(map(str, which.numbers))}_of_{which.count}"
    with RunFolder(None if out is None else Path(out), name, resume) as folder:
        _parts.part_of(plan, command, shard or "").write(folder.path)
        result = make_sweep(plan, machine, folder, lambda done, all: bar.part(done, all), which, mixed)
        bar.end()
        names = write_sweep(result, machine.program, folder, command) if shard is None else ["runs/"]
        if not quiet:
            _say(f"{plan.name}{'' if shard is None else ', shard ' + shard}", result, folder, names)
    return result


def merge(
    folders: Sequence[Union[str, Path]],
    *,
    out: Union[str, Path, None] = None,
    mixed: bool = False,
    quiet: bool = False,
) -> SweepResult:
    """Writes the table and page of a campaign from its shards, identical to those of a single process.

    Parameters
    ----------
    folders : sequence of str or Path
        Folders of the shards.
    out : str or Path, optional
        Folder for results; default: a new folder.
    mixed : bool
        If True, accept results of kernels for different processors.
    quiet : bool
        If True, print nothing.

    Returns
    -------
    SweepResult

    Raises
    ------
    CampaignError
        If the shards have different campaigns, tasks, versions or kernels, or if runs are missing.
    """
    if not folders:
        raise CampaignError("no folder is named; wanted folders that burnish sweep FILE --shard I/N wrote")
    places, target = [Path(folder) for folder in folders], None if out is None else Path(out)
    result, command = _parts.merge(places, mixed)
    with _parts.target_of(places, target, result.sweep.name) as folder:
        _parts.part_of(result.sweep, command, "").write(folder.path)
        names = write_sweep(result, program(), folder, command)
        if not quiet:
            _say(result.sweep.name, result, folder, names)
    return result


def _say(what: str, result: SweepResult, folder: RunFolder, names: Sequence[str]) -> None:
    failed = sum(not row.outcome.succeeded for row in result.rows)
    print(f"{what}: {len(result.rows)} runs, {failed} of them did not succeed\nin {folder.path}: {', '.join(names)}")


def tune(
    tuning: Union[str, Path, Mapping[str, Any]],
    *,
    scheduler: Optional[str] = None,
    out: Union[str, Path, None] = None,
    resume: bool = False,
    mixed: bool = False,
    quiet: bool = False,
    threads: int = 0,
    time_limit: float = 0.0,
    patience: float = 600.0,
) -> Tuned:
    """Tunes keys of a task, and writes the tuned task and a report. See docs/campaigns.md.

    Parameters
    ----------
    tuning : str, Path or mapping
        YAML file of the tuning, or its content as a dictionary.
    scheduler, out, resume, mixed, quiet, threads, time_limit, patience
        Arguments of sweep().

    Returns
    -------
    Tuned

    Raises
    ------
    CampaignError
        If the tuning or an argument is rejected, or the scheduler is lost.
    """
    plan = read_tuning(tuning)
    if scheduler is not None:
        dask()
    if resume and out is None:
        raise CampaignError("--resume requires --out, the folder of the earlier results")
    bar = Bar(plan.name, 1, 0, quiet)
    machine = Machine(program(), scheduler, threads, time_limit, patience, bar.say)
    with RunFolder(None if out is None else Path(out), f"{plan.name}_tuned", resume) as folder:
        tuned = tune_by(Tuner(plan, machine, folder, mixed))
        names = write_tuned(tuned, folder)
        if not quiet:
            print(f"{report_text(tuned)}\nin {folder.path}: {', '.join(names)}")
    return tuned
