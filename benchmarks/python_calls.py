"""What calling burnish from Python costs: states one by one, and 10,000 of them in one batch, beside
the same calls on the same states in C++.

    PYTHONPATH=build/python python3 benchmarks/python_calls.py build/benchmarks/burnish_calls_bench

Talos' right arm, translations of the tool held. Both sides go through the same doors and take turns;
every figure is the least wall time per state of all its repetitions, ratios compare those."""

from __future__ import annotations

import argparse
import subprocess
import tempfile
import time
from pathlib import Path
from typing import Callable, Dict, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

import burnish

STATES = 10_000
PIECE = 250
"""states between two looks at the clock, one by one: small pieces find a quiet moment"""
State = Tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]


def least(repetitions: int, states: Sequence[State], piece: int,
          run: Callable[[Sequence[State]], None]) -> float:
    """Microseconds per state."""
    best = float("inf")
    pieces = [states[first:first + piece] for first in range(0, len(states), piece)]
    for some in repetitions * pieces:
        start = time.perf_counter()
        run(some)
        best = min(best, time.perf_counter() - start)
    return 1e6 * best / piece


def in_cpp(program: Path, states: Path, repetitions: int) -> Dict[str, float]:
    command = [str(program), str(states), str(STATES), str(PIECE), str(repetitions)]
    lines = subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()
    return {name: float(value) for name, value in (line.split() for line in lines)}


class InPython:
    def __init__(self, states: Path) -> None:
        robot = burnish.load_robot("talos:right_arm")
        contact = burnish.ContactSpec(tool="tool", directions="linear").with_gains(0.0, 50.0)
        generator = np.random.default_rng(20)
        nv = robot.model.nv
        around = np.tile(robot.reference_configuration(), (STATES, 1))
        self.q = burnish.integrate(robot.model, around, generator.uniform(-0.3, 0.3, (STATES, nv)))
        self.v = generator.uniform(-1.0, 1.0, (STATES, nv))
        self.tau = generator.uniform(-10.0, 10.0, (STATES, nv))
        states.write_bytes(b"".join(part.tobytes() for part in (self.q, self.v, self.tau)))
        # One array per state, as a program that works state by state has them.
        self.rows = [(q.copy(), v.copy(), tau.copy())
                     for q, v, tau in zip(self.q, self.v, self.tau)]
        self.one = burnish.ContactDynamics(robot.model, [contact])
        self.batches = {
            threads: burnish.ContactDynamicsBatch(robot.model, [contact], STATES, threads=threads)
            for threads in (1, 2)
        }

    def loop(self, states: Sequence[State]) -> None:
        for _, _, _ in states:
            pass

    def forward(self, states: Sequence[State]) -> None:
        forward = self.one.forward
        for q, v, tau in states:
            forward(q, v, tau)

    def forward_and_a(self, states: Sequence[State]) -> None:
        one = self.one
        for q, v, tau in states:
            one.forward(q, v, tau)
            one.a

    def derivatives(self, states: Sequence[State]) -> None:
        one = self.one
        for q, v, tau in states:
            one.forward(q, v, tau)
            one.forward_derivatives()

    def batch(self, threads: int) -> None:
        self.batches[threads].forward_with_derivatives(self.q, self.v, self.tau)

    def measure(self, repetitions: int) -> Dict[str, float]:
        def singly(run: Callable[[Sequence[State]], None]) -> float:
            return least(repetitions, self.rows, PIECE, run)

        def at_once(threads: int) -> float:
            return least(repetitions, self.rows, STATES, lambda _: self.batch(threads))

        return {
            "loop": singly(self.loop),
            "forward": singly(self.forward),
            "forward and a": singly(self.forward_and_a),
            "derivatives": singly(self.derivatives),
            "batch": at_once(1),
            "batch2": at_once(2),
        }


def keep_least(best: Dict[str, float], new: Dict[str, float]) -> None:
    for name, value in new.items():
        best[name] = min(best.get(name, value), value)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=Path, help="burnish_calls_bench")
    parser.add_argument("--rounds", type=int, default=10, help="turns of each side")
    parser.add_argument("--repetitions", type=int, default=5, help="per turn")
    options = parser.parse_args()

    python: Dict[str, float] = {}
    cpp: Dict[str, float] = {}
    with tempfile.TemporaryDirectory() as folder:
        states = Path(folder) / "states"
        ours = InPython(states)
        for _ in range(options.rounds):
            keep_least(cpp, in_cpp(options.program, states, options.repetitions))
            keep_least(python, ours.measure(options.repetitions))

    print(f"us per state, {STATES} states; the loop in Python alone: {python['loop']:.3f}\n")
    print("| one by one | Python | C++ | per state more |\n| --- | ---: | ---: | ---: |")
    for name, calls, there in [
        ("forward", "forward(q, v, tau)", "forward"),
        ("forward and a", "forward(q, v, tau); a", "forward"),
        ("derivatives", "forward(q, v, tau); forward_derivatives()", "derivatives"),
    ]:
        more = python[name] - cpp[there]
        print(f"| {calls} | {python[name]:.3f} | {cpp[there]:.3f} | {more:.3f} |")
    print("\n| one batch, all derivatives | Python | C++ | of C++'s throughput |")
    print("| --- | ---: | ---: | ---: |")
    for name, calls in [("batch", "one thread"), ("batch2", "two threads")]:
        print(f"| {calls} | {python[name]:.3f} | {cpp[name]:.3f} | {cpp[name] / python[name]:.0%} |")


if __name__ == "__main__":
    main()
