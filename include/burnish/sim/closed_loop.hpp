// Simulation of a controller and a plant in closed loop, with disturbances between controller and
// plant. The run is recorded in a trace.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "burnish/base/trace.hpp"
#include "burnish/estimate/estimated_base.hpp"
#include "burnish/mpc/controller.hpp"
#include "burnish/sim/actuation.hpp"
#include "burnish/sim/plant.hpp"
#include "burnish/sim/sensing.hpp"

namespace burnish {

/// Timing, recording and sensors of a simulation in closed loop.
/// @described sim
struct ClosedLoopOptions {
  /// Control period, a whole number of plant steps [s], > 0
  double control_period = 1e-3;
  /// Maximum duration of the recorded trace [s]
  double max_duration = 20.0;
  /// Plant steps per row of the trace, >= 1
  int record_every = 1;
  /// Frame of the inertial measurement unit (empty: the robot's first body; none: no unit)
  /// @more The controller receives the readings of the inertial measurement unit
  std::optional<std::string> imu_frame = {};
};

/// Runs a controller and a plant in closed loop. The controller receives the wrenches on its
/// touches (see Controller::touches()), as measured by sensors. The plant's scene must contain
/// these touches. The plant advances in its own time steps. The controller ticks at the start of
/// every control period, and its torque command is held until the next tick.
///
/// A row of the trace describes one plant step. Time, state, tool, measurement and command are
/// values at the start of the step. Forces and torques are values during the step.
///
/// Columns of the trace, where `<joint>` is a name from Model::v_name (from Model::q_name for q).
/// Columns of the tool are those of the first touch of the scene that is not a support. Without
/// such a touch, the columns of the tool and of its forces, normals, friction and contact are
/// missing:
///     time [s], phase [-], status [-]              phase and status of the Command
///     tool_x|y|z_world [m]                         true position of the tip's frame
///     tool_rx|ry|rz_start [rad]                    rotation of the tip's frame since reset(), as a
///                                                  rotation vector in the tip's axes at reset();
///                                                  the rotation is relative to the frame that
///                                                  carries the surface
///     target_x|y|z_world [m], target_force [N]     targets of the controller
///     measured_force_x|y|z_world [N]               reading of the tool's force sensor, rotated
///                                                  to world axes; NaN if not read
///     estimated_force_x|y|z_world [N]              controller's estimate of the force on the tool
///     push_x|y|z_world [N]                         sum of the pushes on all frames
///     q_<joint>, v_<joint>                         true state
///     measured_q_<joint>, measured_v_<joint>       measured state
///     tau_command_<joint>                          commanded torque
///     tau_applied_<joint>                          torque of the motor
///     tau_measured_<joint>                         reading of the torque sensor
///     tau_friction_<joint>                         torque of joint friction, springs and tendons
///     tool_force_x|y|z_world [N]                   true force of the surface on the tool
///     surface_normal_x|y|z_world [-]               true surface normal at the tool
///     estimated_normal_x|y|z_world [-]             controller's estimate of the surface normal
///     estimated_friction [-]                       controller's estimate of the coefficient of
///                                                  friction at the tool
///     in_contact [-], plant_status [-]             1 if the tip is in contact; status of the plant
///     limited_joints [-]                           number of joints at their effort limit
///     held_command [-]                             1 if an invalid command was replaced
///     solve_time [s], iterations [-], missed_deadline [-]
///                                                  entries of the Command
///     tick [-]                                     1 if the controller ticked in this step
///     constraint_violation [-], constraint_residual [-], active_constraints [-],
///     constraints_infeasible [-], clipped_torques [-]
///                                                  entries of the Command
///     surface_x|y|z_world [m], surface_rx|ry|rz_world [rad]
///                                                  true position and rotation vector of the frame
///                                                  that carries the surface, if there is one
///     support_<frame>_fx|fy|fz [N], support_<frame>_mx|my|mz [Nm]
///                                                  wrench on each support of the scene, in the
///                                                  axes of the support's frame
///     signal_<name>                                values that the controller published at its
///                                                  last tick (Controller::signals())
/// Each further touch that is not a support has columns that begin with tool_<frame>_, followed by
/// x|y|z_world, rx|ry|rz_start, force_x|y|z_world, measured_force_x|y|z_world,
/// surface_normal_x|y|z_world, in_contact and, for a surface that the robot carries,
/// surface_x|y|z_world and surface_rx|ry|rz_world. If the touch is a tool of the controller
/// (Controller::tools()), it also has target_x|y|z_world, target_force,
/// estimated_force_x|y|z_world, estimated_normal_x|y|z_world and estimated_friction.
class ClosedLoop {
 public:
  /// Connects a plant and a controller, which must both outlive the loop. Throws Error
  /// - if the control period is not a multiple of the plant's step,
  /// - if controller and plant have different numbers of torques,
  /// - if the controller reads the wrench on a touch (tool or foot) that the plant's scene does not
  ///   have, or a component of the wrench without a sensor,
  /// - if the controller has a tool twice, or a tool that is not a touch of the scene,
  /// - if two columns of the trace have the same name, such as two signals of the controller,
  /// - if an option is out of range or a disturbance is invalid.
  ///
  /// The constructor does not apply the disturbances of model and scene. To apply them, create the
  /// plant with plant_model() and plant_scene().
  ClosedLoop(Plant& plant, Controller& controller, const Disturbances& disturbances = {},
             const ClosedLoopOptions& options = {});
  ~ClosedLoop();
  ClosedLoop(ClosedLoop&&) noexcept;
  ClosedLoop& operator=(ClosedLoop&&) noexcept;

