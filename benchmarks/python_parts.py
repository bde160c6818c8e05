"""What parts that are written in Python cost in a loop and in a solve.

    PYTHONPATH=build/python python3 benchmarks/python_parts.py

An arm of seven joints; the least wall time of several repetitions. Plants and controllers in Python only
pass on what the library's compute, so that the difference is the price of being called."""

from __future__ import annotations

import time
from typing import Any, Callable

import numpy as np
from numpy.typing import NDArray

import burnish
from burnish import residual

ROBOT = burnish.load_robot("arm7")
Q = ROBOT.posture("ready")
REST = np.concatenate([Q, np.zeros(ROBOT.model.nv)])
SECONDS = 1.0


class Passed:
    """A plant that is another one, through Python."""

    def __init__(self, plant: Any) -> None:
        self.plant, self.model, self.scene, self.dt = plant, plant.model, plant.scene, plant.dt

    def __getattr__(self, name: str) -> Any:
        return getattr(self.plant, name)


class Still:
    """A controller that sends zeros: the array alone, or a Command."""

    def __init__(self, whole: bool) -> None:
        self.nv, self.whole, self.tau = ROBOT.model.nv, whole, np.zeros(ROBOT.model.nv)

    def reset(self) -> None:
        pass

    def tick(self, measurement: burnish.Measurement) -> Any:
        return burnish.Command(tau=self.tau) if self.whole else self.tau


class Reach:
    """residual.FramePosition once more."""

    name, rows, frames = "reach", 3, ["tool"]

    def value(self, at: burnish.NodeView) -> NDArray[np.float64]:
        return np.asarray(at.placement(0)[:3, 3] - GOAL)

    def jacobian(self, at: burnish.NodeView) -> NDArray[np.float64]:
        out = np.zeros((3, at.layout.nz))
        out[:, at.layout.column_q : at.layout.column_v] = at.jacobian(0, "centered")[:3]
        return out


GOAL = np.array([0.5, -0.1, 0.3])


def least(work: Callable[[], object], repetitions: int = 9) -> float:
    times = []
    for _ in range(repetitions):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return min(times)


def loop_time(plant: Any, controller: Any, period: float = 1e-3) -> float:
    loop = burnish.ClosedLoop(plant, controller,
                              options=burnish.ClosedLoopOptions(control_period=period))

    def run() -> None:
        loop.reset(Q)
        loop.run(SECONDS)

    return least(run)


def solve_time(reach: Any) -> float:
    problem = burnish.Problem(burnish.ProblemSpec(
        ROBOT.model,
        initial_state=REST,
        stages=[burnish.Stage("move", costs=[
            burnish.CostTerm(residual.State(), 0.1),
            burnish.CostTerm(residual.Control(), 1e-4),
            burnish.CostTerm(reach, 10.0, "reach"),
        ])],
        horizon=[burnish.HorizonSegment("move", 100)],
    ))
    solver = burnish.DdpSolver(problem, burnish.DdpOptions(
        update=burnish.StepUpdate.MULTIPLE_SHOOTING, max_iterations=1))
    return least(solver.solve)


def main() -> None:
    tip = burnish.with_surface_at(ROBOT.model, Q, [0.0, 0.0, 1.0], burnish.TouchSpec("tool"), clearance=0.5)
    plant = burnish.make_ideal_plant(ROBOT.model, burnish.SceneSpec([tip]))
    steps, ticks = SECONDS / plant.dt, SECONDS / 1e-3
    # Twice as many ticks, and nothing else.
    twice = loop_time(plant, Still(whole=False), period=5e-4)
    arrays = loop_time(plant, Still(whole=False))
    commands = loop_time(plant, Still(whole=True))
    passed = loop_time(Passed(plant), Still(whole=False))
    print(f"a plant in Python: {1e6 * (passed - arrays) / steps:.1f} us more per step")
    print(f"a controller in Python: {1e6 * (twice - arrays) / ticks:.1f} us per tick that answers with "
          f"an array, {1e6 * (commands - arrays) / ticks:.1f} us more for a Command")
    inside, outside = solve_time(residual.FramePosition("tool", GOAL)), solve_time(residual.custom(Reach()))
    print(f"one iteration of 100 knots: {1e3 * inside:.2f} ms; with a cost in Python at every knot "
          f"{1e3 * outside:.2f} ms")


if __name__ == "__main__":
    main()
