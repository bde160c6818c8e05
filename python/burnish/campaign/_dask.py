"""Runs of an experiment handed to Dask distributed, which balances them and hands over again what a
worker had that died. What is here besides is files: a run whose result is there is not made."""

from __future__ import annotations

import importlib
import logging
import socket
import sys
import time
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Optional, Tuple

from ._results import CampaignError, Listed

Result = Dict[str, bytes]

_FIRST_LIMIT = 3600.0
"""s of the clock that a run may take while nothing is known of the others"""

TOGETHER = 6.0
"""s of computing that runs of an experiment are handed over for at once"""


def find_program(name: str) -> Optional[str]:
    """The program of this name in PATH. Relative entries, and empty ones, would mean the working folder,
    and are left out. Sent to workers by value."""
    import os
    import shutil

    folders = [entry for entry in os.environ.get("PATH", os.defpath).split(os.pathsep) if os.path.isabs(entry)]
    return shutil.which(name, path=os.pathsep.join(folders)) if folders else None


def make_runs(program: str, words: List[str], folder: str, numbers: List[int], count: int, names: List[str],
              limit: float, clock: float) -> Dict[str, Result]:
    """What a worker does: some runs, shards of one run each, in a process of its own that ends with its
    time. Sent by value: workers need the program and Dask, and no Python package of burnish."""
    import os
    import pathlib
    import subprocess
    import tempfile

    found = program if os.access(program, os.X_OK) else find_program("burnish")
    if found is None:
        raise RuntimeError(f"the worker on {os.uname().nodename} has no burnish; wanted it in its PATH, "
                           f"or as '{program}'")
    there: str = found
    with tempfile.TemporaryDirectory(prefix="burnish_") as scratch:
        def attempt(to: pathlib.Path, which: List[int], seconds: float, of_clock: float) -> Any:
            command = [find_program("timeout") or "/usr/bin/timeout", "-k", "10", str(of_clock), there, *words, "--shard",
                       f"{','.join(map(str, which))}/{count}", "--threads", "1", "--quiet", "--out", str(to)]
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
            if done.returncode in (124, 137) and len(numbers) > 1:  # one hangs: each by itself
                out = pathlib.Path(scratch) / f"alone_{number}"
                done = attempt(out, [number], limit, clock)
            if done.returncode in (124, 137):  # its result says that it was ended
                out = pathlib.Path(scratch) / f"ended_{number}"
                done = attempt(out, [number], 1e-9, 60.0)
            results[name] = files(out, name)
            if results[name]:
                continue
            said = done.stderr.strip().splitlines()
            other = out.exists() and any((out / "runs").glob("*.json"))
            raise RuntimeError(
                f"the worker on {os.uname().nodename} made another run than was asked for; wanted the "
                f"same version of burnish and the same files of robots there" if other else
                f"the worker on {os.uname().nodename}: {said[-1] if said else 'burnish ended with code '}"
                f"{'' if said else done.returncode}")
        return results


def dask() -> Any:
    """The module distributed. Raises CampaignError where it is not installed."""
    try:
        return importlib.import_module("distributed")
    except ImportError as missing:
        raise CampaignError("Dask distributed is not installed here (Debian: apt install "
                            "python3-distributed); wanted it here and on the workers, or no --scheduler"
                            ) from missing


def _by_value(function: Callable[..., Any]) -> None:
    cloudpickle = importlib.import_module("cloudpickle")
    for module in {function.__module__, find_program.__module__}:
        cloudpickle.register_pickle_by_value(sys.modules[module])


@dataclass
class Job:
    """Runs to be made."""

    runs: List[Listed]
    """those that have no result yet"""
    function: Callable[..., Dict[str, Result]]
    """what a worker does, to results by the runs' names; sent by value, so that it needs no module of burnish"""
    arguments: Callable[[List[Listed], float, float], Tuple[Any, ...]]
    """of the function for some runs, from the limits of one: s of computing (0: none) and of the clock"""
    keep: Callable[[Listed, Result], Optional[float]]
    """what becomes of a result; the s that the run computed, None where it was ended"""
    limit: float
    """s of computing that a run may take; 0: 20 times the median of those before it"""
    say: Callable[[str], None]
    """for sentences"""
    progress: Callable[[int, str], None]
    """called with the number of results that came, and the last one's run"""
    together: float = 0.0
    """s of computing that are handed over at once, for the sake of what a process and a message cost; 0: a run"""


