"""Objects that come and go leave no memory behind."""

from __future__ import annotations

import ctypes
import gc
import mmap
import sys
from typing import Callable, List, Tuple

import numpy as np
import pytest

import burnish

CYCLES = 10_000
BYTES = 500_000
"""What C++ may lose: 50 bytes in every cycle. Nothing was measured to be lost."""
OBJECTS = 2_000
"""What Python may lose: an object in every fifth cycle. Some hundreds were measured, in caches."""
LIBC = ctypes.CDLL(None)


def settled() -> Tuple[int, int]:
    """Resident bytes and objects of Python, without what is free already."""
    gc.collect()
    if hasattr(LIBC, "malloc_trim"):
        LIBC.malloc_trim(0)
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * mmap.PAGESIZE, sys.getallocatedblocks()


def growth(cycle: Callable[[], object]) -> Tuple[int, int]:
    """What CYCLES add to both, after as many as fill the caches."""
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


def failure() -> None:
    made = burnish.ContactDynamics(MODEL)
    for call in (lambda: made.forward(Q, ZERO, [np.nan]), lambda: made.forward(Q, Q, "x"),
                 lambda: burnish.ContactDynamics(MODEL, [TIP])):
        try:
            call()
        except (burnish.Error, TypeError):
            continue
        raise AssertionError("nothing was refused")


@pytest.mark.parametrize("cycle", [model, dynamics, batch, rigid_body, failure])
def test_memory_does_not_grow(cycle: Callable[[], object]) -> None:
    resident, objects = growth(cycle)
    assert resident < BYTES and objects < OBJECTS


def test_the_bounds_see_what_every_cycle_loses() -> None:
    lost: List[object] = []
    assert growth(lambda: lost.append(object()))[1] > OBJECTS
    assert growth(lambda: LIBC.calloc(1, 200))[0] > BYTES
