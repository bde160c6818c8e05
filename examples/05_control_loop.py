"""A control loop: an arm comes down on a tilted board, presses with 20 N and draws a line of 6 cm,
with masses 5 % larger and friction that its controller does not know of.
Shows: model predictive control of a task of your own, its schedule, a plant, and the score."""

import sys

import numpy as np
from numpy.typing import NDArray

import burnish
from burnish import CostTerm, Reference, SchedulePhase, Stage, Touch, residual

robot = burnish.load_robot("arm7")
q = robot.posture("ready")
tilted = [0.2, -0.1, 1.0]  # out of the board, world
# The board is 1 cm under the tip of the tool.
tip = burnish.with_surface_at(robot.model, q, tilted, burnish.TouchSpec("tool"), clearance=0.01)
surface = burnish.Reference.surface_with_normal(tilted)
axes = np.asarray(surface.rotation)
along: NDArray[np.float64] = axes[:, 0]
n: NDArray[np.float64] = axes[:, 2]
start: NDArray[np.float64] = np.asarray(tip.surface.point) + tip.radius * n


def place(t: float) -> NDArray[np.float64]:
    """Where the tool shall be, by time. Contact is due at 0.5 s."""
    return start + min(max(0.03 * (t - 1.0), 0.0), 0.06) * along


def push(t: float) -> float:
    """How hard it shall press."""
    return 0.0 if t < 0.5 else 5.0 + 15.0 * min(1.0, 2 * (t - 0.5))


rest = np.concatenate([q, np.zeros(robot.model.nv)])
board = burnish.ContactSpec("board", tool="tool", reference=surface, directions="z")
state = CostTerm(residual.State(rest), weight=0.1)
across = CostTerm(residual.FramePosition("tool", place, Reference.world(axes)), weight=1e4,
                  weights=[1, 1, 0])
speed = [0.0, 0.0, -0.02, 0.0, 0.0, 0.0]  # m/s, towards the board
down = CostTerm(residual.FrameVelocity("tool", Reference.centered(axes), speed), weight=1e2,
                weights=[0, 0, 1, 0, 0, 0])
force = CostTerm(residual.ContactForce("board", target=push))
torque = CostTerm(residual.Control(), weight=1e-4)
mpc = burnish.MpcSpec(
    problem=burnish.ProblemSpec(
        robot.model,
        contacts=[board.with_gains(0.0, 40.0)],
        stages=[
            Stage("approach", costs=[state, torque, across, down]),
            Stage("press", contacts=["board"], costs=[state, torque, across, force]),
        ],
        terminal=[state, across],
        horizon=[burnish.HorizonSegment("approach", 50)],  # half a second
        initial_state=rest,
    ),
    schedule=[
        SchedulePhase("approach", "approach", duration=0.5, until="contact"),
        SchedulePhase("press", "press"),
    ],
    tools=[burnish.ToolSpec("tool", normal_base=n)],
    task=burnish.PressingTask([Touch.DUE, Touch.WANTED],
                              lambda t: burnish.TaskTarget(place(t), push(t))),
    tick_period=1e-3,
    update_period=1e-3,
    model_error=burnish.ModelErrorOptions(bandwidth=150.0),
)

controller = burnish.MpcController(mpc)
disturbances = burnish.Disturbances(joint_viscous=0.2, mass_scale=1.05, surface_friction=0.3)
plant = burnish.make_ideal_plant(burnish.plant_model(robot.model, disturbances),
                                 burnish.plant_scene(burnish.SceneSpec([tip]), disturbances))
loop = burnish.ClosedLoop(plant, controller, disturbances)
loop.reset(q)
loop.run(4.0)
if controller.fault().kind != burnish.FaultKind.NONE:
    sys.exit(controller.fault().text())
score = burnish.measure(loop.trace, robot.model,
                        burnish.MetricsSpec(start=1.1, end=3.0, normal_world=n))
print(f"polished: force error {score.force_rmse:.3f} N, "
      f"path error {1e3 * score.position_rmse:.3f} mm rms")
