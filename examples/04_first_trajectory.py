"""A first trajectory: an arm moves its tool to a point in one second and comes to rest there.

Shows: a problem in code (what is measured, how much it counts, for how long), a solve, and what comes
out: why the solver stopped, where the cost comes from, states, controls and gains."""

import sys

import numpy as np

import burnish as bn
from burnish import residual

robot = bn.load_robot("arm7")
model = robot.model
q = robot.posture("ready")
goal = [0.55, -0.15, 0.35]  # m, world; the tool is at (0.45, 0.05, 0.25)

move = bn.Stage(
    "move",
    step=0.01,
    costs=[bn.CostTerm(residual.State(), weight=0.1), bn.CostTerm(residual.Control(), weight=1e-4)],
)
spec = bn.ProblemSpec(
    model,
    initial_state=np.concatenate([q, np.zeros(model.nv)]),  # at rest
    stages=[move],
    horizon=[bn.HorizonSegment("move", 100)],  # 100 steps of 10 ms
    terminal=[
        bn.CostTerm(residual.FramePosition("tool", goal), weight=1e4),
        bn.CostTerm(residual.JointVelocity(), weight=1e2),
    ],
)

problem = bn.Problem(spec)
solver = bn.DdpSolver(problem)
summary = solver.solve()
print(f"{solver.text()}\n{solver.cost_report().text()}", end="")
if summary.reason != bn.StopReason.CONVERGED:
    sys.exit(1)

last = solver.xs[100, : model.nq]
miss = np.linalg.norm(bn.frame_placement(model, last, "tool")[:3, 3] - goal)
print(f"the tool ends {1e3 * miss:.2f} mm from the point, after {summary.iterations} iterations")

# The same problem answers what to do next to the trajectory: u = u_0 + K (x (-) x_0).
gain = solver.named_gain(0)
print(f"{gain.rows[1]} moves by {gain.values[1, 1]:.1f} Nm per rad of '{gain.columns[1]}'")
