"""What a contact does to a robot: Talos presses its tool on a tilted board with 30 N.

Shows: a robot by name, a contact along one direction, torques for a wanted force, the force as a
sentence and in other references, and how the force reacts to the joints."""

import numpy as np

import burnish

robot = burnish.load_robot("talos:right_arm")
q = robot.posture("tilt_45")
still = np.zeros(robot.model.nv)

# A tip that slides on the board: one direction is held, along the normal.
tip = burnish.ContactSpec(
    name="board",
    tool="tool",
    reference=burnish.Reference.surface_with_normal([-1.0, 0.0, 1.0]),
    directions="z",
)
dynamics = burnish.ContactDynamics(robot.model, [tip])

# Torques that hold the arm still while it presses with 30 N, and what they do.
dynamics.inverse(q, still, still, [30.0])
tau = dynamics.tau
dynamics.forward(q, still, tau)

force = dynamics.force("board")
print(force.text())
print("  the same:", force.in_(burnish.Reference.local()).text())
print("  the same:", force.in_(burnish.Reference.world()).text())

# The torques stay, one joint moves: the force changes by
dynamics.forward_derivatives()
by_q, by_tau = dynamics.dlambda_dq[0], dynamics.dlambda_dtau[0]
for name, dq, dtau in zip(robot.model.v_names, by_q, by_tau):
    print(f"  {dq:+8.2f} N/rad  {dtau:+6.2f} N/Nm  {name}")
