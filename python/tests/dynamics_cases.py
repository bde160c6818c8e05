"""States and finite differences for the tests of derivatives."""

from __future__ import annotations

from typing import Callable, Tuple

import numpy as np
from numpy.typing import NDArray

import burnish
from burnish import ContactSpec, Reference

Array = NDArray[np.float64]
ROBOT = burnish.load_robot("talos:right_arm")
MODEL = ROBOT.model
TALOS = burnish.load_robot("talos")
TIP = ContactSpec(name="tip", tool="tool", directions="linear",
                  reference=Reference.surface_with_normal([0.2, -0.4, 0.9])).with_gains(9.0, 5.0)
PAD = ContactSpec(name="pad", tool="tool", directions="rz")
SOLES = [ContactSpec(name=side, tool=side + "_sole_link") for side in ("left", "right")]


def states(model: burnish.Model, count: int, seed: int = 1) -> Tuple[Array, Array, Array]:
    generator = np.random.default_rng(seed)
    q0 = np.tile(TALOS.reference_configuration() if model.nq > 7 else ROBOT.posture("tilt_45"),
                 (count, 1))
    q = burnish.integrate(model, q0, generator.uniform(-0.3, 0.3, (count, model.nv)))
    v, tau = generator.uniform(-1.0, 1.0, (2, count, model.nv))
    return q, v, 10.0 * tau


def state(model: burnish.Model = MODEL) -> Tuple[Array, Array, Array]:
    q, v, tau = states(model, 1)
    return q[0], v[0], tau[0]


def differences(f: Callable[[Array], Array], size: int, step: float = 1e-6) -> Array:
    """Returns the Jacobian of f at zero by central differences."""
    columns = [(f(h) - f(-h)) / (2.0 * step) for h in step * np.eye(size)]
    return np.transpose(columns)


def assert_close(got: Array, wanted: Array, tolerance: float = 1e-6) -> None:
    assert got.shape == wanted.shape
    assert np.abs(got - wanted).max() <= tolerance * (1.0 + np.abs(wanted).max())
