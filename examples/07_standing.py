"""A robot on its feet: whole Talos stands in MuJoCo, draws a circle in the air with its right hand and
is pushed at the torso with 80 N; it is 2 % heavier than its controller thinks.
Shows: feet as contacts within what they bear, balance, knots that grow, ground that only pushes."""

import math
import sys

import numpy as np
from numpy.typing import NDArray

import burnish
from burnish import Constraint, CostTerm, residual

robot = burnish.load_robot("talos")  # or a URDF of your own, RobotOverrides(base=Base.FREE_FLYER)
nv = robot.model.nv
q, rest = robot.posture("standing_table"), np.zeros(nv)
body = burnish.RigidBody(robot.model)
body.update(q, rest)
hand = body.placement("tool")[:3, 3]


def circle(t: float) -> NDArray[np.float64]:
    """Where the hand shall be, by time."""
    out = np.array([0.0, math.cos(4.0 * t), math.sin(4.0 * t)])
    return np.asarray(hand + 0.04 * min(1.0, t) * out)


feet = ["left_sole_link", "right_sole_link"]
contacts, constraints, supports = [], [], []
least = [-1e9, -1e9, 40.0, -1e9, -1e9, -1e9]  # N that each foot bears
for foot in feet:
    sole = burnish.ContactSpec(foot, tool=foot, reference=burnish.Reference.centered())
    contacts.append(sole.with_gains(0.0, 20.0))  # all 6 directions of it are held
    constraints += [
        Constraint(residual.FrictionCone(foot, 0.5), name="rubs " + foot),
        Constraint(residual.CenterOfPressure(foot, 0.09, 0.06), name="tips " + foot),
        Constraint(residual.ContactForce(foot), name="bears " + foot, lower=least, scale=[100.0]),
    ]
    ground = burnish.SurfaceSpec(point=body.placement(foot)[:3, 3], friction=0.7, stiffness=2e6, damping=1e5)
    supports.append(burnish.TouchSpec(foot, half_x=0.1, half_y=0.065, surface=ground, is_support=True))
scene = burnish.SceneSpec(supports)  # the hand touches nothing

weights = np.concatenate([np.full(nv, 0.1), np.full(nv, 5.0)])
weights[:3] = 0.0  # where the base is, the centre of mass says
weights[3:6] = 100.0  # it is upright
stand = burnish.Stage("stand", contacts=feet, constraints=constraints, costs=[
    CostTerm(residual.State(), weights=weights, name="state"),
    CostTerm(residual.CenterOfMass(body.com), weight=1e3, name="balance"),
    CostTerm(residual.CentroidalMomentum(), weight=1e-2, name="momentum"),
    CostTerm(residual.FramePosition("tool", circle), weight=1e4, name="circle"),
])
start = np.concatenate([q, rest])
problem = burnish.ProblemSpec(
    robot.model, contacts=contacts, stages=[stand], initial_state=start,
    horizon=[burnish.HorizonSegment("stand", knots=25, step=0.01, duration=0.8)])
held = burnish.Problem(problem).quasi_static(0, start).control
stand.costs.append(CostTerm(residual.Control(held), weight=1e-4, name="torque"))
mpc = burnish.MpcSpec(
    problem, supports=feet, touches=[burnish.TouchSensor(foot) for foot in feet],
    schedule=[burnish.SchedulePhase("stand", "stand")],
    tick_period=1e-3, update_period=5e-3, solver_delay=5e-3,  # plans take 5 ms
    model_error=burnish.ModelErrorOptions(bandwidth=60.0, decay_time=0.2))

controller = burnish.MpcController(mpc)
push = burnish.Push(1.5, 0.2, [0.0, 80.0, 0.0], "torso_2_link")
disturbances = burnish.Disturbances(mass_scale=1.02, pushes=[push])
heavier = burnish.plant_model(robot.model, disturbances)
plant = burnish.make_mujoco_plant(heavier, scene)
loop = burnish.ClosedLoop(plant, controller, disturbances)
loop.reset(q)
loop.run(2.5)
if controller.fault().kind != burnish.FaultKind.NONE:
    sys.exit(controller.fault().text())
stood = burnish.measure_standing(loop.trace, heavier, supports)
body.update(plant.q, plant.v)
off = np.linalg.norm(body.placement("tool")[:3, 3] - circle(2.5))
print(f"stood: each foot bore {stood.min_load:.0f} N or more, used {100 * stood.friction_used:.0f} % "
      f"of its friction, slid {1e3 * stood.slip:.1f} mm")
print(f"balance: the centre of mass moved {1e3 * stood.com_moved:.0f} mm, the hand is {1e3 * off:.1f} mm off")
