"""Distribution of runs with Dask distributed, which balances the load and resubmits the runs of a dead worker.
Results are files. Runs that have a result are not repeated."""

from __future__ import annotations

import importlib
import logging
import math
import socket
import sys
import time
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Optional, Tuple

from ._results import CampaignError, Listed

Result = Dict[str, bytes]

_FIRST_LIMIT = 3600.0
"""Largest wall time of a run before computing times of other runs are measured [s]; chosen by hand"""

TOGETHER = 6.0
"""Computing time of the runs that are submitted together [s]; chosen by hand"""


def find_program(name: str) -> Optional[str]:
    """Finds a program in the absolute folders of PATH. Relative and empty entries, which mean the working folder,
    are ignored. Workers receive this function by value."""
    import os
    import shutil

    folders = [entry for entry in os.environ.get("PATH", os.defpath).split(os.pathsep) if os.path.isabs(entry)]
    return shutil.which(name, path=os.pathsep.join(folders)) if folders else None


def make_runs(program: str, words: List[str], folder: str, numbers: List[int], count: int, names: List[str],
              limit: float, clock: float) -> Dict[str, Result]:
    """Makes some runs on a worker, as shards of one run each, in a process with a time limit. Workers receive this
    function by value, and do not need the Python package burnish."""
    import os
    import pathlib
    import subprocess
    import tempfile

    found = program if os.access(program, os.X_OK) else find_program("burnish")
    if found is None:
        raise RuntimeError(f"the worker on {os.uname().nodename} has no program burnish; wanted it in its PATH, "
                           f"or as '{program}'")
    path: str = found
    with tempfile.TemporaryDirectory(prefix="burnish_") as scratch:
        def attempt(to: pathlib.Path, which: List[int], seconds: float, of_clock: float) -> Any:
            command = [find_program("timeout") or "/usr/bin/timeout", "-k", "10", str(of_clock), path, *words,
                       "--shard", f"{','.join(map(str, which))}/{count}", "--threads", "1", "--quiet", "--out", str(to)]
            if seconds > 0:
                command += ["--time-limit", str(seconds)]
            return subprocess.run(command, cwd=folder if os.path.isdir(folder) else None,
                                  stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.PIPE, text=True)

        def files(out: pathlib.Path, name: str) -> Dict[str, bytes]:
            result = out / "runs" / f"{name}.json"
            if not result.exists():
                return {}
            return {"times": (out / "runs" / f"{name}.times.json").read_bytes(), "result": result.read_bytes(),
                    "campaign": (out / "campaign.json").read_bytes()}

        out = pathlib.Path(scratch) / "part"
        done = attempt(out, numbers, limit, clock * len(numbers))
        results = {name: files(out, name) for name in names}
        for number, name in zip(numbers, names):
            if results[name]:
                continue
            if done.returncode in (124, 137) and len(numbers) > 1:  # one run hangs: make each one alone
                out = pathlib.Path(scratch) / f"alone_{number}"
                done = attempt(out, [number], limit, clock)
            if done.returncode in (124, 137):  # the time limit ended it: record this as its result
                out = pathlib.Path(scratch) / f"ended_{number}"
                done = attempt(out, [number], 1e-9, 60.0)
            results[name] = files(out, name)
            if results[name]:
                continue
            said = done.stderr.strip().splitlines()
            other = out.exists() and any((out / "runs").glob("*.json"))
            raise RuntimeError(
                f"the worker on {os.uname().nodename} made a run with another name; wanted the "
                f"same version of burnish and the same robot files on all machines" if other else
                f"the worker on {os.uname().nodename}: {said[-1] if said else 'burnish ended with code '}"
                f"{'' if said else done.returncode}")
        return results


def dask() -> Any:
    """Imports the module distributed. Raises CampaignError if it is not installed."""
    try:
        return importlib.import_module("distributed")
    except ImportError as missing:
        raise CampaignError("Dask distributed is not installed on this machine (Debian: apt install "
                            "python3-distributed); wanted it on this machine and on the workers, or no --scheduler"
                            ) from missing


