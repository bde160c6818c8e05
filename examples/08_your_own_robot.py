"""A task of one's own for a robot of one's own: whatever stands on balls as feet is put on bent legs
and bows twice in MuJoCo. It knows where its base is from an inertial unit, encoders and feet.
    08_your_own_robot.py my_robot.urdf foot_1 foot_2 foot_3 foot_4     # without words: the quadruped"""

import math
import sys

import numpy as np
from numpy.typing import NDArray

import burnish
from burnish import Constraint, CostTerm, residual, stand

# What the robot is, what it stands on and what nobody tells the controller.
task = stand.make_task(posture="search", overrides=["disturbances=mismatch"])
if len(sys.argv) > 2:
    task.robot, task.standing.feet = sys.argv[1], sys.argv[2:]
at = stand.make_setting(task)
model = at.robot.model
nv = model.nv
weight, bow, deep = model.total_mass * 9.81, 0.15, 0.02


def share(t: float) -> float:
    """Of the whole bow, which takes 2 s."""
    return 0.5 - 0.5 * math.cos(math.pi * t)


def com(t: float) -> NDArray[np.float64]:
    return np.asarray(np.asarray(at.com) - np.array([0.0, 0.0, deep * share(t)]))


def turn(t: float) -> NDArray[np.float64]:
    """Quaternion x y z w: the base is level at the start."""
    return np.array([0.0, math.sin(0.5 * bow * share(t)), 0.0, math.cos(0.5 * bow * share(t))])


contacts, constraints = [], []
for foot in task.standing.feet:
    ball = burnish.ContactSpec(foot, tool=foot, directions="linear", reference=burnish.Reference.centered())
    contacts.append(ball.with_gains(0.0, 20.0))
    constraints += [
        Constraint(residual.FrictionCone(foot, 0.5), name="rubs " + foot),
        Constraint(residual.ContactForce(foot), name="bears " + foot,
                   lower=[-1e9, -1e9, 0.03 * weight], scale=[weight]),
    ]
weights = np.full(2 * nv, 0.1)
weights[:6] = weights[nv:nv + 6] = 0.0  # where the base is and how it moves, balance and bow say
stage = burnish.Stage("bow", contacts=task.standing.feet, constraints=constraints, costs=[
    CostTerm(residual.State(), weights=weights, name="state"),
    CostTerm(residual.CenterOfMass(com), weight=1e4, name="balance"),
    CostTerm(residual.FrameRotation(at.base, turn), weight=1e3, name="bow"),
])
problem = burnish.ProblemSpec(
    model, contacts=contacts, stages=[stage], initial_state=np.concatenate([at.q_start, np.zeros(nv)]),
    horizon=[burnish.HorizonSegment("bow", knots=20, step=0.01, duration=0.6)])
controller = burnish.MpcController(burnish.MpcSpec(
    problem, supports=task.standing.feet,
    touches=[burnish.TouchSensor(foot) for foot in task.standing.feet],  # with sensors of force and moment
    schedule=[burnish.SchedulePhase("bow", "bow")],
    settle=0.5, fallback=task.standing.fallback,  # held at first, while the estimate of its base settles
    tick_period=1e-3, update_period=5e-3, solver_delay=5e-3,  # plans take 5 ms
    model_error=burnish.ModelErrorOptions(bandwidth=60.0, decay_time=0.2)))
heavier = burnish.plant_model(model, task.disturbances)
loop = burnish.ClosedLoop(burnish.make_mujoco_plant(heavier, at.scene), controller, task.disturbances)
estimator = burnish.BaseEstimatorOptions(
    gyro_noise=3e-4, accelerometer_noise=5e-3, feet=[burnish.FootSpec(foot) for foot in task.standing.feet])
loop.estimate_base(model, estimator, burnish.FootContactOptions(force_noise=1e-3 * weight))
loop.reset(at.q_start)
loop.run(4.5)
if controller.fault().kind != burnish.FaultKind.NONE:
    sys.exit(controller.fault().text())
stood = burnish.measure_standing(loop.trace, heavier, at.scene.supports())
print(f"bowed: by {stood.base_tilt:.3f} rad, the centre of mass moved {1e3 * stood.com_moved:.0f} mm")
print(f"stood: each foot bore {100 * stood.min_load / weight:.0f} % of the weight or more")
