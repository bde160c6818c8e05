"""The folder of a campaign, as burnish experiment leaves and takes it."""

from __future__ import annotations

import fcntl
import json
import os
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Dict, List, Mapping, Optional


class CampaignError(Exception):
    """What is wrong, in one sentence."""


@dataclass(frozen=True)
class Listed:
    """A run of an experiment, as burnish experiment --list tells."""

    number: int
    """from 1 on"""
    name: str
    """of its result"""
    run: str
    """its own name"""


def list_runs(program: str, words: List[str]) -> List[Listed]:
    """Raises CampaignError with what the words are refused with."""
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
    lines = said.strip().splitlines() or ["burnish ended without a word"]
    return lines[-1].replace("burnish: ", "", 1)


def write_whole(file: Path, data: bytes) -> None:
    """A file that is there whole or not at all."""
    part = file.parent / f".{file.name}.{os.getpid()}.part"
    try:
        part.write_bytes(data)
        part.replace(file)
    except OSError as error:
        part.unlink(missing_ok=True)
        raise CampaignError(f"cannot write '{file}': {error.strerror}") from error


class RunFolder:
    """A folder with results, held against others while it is open."""

    def __init__(self, out: Optional[Path], name: str, resume: bool) -> None:
        """`out`: where; None: a new one, called NAME, NAME_2, ... Raises CampaignError for a folder
        that holds a run, unless `resume`, and for one that another process holds."""
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
            raise CampaignError(f"another run writes into '{self.path}'; wanted another folder, or to "
                                f"wait for its end") from taken
        except OSError:
            pass  # files cannot be locked there
        if not resume and any((self.path / name).exists() for name in (".burnish", "runs")):
            self.close()
            raise CampaignError(f"'{self.path}' holds a run; wanted another folder, or --resume to go on "
                                f"with it")

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
        raise CampaignError(f"there are too many folders '{name}'; wanted --out")

    def close(self) -> None:
        """Lets others have it. One that was made and is empty goes."""
        if self._lock >= 0:
            os.close(self._lock)
        self._lock = -1
        if not self._used:
            try:
                self.path.rmdir()  # unless there is something in it
            except OSError:
                pass

    def __enter__(self) -> RunFolder:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def _file(self, name: str) -> Path:
        return self.path / "runs" / f"{name}.json"

    def has(self, name: str) -> bool:
        """Whether there is a result, of a run that was not ended by its time limit."""
        try:
            return not json.loads(self._file(name).read_text())["late"]
        except FileNotFoundError:
            return False
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise CampaignError(f"'{self._file(name)}' is no result of a run: {error}; wanted it whole, or "
                                f"removed to make the run again") from error

    def keep(self, name: str, result: Mapping[str, bytes]) -> Optional[float]:
        """Writes what came from a worker; the s that the run computed, None where it was ended."""
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
        # The result comes last: where it is, so are its times.
        write_whole(self.path / "runs" / f"{name}.times.json", result["times"])
        write_whole(self._file(name), result["result"])
        if json.loads(result["result"])["late"]:
            return None
        return float(json.loads(result["times"])["computing"])
