"""Runs an example in C++ and its Python version: both must succeed and print the same lines.

Lines with a measured time ("us per state") are compared without their numbers."""

import re
import subprocess
import sys


def lines_of(command: list[str]) -> list[str]:
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"{' '.join(command)} failed with {run.returncode}:\n{run.stdout}{run.stderr}")
    text = re.sub(r"-(0\.?0*)(?![0-9])", r" \1", run.stdout)  # a zero has no sign
    return [
        re.sub(r"[0-9.]+", "#", line) if "us per state" in line else line.rstrip()
        for line in text.splitlines()
    ]


def main() -> None:
    program, twin = sys.argv[1:]
    ours, theirs = lines_of([sys.executable, twin]), lines_of([program])
    for number, (a, b) in enumerate(zip(ours, theirs), 1):
        if a != b:
            sys.exit(f"line {number} differs\n  Python: {a}\n  C++:    {b}")
    if len(ours) != len(theirs):
        sys.exit(f"Python printed {len(ours)} lines, C++ {len(theirs)}")
    if not ours:
        sys.exit("nothing was printed")
    print(f"{len(ours)} lines are the same")


main()
