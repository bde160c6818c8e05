"""A contact between two moving bodies: the two arms of a crane hold one another by their tips.
Then the same dynamics and all derivatives for 1000 states at once, one state per SIMD lane."""

import time

import numpy as np

import burnish

crane = burnish.load_robot("crane")
model = crane.model

grip = burnish.ContactSpec(
    name="grip",
    tool="left_tip",
    base="right_tip",  # a moving body: it receives the opposite force, at the same point
    directions="linear",
)
dynamics = burnish.ContactDynamics(model, [grip])

zero = np.zeros(model.nv)
dynamics.forward(crane.reference_configuration(), zero, zero)
print(dynamics.force("grip").text())

states = 1000
generator = np.random.default_rng(1)
Q = burnish.random_configuration(model, seed=1, count=states)
V, Tau = generator.uniform(-1.0, 1.0, (2, states, model.nv))

batch = burnish.ContactDynamicsBatch(model, [grip], capacity=states)
start = time.perf_counter()
batch.forward_with_derivatives(Q, V, Tau)
batched = time.perf_counter() - start

start = time.perf_counter()
difference = 0.0
for q, v, tau, da_dq in zip(Q, V, Tau, batch.da_dq):
    dynamics.forward(q, v, tau)
    dynamics.forward_derivatives()
    single = dynamics.da_dq
    scale = 1.0 + np.abs(single).max()
    difference = max(difference, np.abs(da_dq - single).max() / scale)
one_by_one = time.perf_counter() - start

print(
    f"{states} states, all derivatives: {1e6 * batched / states:.2f} us per state in packs of "
    f"{burnish.pack_width()}, {1e6 * one_by_one / states:.2f} us one by one"
)
print("batch and single", "agree" if difference < 1e-9 else "differ")
