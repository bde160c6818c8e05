// Properties of a control loop between a controller and the joints.
#pragma once

namespace burnish {

/// Properties of a control loop that affect its stability: delay, lag and filters between a
/// controller and the joints, and stiffness and damping of the touched surface. The value 0
/// switches a delay, lag or filter off.
struct LoopChain {
  double command_delay = 0.0;  ///< Delay from the controller to the motors [s].
  double torque_cutoff = 0.0;  ///< Cutoff of the motors' first-order lag [rad/s].
  /// True if velocities are computed as differences of measured positions.
  bool difference_velocity = true;
  double velocity_cutoff = 0.0;  ///< Cutoff of the low-pass filter of velocity differences [rad/s].
  double force_cutoff = 0.0;     ///< Cutoff of the low-pass filter of the measured force [rad/s].
  double stiffness = 1e5;        ///< Stiffness of the surface along its normal [N/m].
  double damping = 500.0;        ///< Damping of the surface along its normal [Ns/m].
};

}  // namespace burnish
