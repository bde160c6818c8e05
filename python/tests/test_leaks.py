"""Created and destroyed objects do not leak memory."""

from __future__ import annotations

import ctypes
import gc
import mmap
import sys
from typing import Callable, List, Tuple

import numpy as np
import pytest
from numpy.typing import NDArray

import burnish

CYCLES = 10_000
BYTES = 500_000
"""Largest allowed growth in C++: 50 bytes per cycle. The measured growth is zero."""
OBJECTS = 2_000
"""Largest allowed growth in Python: one object per five cycles. Caches grow by some hundreds."""
LIBC = ctypes.CDLL(None)


def settled() -> Tuple[int, int]:
    """Returns resident bytes and Python objects after freeing unused memory."""
    gc.collect()
    if hasattr(LIBC, "malloc_trim"):
        LIBC.malloc_trim(0)
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * mmap.PAGESIZE, sys.getallocatedblocks()


def growth(cycle: Callable[[], object]) -> Tuple[int, int]:
    """Returns the growth of bytes and objects over CYCLES calls, after calls that fill the caches."""
    for _ in range(CYCLES // 10):
        cycle()
    resident, objects = settled()
    for _ in range(CYCLES):
        cycle()
    resident_after, objects_after = settled()
    return resident_after - resident, objects_after - objects


ROBOT = burnish.load_robot("pendulum")
MODEL = ROBOT.model
Q = ROBOT.reference_configuration()
ZERO = np.zeros(MODEL.nv)
INERTIA = burnish.InertiaSpec(mass=1.0, com=[0.0, 0.0, 0.5], inertia_at_com=0.1 * np.eye(3))
TREE = burnish.TreeSpec(
    links=[burnish.LinkSpec("base"), burnish.LinkSpec("bob", INERTIA)],
    joints=[burnish.JointSpec("pivot", burnish.JointType.REVOLUTE, "base", "bob")],
)
ARM = burnish.load_robot("talos:right_arm")
TIP = burnish.ContactSpec(tool="tool", directions="linear")
ROWS = np.tile(ARM.posture("tilt_45"), (16, 1))


def model() -> object:
    return burnish.build_model(TREE).joints


def dynamics() -> object:
    made = burnish.ContactDynamics(ARM.model, [TIP])
    made.forward(ROWS[0], ROWS[1], ROWS[2])
    made.forward_derivatives()
    return made.da_dq, made.force(0), made.wrench_derivatives(0, burnish.Reference.world())


def batch() -> object:
    made = burnish.ContactDynamicsBatch(ARM.model, [TIP], 16)
    made.forward_with_derivatives(ROWS, ROWS, ROWS)
    return made.da_dq, made.statuses


def rigid_body() -> object:
    made = burnish.RigidBody(MODEL)
    made.update(Q, ZERO)
    return made.placement(0), made.frame_derivatives(0, "local")


class Height:
    """Residual written in Python."""

    name, rows, frames = "height", 1, [MODEL.frames[-1].name]

    def value(self, at: burnish.NodeView) -> float:
        return float(at.placement(0)[2, 3])


PROBLEM = burnish.ProblemSpec(
    MODEL,
    initial_state=np.concatenate([Q, ZERO]),
    stages=[burnish.Stage("swing", costs=[
        burnish.CostTerm(burnish.residual.State()),
        burnish.CostTerm(burnish.residual.Control(target=lambda t: np.full(MODEL.nv, t))),
        burnish.CostTerm(burnish.residual.custom(Height())),
    ])],
    horizon=[burnish.HorizonSegment("swing", 2)],
)


def solve() -> object:
    problem = burnish.Problem(PROBLEM)
    solver = burnish.DdpSolver(problem, burnish.DdpOptions(max_iterations=1))
    return solver.solve(), solver.xs, solver.gain(0)


class Still(burnish.Controller):
    """Controller written in Python."""

    @property
    def nv(self) -> int:
        return int(ARM.model.nv)

    def reset(self) -> None:
        pass

    def tick(self, measurement: burnish.Measurement) -> NDArray[np.float64]:
        return np.zeros(self.nv)


SCENE = burnish.SceneSpec([burnish.with_surface_at(ARM.model, ROWS[0], [-1.0, 0.0, 1.0], burnish.TouchSpec("tool"),
                                                   clearance=0.1)])
SHORT = burnish.ClosedLoopOptions(max_duration=0.002)


def loop() -> object:
    plant = burnish.make_ideal_plant(ARM.model, SCENE)
    made = burnish.ClosedLoop(plant, Still(), options=SHORT)
    made.reset(ROWS[0])
    made.run(0.001)
    return made.trace.array()


def failure() -> None:
    made = burnish.ContactDynamics(MODEL)
    for call in (lambda: made.forward(Q, ZERO, [np.nan]), lambda: made.forward(Q, Q, "x"),
                 lambda: burnish.ContactDynamics(MODEL, [TIP])):
        try:
            call()
        except (burnish.Error, TypeError):
            continue
        raise AssertionError("nothing was refused")


@pytest.mark.parametrize("cycle", [model, dynamics, batch, rigid_body, solve, loop, failure])
def test_memory_does_not_grow(cycle: Callable[[], object]) -> None:
    resident, objects = growth(cycle)
    assert resident < BYTES and objects < OBJECTS


def test_bounds_detect_a_leak_in_every_cycle() -> None:
    lost: List[object] = []
    assert growth(lambda: lost.append(object()))[1] > OBJECTS
    assert growth(lambda: LIBC.calloc(1, 200))[0] > BYTES
