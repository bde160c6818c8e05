"""Folder of a campaign, in the format of burnish experiment."""

from __future__ import annotations

import fcntl
import json
import os
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Dict, List, Mapping, Optional


class CampaignError(Exception):
    """Error with a message of one sentence."""


@dataclass(frozen=True)
class Listed:
    """A run, as burnish experiment --list prints it."""

    number: int
    """Number of the run, from 1"""
    name: str
    """Name of its result"""
    run: str
    """Name of the run"""


def list_runs(program: str, words: List[str]) -> List[Listed]:
    """Lists the runs of an experiment. Raises CampaignError with the message of burnish."""
    done = subprocess.run([program, *words, "--list"], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True)
    if done.returncode != 0:
        raise CampaignError(_sentence(done.stderr))
    runs = []
    for line in done.stdout.splitlines():
        number, name, run = line.split("\t", 2)
        runs.append(Listed(int(number), name, run))
    return runs


def _sentence(said: str) -> str:
    lines = said.strip().splitlines() or ["burnish failed without a message"]
    return lines[-1].replace("burnish: ", "", 1)


def write_whole(file: Path, data: bytes) -> None:
    """Writes a file atomically. Raises CampaignError if it cannot be written."""
    part = file.parent / f".{file.name}.{os.getpid()}.part"
    try:
        part.write_bytes(data)
        part.replace(file)
    except OSError as error:
        part.unlink(missing_ok=True)
        raise CampaignError(f"cannot write '{file}': {error.strerror}") from error


class RunFolder:
    """Folder with results, locked while it is open."""

    def __init__(self, out: Optional[Path], name: str, resume: bool) -> None:
        """Opens the folder `out`; None: a new folder NAME, NAME_2, ... Raises CampaignError if the folder holds a
        run and `resume` is False, and if another process has locked it."""
        self._used = out is not None and out.exists()
        self.path = out if out is not None else self._new(name)
        try:
            self.path.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise CampaignError(f"cannot make the folder '{self.path}': {error.strerror}") from error
        self._lock = os.open(self.path, os.O_RDONLY | os.O_DIRECTORY)
        try:
            fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as taken:
            os.close(self._lock)
            raise CampaignError(f"another run writes into '{self.path}'; choose another folder, or wait for "
                                f"that run to end") from taken
        except OSError:
            pass  # the file system has no locks
        if not resume and any((self.path / name).exists() for name in (".burnish", "runs")):
            self.close()
            raise CampaignError(f"'{self.path}' holds a run; wanted another folder, or --resume to "
                                f"continue it")

    @staticmethod
    def _new(name: str) -> Path:
        for number in range(1, 100_001):
            path = Path(name if number == 1 else f"{name}_{number}")
            try:
                path.mkdir()
                return path
            except FileExistsError:
                continue
            except OSError as error:
                raise CampaignError(f"cannot make the folder '{path}': {error.strerror}") from error
        raise CampaignError(f"the folders '{name}' to '{name}_100000' exist; wanted --out")

    def close(self) -> None:
        """Unlocks the folder. Removes it if it is new and empty."""
        if self._lock >= 0:
            os.close(self._lock)
        self._lock = -1
        if not self._used:
            try:
                self.path.rmdir()  # fails if the folder is not empty
            except OSError:
                pass

    def __enter__(self) -> RunFolder:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def _file(self, name: str) -> Path:
        return self.path / "runs" / f"{name}.json"

    def has(self, name: str) -> bool:
        """Returns whether a run has a result. A run that its time limit ended has none."""
        try:
            return not json.loads(self._file(name).read_text())["late"]
        except FileNotFoundError:
            return False
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise CampaignError(f"'{self._file(name)}' is not the result of a run: {error}; wanted a complete file, or "
                                f"no file, to repeat the run") from error

    def keep(self, name: str, result: Mapping[str, bytes]) -> Optional[float]:
        """Writes the result of a worker. Returns the computing time [s], None if the time limit ended the run."""
        try:
            (self.path / "runs").mkdir(exist_ok=True)
        except OSError as error:
            raise CampaignError(f"cannot make the folder '{self.path / 'runs'}': {error.strerror}") from error
        campaign: Dict[str, Any] = json.loads(result["campaign"])
        campaign["shard"] = ""
        text = json.dumps(campaign, indent=2).encode() + b"\n"
        file = self.path / "campaign.json"
        if not file.exists():
            write_whole(file, text)
        # Writes the result last, so that a result always has its times.
        write_whole(self.path / "runs" / f"{name}.times.json", result["times"])
        write_whole(self._file(name), result["result"])
        if json.loads(result["result"])["late"]:
            return None
        return float(json.loads(result["times"])["computing"])