def _by_value(function: Callable[..., Any]) -> None:
    cloudpickle = importlib.import_module("cloudpickle")
    for module in {function.__module__, find_program.__module__}:
        cloudpickle.register_pickle_by_value(sys.modules[module])


@dataclass
class Job:
    """Runs to make, and the functions that make them."""

    runs: List[Listed]
    """Runs without a result"""
    function: Callable[..., Dict[str, Result]]
    """Function that a worker calls; returns results by the names of the runs. It is sent by value"""
    arguments: Callable[[List[Listed], float, float], Tuple[Any, ...]]
    """Arguments of `function` for some runs, from the limits of one run: computing time (0: none), wall time [s]"""
    keep: Callable[[Listed, Result], Optional[float]]
    """Function that stores a result; returns the computing time [s], None if the time limit ended the run"""
    limit: float
    """Largest computing time of a run [s]; 0: see Limit"""
    say: Callable[[str], None]
    """Function that prints a message"""
    progress: Callable[[int, str], None]
    """Function that is called with the number of results and the name of the last run"""
    together: float = 0.0
    """Computing time of the runs that are submitted together [s], to reduce overhead; 0: one run"""


class Limit:
    """Time limit: 10 times the computing time of 95 % of the earlier runs, at least 120 s, as in burnish experiment."""

    def __init__(self, given: float) -> None:
        self._given = given
        self._seen: List[float] = []

    def note(self, seconds: float) -> None:
        self._seen.append(seconds)

    def seconds(self) -> float:
        if self._given > 0 or len(self._seen) < 5:
            return self._given
        return max(120.0, 10.0 * sorted(self._seen)[math.ceil(0.95 * (len(self._seen) - 1))])

    def typical(self) -> float:
        """Median computing time of a run [s]; 0 before five runs have finished."""
        return sorted(self._seen)[(len(self._seen) - 1) // 2] if len(self._seen) >= 5 else 0.0

    def clock(self) -> float:
        """Limit of the wall time [s], larger than that of the computing time, because machines can be busy."""
        limit = self.seconds()
        return 3.0 * limit + 30.0 if limit > 0 else _FIRST_LIMIT


class _Lost(Exception):
    """Raised if the connection to the scheduler is lost."""


def hand_over(job: Job, address: str, patience: float) -> None:
    """Makes the runs of a job on the workers of a scheduler, and stores each result when it arrives. If the
    scheduler is lost, waits for it for up to `patience` [s], then submits the runs without a result again.
    Raises CampaignError if no scheduler is found, if a lost scheduler does not return, and if a worker rejects
    a run."""
    distributed = dask()
    _by_value(job.function)
    limit = Limit(job.limit)
    left = {run.name: run for run in job.runs}
    client = _connect(distributed, address, 5.0)
    if client is None:
        raise CampaignError(f"there is no Dask scheduler at '{address}'; wanted the address that "
                            f"dask-scheduler prints")
    try:
        while left:
            try:
                _drain(job, client, left, limit)
            except _Lost:
                job.say(f"the connection to the scheduler at {address} is lost; {len(left)} runs are waiting")
                _close(client)
                client = _connect(distributed, address, patience)
                if client is None:
                    raise CampaignError(
                        f"the scheduler at {address} did not return within {patience:g} s; {len(left)} "
                        f"runs have no result, and --resume makes them") from None
    finally:
        _close(client)


def _port_of(address: str) -> Tuple[str, int]:
    """Host and port of an address. Raises CampaignError for an invalid address."""
    host, colon, port = address.split("://")[-1].rpartition(":")
    if not (colon and host and port.isdigit() and 0 < int(port) < 65536):
        raise CampaignError(f"'{address}' is not the address of a scheduler; wanted an address such as "
                            f"tcp://192.168.0.5:8786")
    return host.strip("[]"), int(port)


def _connect(distributed: Any, address: str, patience: float) -> Any:
    """Returns a client, or None if the scheduler does not answer within `patience` [s]."""
    place = _port_of(address)
    # Suppress repeated messages of the libraries: hand_over() reports a lost scheduler once.
    for noise in ("distributed", "asyncio", "tornado"):
        logging.getLogger(noise).setLevel(logging.CRITICAL)
    end = time.monotonic() + patience
    while True:
        try:
            socket.create_connection(place, timeout=5.0).close()
            return distributed.Client(address, timeout=10.0, set_as_default=False)
        except OSError:  # TimeoutError is one
            if time.monotonic() > end:
                return None
            time.sleep(0.5)


def _close(client: Any) -> None:
    if client is None:
        return
    try:
        client.close(timeout=2)
    except Exception:  # the client may be in any state
        pass


def _threads(client: Any) -> int:
    try:
        workers = client.scheduler_info(timeout=5)["workers"].values()
        return sum(int(worker["nthreads"]) for worker in workers)
    except Exception as gone:
        raise _Lost from gone


def _drain(job: Job, client: Any, left: Dict[str, Listed], limit: Limit) -> None:
    """Submits runs and stores results until no run is left. Raises _Lost."""
    waiting = [run for run in left.values()]
    pending: List[Tuple[Any, List[Listed]]] = []
    window, threads, checked_at, reported = 0, 0, 0.0, False
    while left:
        now = time.monotonic()
        if now - checked_at > 2.0:
            # Submit several runs per thread, so that workers that join later get runs immediately.
            threads, checked_at = _threads(client), now
            window = max(8, 4 * threads) if job.together == 0.0 else max(4, 2 * threads)
            if threads == 0 and not reported:
                job.say("the scheduler has no workers; the runs are waiting for workers")
            reported = threads == 0
        while waiting and len(pending) < window:
            size = _together(job, limit, len(waiting), threads)
            runs, waiting = waiting[:size], waiting[size:]
            pending.append((_submit(job, client, runs, limit), runs))
        still: List[Tuple[Any, List[Listed]]] = []
        for future, runs in pending:
            status = future.status
            if status == "pending":
                still.append((future, runs))
            elif status == "finished":
                _keep(job, runs, future, left, limit)
            elif status == "error":
                raise CampaignError(_why(runs, future))
            else:  # cancelled or lost
                raise _Lost
        if len(still) == len(pending):
            if client.status != "running":
                raise _Lost
            time.sleep(0.01)
        pending = still


def _together(job: Job, limit: Limit, waiting: int, threads: int) -> int:
    """Number of runs to submit together, fewer at the end, so that all workers finish at about the same time."""
    typical = limit.typical()
    if job.together == 0.0 or typical <= 0.0:
        return 1
    return max(1, min(int(job.together / typical), waiting // max(1, 4 * threads)))


def _submit(job: Job, client: Any, runs: List[Listed], limit: Limit) -> Any:
    try:
        return client.submit(job.function, *job.arguments(runs, limit.seconds(), limit.clock()),
                             key=f"burnish-{runs[0].name}-{len(runs)}", pure=False)
    except Exception as gone:
        raise _Lost from gone


def _keep(job: Job, runs: List[Listed], future: Any, left: Dict[str, Listed], limit: Limit) -> None:
    try:
        results: Dict[str, Result] = future.result(timeout=60)
    except Exception as gone:  # the worker stopped before its result was fetched
        raise _Lost from gone
    future.release()
    for run in runs:
        seconds = job.keep(run, results[run.name])
        if seconds is not None:
            limit.note(seconds)
        del left[run.name]
        job.progress(len(job.runs) - len(left), run.run)


def _why(runs: List[Listed], future: Any) -> str:
    error = future.exception(timeout=60)
    what = f"the run '{runs[0].run}'" if len(runs) == 1 else f"one of the runs '{runs[0].run}' to '{runs[-1].run}'"
    if type(error).__name__ == "KilledWorker":
        return (f"{what} ended several workers one after the other; wanted workers with more memory, or that run "
                f"alone on this machine")
    return f"{what} failed: {error}"
