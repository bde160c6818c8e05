// A controller and a plant, with the disturbances between them, and the record of their run.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "burnish/base/trace.hpp"
#include "burnish/mpc/controller.hpp"
#include "burnish/mpc/estimated_base.hpp"
#include "burnish/sim/actuation.hpp"
#include "burnish/sim/plant.hpp"
#include "burnish/sim/sensing.hpp"

namespace burnish {

/// How a ClosedLoop runs, and what it records.
/// @described sim
struct ClosedLoopOptions {
  double control_period = 1e-3;  ///< [s], a multiple of the plant's step, > 0
  double max_duration = 20.0;    ///< [s] that the trace has room for
  int record_every = 1;          ///< plant steps per row of the trace, >= 1
  /// frame of an inertial measurement unit that the controller is given readings of; empty: of the
  /// robot's first body; none: there is no unit
  std::optional<std::string> imu_frame = {};
  /// the controller is told the wrenches on the scene's supports: Measurement::support_wrenches
  bool support_sensors = true;
};

/// Advances the plant by its own step; the controller ticks at the start of every control period
/// and its torque is held until the next. One row of the trace is a plant step: time, state, tool,
/// measurement and command are those at its start, forces and torques those during it.
///
/// Columns, `<joint>` standing for a name of Model::v_name (of q_name for q):
///     time [s], phase [-], status [-]                  of Command
///     tool_x|y|z_world [m], tool_rx|ry|rz_start [rad]  true placement of the tip's frame; its
///                                                      rotation since reset(), in its axes
///                                                      then, against what carries the surface
///     target_x|y|z_world [m], target_force [N]         what the controller aims at
///     measured_force_x|y|z_world [N], estimated_force_x|y|z_world [N], push_x|y|z_world [N]
///     q_<joint>, measured_q_<joint>, v_<joint>, measured_v_<joint>
///     tau_command_<joint>, tau_applied_<joint>, tau_measured_<joint>, tau_friction_<joint>
///     tool_force_x|y|z_world [N]                       true, of the surface on the tool
///     surface_normal_x|y|z_world [-]                   true, at the tool
///     believed_normal_x|y|z_world [-]                  what the controller believes it to be
///     believed_friction [-]                            and the coefficient of friction there
///     in_contact [-], plant_status [-], limited_joints [-], held_command [-]
///     solve_time [s], iterations [-], missed_deadline [-]
///     tick [-]                                         1 where the controller ticked
///     surface_x|y|z_world [m], surface_rx|ry|rz_world [rad]
///                                                      where the robot carries the surface: true
///                                                      place and rotation vector of its frame
///     support_<frame>_fx|fy|fz [N], support_<frame>_mx|my|mz [Nm]
///                                                      on the scene's supports, in their axes
class ClosedLoop {
 public:
  /// Plant and controller must outlive the loop. Throws Error for periods that do not fit, for a
  /// controller of another size and for bad disturbances. The disturbances of model and scene are
  /// not applied here: build the plant with plant_model() and plant_scene().
  ClosedLoop(Plant& plant, Controller& controller, const Disturbances& disturbances = {},
             const ClosedLoopOptions& options = {});
  ~ClosedLoop();
  ClosedLoop(ClosedLoop&&) noexcept;
  ClosedLoop& operator=(ClosedLoop&&) noexcept;

  /// From the next reset() on the controller is given an estimate of where the base is, in place of
  /// the plant's own entries: from a measurement unit, which is mounted where the options say, the
  /// joints and the feet. It starts where the robot does. `known`: the robot as the controller
  /// knows it. Throws Error as EstimatedBase does, and for a controller that carries a payload
  /// (MpcController::set_payload), which the estimate would not know of.
  void estimate_base(const Model& known, const BaseEstimatorOptions& estimator,
                     const FootContactOptions& feet = {});

  /// Puts the plant into a state and everything else to its start. The motors start at the torque
  /// of the controller's first command, as if the robot had been held.
  [[nodiscard]] Status reset(const ConstVectorRef& q, const ConstVectorRef& v) noexcept;
  /// One plant step: the plant's status. Allocates nothing.
  [[nodiscard]] Status step() noexcept;
  /// Steps until `duration` s have passed, or until the plant's status is above NotConverged.
  [[nodiscard]] Status run(double duration) noexcept;

  const Trace& trace() const;
  const Actuation& actuation() const;
  const Measurement& measurement() const;  ///< of the last tick
  const Command& command() const;          ///< of the last tick

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The trace as one sees it who moves with the surface: what its columns say of tool, target,
/// forces and normals in the axes of the frame that carries it, places from its origin. Put into
/// `room`; where the surface stands in the world it is the trace itself.
const Trace& seen_from_surface(const Trace& trace, Trace& room);

}  // namespace burnish
