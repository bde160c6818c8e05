"""Progress bar of many runs."""

from __future__ import annotations

import sys


class Bar:
    """Progress bar on a terminal, and messages."""

    def __init__(self, name: str, count: int, finished: int, quiet: bool) -> None:
        self._name, self._count, self._finished, self._quiet = name, count, finished, quiet
        self._draws = not quiet and sys.stderr.isatty()

    def show(self, made: int, run: str) -> None:
        if self._draws:
            done = self._finished + made
            hashes = 30 * done // max(1, self._count)
            print(f"\r\033[K{self._name} [{'#' * hashes:.<30}] {100 * done // max(1, self._count):3d} %  {run}",
                  end="", file=sys.stderr, flush=True)

    def part(self, done: int, count: int) -> None:
        self._count = count
        self.show(done, "")

    def say(self, sentence: str) -> None:
        self.end()
        if not self._quiet:
            print(f"burnish: {sentence}", file=sys.stderr, flush=True)

    def end(self) -> None:
        if self._draws:
            print("\r\033[K", end="", file=sys.stderr, flush=True)
