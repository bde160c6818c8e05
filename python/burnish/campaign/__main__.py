"""Command line of `python3 -m burnish.campaign`."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import List, Optional, Sequence

from . import CampaignError, merge, sweep, tune
from . import _experiment as perform


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python3 -m burnish.campaign",
        description="Performs experiments, campaigns and tunings on the workers of a Dask scheduler, or on the "
                    "cores of this machine.",
        epilog="Exit codes are those of burnish experiment.")
    commands = parser.add_subparsers(dest="command", required=True)
    one = commands.add_parser("experiment", help="perform an experiment, as burnish experiment does")
    one.add_argument("--scheduler", metavar="ADDRESS",
                     help="address of a Dask scheduler, such as tcp://192.168.0.5:8786")
    one.add_argument("--out", type=Path, metavar="DIR", help="folder for results")
    one.add_argument("--resume", action="store_true",
                     help="keep the results in the folder of --out, and make only the missing runs")
    one.add_argument("--mixed", action="store_true", help="accept results of kernels for different processors")
    one.add_argument("--quiet", action="store_true", help="print nothing")
    one.add_argument("--time-limit", type=float, default=0.0, metavar="S",
                     help="largest computing time of a run [10 times the time of earlier runs, at least 120]")
    one.add_argument("--patience", type=float, default=600.0, metavar="S",
                     help="longest wait for a lost scheduler [600]")
    one.add_argument("words", nargs=argparse.REMAINDER, metavar="-- EXPERIMENT [OPTIONS]",
                     help="name and options of the experiment")
    many = commands.add_parser("sweep", help="make the runs of a campaign, and their table")
    _add_file(many)
    many.add_argument("--shard", metavar="I/N",
                      help="make only the runs I, I + N, I + 2N, ..., without a table; several shards: 1,3/4")
    parts = commands.add_parser("merge", help="write the table of a campaign from its shards")
    parts.add_argument("folders", nargs="+", type=Path, metavar="DIR", help="folder that sweep --shard wrote")
    parts.add_argument("--out", type=Path, metavar="DIR", help="folder for results")
    parts.add_argument("--mixed", action="store_true", help="accept results of kernels for different processors")
    parts.add_argument("--quiet", action="store_true", help="print nothing")
    _add_file(commands.add_parser("tune", help="tune keys of a task"))
    return parser


def _add_file(many: argparse.ArgumentParser) -> None:
    many.add_argument("file", type=Path, metavar="FILE",
                      help="file of the campaign or the tuning; see docs/campaigns.md")
    many.add_argument("--scheduler", metavar="ADDRESS",
                      help="address of a Dask scheduler, such as tcp://192.168.0.5:8786")
    many.add_argument("--out", type=Path, metavar="DIR", help="folder for results")
    many.add_argument("--resume", action="store_true",
                      help="keep the results in the folder of --out, and make only the missing runs")
    many.add_argument("--mixed", action="store_true", help="accept results of kernels for different processors")
    many.add_argument("--threads", type=int, default=0, metavar="N", help="number of parallel runs [one per core]")
    many.add_argument("--time-limit", type=float, default=0.0, metavar="S",
                      help="largest computing time of a run [10 times the time of earlier runs, at least 120]")
    many.add_argument("--patience", type=float, default=600.0, metavar="S",
                      help="longest wait for a lost scheduler [600]")
    many.add_argument("--quiet", action="store_true", help="print nothing")


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Runs the command line; returns the exit code."""
    a = _parser().parse_args(arguments)
    try:
        return _do(a)
    except CampaignError as error:
        print(f"burnish: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("burnish: interrupted; finished runs are kept, and --resume continues with them", file=sys.stderr)
        return 1


def _do(a: argparse.Namespace) -> int:
    if a.command == "sweep":
        result = sweep(a.file, scheduler=a.scheduler, out=a.out, resume=a.resume, shard=a.shard, mixed=a.mixed,
                       quiet=a.quiet, threads=a.threads, time_limit=a.time_limit, patience=a.patience)
        return 0 if all(row.outcome.succeeded for row in result.rows) else 1
    if a.command == "merge":
        result = merge(a.folders, out=a.out, mixed=a.mixed, quiet=a.quiet)
        return 0 if all(row.outcome.succeeded for row in result.rows) else 1
    if a.command == "tune":
        tuned = tune(a.file, scheduler=a.scheduler, out=a.out, resume=a.resume, mixed=a.mixed, quiet=a.quiet,
                     threads=a.threads, time_limit=a.time_limit, patience=a.patience)
        return 0 if tuned.better else 1
    words: List[str] = a.words[1:] if a.words[:1] == ["--"] else a.words
    return perform(words, a.scheduler, a.out, a.resume, a.mixed, a.quiet, a.time_limit, a.patience)[1]


if __name__ == "__main__":
    sys.exit(main())