  /// From the next reset() on, replaces the floating base's entries in measurements by estimates.
  /// The estimator uses the joints, the feet and an inertial measurement unit at
  /// `estimator.imu_frame`. The initial estimate is the plant's true state. `nominal` is the
  /// controller's model of the robot.
  ///
  /// Throws Error in the same cases as EstimatedBase, and if the controller already has a payload.
  void estimate_base(const Model& nominal, const BaseEstimatorOptions& estimator,
                     const FootContactOptions& feet = {});

  /// Sets the payload that controller and base estimator assume, from the next tick on. The plant
  /// does not change. `payload` is an inertia in the axes of `frame`. A previous payload of the
  /// same body is replaced, and reset() keeps the payload. Call set_payload() after
  /// estimate_base(), which creates the estimator without payloads. Allocates nothing.
  ///
  /// Returns Ok. Returns NotEvaluated if the controller does not account for payloads. If
  /// check_inertia() reports NotFinite or NotPhysical, returns that status and changes nothing.
  /// Throws Error for an unknown frame and for a frame that is fixed to the world.
  Status set_payload(std::string_view frame, const InertiaSpec& payload);

  /// Sets the plant's state to (q, v) and restarts controller, sensors and actuation. Delay and lag
  /// of the motors start at the torque of the controller's first command. Returns the plant's
  /// status. If the status is more severe than NotConverged, the state was rejected and nothing
  /// changes.
  [[nodiscard]] Status reset(const ConstVectorRef& q, const ConstVectorRef& v) noexcept;
  /// Advances by one plant step and returns the plant's status. Allocates nothing.
  [[nodiscard]] Status step() noexcept;
  /// Steps until `duration` [s] has passed, or until a step fails. A step has failed if its status
  /// is more severe than NotConverged. Returns the most severe status of all steps.
  [[nodiscard]] Status run(double duration) noexcept;

  const Trace& trace() const;
  const Actuation& actuation() const;
  const Measurement& measurement() const;  ///< Measurement at the last tick
  const Command& command() const;          ///< Command of the last tick

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Returns the trace relative to the frame that carries the surface. Positions of tool and target
/// are relative to the frame's origin, in the frame's axes. Forces and normals are rotated into the
/// frame's axes.
///
/// The names of the columns do not change. The result is stored in `room`. If the surface is fixed
/// in the world, `trace` itself is returned.
const Trace& seen_from_surface(const Trace& trace, Trace& room);

}  // namespace burnish
