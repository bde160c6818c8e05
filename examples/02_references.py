"""One contact in the four references and in the axes of a third body: the same motion and the same
force, in different numbers. Then the trap: as soon as some directions are free, the reference decides which ones are held."""

import numpy as np

import burnish

robot = burnish.load_robot("arm7")
zero = np.zeros(robot.model.nv)
references = [
    burnish.Reference.local(),
    burnish.Reference.centered(),
    burnish.Reference.surface_with_normal([0.0, -1.0, 1.0]),
    burnish.Reference.world(),
    burnish.Reference(axes="link_4"),  # at the tool, turning with the elbow
]

for title, directions in [("All six held", "all"), ("Only z held", "z")]:
    print(title)
    print(f"{'':25} {'force (N)  and  moment (Nm)':>29} {'a (rad/s^2)':>30}")
    accelerations = []
    for reference in references:
        # The motors are off, the tool is held by the contact, and the robot sags from rest.
        contact = burnish.ContactSpec(tool="tool", reference=reference, directions=directions)
        dynamics = burnish.ContactDynamics(robot.model, [contact])
        dynamics.forward(robot.posture("bent"), zero, zero)
        a, wrench = dynamics.a, dynamics.force(0).value
        accelerations.append(a)
        forces = "".join(f" {0.0 if abs(entry) < 0.05 else entry:6.1f}" for entry in wrench)
        print(f"{reference.name:<25}{forces}  |" + "".join(f" {x:6.2f}" for x in a[:4]) + " ...")
    spread = np.ptp(accelerations, axis=0).max()
    print(f"-> {'the same' if spread < 1e-8 else 'different'} accelerations\n")