class Limit:
    """20 times the median of what runs computed, as burnish experiment has it."""

    def __init__(self, said: float) -> None:
        self._said = said
        self._seen: List[float] = []

    def note(self, seconds: float) -> None:
        self._seen.append(seconds)

    def seconds(self) -> float:
        if self._said > 0 or len(self._seen) < 5:
            return self._said
        return max(10.0, 20.0 * sorted(self._seen)[(len(self._seen) - 1) // 2])

    def typical(self) -> float:
        """s that a run computes; 0 while too few are known."""
        return sorted(self._seen)[(len(self._seen) - 1) // 2] if len(self._seen) >= 5 else 0.0

    def clock(self) -> float:
        """A machine may be busy, and a limit is looked at between two ticks alone."""
        limit = self.seconds()
        return 3.0 * limit + 30.0 if limit > 0 else _FIRST_LIMIT


class _Lost(Exception):
    """The scheduler is gone."""


def hand_over(job: Job, address: str, patience: float) -> None:
    """Makes the runs of a job on the workers of a scheduler, and keeps each result as it comes. A
    scheduler that is lost is waited for, `patience` s; what has no result then is handed over again.
    Raises CampaignError where there is no scheduler to begin with, where it does not come back, and
    for what a run was refused with."""
    distributed = dask()
    _by_value(job.function)
    limit = Limit(job.limit)
    left = {run.name: run for run in job.runs}
    client = _connect(distributed, address, 5.0)
    if client is None:
        raise CampaignError(f"there is no Dask scheduler at '{address}'; wanted one that runs, such as "
                            f"dask-scheduler prints its address")
    try:
        while left:
            try:
                _drain(job, client, left, limit)
            except _Lost:
                job.say(f"the scheduler at {address} is lost; {len(left)} runs wait for it")
                _close(client)
                client = _connect(distributed, address, patience)
                if client is None:
                    raise CampaignError(
                        f"the scheduler at {address} did not come back in {patience:g} s; {len(left)} "
                        f"runs have no result, and --resume goes on with them") from None
    finally:
        _close(client)


def _port_of(address: str) -> Tuple[str, int]:
    """Raises CampaignError for what is no address."""
    host, colon, port = address.split("://")[-1].rpartition(":")
    if not (colon and host and port.isdigit() and 0 < int(port) < 65536):
        raise CampaignError(f"'{address}' is no address of a scheduler; wanted one such as "
                            f"tcp://192.168.0.5:8786")
    return host.strip("[]"), int(port)


def _connect(distributed: Any, address: str, patience: float) -> Any:
    """A client, or None."""
    place = _port_of(address)
    # What is retried is told here, once.
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
    except Exception:  # whatever state it was in
        pass


def _threads(client: Any) -> int:
    try:
        workers = client.scheduler_info(timeout=5)["workers"].values()
        return sum(int(worker["nthreads"]) for worker in workers)
    except Exception as gone:
        raise _Lost from gone


def _drain(job: Job, client: Any, left: Dict[str, Listed], limit: Limit) -> None:
    """Until nothing is left. Raises _Lost."""
    waiting = [run for run in left.values()]
    pending: List[Tuple[Any, List[Listed]]] = []
    window, threads, looked, silent = 0, 0, 0.0, False
    while left:
        now = time.monotonic()
        if now - looked > 2.0:
            # Some for every thread to come: workers that join have theirs at once.
            threads, looked = _threads(client), now
            window = max(8, 4 * threads) if job.together == 0.0 else max(4, 2 * threads)
            if threads == 0 and not silent:
                job.say("the scheduler has no workers; the runs wait for some")
            silent = threads == 0
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
            else:  # cancelled or lost: the connection is gone
                raise _Lost
        if len(still) == len(pending):
            if client.status != "running":
                raise _Lost
            time.sleep(0.01)
        pending = still


def _together(job: Job, limit: Limit, waiting: int, threads: int) -> int:
    """Runs that are handed over at once. Towards the end fewer, so that no worker waits for the others."""
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
    except Exception as gone:  # its worker went before it was fetched
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
        return (f"{what} was on several workers that died one after the other; wanted workers with more "
                f"memory, or a look at it by itself")
    return f"{what} could not be made: {error}"
