"""Shards of a campaign: the file that describes a shard, and merging of shards."""

from __future__ import annotations

import json
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import List, Optional, Sequence, Tuple

import burnish

from ._results import CampaignError, RunFolder, write_whole
from ._sweep import Shard, Sweep, SweepResult, SweepRuns, read_sweep

FILE = "campaign.json"
"""Name of the file, the same as in folders of burnish experiment"""


@dataclass(frozen=True)
class Part:
    """Content of campaign.json: the campaign of the runs in a folder."""

    name: str
    command: str
    campaign: str
    """Text of the campaign's file"""
    task: str
    """Text of the task file"""
    version: str
    shard: str
    """Shard "2/4", several shards "1,3/4", or "" for the whole campaign"""

    def write(self, folder: Path) -> None:
        tree = {"experiment": "sweep", "name": self.name, "command": self.command, "version": self.version,
                "shard": self.shard, "campaign": self.campaign, "task": self.task}
        write_whole(folder / FILE, (json.dumps(tree, indent=2) + "\n").encode())

    @staticmethod
    def read(folder: Path) -> Part:
        """Reads campaign.json. Raises CampaignError if the folder has no runs of a campaign, or runs of another
        version."""
        try:
            tree = json.loads((folder / FILE).read_text())
            if tree["experiment"] != "sweep":
                raise CampaignError(f"'{folder}' holds runs of `{tree['command']}`; wanted runs of burnish sweep, or "
                                    f"only runs of that command")
            part = Part(*(str(tree[key]) for key in ("name", "command", "campaign", "task", "version", "shard")))
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise CampaignError(f"'{folder}' holds no runs of a campaign; wanted a folder that burnish sweep FILE "
                                f"--shard I/N wrote") from error
        if part.version != burnish.__version__:
            raise CampaignError(f"'{folder}' holds runs of burnish {part.version}, but this is burnish "
                                f"{burnish.__version__}; wanted equal versions")
        return part


def part_of(sweep: Sweep, command: str, shard: str) -> Part:
    return Part(sweep.name, command, sweep.text, sweep.task.text, burnish.__version__, shard)


def _common_part(folders: Sequence[Path]) -> Part:
    first = Part.read(folders[0])
    for folder in folders[1:]:
        other = Part.read(folder)
        for what, one, another in (("another campaign", first.campaign, other.campaign),
                                   ("another task", first.task, other.task)):
            if one != another:
                raise CampaignError(f"'{folder}' holds runs of {what} than those in '{folders[0]}'; wanted shards of "
                                    f"one campaign")
    return first


def _lacking(plan: SweepRuns, folders: Sequence[Path]) -> str:
    """Sentence with the number of missing runs, and the shards without a folder."""
    missing = plan.missing()
    text = (f"{len(missing)} of {len(plan.runs)} runs are missing, first number {missing[0] + 1}; "
            f"wanted all shards, each with all of its runs")
    shards = [Part.read(folder).shard for folder in folders]
    if all(shards):
        read = [Shard.parse(shard) for shard in shards]
        numbers, count = {number for shard in read for number in shard.numbers}, read[0].count
        absent = [f"{number}/{count}" for number in range(1, count + 1) if number not in numbers]
        if absent and all(shard.count == count for shard in read):
            text += f" (without a folder: {', '.join(absent)})"
    return text


def _runs_of(part: Part, folders: Sequence[Path], mixed: bool) -> SweepRuns:
    """Runs of a campaign with the results in the folders. The task is read from its text, so its file need not
    exist on this machine; files that the task names must exist."""
    with tempfile.TemporaryDirectory(prefix="burnish_") as scratch:
        task = Path(scratch) / "task.yaml"
        task.write_text(part.task)
        file = Path(scratch) / "campaign.yaml"
        file.write_text(part.campaign)
        plan = SweepRuns(read_sweep(file, task=task, name=part.name), Shard(), mixed)
    plan.find(folders)
    return plan


def merge(folders: Sequence[Path], mixed: bool) -> Tuple[SweepResult, str]:
    """Returns the merged result, and the command that makes it in one process. Raises CampaignError for shards of
    different campaigns, and if runs are missing."""
    part = _common_part(folders)
    plan = _runs_of(part, folders, mixed)
    if plan.size() is None:
        raise CampaignError(_lacking(plan, folders))
    return plan.result(), part.command


def target_of(folders: Sequence[Path], out: Optional[Path], name: str) -> RunFolder:
    """Folder for the tables. It may be one of the folders with runs."""
    beside = out is not None and any(out.exists() and out.samefile(folder) for folder in folders)
    return RunFolder(out, f"{name}_campaign", resume=beside)


__all__: List[str] = ["Part", "merge", "part_of", "target_of"]
