"""What `python3 -m burnish.campaign` does."""

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
        description="Performs an experiment on the workers of a Dask scheduler, or on the cores here.",
        epilog="Exit codes: those of burnish experiment.")
    commands = parser.add_subparsers(dest="command", required=True)
    one = commands.add_parser("experiment", help="as burnish experiment, with --scheduler")
    one.add_argument("--scheduler", metavar="ADDRESS", help="of Dask, such as tcp://192.168.0.5:8786")
    one.add_argument("--out", type=Path, metavar="DIR", help="folder for what is written")
    one.add_argument("--resume", action="store_true", help="go on with what the folder of --out holds")
    one.add_argument("--mixed", action="store_true", help="take results of kernels for other processors")
    one.add_argument("--quiet", action="store_true", help="print nothing")
    one.add_argument("--time-limit", type=float, default=0.0, metavar="S",
                     help="computing time of a run [20 times the median of those before]")
    one.add_argument("--patience", type=float, default=600.0, metavar="S",
                     help="how long a scheduler that is lost is waited for [600]")
    one.add_argument("words", nargs=argparse.REMAINDER, metavar="-- EXPERIMENT [OPTIONS]",
                     help="name and options of burnish experiment")
    many = commands.add_parser("sweep", help="the runs of a campaign's file, and their table")
    _add_file(many)
    many.add_argument("--shard", metavar="I/N",
                      help="every Nth run alone, from the Ith on, and no table; several: 1,3/4")
    parts = commands.add_parser("merge", help="the table of a campaign whose runs were made in shards")
    parts.add_argument("folders", nargs="+", type=Path, metavar="DIR", help="that sweep --shard left")
    parts.add_argument("--out", type=Path, metavar="DIR", help="folder for what is written")
    parts.add_argument("--mixed", action="store_true", help="take results of kernels for different processors")
    parts.add_argument("--quiet", action="store_true", help="print nothing")
    _add_file(commands.add_parser("tune", help="keys of a task made better, as a file says"))
    return parser


def _add_file(many: argparse.ArgumentParser) -> None:
    many.add_argument("file", type=Path, metavar="FILE", help="the campaign or the tuning: docs/campaigns.md")
    many.add_argument("--scheduler", metavar="ADDRESS", help="of Dask, such as tcp://192.168.0.5:8786")
    many.add_argument("--out", type=Path, metavar="DIR", help="folder for what is written")
    many.add_argument("--resume", action="store_true", help="go on with what the folder of --out holds")
    many.add_argument("--mixed", action="store_true", help="take results of kernels for different processors")
    many.add_argument("--threads", type=int, default=0, metavar="N", help="runs at once [one per core]")
    many.add_argument("--time-limit", type=float, default=0.0, metavar="S",
                      help="computing time of a run [20 times the median of those before]")
    many.add_argument("--patience", type=float, default=600.0, metavar="S",
                      help="how long a scheduler that is lost is waited for [600]")
    many.add_argument("--quiet", action="store_true", help="print nothing")


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """What the command line does; its exit code."""
    a = _parser().parse_args(arguments)
    try:
        return _do(a)
    except CampaignError as error:
        print(f"burnish: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("burnish: interrupted; what came back stays, and --resume goes on with it", file=sys.stderr)
        return 1


def _do(a: argparse.Namespace) -> int:
    if a.command == "sweep":
        result = sweep(a.file, scheduler=a.scheduler, out=a.out, resume=a.resume, shard=a.shard, mixed=a.mixed,
                       quiet=a.quiet, threads=a.threads, time_limit=a.time_limit, patience=a.patience)
        return 0 if all(row.outcome.done for row in result.rows) else 1
    if a.command == "merge":
        result = merge(a.folders, out=a.out, mixed=a.mixed, quiet=a.quiet)
        return 0 if all(row.outcome.done for row in result.rows) else 1
    if a.command == "tune":
        tuned = tune(a.file, scheduler=a.scheduler, out=a.out, resume=a.resume, mixed=a.mixed, quiet=a.quiet,
                     threads=a.threads, time_limit=a.time_limit, patience=a.patience)
        return 0 if tuned.better else 1
    words: List[str] = a.words[1:] if a.words[:1] == ["--"] else a.words
    return perform(words, a.scheduler, a.out, a.resume, a.mixed, a.quiet, a.time_limit, a.patience)[1]


if __name__ == "__main__":
    sys.exit(main())
