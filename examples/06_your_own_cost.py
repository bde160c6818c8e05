"""A cost of your own: keep two points of an arm apart. Written once with values alone (derivatives
come from differences) and once with its own derivative, which the checker compares."""

import math

import numpy as np
from numpy.typing import NDArray

import burnish as bn
from burnish import residual


class Distance:
    """Distance between the origins of two frames, m."""

    name = "distance"
    rows = 1
    frames = ["tool", "link_2"]

    def value(self, at: bn.NodeView) -> float:
        apart = at.placement("tool")[:3, 3] - at.placement("link_2")[:3, 3]
        return float(np.linalg.norm(apart))


class DistanceWithDerivative(Distance):
    """The same with d(distance)/dz: only q matters. Linear rows of the centered Jacobian are dp/dq."""

    def jacobian(self, at: bn.NodeView) -> NDArray[np.float64]:
        apart = at.placement("tool")[:3, 3] - at.placement("link_2")[:3, 3]
        moved = at.jacobian("tool", "centered")[:3] - at.jacobian("link_2", "centered")[:3]
        layout = at.layout
        out = np.zeros((1, layout.nz))
        out[0, layout.column_q : layout.column_v] = apart / np.linalg.norm(apart) @ moved
        return out


def solve(robot: bn.Robot, distance: residual.Custom) -> float:
    """Solves with this residual and returns the cost."""
    fold = bn.Stage(
        "fold",
        costs=[
            bn.CostTerm(residual.State(), weight=1.0),
            bn.CostTerm(residual.Control(), weight=1e-4),
            bn.CostTerm(distance, weight=1e3, penalty=bn.Penalty.at_least(0.5)),
        ],
    )
    rest = np.concatenate([robot.reference_configuration(), np.zeros(robot.model.nv)])
    problem = bn.Problem(
        bn.ProblemSpec(
            robot.model, initial_state=rest, stages=[fold], horizon=[bn.HorizonSegment("fold", 50)]
        )
    )
    report = bn.check_problem(problem)
    solver = bn.DdpSolver(problem)
    summary = solver.solve()
    print("derivatives agree with differences" if report.pass_ else "wrong derivatives")
    print(solver.text())
    return summary.cost if report.pass_ else math.nan


robot = bn.load_robot("arm7")
without = solve(robot, residual.custom(Distance()))
with_derivative = solve(robot, residual.custom(DistanceWithDerivative()))
print("both ways", "the same cost" if abs(with_derivative - without) < 1e-6 else "single differ")
